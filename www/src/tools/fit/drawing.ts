import type { Pair } from "../../document/fit/fit.ts";
import type { Editor } from "../../editor/editor.ts";
import { addStroke, setFitView } from "../../editor/fit/fit-edits.ts";
import { knotAt } from "../../editor/fit/knot-hit.ts";
import { distanceBetween, dragThreshold, type PointerSample } from "../../editor/tool.ts";
import { choose } from "./choosing.ts";
import type { FitPress } from "./fit-press.ts";

/** A hand does not mean two places nearer than this, in CSS pixels. */
const leastStep = 0.75;

/** A drag is a stroke, a click chooses a knot. */
export function draw(editor: Editor, start: PointerSample): FitPress {
  // A mouse on a knot means the knot; a finger is too wide to tell.
  const onKnot = start.kind === "mouse" && knotAt(editor.state.value, start.screen, start.kind) !== null;
  const stroke: Pair[] = [[start.page.x, start.page.y]];
  let dragging = false;
  return {
    drag(sample) {
      if (!dragging && distanceBetween(start.screen, sample.screen) < dragThreshold[sample.kind]) return;
      dragging = true;
      if (onKnot) return;
      addPlaces(stroke, sample, leastStep / editor.state.value.view.zoom);
      setFitView(editor, { stroke: [...stroke] });
    },
    release() {
      setFitView(editor, { stroke: [] });
      if (!dragging || onKnot) choose(editor, start);
      if (dragging && onKnot) sayWhereKnotsMove(editor);
      else if (dragging && stroke.length > 1) addStroke(editor, stroke);
    },
  };
}

function addPlaces(stroke: Pair[], { trail, page }: PointerSample, least: number): void {
  for (const { x, y } of trail ?? [page]) {
    const last = stroke.at(-1);
    if (last === undefined || Math.hypot(x - last[0], y - last[1]) >= least) stroke.push([x, y]);
  }
}

function sayWhereKnotsMove(editor: Editor): void {
  editor.notify({ kind: "toast", text: "Knots are placed by the fit. To move one, choose Edit in Curve.", actionId: "fit-edit" });
}
