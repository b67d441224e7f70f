// Interpolating and B-spline curves through the JavaScript interface: the reference's values at every level, measures
// against dense samples, plain data, and what hostile callers get.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import {
  BSplineCurve,
  type BSplineCurveJSON,
  ExponentialBSpline,
  HermiteCurve,
  InterpolatingCurve,
  type InterpolatingCurveJSON,
  Interpolator,
  LocalCurve,
  type LocalCurveJSON,
  type Root,
  fromJSON,
  roots,
} from "expline";

import { type Case, testCases } from "./hostile.ts";

interface Example {
  name: string;
  alpha: [number, number][];
  n0: number;
  M: number;
  m0: number;
  m: number;
  c: number[];
  levels: number[][];
  scale: number[];
  beta_hat0_per_level: number[];
  t: number[];
  f: number[];
}

const examples = (JSON.parse(readFileSync("tests/golden/splines/refinement.json", "utf8")) as { periodic_examples: Example[] }).periodic_examples;
const list = (pairs: [number, number][]): Root[] => pairs.map(([re, im]) => (im === 0 ? re : { re, im }));
const largest = (values: ArrayLike<number>): number => Math.max(...Array.from(values, Math.abs));

/** The same coordinate twice, as a curve of the plane. */
const doubled = (values: readonly number[]): number[] => values.flatMap((value) => [value, value]);

test("curves of the reference have its values and control points at every level, to 2e-13", (t) => {
  let worst = 0;
  for (const c of examples) {
    const curve = new InterpolatingCurve({ points: doubled(c.c), roots: list(c.alpha) });
    const allowed = 2e-13 * largest(c.c);
    const check = (got: number, expected: number, where: string): void => {
      worst = Math.max(worst, Math.abs(got - expected) / allowed);
      assert.ok(Math.abs(got - expected) <= allowed, `${c.name} ${where}: ${got} instead of ${expected}`);
    };
    const at = Float64Array.from(c.t);
    c.f.forEach((value, i) => check(curve.evaluate(at)[2 * i] ?? NaN, value, `t = ${c.t[i]}`));
    c.levels.forEach((level, j) => {
      const fine = curve.refine(j + 1, { m0: c.m0, m: c.m });
      const { points } = fine;
      assert.equal(points.length, 2 * level.length);
      const scale = c.scale[j] ?? NaN;
      // The reference's points are those of B-splines as they are, in the order of the delayed curve.
      const shift = scale * (c.n0 - 1) - Math.floor(c.n0 / 2);
      level.forEach((value, l) => {
        const place = (((l - shift) % level.length) + level.length) % level.length;
        check((points[2 * place] ?? NaN) / (c.beta_hat0_per_level[j] ?? NaN), value, `level ${j}, point ${l}`);
      });
      const refined = fine.evaluate(at);
      c.f.forEach((value, i) => check(refined[2 * i] ?? NaN, value, `level ${j}, t = ${c.t[i]}`));
    });
  }
  t.diagnostic(`worst: ${worst.toFixed(3)} of what is allowed`);
});

/** Five points of no special place, and what is asked of curves through them. */
const POINTS = [0, 0, 7, 1, 9, 6, 3, 8, -2, 5];
const KINDS: [string, () => InterpolatingCurve | BSplineCurve | LocalCurve][] = [
  ["ellipses", () => new InterpolatingCurve({ points: POINTS })],
  ["cubics", () => new InterpolatingCurve({ points: POINTS, roots: roots.polynomials(3) })],
  ["degree 5", () => new InterpolatingCurve({ points: POINTS, roots: roots.polynomials(5) })],
  ["harmonics", () => new InterpolatingCurve({ points: POINTS, roots: roots.harmonics(5, 2) })],
  ["growing", () => new InterpolatingCurve({ points: POINTS, roots: roots.union(roots.ellipse(5), roots.hyperbola(1.5)) })],
  ["open", () => new InterpolatingCurve({ points: POINTS, closed: false })],
  ["refined", () => new InterpolatingCurve({ points: POINTS, roots: roots.harmonics(5, 2) }).refine(2)],
  [
    "patched",
    () => {
      const curve = new InterpolatingCurve({ points: POINTS }).refineAt(1.5, { levels: 3, reach: 0.4 });
      const [x = NaN, y = NaN] = curve.patchPoints(0).slice(4);
      curve.setPatchPoint(0, 2, x + 0.3, y - 0.2);
      return curve;
    },
  ],
];

