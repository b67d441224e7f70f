// Whatever is handed to whichever function: it works, or an ExplineError says which argument is wrong, and nothing has
// changed.

import assert from "node:assert/strict";
import { test } from "node:test";

import * as expline from "expline";
import { ExponentialBSpline, HermiteCurve, HermiteGenerators, InterpolatingCurve, Interpolator, SparseFitter, TensorSurface, traceImage } from "expline";

import { type Valid, tryEverything } from "./any-value.ts";

const PLACES = [0, 0, 4, 0, 4, 4, 0, 4, 1, 2];
const SPLINE = [0, 0, 9, 2, 10, 11, 2, 9, -3, 4];
const NET = Float64Array.from({ length: 75 }, (_, i) => i % 7);
const IMAGE = { width: 4, height: 4, data: new Uint8Array(16) };
const TURN = [0, { re: 0, im: 1 }, { re: 0, im: -1 }];

const hermite = (): HermiteCurve => HermiteCurve.ellipse({ center: [0, 0], radii: [2, 1], count: 4 });
const through = (): InterpolatingCurve => new InterpolatingCurve({ points: SPLINE });
const torus = (): TensorSurface => TensorSurface.torus(3, 1).refineAt(0.5, 0.5);

/** Methods of one object, made afresh for each call where calls change it. */
function methods<T extends object>(name: string, make: () => T, calls: Readonly<Record<string, readonly unknown[]>>): Valid[] {
  const subject = make();
  return Object.entries(calls).map(([method, values]) => ({
    name: `${name}.${method}`,
    run: subject[method as keyof T] as Valid["run"],
    values,
    make: method.startsWith("set") ? make : () => subject,
  }));
}

/** Functions by name. */
function functions(owner: object, name: string, calls: Readonly<Record<string, readonly unknown[]>>): Valid[] {
  return Object.entries(calls).map(([method, values]) => ({ name: `${name}.${method}`, run: (...given) => (owner[method as keyof object] as Valid["run"]).apply(owner, given), values }));
}

/** Constructors by name. */
function constructors(calls: Readonly<Record<string, readonly unknown[]>>): Valid[] {
  return Object.entries(calls).map(([name, values]) => {
    const Made = expline[name as keyof typeof expline] as unknown as new (...given: never[]) => unknown;
    return { name: `new ${name}`, run: (...given: never[]) => new Made(...given), values };
  });
}

/** What every curve can be asked. */
const MEASURES = {
  evaluate: [[0.5, 1], 1, new Float64Array(4)],
  sample: [5, { out: new Float64Array(20), tangents: true }],
  sampleByLength: [5, { tolerance: 0.1 }],
  length: [0.1],
  parameterAtLength: [1, 0.1],
  nearest: [1, 1, 0],
  nearestAll: [[1, 1, 2, 2]],
  curvature: [[0.5, 1]],
  flatten: [0.1],
  toCubics: [0.1],
  toPathD: [{ tolerance: 0.1, decimals: 2, arcs: true, relative: true }],
  asEllipse: [0.1],
} as const;

