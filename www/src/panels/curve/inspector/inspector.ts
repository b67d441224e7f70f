import { baseCount } from "../../../document/document.ts";
import type { EditorState } from "../../../editor/editor.ts";
import { late } from "../../../editor/loading.ts";
import { h, setText } from "../../controls/dom.ts";
import { nothingSelected, type Section } from "../../mode/panel-parts.ts";
import type { Shell } from "../../shell.ts";

/**
 * The chosen point in numbers, which come when there is one: typed values are exact. Several points: their box, what
 * they share, and what brings them in line.
 */
export function inspectorSection({ editor }: Shell): Section {
  const which = h("span", { class: "section-note num" });
  const none = h("p", { class: "quiet" });
  const numbers = h("div", { class: "inspector" });
  const together = h("div", { class: "inspector" });
  const point = late(editor, hasAny, async () => (await import("./numbers.ts")).pointNumbers(editor), (section) => {
    numbers.append(section.element);
    section.update(editor.state.value);
  });
  const several = late(editor, hasSeveral, async () => (await import("./align-rows.ts")).alignSection(editor), (section) => {
    together.append(section.element);
    section.update(editor.state.value);
  });
  const head = h("div", { class: "section-head" }, h("h3", { class: "section-title" }, "Selected"), which);
  return {
    element: h("section", { class: "section", "aria-label": "Selected" }, head, none, together, numbers),
    update(state) {
      none.hidden = hasAny(state);
      setText(none, nothingSelected(state, "a point"));
      numbers.hidden = !hasAny(state);
      together.hidden = !hasSeveral(state);
      setText(which, describeSelection(state));
      point()?.update(state);
      several()?.update(state);
    },
  };
}

function hasAny({ selection }: EditorState): boolean {
  return selection.points.length > 0;
}

function hasSeveral({ selection }: EditorState): boolean {
  return selection.points.length > 1;
}

function describeSelection({ selection, curve }: EditorState): string {
  const { points } = selection;
  const first = points[0];
  if (first === undefined) return "";
  if (points.length > 1) return `${points.length} points`;
  const contour = curve.contours[first.contour];
  const of = contour === undefined ? 0 : baseCount(contour);
  if (contour !== undefined && first.index >= of) return `finer point ${first.index - of + 1} of ${contour.points.length - of}`;
  const where = curve.contours.length > 1 ? `, contour ${first.contour + 1}` : "";
  return `point ${first.index + 1} of ${of}${where}`;
}