test("measures of every kind of curve agree with dense samples", () => {
  for (const [name, make] of KINDS) {
    const curve = make();
    const count = 40_001;
    const dense = curve.sample(count);
    const [x, y] = [(i: number): number => dense[2 * (i % count)] ?? NaN, (i: number): number => dense[2 * (i % count) + 1] ?? NaN];
    const edges = curve.closed ? count : count - 1;
    let [length, area] = [0, 0];
    for (let i = 0; i < edges; i += 1) {
      length += Math.hypot(x(i + 1) - x(i), y(i + 1) - y(i));
      area += 0.5 * (x(i) * y(i + 1) - x(i + 1) * y(i));
    }
    assert.ok(Math.abs(curve.length() - length) < 1e-6 * length, `${name}: length ${curve.length()}, ${length}`);
    if (curve.closed) assert.ok(Math.abs(curve.area() - area) < 1e-5 * Math.abs(area), `${name}: area`);
    const bounds = curve.bounds();
    const xs = Array.from({ length: count }, (_, i) => x(i));
    assert.ok(Math.abs(bounds.minX - Math.min(...xs.slice(0, 20_000), ...xs.slice(20_000))) < 1e-6, `${name}: bounds`);
    for (const [px, py] of [[4, 4], [-5, 12], [20, -3], [0.1, 0.2]] as const) {
      const least = Math.sqrt(xs.reduce((best, value, i) => Math.min(best, (value - px) ** 2 + (y(i) - py) ** 2), Infinity));
      const found = curve.nearest(px, py);
      assert.ok(found.distance <= least + 1e-12 && found.distance > least - 1e-4, `${name}: nearest`);
      const at = curve.evaluate(found.t);
      assert.ok(Math.hypot((at[0] ?? NaN) - found.x, (at[1] ?? NaN) - found.y) < 1e-12 * 20, `${name}: t of the nearest point`);
    }
    const { path, maxError } = curve.toCubics(1e-3);
    assert.ok(maxError <= 1e-3 && path.length % 8 === 0, `${name}: cubics`);
    const half = curve.parameterAtLength(0.5 * length);
    assert.ok(half > curve.domain[0] && half < curve.domain[1], `${name}: half way`);
    const { d, maxError: printed } = curve.toPathD({ tolerance: 0.01 });
    assert.ok(printed <= 0.01 && d.startsWith("M"), `${name}: path`);
    const { curve: hermite, maxError: off } = curve.toHermite(1e-6);
    const again = hermite.length();
    assert.ok(off <= 1e-6 && Math.abs(again - curve.length()) < 1e-3, `${name}: as a Hermite curve ${again}`);
  }
});

test("a circle through five points is a circle for every measure", () => {
  const place = (k: number): [number, number] => [3 + 2 * Math.cos((2 * Math.PI * k) / 5), 1 + 2 * Math.sin((2 * Math.PI * k) / 5)];
  const circle = new InterpolatingCurve({ points: [0, 1, 2, 3, 4].map(place) });
  for (const curve of [circle, circle.refine(3)]) {
    assert.ok(Math.abs(curve.length() - 4 * Math.PI) < 1e-12);
    assert.ok(Math.abs(curve.area() - 4 * Math.PI) < 1e-12);
    const ellipse = curve.asEllipse();
    assert.ok(ellipse !== undefined && Math.abs(ellipse.radii[0] - 2) < 1e-12 && Math.abs(ellipse.center[0] - 3) < 1e-12);
    assert.equal(curve.toPathD().d, "M5 1A2 2 0 0 1 1 1 2 2 0 0 1 5 1Z");
    assert.equal(curve.toHermite().maxError, 0);
    curve.curvature(Float64Array.of(0.2, 1.7, 4.4)).forEach((value) => assert.ok(Math.abs(value - 0.5) < 1e-11));
  }
});

