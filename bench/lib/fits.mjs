// Rows about fits: the sparse problem at the sizes of a logo and of a scan, and noisy points whose truth is known.

import fitCurve from "fit-curve";
import simplify from "simplify-js";

import { here } from "./harness.mjs";
import { normal, outline, random } from "./outlines.mjs";
import { paper } from "./peers.mjs";

/** λ for a detail of so many points: size · (ℓ/2π)^(degree + 1). */
const lambdaOf = (degree, detail) => 400 * (detail / (2 * Math.PI)) ** (degree + 1);

const summary = (fit) => `${fit.knots.length} knots, gap ${fit.gap.toExponential(0)}, ${fit.iterations} iterations`;

/** What solvers of cones in general and of the paper make of the same problem, natively. */
const RIVALS = [
  ["expline, native, to 1e-6", "expline"],
  ["ADMM, native, to 1e-3 or 4000 its", "admm"],
  ["Clarabel 0.11.1, native", "clarabel"],
];

/**
 * One fit from nothing, and steps of the slider. `splines` are [degree, places for knots] each, `detail` how many
 * points long what is kept is; `rivals` says whether other solvers have a go.
 */
function sized(count, splines, detail, [cold, warm], rivals) {
  const degrees = splines.map(([degree]) => degree).join(" + ");
  const title = `sparse fit, degree ${degrees}, ${count} points, ${splines.map(([, size]) => size).join(" + ")} places for knots`;
  const prepare = ({ expline, native }) => {
    const points = outline(count);
    const lambdas = splines.map(([degree], i) => lambdaOf(degree, detail / (i < splines.length - 1 ? 3.3 : 1)));
    const one = splines.length === 1;
    const options = {
      degree: one ? splines[0][0] : splines.map(([degree]) => degree),
      gridSize: splines[0][1],
      finish: "none",
      parameters: Float64Array.from({ length: count }, (_, i) => i),
      period: count,
    };
    const asked = (factor) => (one ? lambdas[0] * factor : lambdas.map((lambda) => lambda * factor));
    const slider = new expline.SparseFitter(points, { ...options, lambda: asked(1), gap: 1e-3 });
    slider.solve({ lambda: asked(1) });
    if (rivals) native.sparse([splines.length, ...splines.flatMap(([degree, size], i) => [degree, lambdas[i], size]), ...points]);
    let factor = 1;
    let result;
    const row = (name, action) => ({ name, measure: here(() => (result = action())), units: 1, note: () => summary(result) });
    const first = `expline, wasm, from nothing to 1e-6`;
    const step = `expline, wasm, λ × 1.05 to 1e-3`;
    const solver = ([name, own]) => {
      const excess = () => native.answer(`sparse:${own}`);
      const note = () => `objective ${excess().toExponential(0)} of it above the optimum`;
      return { name, measure: native.measure(`sparse:${own}`), units: 1, note };
    };
    return {
      unit: "fit",
      contestants: [
        row(first, () => expline.fitSparse(points, { ...options, lambda: asked(1), gap: 1e-6 })),
        row(step, () => slider.solve({ lambda: asked((factor = factor > 1.6 ? 1 : factor * 1.05)) })),
        ...(rivals ? RIVALS.map(solver) : []),
      ],
      targets: rivals ? [["Clarabel 0.11.1, native", 10]] : [],
      limits: [...(cold === undefined ? [] : [[first, cold]]), [step, warm]],
    };
  };
  return [title, prepare];
}

/** Points evenly along 14 cubics round a circle of 200, noise of deviation 1; distances to the curve without noise. */
function truth(expline, count) {
  const knots = Float64Array.from({ length: 28 }, (_, i) => {
    const angle = (2 * Math.PI * (i >> 1)) / 14;
    const radius = 200 + 40 * Math.sin(3.7 * (i >> 1));
    return 250 + radius * (i % 2 === 0 ? Math.cos(angle) : Math.sin(angle));
  });
  const curve = expline.HermiteCurve.through(knots, { space: "polynomial", omega: 0 });
  const next = random(7);
  return { curve, points: Float64Array.from(curve.sampleByLength(count), (value) => value + normal(next)) };
}

/** Root mean square distance from a curve's own places to the truth. */
function rms(curve, places) {
  const all = curve.nearestAll(places);
  let sum = 0;
  for (let i = 3; i < all.length; i += 4) sum += all[i] ** 2;
  return Math.sqrt(sum / (all.length / 4));
}

