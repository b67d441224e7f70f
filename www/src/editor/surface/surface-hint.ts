import { netPoints } from "../../kernel/surface/surface-mesh.ts";
import type { EditorState } from "../editor.ts";
import { describeNet, shownPoint } from "./surface-edits.ts";

/** What the next press would do. */
export function surfaceHint(state: EditorState): string {
  const { solid, surface, hint } = state;
  if (hint !== "") return hint;
  const point = solid.hover === null ? undefined : shownPoint(surface, solid.hover);
  if (point !== undefined) return `${describeNet(point)}: drag to move; hold Shift for the normal, X, Y or Z for an axis`;
  if (state.touch) return "Drag a control point. Drag elsewhere to orbit, two fingers to pan and zoom.";
  return state.chosen.length > 0
    ? "Drag to orbit, Shift-drag to pan. Enter refines around the selected point."
    : "Drag a control point. Drag elsewhere to orbit, Shift-drag to pan, scroll to zoom.";
}

/** The picture in words. */
export function surfaceSummary({ surface }: EditorState): string {
  const points = netPoints(surface).length;
  const finer = surface.details?.length ?? 0;
  const places = finer === 0 ? "" : `, ${finer} refined ${finer === 1 ? "area" : "areas"}`;
  return `A surface with ${points} control points and ${surface.patches} patches${places}. Brackets step through the points, arrows move the selected one, or turn the view while none is selected, Shift with 1, 2 or 3 shows the front, side or top.`;
}

export function surfaceChosen({ surface, chosen }: EditorState): string {
  const [ref] = chosen;
  if (chosen.length > 1) return `${chosen.length} points selected`;
  const point = ref === undefined ? undefined : shownPoint(surface, ref);
  return point === undefined ? "" : describeNet(point);
}
