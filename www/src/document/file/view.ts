import { mostAcross, type DemoState, type View } from "../document.ts";
import { workSizes } from "../trace/trace.ts";
import { asNumber, field, type Found } from "./check.ts";

export function readView(found: Found): View {
  return {
    // The largest drawing there can be, 2e9 across, in the smallest window.
    zoom: asNumber(field(found, "zoom"), 1e-9, 1e9),
    x: asNumber(field(found, "x")),
    y: asNumber(field(found, "y")),
  };
}

/** The view of a state, no nearer to what its mode shows than that can be drawn. */
export function drawable({ view, ...state }: DemoState): View {
  const size = sizeOf(state);
  return size * view.zoom > mostAcross ? { ...view, zoom: mostAcross / size } : view;
}

function sizeOf({ mode, curve, fit, trace }: Omit<DemoState, "view">): number {
  if (mode === "curve") return across(curve.contours.flatMap(({ points }) => points));
  if (mode === "fit") return across(fit.data.map(([x, y]) => ({ x, y })));
  const { width, height } = trace.picture ?? trace.kept ?? { width: 0, height: 0 };
  return mode === "trace" ? Math.max(...workSizes, width, height) : 0;
}

/** The longer side of the box around places. */
function across(places: readonly { readonly x: number; readonly y: number }[]): number {
  let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const { x, y } of places) [minX, minY, maxX, maxY] = [Math.min(minX, x), Math.min(minY, y), Math.max(maxX, x), Math.max(maxY, y)];
  return Math.max(0, maxX - minX, maxY - minY);
}
