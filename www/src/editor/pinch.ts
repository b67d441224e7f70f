import { clampZoom, panned, toPage, type ScreenPoint, type StageBox } from "./camera.ts";
import type { View } from "../document/document.ts";
import { distanceBetween } from "./tool.ts";

/** Two fingers: pinch and pan, with a dead zone so that a tap with two fingers is never a zoom. */

export interface Pinch {
  /** The view for where the fingers are now; the same view while they are inside the dead zone. */
  update(a: ScreenPoint, b: ScreenPoint): View;
  /** Whether the fingers have left the dead zone. */
  readonly moved: boolean;
}

const deadPixels = 8;
const deadRatio = 0.03;

export function createPinch(view: View, stage: StageBox, a: ScreenPoint, b: ScreenPoint): Pinch {
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
      if (!moved) return view;
      const zoom = clampZoom(view.zoom * ratio);
      // The document point first under the fingers' middle stays under it.
      const page = toPage(view, stage, startCentre);
      const centred = { zoom, x: page.x - (startCentre.x - stage.width / 2) / zoom, y: page.y - (startCentre.y - stage.height / 2) / zoom };
      return panned(centred, centre.x - startCentre.x, centre.y - startCentre.y);
    },
  };
}

function middle(a: ScreenPoint, b: ScreenPoint): ScreenPoint {
  return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
}