test("only what is made of arcs is an ellipse: no cubic is, nor a curve of other roots, whatever the tolerance", () => {
  const points = Array.from({ length: 8 }, (_, k): [number, number] => [5 * Math.cos((Math.PI * k) / 4), 3 * Math.sin((Math.PI * k) / 4)]);
  const ellipse = new InterpolatingCurve({ points });
  const other = new InterpolatingCurve({ points, roots: roots.harmonics(8, 2) });
  assert.ok(ellipse.asEllipse() !== undefined);
  for (const tolerance of [undefined, 1e-3, 1, 1e9]) {
    assert.equal(other.asEllipse(tolerance), undefined);
    assert.equal(other.toHermite(1e-3).curve.asEllipse(tolerance), undefined);
  }
});

test("made of cubics, a curve keeps the parameters of its own segments' ends, and not of what lies between", () => {
  const curve = new InterpolatingCurve({ points: [0, 0, 3, 1, 5, 0, 7, 3, 2, 5], roots: roots.polynomials(5) });
  const { curve: cubics, maxError } = curve.toHermite(1e-3);
  const apart = (t: number): number => Math.hypot(...curve.evaluate(t).map((x, axis) => x - (cubics.evaluate(t)[axis] ?? NaN)));
  assert.ok(maxError > 0 && maxError <= 1e-3);
  for (const t of [0, 1, 2, 3, 4, 5]) assert.ok(apart(t) < 1e-12, `at ${t}`);
  assert.ok(apart(0.75) > 10 * maxError, "the curve is near, but not at the same parameter");
});

test("the way back from B-splines takes those and no other kind of curve", () => {
  const curve = new InterpolatingCurve({ points: [0, 0, 3, 1, 5, 0] });
  for (const other of [curve, curve.refineAt(1), curve.toHermite().curve, {}, undefined]) {
    assert.throws(() => InterpolatingCurve.from(other as never), { code: "E_TYPE", argument: "curve", bound: "BSplineCurve" });
  }
});

test("a point that moves changes n0 − 1 segments to each side and nothing else", () => {
  const points = Array.from({ length: 16 }, (_, k): [number, number] => [Math.cos(k) * (k + 3), Math.sin(2 * k) * 5]);
  const curve = new InterpolatingCurve({ points, roots: roots.polynomials(3) });
  const before = curve.sample(1600);
  curve.setPoint(8, 40, 30);
  assert.deepEqual(curve.evaluate(8), Float64Array.of(40, 30));
  const after = curve.sample(1600);
  for (let i = 0; i < 1600; i += 1) {
    const same = before[2 * i] === after[2 * i] && before[2 * i + 1] === after[2 * i + 1];
    if (Math.abs(i / 100 - 8) >= 3) assert.ok(same, `t = ${i / 100}`);
  }
});

test("refining changes no shape, and reducing brings the points back", () => {
  const curve = new InterpolatingCurve({ points: POINTS, roots: roots.harmonics(5, 2) });
  const dense = curve.sample(400);
  const fine = curve.refine(6);
  fine.sample(400).forEach((value, i) => assert.ok(Math.abs(value - (dense[i] ?? NaN)) < 1e-11));
  const { curve: coarse, maxError } = fine.reduce();
  assert.ok(maxError < 1e-11 && coarse.points.length === fine.points.length / 2);
  const { curve: back, maxError: off } = InterpolatingCurve.from(curve.refine(1));
  assert.ok(off < 1e-12);
  back.points.forEach((value, i) => assert.ok(Math.abs(value - (POINTS[i] ?? NaN)) < 1e-12));
});

test("patches make room without a change, take edits near by, and go with their detail", () => {
  const curve = new InterpolatingCurve({ points: POINTS });
  const at = Float64Array.from({ length: 500 }, (_, i) => i / 100);
  const dense = curve.evaluate(at);
  const local = curve.refineAt(2.5, { levels: 4, reach: 0.25 });
  assert.deepEqual(local.evaluate(at), dense);
  const [x = NaN, y = NaN] = local.patchPoints(0);
  local.setPatchPoint(0, 0, x + 1, y);
  const [moved = NaN] = local.patchPoints(0);
  assert.ok(Math.abs(moved - x - 1) < 1e-12);
  assert.deepEqual(local.evaluate(Float64Array.of(0, 1, 3.5)), curve.evaluate(Float64Array.of(0, 1, 3.5)));
  assert.notDeepEqual(local.evaluate(at), dense);
  assert.deepEqual(local.withoutPatch(0).evaluate(at), dense);
});