const kinds: Record<string, () => Valid[]> = {
  "exact curves": () => [
    ...methods("HermiteCurve", hermite, MEASURES),
    ...methods("HermiteCurve", hermite, {
      ...{ setPoint: [1, 2, 3], setTangent: [1, 2, 3, "out"], refine: [2], insert: [0.5], remove: [1], split: [0.5], trim: [0.5, 1.5] },
      ...{ transform: [[1, 0, 0, 1, 2, 3]], subdivide: [2, { arity: 2, scheme: "scalar" }] },
    }),
    ...constructors({
      HermiteCurve: [{ points: PLACES, tangents: PLACES, tangentsIn: PLACES, closed: true, space: "hyperbolic", omega: 1, lengths: [1, 1, 1, 1, 1] }],
      HermiteGenerators: [1, "hyperbolic"],
    }),
    ...functions(HermiteCurve, "HermiteCurve", {
      ellipse: [{ center: [0, 0], radii: [1, 1], rotation: 0, count: 4 }],
      arc: [{ center: [0, 0], radii: [1, 1], rotation: 0, start: 0, sweep: 1 }],
      through: [PLACES, { closed: true, omega: 1, space: "trigonometric" }],
    }),
    ...functions(expline, "expline", {
      ...{ hitTest: [[hermite()], 1, 1, { reach: 2, curveReach: 1, handles: [[0, 1]] }], handlesOf: [hermite(), 1], jointOf: [hermite(), 1], tangentWeights: [hermite(), 0.5] },
      ...{ movePoint: [hermite(), 1, 3, 4], moveHandle: [hermite(), 1, "out", 3, 4, "cusp"], bendCurve: [hermite(), 0.5, 1, 1] },
    }),
    ...methods("HermiteGenerators", () => new HermiteGenerators(1), { evaluate: [[0.5], 1], bernstein: [[0.5], 1], mask: [2, 1], greens: [[0.5]] }),
  ],
  "curves of any roots": () => [
    ...methods("InterpolatingCurve", through, MEASURES),
    ...methods("InterpolatingCurve", through, { refine: [2, { m0: 2, m: 2 }], refineAt: [0.5, { levels: 1, reach: 2 }], setPoint: [1, 2, 3], transform: [[1, 0, 0, 1, 2, 3]], toHermite: [0.1] }),
    ...methods("BSplineCurve", () => through().refine(1), { evaluate: [0.5, 1], refine: [2], reduce: [2], setPoint: [1, 2, 3], nearest: [1, 1] }),
    ...methods("LocalCurve", () => through().refineAt(0.5), { evaluate: [0.5, 1], refineAt: [1.5], patchPoints: [0], setPatchPoint: [0, 1, 2, 3], withoutPatch: [0], transform: [[1, 0, 0, 1, 2, 3]], length: [0.1] }),
    ...constructors({ InterpolatingCurve: [{ points: PLACES, closed: true, roots: TURN }], Interpolator: [TURN], ExponentialBSpline: [[0, 0]] }),
    ...methods("ExponentialBSpline", () => new ExponentialBSpline([0, 0, 0]), { evaluate: [[0.5], 1], refinementFilter: [2, { affine: true }] }),
    ...methods("Interpolator", () => Interpolator.forEllipse(8), { evaluate: [[0.5], 1], preFilter: [2, { affine: true }] }),
    ...functions(expline.roots, "roots", { polynomials: [3], ellipse: [8], harmonics: [8, 2], hyperbola: [1], union: [[0, 0], [0]] }),
    ...functions(Interpolator, "Interpolator", { forEllipse: [8] }),
  ],
  surfaces: () => [
    ...methods("TensorSurface", torus, {
      ...{ evaluate: [[0.5], [0.5], 1, 1], normal: [[0.5], [0.5]], curvature: [[0.5], [0.5]], parameters: [1, 1], mesh: [4, 5], meshCurvature: [4, 5] },
      ...{ refine: [1, 1], refineAt: [0.5, 0.5], patchPoints: [0], setPoint: [1, 1, 1, 2, 3], setPatchPoint: [0, 1, 1, 1, 2, 3], transform: [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1]] },
    }),
    ...methods("TensorSurface", torus, { toObj: [{ name: "a" }], toGltf: [{ name: "a" }] }),
    ...constructors({ TensorSurface: [{ net: NET, u: { roots: TURN, count: 5, closed: true }, v: { roots: TURN, count: 5, closed: true } }] }),
    ...functions(TensorSurface, "TensorSurface", {
      ...{ sphere: [2, [4, 4]], ellipsoid: [[1, 2, 3], [4, 4]], torus: [3, 1, [4, 4]], cylinder: [1, 2, [4, 4]], romanSurface: [1, [6, 6]] },
      ...{ hyperbolicParaboloid: [1, 1, 1, [4, 4]] },
    }),
  ],
  fits: () => [
    {
      name: "fitSparse",
      run: expline.fitSparse,
      values: [
        PLACES,
        {
          ...{ degree: [1, 3], lambda: [1, 1], mix: 0.5, gridSize: 10, norm: "l2", closed: true, corners: true, robust: false, finish: "full", noise: 0.1 },
          ...{ parameters: [0, 1, 2, 3, 4], period: 5, weights: [1, 1, 1, 1, 1], gap: 1e-3, maxIterations: 50, deadline: 1000 },
        },
      ],
    },
    { name: "fitSparse", run: expline.fitSparse, values: [PLACES, { smoothing: 0.5, signal: undefined }] },
    { name: "fitSparseAsync", run: expline.fitSparseAsync, values: [PLACES, { tolerance: 0.5, onProgress: () => undefined }] },
    { name: "fitSparseAll", run: expline.fitSparseAll, values: [[PLACES, PLACES], { noise: 0.1 }] },
    { name: "fitSparseAllAsync", run: expline.fitSparseAllAsync, values: [[PLACES, PLACES], { noise: 0.1 }] },
    { name: "fitSparseAll of none", run: expline.fitSparseAll, values: [[], { closed: true }] },
    ...constructors({ SparseFitter: [PLACES, { degree: 1 }] }),
    ...methods("SparseFitter", () => new SparseFitter(PLACES), { solve: [{ lambda: [0.1, 0.1] }], solveAsync: [{ smoothing: 0.1 }] }),
  ],
  traces: () => [
    {
      name: "traceImage",
      run: traceImage,
      values: [
        IMAGE,
        {
          ...{ source: "brightness", model: "sparse", threshold: "auto", blur: 1, invert: false, speckle: 1, corner: 1, tolerance: 0.5 },
          ...{ refine: true, maxContours: 10, colors: 2 },
        },
      ],
    },
    { name: "traceImage in colours", run: traceImage, values: [IMAGE, { colors: ["#fff", "#000"] }] },
    { name: "traceImageAsync", run: expline.traceImageAsync, values: [IMAGE, { signal: undefined, onProgress: () => undefined }] },
    { name: "evenLight", run: expline.evenLight, values: [IMAGE] },
    ...methods("Trace", () => traceImage(IMAGE), { toSvg: [{ tolerance: 0.1, decimals: 2 }] }),
    ...functions(expline, "expline", {
      quasiInterpolate: [PLACES, { degree: 1, knots: [0, 0, 1, 1], neighbours: 2 }],
      looScore: [PLACES, { degree: 1, knots: [0, 0, 1, 1], neighbours: 2 }],
      fitProfile: [PLACES, { closed: true, degree: 2, corner: 1, method: "mean" }],
    }),
    ...functions(expline.metrics, "metrics", { rmse: [[1, 2]], mae: [[1, 2]], directedHausdorff: [PLACES, PLACES], jaccard: [PLACES, PLACES, { literal: true }] }),
  ],
  "text, data and engines": () => [
    ...functions(expline, "expline", { parsePath: ["M0 0L1 1", { onWarning: () => undefined }], fromJSON: [hermite().toJSON(), { onWarning: () => undefined }] }),
    ...[through().refine(1), through().refineAt(0.5), through(), torus()].map((shape) => ({ name: "fromJSON", run: expline.fromJSON as Valid["run"], values: [shape.toJSON()] })),
    { name: "init", run: expline.default, values: [{}] },
    ...functions(expline, "expline", { initSpline: [{}], initSurface: [{}], initFit: [{}], initTrace: [{}] }),
  ],
};

/** What was called, and how often. */
const names: string[] = [];
let tried = 0;

for (const [kind, calls] of Object.entries(kinds)) {
  test(`${kind}: any value in any place works, or is refused by name and changes nothing`, async () => {
    for (const valid of calls()) {
      names.push(valid.name);
      tried += await tryEverything(valid);
    }
  });
}

test("every function and class of the package was among them", () => {
  const asked = new Set(names.flatMap((name) => name.replace(/^new |^expline\./, "").split(/[ .]/, 1)));
  // Their arguments are those of init; where an engine runs they change nothing.
  const alike = new Set(["ExplineError", "version", "initSync", "initFitSync", "initSplineSync", "initSurfaceSync", "initTraceSync"]);
  const missing = Object.keys(expline).filter((name) => !asked.has(name === "default" ? "init" : name) && !alike.has(name));
  assert.deepEqual(missing, []);
  assert.ok(tried > 20_000, `only ${tried} calls`);
});
