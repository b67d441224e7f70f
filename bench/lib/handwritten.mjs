// What a careful JavaScript programmer writes without a library: typed arrays, no allocation, one pass.

import { SEGMENTS, cubics } from "./curve.mjs";

/** Bernstein weights, or those of the derivative, at `each` uniform places: one table that every segment shares. */
function table(each, weights) {
  const out = new Float64Array(4 * each);
  for (let k = 0; k < each; k++) out.set(weights(k / each), 4 * k);
  return out;
}

const values = (t) => [(1 - t) ** 3, 3 * (1 - t) ** 2 * t, 3 * (1 - t) * t * t, t ** 3];
const slopes = (t) => [-3 * (1 - t) ** 2, 3 * (1 - t) ** 2 - 6 * (1 - t) * t, 6 * (1 - t) * t - 3 * t * t, 3 * t * t];

/** A function that fills `out` with `count` points. */
export function evaluator(count) {
  const weights = table(count / SEGMENTS, values);
  return (out) => {
    let o = 0;
    for (let s = 0; s < 8 * SEGMENTS; s += 8) {
      const x0 = cubics[s];
      const y0 = cubics[s + 1];
      const x1 = cubics[s + 2];
      const y1 = cubics[s + 3];
      const x2 = cubics[s + 4];
      const y2 = cubics[s + 5];
      const x3 = cubics[s + 6];
      const y3 = cubics[s + 7];
      for (let k = 0; k < weights.length; k += 4) {
        const a = weights[k];
        const b = weights[k + 1];
        const c = weights[k + 2];
        const d = weights[k + 3];
        out[o] = a * x0 + b * x1 + c * x2 + d * x3;
        out[o + 1] = a * y0 + b * y1 + c * y2 + d * y3;
        o += 2;
      }
    }
    return out;
  };
}

/** The same without a table: the power form by Horner's rule. */
export function hornerEvaluator(count) {
  const each = count / SEGMENTS;
  return (out) => {
    let o = 0;
    for (let s = 0; s < 8 * SEGMENTS; s += 8) {
      const x0 = cubics[s];
      const y0 = cubics[s + 1];
      const bx = 3 * (cubics[s + 2] - x0);
      const by = 3 * (cubics[s + 3] - y0);
      const cx = 3 * (x0 - 2 * cubics[s + 2] + cubics[s + 4]);
      const cy = 3 * (y0 - 2 * cubics[s + 3] + cubics[s + 5]);
      const dx = cubics[s + 6] - x0 - bx - cx;
      const dy = cubics[s + 7] - y0 - by - cy;
      for (let k = 0; k < each; k++) {
        const t = k / each;
        out[o] = x0 + t * (bx + t * (cx + t * dx));
        out[o + 1] = y0 + t * (by + t * (cy + t * dy));
        o += 2;
      }
    }
    return out;
  };
}

/** A function that fills `out` with x, y, dx, dy of `count` points. */
export function tangentEvaluator(count) {
  const weights = table(count / SEGMENTS, values);
  const rates = table(count / SEGMENTS, slopes);
  return (out) => {
    let o = 0;
    for (let s = 0; s < 8 * SEGMENTS; s += 8) {
      const x0 = cubics[s];
      const y0 = cubics[s + 1];
      const x1 = cubics[s + 2];
      const y1 = cubics[s + 3];
      const x2 = cubics[s + 4];
      const y2 = cubics[s + 5];
      const x3 = cubics[s + 6];
      const y3 = cubics[s + 7];
      for (let k = 0; k < weights.length; k += 4) {
        const a = weights[k];
        const b = weights[k + 1];
        const c = weights[k + 2];
        const d = weights[k + 3];
        out[o] = a * x0 + b * x1 + c * x2 + d * x3;
        out[o + 1] = a * y0 + b * y1 + c * y2 + d * y3;
        const e = rates[k];
        const f = rates[k + 1];
        const g = rates[k + 2];
        const h = rates[k + 3];
        out[o + 2] = e * x0 + f * x1 + g * x2 + h * x3;
        out[o + 3] = e * y0 + f * y1 + g * y2 + h * y3;
        o += 4;
      }
    }
    return out;
  };
}