test("a reach beyond the curve makes room on all of it, at every level", () => {
  const curve = new InterpolatingCurve({ points: POINTS });
  for (const levels of [1, 6, 12]) {
    const [patch] = curve.refineAt(2.5, { levels, reach: 1e6 }).patches;
    assert.equal(patch?.displacements.length, POINTS.length * 2 ** levels);
  }
  const long = new InterpolatingCurve({ points: Float64Array.from({ length: 10_000 }, (_, i) => Math.sin(i)) });
  for (const reach of [0.1, 1e6]) assert.throws(() => long.refineAt(2.5, { levels: 12, reach }), { code: "E_LIMIT", arg: "levels" });
});

test("curves in space do what they can, and say what they cannot", () => {
  const helix = Array.from({ length: 9 }, (_, k): [number, number, number] => [Math.cos(k / 2), Math.sin(k / 2), k / 4]);
  const curve = new InterpolatingCurve({ points: helix, closed: false, roots: roots.union(roots.polynomials(1), [{ re: 0, im: 0.5 }, { re: 0, im: -0.5 }]) });
  assert.equal(curve.dimension, 3);
  assert.ok(Math.abs(curve.length() - 8 * Math.hypot(0.5, 0.25)) < 1e-9, "a helix has a constant speed");
  const bend = curve.curvature(3.3)[0] ?? NaN;
  assert.ok(Math.abs(bend - 0.25 / (0.25 + 0.0625)) < 1e-9, "and a constant curvature");
  const { t, distance, z } = curve.nearest(0, 0, 1);
  assert.ok(Math.abs(distance - 1) < 1e-9 && Math.abs(t - 4) < 1e-6 && Math.abs((z ?? NaN) - 1) < 1e-6);
  const places: [number, number, number][] = [[0, 0, 1], [2, -1, 0.5], [-3, 0, 7]];
  const all = curve.nearestAll(places);
  places.forEach((place, i) => {
    const { t, x, y, z, distance } = curve.nearest(...place);
    assert.deepEqual([...all.subarray(5 * i, 5 * i + 5)], [t, x, y, z, distance], "many at once are each on its own");
  });
  const { minZ, maxZ } = curve.bounds();
  assert.ok(Math.abs(minZ ?? NaN) < 1e-12 && Math.abs((maxZ ?? NaN) - 2) < 1e-12);
  assert.equal(curve.toCubics(1e-3).path.length % 12, 0);
  assert.equal(curve.flatten(1e-2).length % 3, 0);
  assert.equal(curve.sampleByLength(7).length, 21);
  for (const call of [() => curve.area(), () => curve.toPathD(), () => curve.toHermite()]) {
    assert.throws(call, { name: "ExplineError", code: "E_DEGENERATE", arg: "curve" });
  }
});

test("every kind comes back from JSON to the last bit", () => {
  for (const [name, make] of KINDS) {
    const curve = make();
    const text = JSON.stringify(curve);
    const again = fromJSON(JSON.parse(text) as InterpolatingCurveJSON);
    assert.equal(JSON.stringify(again), text, name);
    assert.deepEqual(again.sample(101), curve.sample(101), name);
    assert.equal(Object.getPrototypeOf(again), Object.getPrototypeOf(curve));
  }
});

/** Hostile values get past the compiler here, as they do in JavaScript. */
const hostile = <T>(value: unknown): T => value as T;
const made = (options: object): InterpolatingCurve => new InterpolatingCurve({ points: POINTS, ...options });
/** A file of a curve with patches. */
const local = (patches: readonly object[]): unknown => ({ ...new LocalCurve({ points: POINTS }).toJSON(), patches });
const file = (change: object): unknown => ({ ...made({}).toJSON(), ...change });
const fine = (): BSplineCurve => made({}).refine(1);
const IM = 1.2;

