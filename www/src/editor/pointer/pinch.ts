import { panned, zoomedAt, type ScreenPoint, type StageBox } from "./camera.ts";
import type { Box } from "../../document/artboard.ts";
import type { View } from "../../document/document.ts";
import type { EditorPatch } from "../state.ts";
import { distanceBetween } from "../tool.ts";

/** Two fingers: pinch and pan, with a dead zone so that a tap with two fingers is never a zoom. */

export interface Pinch {
  /** The view for where the fingers are now; none while they are inside the dead zone. */
  update(a: ScreenPoint, b: ScreenPoint): EditorPatch;
  /** Whether the fingers have left the dead zone. */
  readonly moved: boolean;
}

const deadPixels = 8;
const deadRatio = 0.03;

/** What two fingers have done since they came down. */
export interface Spread {
  readonly ratio: number;
  /** Way of their middle, CSS pixels. */
  readonly dx: number;
  readonly dy: number;
  /** Where their middle was. */
  readonly centre: ScreenPoint;
}

/** Two fingers whose way `look` turns into a view. */
export function trackPinch(a: ScreenPoint, b: ScreenPoint, look: (spread: Spread) => EditorPatch): Pinch {
  const startCentre = middle(a, b);
  const startSpread = Math.max(1, distanceBetween(a, b));
  let moved = false;
  return {
    get moved() {
      return moved;
    },
    update(nowA, nowB) {
      const centre = middle(nowA, nowB);
      const ratio = distanceBetween(nowA, nowB) / startSpread;
      moved ||= distanceBetween(centre, startCentre) > deadPixels || Math.abs(ratio - 1) > deadRatio;
      return moved ? look({ ratio, dx: centre.x - startCentre.x, dy: centre.y - startCentre.y, centre: startCentre }) : {};
    },
  };
}

/** The plane's own pinch. */
export function createPinch(view: View, stage: StageBox, box: Box | null, a: ScreenPoint, b: ScreenPoint): Pinch {
  return trackPinch(a, b, ({ ratio, dx, dy, centre }) => {
    // The document point first under the fingers' middle stays under it.
    return { view: panned(zoomedAt(view, stage, centre, view.zoom * ratio, box), dx, dy) };
  });
}

function middle(a: ScreenPoint, b: ScreenPoint): ScreenPoint {
  return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
}
