import { netPoints } from "../../kernel/surface/surface-mesh.ts";
import type { EditorState } from "../editor.ts";
import { describeNet, shownPoint } from "./surface-edits.ts";

/** What the next press would do. */
export function surfaceHint(state: EditorState): string {
  const { solid, surface, hint } = state;
  if (hint !== "") return hint;
  const point = solid.hover === null ? undefined : shownPoint(surface, solid.hover);
  if (point !== undefined) return `${describeNet(point)}: drag to move, Shift along the normal, X Y Z along an axis`;
  if (state.touch) return "Drag a control point. Drag anywhere else to turn; two fingers move it and bring it closer.";
  return state.chosen.length > 0
    ? "Drag turns the view, Shift-drag moves it. Enter refines around the chosen point."
    : "Drag a control point. Drag anywhere else to turn, Shift-drag to move, wheel to come closer.";
}

/** The picture in words. */
export function surfaceSummary({ surface }: EditorState): string {
  const points = netPoints(surface).length;
  const finer = surface.details?.length ?? 0;
  const places = finer === 0 ? "" : `, ${finer} refined ${finer === 1 ? "place" : "places"}`;
  return `A surface with ${points} control points and ${surface.patches} patches${places}. Brackets step from point to point, arrows move the chosen one, Shift with 1, 2, 3 looks from the front, the side, the top.`;
}
