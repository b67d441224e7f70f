import type { EditorState } from "../../editor/editor.ts";
import { h } from "../controls/dom.ts";
import type { ModePanel, Section } from "./panel-parts.ts";

/** A mode's panel of sections, one below the other. */
export function stackedPanel(
  name: string,
  sections: readonly Section[],
  { peek, note, ready }: Pick<ModePanel, "note"> & { readonly peek: HTMLElement; ready?(state: EditorState): boolean },
): ModePanel {
  return {
    element: h("div", { class: name }, ...sections.map((section) => section.element)),
    peek, note,
    update(state) {
      if (ready?.(state) !== false) for (const section of sections) section.update(state);
    },
  };
}
