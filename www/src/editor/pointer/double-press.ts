import type { ScreenPoint } from "./camera.ts";
import { distanceBetween } from "../tool.ts";
import type { PointerRecord } from "./pointer-record.ts";

const doubleMs = 400;
const doublePx = 5;

/** Tells the second of two quick presses at one place from a first one. */
export interface DoublePress {
  /** 1 for a press by itself, 2 for the second of two; a third begins anew. */
  clicks(record: PointerRecord): 1 | 2;
  /** A press that became a drag is not the first half of a double-click. */
  dragged(screen: ScreenPoint): void;
  forget(): void;
}

export function createDoublePress(): DoublePress {
  let last: { readonly screen: ScreenPoint; readonly time: number } | null = null;
  const near = (screen: ScreenPoint): boolean => last !== null && distanceBetween(screen, last.screen) <= doublePx;
  return {
    clicks({ screen, time }) {
      const again = last !== null && time - last.time < doubleMs && near(screen);
      last = again ? null : { screen, time };
      return again ? 2 : 1;
    },
    dragged(screen) {
      if (!near(screen)) last = null;
    },
    forget() {
      last = null;
    },
  };
}
