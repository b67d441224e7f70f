import type { NetRef } from "../../document/surface/surface.ts";
import { netPoints } from "../../kernel/surface/surface-mesh.ts";
import type { ScreenPoint } from "../pointer/camera.ts";
import type { EditorState } from "../editor.ts";
import type { PointerKind } from "../pointer/hit-test.ts";
import { projector } from "./orbit.ts";
import { facesAway } from "./surface-edits.ts";

const reachOf: Readonly<Record<PointerKind, number>> = { mouse: 10, pen: 12, touch: 22 };

/** The control point under a place of the screen: the nearest that faces the eye, else the nearest behind. */
export function netHit(state: EditorState, at: ScreenPoint, kind: PointerKind): NetRef | null {
  const { surface, solid, stage } = state;
  if (!solid.handles) return null;
  const project = projector(solid.orbit, stage);
  let best: { readonly ref: NetRef; readonly distance: number; readonly away: boolean; readonly depth: number } | null = null;
  for (const point of netPoints(surface)) {
    const place = project(point.at);
    const distance = Math.hypot(place.x - at.x, place.y - at.y);
    if (distance > reachOf[kind] || place.depth <= 0) continue;
    const found = { ref: point.ref, distance, away: facesAway(solid.orbit, point), depth: place.depth };
    if (best === null || isBefore(found, best)) best = found;
  }
  return best?.ref ?? null;
}

interface Found {
  readonly distance: number;
  readonly away: boolean;
  readonly depth: number;
}

function isBefore(a: Found, b: Found): boolean {
  if (a.away !== b.away) return !a.away;
  // Two that cannot be told apart on the screen: the one in front.
  return Math.abs(a.distance - b.distance) < 1 ? a.depth < b.depth : a.distance < b.distance;
}