function noisy({ expline }) {
  const { curve, points } = truth(expline, 1000);
  const pairs = Array.from({ length: 1000 }, (_, i) => [points[2 * i], points[2 * i + 1]]);
  const xy = pairs.map(([x, y]) => ({ x, y }));
  const closedPairs = [...pairs, pairs[0]];
  let fit;
  let beziers;
  let path;
  let polyline;
  const dense = (segments) => Float64Array.from(segments.flatMap(([a, b, c, d]) => Array.from({ length: 20 }, (_, k) => {
    const t = k / 20;
    return [0, 1].map((i) => (1 - t) ** 3 * a[i] + 3 * (1 - t) ** 2 * t * b[i] + 3 * (1 - t) * t * t * c[i] + t ** 3 * d[i]);
  }).flat()));
  const row = (name, action, note) => ({ name, measure: here(action), units: 1, note });
  const near = (places) => `rms to the truth ${rms(curve, places).toFixed(3)}`;
  const corners = () => Float64Array.from(polyline.flatMap(({ x, y }) => [x, y]));
  const ours = "expline, wasm, no σ given";
  return {
    unit: "fit",
    contestants: [
      row(
        ours,
        () => (fit = expline.fitSparse(points, { degree: 3 })),
        () => `${fit.curve.lengths.length} segments, ${near(fit.curve.sample(4000))}`,
      ),
      row(
        "fit-curve, error 9",
        () => (beziers = fitCurve(closedPairs, 9)),
        () => `${beziers.length} segments, ${near(dense(beziers))}`,
      ),
      row("paper's simplify, tolerance 2.5", () => {
        path = new paper.Path({ segments: pairs, closed: true, insert: false });
        path.simplify(2.5);
      }, () => {
        const places = Float64Array.from({ length: 4000 }, (_, i) => path.getPointAt((path.length * (i >> 1)) / 2000)[i % 2 === 0 ? "x" : "y"]);
        return `${path.segments.length} segments, ${near(places)}`;
      }),
      row(
        "simplify-js, tolerance 2.5",
        () => (polyline = simplify(xy, 2.5, true)),
        () => `${polyline.length} lines, ${near(corners())} at its points`,
      ),
    ],
    targets: [],
    limits: [[ours, 8]],
    recorded: [
      ["scipy's splprep, σ given, Python", "4.4 ms", "35 segments, rms to the truth 0.264"],
      ["scipy's make_splprep, σ given, Python", "13 ms", "35 segments, rms to the truth 0.264"],
      ["kurbo's fit_to_bezpath, 3.5, native", "15 ms", "420 segments, rms to the truth 0.641"],
      ["kurbo's fit_to_bezpath_opt, 3.5, native", "4.6 s", "183 segments, rms to the truth 0.687"],
      ["least squares, knots and parameters known", "", "14 segments, rms to the truth 0.184"],
    ],
  };
}

function many({ expline }) {
  const { curve, points } = truth(expline, 10_000);
  let fit;
  const ours = "expline, wasm, tolerance 5";
  return {
    unit: "fit",
    contestants: [
      {
        name: ours,
        units: 1,
        measure: here(() => (fit = expline.fitSparse(points, { degree: 3, tolerance: 5 }))),
        note: () => {
          const near = rms(curve, fit.curve.sample(4000)).toFixed(3);
          return `${fit.curve.lengths.length} segments, proved within ${fit.maxError.toFixed(2)}, rms to the truth ${near}`;
        },
      },
    ],
    targets: [],
    limits: [[ours, 15]],
  };
}

/** Titles and what makes the contestants. */
export const fitRows = [
  sized(500, [[1, 500]], 500 / 60, [5, 1], true),
  sized(500, [[3, 500]], 500 / 60, [20, 1], true),
  sized(2700, [[1, 2700]], 45, [10, 3], true),
  sized(2700, [[3, 1350]], 45, [20, 5], true),
  sized(600, [[1, 300], [3, 300]], 30, [undefined, 12], true),
  sized(2700, [[1, 1350], [3, 1350]], 45, [undefined, 60], true),
  // The largest λ that is allowed is a detail of some 1400 points.
  sized(100_000, [[3, 2000]], 1200, [60, 10], false),
  ["noisy points, 1000 of them, on 14 cubics", noisy],
  ["noisy points, 10 000 of them, within a tolerance", many],
];
