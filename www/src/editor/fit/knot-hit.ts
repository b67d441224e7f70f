import { toScreen, type ScreenPoint } from "../pointer/camera.ts";
import type { EditorState } from "../editor.ts";
import type { PointerKind } from "../pointer/hit-test.ts";

/** How far from a mark a press still counts, CSS pixels. */
const reach: Readonly<Record<PointerKind, number>> = { mouse: 10, pen: 12, touch: 22 };

/** The knot nearest to a place of the stage, if one is within reach. */
export function knotAt({ fitRun, fitView, view, stage, originalOnly }: EditorState, at: ScreenPoint, kind: PointerKind): number | null {
  if (fitRun.outcome === null || !fitView.overlays.knots || originalOnly) return null;
  let best: number | null = null;
  let least = reach[kind];
  fitRun.outcome.knots.forEach((knot, i) => {
    const { x, y } = toScreen(view, stage, knot);
    const distance = Math.hypot(x - at.x, y - at.y);
    if (distance < least) [best, least] = [i, distance];
  });
  return best;
}
