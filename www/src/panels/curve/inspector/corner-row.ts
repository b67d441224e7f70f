import { radiusOf } from "../../../editor/curve/corners/chosen.ts";
import { rounding } from "../../../editor/curve/on-demand.ts";
import type { Editor } from "../../../editor/editor.ts";
import type { Section } from "../../mode/panel-parts.ts";
import { lengthField } from "./length-field.ts";

/** The radius of the chosen corners; hidden where none is. */
export function cornerRow(editor: Editor): Section {
  const field = lengthField(editor, {
    label: "Corner radius",
    testid: "corner-radius",
    about: "Rounds the selected corners with exact arcs; 0 makes them sharp.",
    least: 0,
    word: "Mixed",
    write(value) {
      if (value !== null) rounding(editor, ({ roundCorners }) => roundCorners(editor, value, "corner-radius"));
    },
  });
  return {
    element: field.element,
    update(state) {
      // A drag changes where corners are, and not which.
      if (state.drag !== null) return;
      const radius = radiusOf(state);
      field.element.hidden = radius === null;
      field.show(radius);
    },
  };
}