const cases: Case[] = [
  { id: "SC-001", what: "no points", run: () => made({ points: [] }), refuses: { code: "E_TOO_FEW_POINTS", arg: "points", bound: ">= 3" } },
  { id: "SC-002", what: "two points of a closed curve", run: () => made({ points: [0, 0, 1, 1] }), refuses: { code: "E_TOO_FEW_POINTS", arg: "points" } },
  { id: "SC-003", what: "a NaN", run: () => made({ points: [0, 0, 1, NaN, 2, 2] }), refuses: { code: "E_NOT_FINITE", arg: "points", index: 3 } },
  { id: "SC-004", what: "an odd length", run: () => made({ points: [0, 0, 1, 1, 2] }), refuses: { code: "E_LENGTH", arg: "points" } },
  { id: "SC-005", what: "pairs and triples mixed", run: () => made({ points: [[0, 0, 0], [1, 1], [2, 2, 2]] }), refuses: { code: "E_TYPE", arg: "points", index: 1 } },
  { id: "SC-006", what: "four dimensions", run: () => made({ dimension: 4 }), refuses: { code: "E_RANGE", arg: "dimension" } },
  { id: "SC-007", what: "roots that are no array", run: () => made({ roots: 5 }), refuses: { code: "E_TYPE", arg: "roots" } },
  { id: "SC-008", what: "no roots", run: () => new ExponentialBSpline([]), refuses: { code: "E_TOO_FEW_POINTS", arg: "roots" } },
  { id: "SC-009", what: "a root without its conjugate", run: () => made({ roots: [0, { re: 0, im: IM }, 0] }), refuses: { code: "E_DEGENERATE", arg: "roots", index: 1 } },
  { id: "SC-010", what: "a root without its opposite", run: () => made({ roots: [0, 1, 0] }), refuses: { code: "E_DEGENERATE", arg: "roots", index: 1 } },
  { id: "SC-011", what: "a root that is not a number", run: () => made({ roots: [0, "x", 0] }), refuses: { code: "E_TYPE", arg: "roots", index: 1 } },
  { id: "SC-012", what: "an infinite root", run: () => made({ roots: [0, { re: 0, im: Infinity }, 0] }), refuses: { code: "E_NOT_FINITE", arg: "roots", index: 1 } },
  { id: "SC-013", what: "seventeen roots", run: () => made({ roots: new Array(17).fill(0) }), refuses: { code: "E_LIMIT", arg: "roots", limit: "maxRoots" } },
  { id: "SC-014", what: "frequencies beyond π", run: () => made({ roots: [0, { re: 0, im: 3.5 }, { re: 0, im: -3.5 }] }), refuses: { code: "E_RANGE", arg: "roots" } },
  {
    id: "SC-015",
    what: "the counter-example to the conjecture",
    run: () => new Interpolator([0, 0, { re: 0, im: 8.98681891581812835 }, { re: 0, im: -8.98681891581812835 }], { beyondPi: true }),
    refuses: { code: "E_DEGENERATE", arg: "roots" },
  },
  {
    id: "SC-016",
    what: "the other counter-example",
    run: () => new Interpolator([1, -1].flatMap((re) => [{ re, im: Math.PI }, { re, im: -Math.PI }]), { beyondPi: true }),
    refuses: { code: "E_DEGENERATE", arg: "roots" },
  },
  { id: "SC-017", what: "two roots", run: () => made({ roots: [0, 0] }), refuses: { code: "E_TOO_FEW_POINTS", arg: "roots", bound: ">= 3" } },
  { id: "SC-018", what: "tiny roots", run: () => made({ roots: [0, { re: 0, im: 1e-300 }, { re: 0, im: -1e-300 }] }).evaluate(0.5), gives: () => undefined },
  { id: "SC-019", what: "t of an open curve outside", run: () => made({ closed: false }).evaluate(4.001), refuses: { code: "E_RANGE", arg: "t", bound: "[0, 4]" } },
  { id: "SC-020", what: "t is NaN", run: () => made({}).evaluate(NaN), refuses: { code: "E_NOT_FINITE", arg: "t" } },
  { id: "SC-021", what: "a derivative too many", run: () => made({}).evaluate(0, 3), refuses: { code: "E_RANGE", arg: "derivative", bound: "[0, 2]" } },
  { id: "SC-022", what: "twenty-five levels", run: () => made({}).refine(25), refuses: { code: "E_RANGE", arg: "levels", bound: "[1, 24]" } },
  { id: "SC-023", what: "twenty-four levels", run: () => made({}).refine(24), refuses: { code: "E_LIMIT", limit: "maxOutputPoints" } },
  { id: "SC-024", what: "an odd m0", run: () => made({}).refine(1, { m0: 3 }), refuses: { code: "E_DEGENERATE", arg: "m0" } },
  { id: "SC-025", what: "m of 0", run: () => fine().refine(0), refuses: { code: "E_RANGE", arg: "m" } },
  { id: "SC-026", what: "m of 1 changes nothing", run: () => fine().refine(1).points, gives: (got: Float64Array) => assert.deepEqual(got, fine().points) },
  { id: "SC-027", what: "a reduction that does not divide", run: () => fine().reduce(3), refuses: { code: "E_DEGENERATE", arg: "m" } },
  { id: "SC-028", what: "a step of 0", run: () => new BSplineCurve({ points: POINTS, roots: [0, 0, 0], step: 0 }), refuses: { code: "E_RANGE", arg: "step" } },
  { id: "SC-028a", what: "a million times the points", run: () => fine().refine(1e7), refuses: { code: "E_RANGE", arg: "m", bound: "[1, 1024]" } },
  {
    id: "SC-028b",
    what: "a step below the least",
    run: () => new BSplineCurve({ points: POINTS, roots: [0, 0, 0], step: 1e-12 }).refine(2),
    refuses: { code: "E_RANGE", arg: "m", bound: "[1, 1]" },
  },
  { id: "SC-028c", what: "a grid as coarse as half a turn", run: () => fine().reduce(5), refuses: { code: "E_RANGE", arg: "m", bound: "[1, 4]" } },
  {
    id: "SC-028d",
    what: "JSON with the domain of another curve",
    run: () => fromJSON({ ...fine().toJSON(), domain: [0, 6] }),
    refuses: { code: "E_RANGE", path: "$.domain[1]" },
  },
  {
    id: "SC-028e",
    what: "the end of a refined curve, of its file and of it after an edit",
    run: () => {
      const thirds = made({ closed: false }).refine(6, { m: 3 });
      const again = fromJSON(JSON.parse(JSON.stringify(thirds)) as BSplineCurveJSON);
      again.setPoint(0, 0, 0);
      return [thirds, again].map((curve) => (curve.evaluate(4), curve.domain[1]));
    },
    gives: (got: number[]) => assert.deepEqual(got, [4, 4]),
  },
  { id: "SC-028f", what: "JSON without a domain", run: () => fromJSON(hostile<BSplineCurveJSON>({ ...fine().toJSON(), domain: undefined })).domain, gives: (got: number[]) => assert.deepEqual(got, [0, 5]) },
  { id: "SC-028g", what: "an empty list of roots", run: () => made({ roots: [] }), refuses: { code: "E_TOO_FEW_POINTS", arg: "roots", bound: ">= 3" } },
  { id: "SC-028h", what: "JSON with patches and no roots", run: () => fromJSON({ ...new LocalCurve({ points: POINTS }).toJSON(), roots: [] }), refuses: { code: "E_TOO_FEW_POINTS", path: "$.roots" } },
  { id: "SC-029", what: "an unknown option", run: () => made({ root: [] }), refuses: { code: "E_TYPE", arg: "root" } },
  { id: "SC-030", what: "setPoint beyond the last", run: () => made({}).setPoint(5, 0, 0), refuses: { code: "E_RANGE", arg: "i" } },
  { id: "SC-031", what: "setPoint in space without z", run: () => made({ points: [[0, 0, 0], [1, 1, 1], [2, 0, 1]] }).setPoint(0, 1, 1), refuses: { code: "E_TYPE", arg: "z" } },
  { id: "SC-032", what: "a forged this", run: () => Object.getOwnPropertyDescriptor(BSplineCurve.prototype, "step")?.get?.call({}), refuses: { code: "E_TYPE", arg: "this" } },
  {
    id: "SC-033",
    what: "another kind's method",
    run: () => BSplineCurve.prototype.refine.call(hostile(HermiteCurve.through(POINTS)), 2),
    refuses: { code: "E_TYPE", arg: "this" },
  },
  { id: "SC-034", what: "JSON without roots", run: () => fromJSON(file({ roots: undefined })), refuses: { code: "E_SCHEMA", path: "$.roots" } },
  { id: "SC-035", what: "JSON with a bad root", run: () => fromJSON(file({ roots: [0, { re: 0 }, 0] })), refuses: { code: "E_SCHEMA", path: "$.roots[1].im" } },
  { id: "SC-036", what: "JSON of a newer version", run: () => fromJSON(file({ version: 2 })), refuses: { code: "E_UNSUPPORTED", path: "$.version" } },
  { id: "SC-037", what: "JSON of an unknown type", run: () => fromJSON(file({ type: "NurbsCurve" })), refuses: { code: "E_SCHEMA", path: "$.type" } },
  {
    id: "SC-038",
    what: "a patch of one number too many",
    run: () => new LocalCurve({ points: POINTS, patches: [{ level: 2, first: 0, displacements: [1, 2, 3] }] }),
    refuses: { code: "E_LENGTH", arg: "patches" },
  },
  {
    id: "SC-039",
    what: "a patch on a level that there is not",
    run: () => new LocalCurve({ points: POINTS, patches: [{ level: 13, first: 0, displacements: [1, 2] }] }),
    refuses: { code: "E_RANGE", arg: "patches" },
  },
  {
    id: "SC-039a",
    what: "a patch that begins beyond its grid",
    run: () => fromJSON(local([{ level: 1, first: 0, displacements: [1, 2] }, { level: 1, first: 10, displacements: [1, 2] }])),
    refuses: { code: "E_RANGE", path: "$.patches[1].first", bound: "[0, 9]" },
  },
  {
    id: "SC-039b",
    what: "a patch of more points than its grid has",
    run: () => fromJSON(local([{ level: 1, first: 0, displacements: new Array<number>(22).fill(0) }])),
    refuses: { code: "E_RANGE", path: "$.patches[0].displacements", bound: "[1, 10]" },
  },
  {
    id: "SC-039c",
    what: "a field of a patch that is not known: it would be lost",
    run: () => fromJSON(local([{ level: 1, first: 0, displacements: [1, 2], note: 1 }])),
    refuses: { code: "E_SCHEMA", path: "$.patches[0].note" },
  },
  {
    id: "SC-039d",
    what: "points that are wrong after a patch that was refused",
    run: () => {
      assert.throws(() => fromJSON(local([{ level: 1, first: 10, displacements: [1, 2] }])));
      return made({ roots: [0, 0] });
    },
    refuses: { code: "E_TOO_FEW_POINTS", arg: "roots", bound: ">= 3" },
  },
  { id: "SC-040", what: "room at no place", run: () => made({}).refineAt(NaN), refuses: { code: "E_NOT_FINITE", arg: "t" } },
  { id: "SC-041", what: "a patch that is not there", run: () => made({}).refineAt(1).patchPoints(1), refuses: { code: "E_RANGE", arg: "k" } },
  { id: "SC-042", what: "a million points", run: () => made({ points: new Float64Array(2_000_002) }), refuses: { code: "E_LIMIT", arg: "points", limit: "maxPoints" } },
  { id: "SC-043", what: "all points in one place", run: () => made({ points: new Float64Array(10).fill(3) }).toCubics(0.1), gives: () => undefined },
  { id: "SC-044", what: "the curvature of a point", run: () => made({ points: new Float64Array(10).fill(3) }).curvature(0.5), refuses: { code: "E_DEGENERATE", arg: "t" } },
  { id: "SC-045", what: "measures of a point", run: () => made({ points: new Float64Array(10).fill(3) }).length(), gives: (got: number) => assert.ok(got < 1e-12) },
];

testCases("spline curves", cases);

test("a curve of plain data is of its kind for the compiler, too", () => {
  const spline: BSplineCurve = fromJSON(JSON.parse(JSON.stringify(fine())) as BSplineCurveJSON);
  const patched: LocalCurve = fromJSON(JSON.parse(JSON.stringify(made({}).refineAt(1))) as LocalCurveJSON);
  assert.ok(spline.step === 0.5 && patched.patches.length === 1);
});
