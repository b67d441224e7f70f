import { weightsOf } from "../../kernel/curve/weights.ts";
import { inPage, type Scene } from "../scene.ts";

/** The generators of a control point, standing on the curve where the point acts: as high as it acts strongly. */

/** CSS pixels that stand for a weight of 1. */
const high = 72;

export function drawWeights(scene: Scene): void {
  const { state, palette } = scene;
  if (!state.settings.overlays.weights || state.originalOnly) return;
  const ref = state.selection.points[0] ?? { contour: 0, index: 0 };
  const weights = weightsOf(state.curve, ref);
  if (weights === null) return;
  const context = inPage(scene);
  const scale = high / state.view.zoom;
  context.lineJoin = "round";
  for (const [values, colour, dash] of [[weights.point, palette.point, []], [weights.tangent, palette.cubic, [4, 3]]] as const) {
    if (values === null) continue;
    const path = standing(weights.places, values, weights.closed, scale);
    context.globalAlpha = 0.16;
    context.fillStyle = colour;
    context.fill(path);
    context.globalAlpha = 1;
    context.strokeStyle = colour;
    context.lineWidth = 1.5 / state.view.zoom;
    context.setLineDash(dash.map((length) => length / state.view.zoom));
    context.stroke(path);
    context.setLineDash([]);
  }
}

/** Less is no weight but the rounding of one. */
const least = 1e-7;

/** An area between the curve and what stands on it, for each stretch on which there is anything. */
function standing(places: Float64Array, values: Float64Array, closed: boolean, scale: number): Path2D {
  const path = new Path2D();
  const count = values.length;
  const at = (i: number): readonly [number, number] => {
    const k = closed ? ((i % count) + count) % count : Math.max(0, Math.min(count - 1, i));
    return [places[2 * k] ?? 0, places[2 * k + 1] ?? 0];
  };
  const outside = scale * (turnsRight(places) ? -1 : 1);
  const tip = (i: number): readonly [number, number] => {
    const [[x, y], [a, b], [c, d]] = [at(i), at(i - 1), at(i + 1)];
    const size = Math.hypot(c - a, d - b) || 1;
    const height = outside * (values[((i % count) + count) % count] ?? 0);
    return [x - ((d - b) / size) * height, y + ((c - a) / size) * height];
  };
  const acts = (i: number): boolean => Math.abs(values[((i % count) + count) % count] ?? 0) > least;
  // Round a closed curve from a place where nothing stands, if there is one.
  let from = 0;
  while (closed && from < count && acts(from)) from += 1;
  for (let i = from; i < from + count; i += 1) {
    if (!acts(i)) continue;
    const first = i;
    while (i + 1 < from + count && acts(i + 1)) i += 1;
    path.moveTo(...at(first - 1));
    for (let k = first; k <= i; k += 1) path.lineTo(...tip(k));
    for (let k = i + 1; k >= first; k -= 1) path.lineTo(...at(k));
    path.closePath();
  }
  return path;
}

/** Whether the area is run around clockwise as it is seen, y going down. */
function turnsRight(places: Float64Array): boolean {
  let area = 0;
  for (let i = 0; i < places.length; i += 2) {
    const j = (i + 2) % places.length;
    area += (places[i] ?? 0) * (places[j + 1] ?? 0) - (places[j] ?? 0) * (places[i + 1] ?? 0);
  }
  return area > 0;
}
