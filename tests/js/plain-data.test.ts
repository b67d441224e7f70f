// Curves keep what they are made of to themselves. What the README says to send to a worker, and to compare in a test,
// is all of it.

import assert from "node:assert/strict";
import { test } from "node:test";

import { HermiteCurve, InterpolatingCurve, TensorSurface, fitSparse, fromJSON, traceImage } from "expline";

const circle = (radius: number): HermiteCurve => HermiteCurve.ellipse({ center: [0, 0], radii: [radius, radius], count: 4 });
const noisy = Float64Array.from({ length: 400 }, (_, i) => (i % 2 ? Math.sin : Math.cos)(i / 62) * 80 + Math.sin(97 * i));
const ring = Uint8Array.from({ length: 4096 }, (_, i) => Math.min(255, 255 * Math.abs(Math.hypot((i % 64) - 31.5, (i >> 6) - 31.5) - 18) * 0.2));

test("a curve and a surface cross as their toJSON, to the last bit", () => {
  for (const thing of [circle(0.1), new InterpolatingCurve({ points: [0, 0, 9, 1, 5, 7] }), TensorSurface.torus(3, 1)]) {
    const read: { toJSON(): object } = fromJSON(structuredClone(thing.toJSON()));
    assert.equal(read.constructor, thing.constructor);
    assert.deepStrictEqual(read.toJSON(), thing.toJSON());
  }
});

test("a fit crosses whole once its curve is plain data", () => {
  const fit = fitSparse(noisy, { smoothing: 0.4, robust: true });
  const plain = { ...fit, curve: fit.curve.toJSON(), parts: fit.parts.map((part) => part.toJSON()) };
  const sent = structuredClone(plain);
  assert.deepStrictEqual(sent, plain);
  for (const [there, here] of [[sent.curve, fit.curve], [sent.parts[0], fit.parts[0]]] as const) assert.deepStrictEqual(fromJSON(there).toJSON(), here?.toJSON());
});

test("the contours of a trace cross whole once their curves are plain data", () => {
  const { contours } = traceImage({ width: 64, height: 64, data: ring });
  assert.ok(contours.length > 0);
  const sent = structuredClone(contours.map((contour) => ({ ...contour, curve: contour.curve.toJSON() })));
  sent.forEach((contour, i) => {
    assert.deepStrictEqual({ ...contour, curve: undefined }, { ...contours[i], curve: undefined });
    assert.deepStrictEqual(fromJSON(contour.curve).toJSON(), contours[i]?.curve.toJSON());
  });
});

test("what toJSON gives tells curves apart, and is the same for the same curve", () => {
  assert.deepStrictEqual(circle(5).toJSON(), circle(5).toJSON());
  assert.notDeepStrictEqual(circle(5).toJSON(), circle(7).toJSON());
  for (const lengths of [[1, 1, 1], [2, 2, 2], [1, 2, 1.5], 1, 0.5]) {
    const curve = new HermiteCurve({ points: [0, 0, 9, 0, 9, 9], tangents: [3, 0, 0, 3, 1, 1], lengths });
    assert.deepStrictEqual(curve.reverse().reverse().toJSON(), curve.toJSON(), `lengths ${String(lengths)}`);
    const { points, tangents } = curve;
    const same = new HermiteCurve({ points, tangents, tangentsIn: tangents, lengths });
    assert.deepStrictEqual(same.toJSON(), curve.toJSON(), "tangents that arrive as they leave are said once");
    same.setTangent(1, 5, 6, "in");
    assert.deepStrictEqual(fromJSON(same.toJSON()).tangentsIn, same.tangentsIn);
  }
});

/**
 * As stores show their state: plain objects and arrays through proxies, or frozen; instances of classes and typed
 * arrays as they are.
 */
function shownBy<T>(store: <O extends object>(plain: O) => O, value: T): T {
  if (typeof value !== "object" || value === null) return value;
  const plain = Array.isArray(value) || Object.getPrototypeOf(value) === Object.prototype;
  if (!plain) return value;
  for (const [name, inside] of Object.entries(value)) (value as Record<string, unknown>)[name] = shownBy(store, inside);
  return store(value);
}

for (const [name, store] of [
  ["frozen", Object.freeze],
  ["shown through proxies", <O extends object>(plain: O): O => new Proxy(plain, {})],
] as const) {
  test(`what a store holds works where it is ${name}`, () => {
    const made = () => ({
      ...{ points: Array.from({ length: 40 }, (_, i) => [Math.cos(i / 6) * 40, Math.sin(i / 6) * 40]), options: { tolerance: 1, closed: true, degree: [1, 3] as [number, number] } },
      ...{ image: { width: 64, height: 64, data: ring }, circle: circle(5), json: circle(5).toJSON() },
    });
    const [own, state] = [made(), shownBy(store, made())];
    assert.deepStrictEqual(fitSparse(state.points, state.options).curve.toJSON(), fitSparse(own.points, own.options).curve.toJSON());
    const trace = shownBy(store, { ...traceImage(state.image) });
    assert.equal(trace.toSvg(), traceImage(own.image).toSvg());
    assert.deepStrictEqual(trace.contours[0]?.curve.toJSON(), traceImage(own.image).contours[0]?.curve.toJSON());
    assert.deepStrictEqual(fromJSON(state.json).toJSON(), own.circle.toJSON());
    state.circle.setPoint(0, 6, 0);
    assert.equal(state.circle.points[0], 6);
  });
}
