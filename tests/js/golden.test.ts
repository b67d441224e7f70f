// The reference values of the splines, computed with many digits elsewhere, through the JavaScript interface.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { HermiteCurve, HermiteGenerators } from "expline";

/** Relative to the largest value of a case: a few roundings of the formulas, which are not the reference's. */
const VALUE = 4e-15;
const FIRST = 4e-15;
const SECOND = 1e-14;
/** Quadrature and differences of entries; the smallest entry is a hundredth of the largest. */
const GRAM = 3e-14;
/** The bounds are a root of an eigenvalue of differences. */
const RIESZ = 1e-12;
/** Exactness of curves, relative to their size. */
const STAYS = 2e-14;

interface HermiteCase {
  w0: number;
  x: number[];
  phi1: number[];
  phi2: number[];
  dphi1: number[];
  dphi2: number[];
  d2phi1: number[];
  d2phi2: number[];
}
interface CurveCase {
  name: string;
  w0: number;
  points: number[][];
  tangents: number[][];
  t: number[];
  r: number[][];
  dr: number[][];
  d2r: number[][];
}
interface Golden {
  hermite: { cases: HermiteCase[]; curves: CurveCase[] };
  bernstein: { cases: ({ w0: number; x: number[] } & Record<`${"" | "d"}b${0 | 1 | 2 | 3}`, number[]>)[] };
  masks: {
    dyadic: { w0: number; j: number; Hm1: number[][]; Hp1: number[][] }[];
    mary: { m: number; w0: number; j: number; n: number[]; H: number[][][] }[];
  };
  gram: { cases: ({ w0: number; alpha: number; beta: number } & Record<"a" | "b" | "c" | "d" | "e", number>)[] };
}

function golden<K extends keyof Golden>(name: K): Golden[K] {
  return JSON.parse(readFileSync(`tests/golden/splines/${name}.json`, "utf8")) as Golden[K];
}

/** The largest difference, relative to the largest value but at least to 1. */
function worst(got: ArrayLike<number>, expected: readonly number[]): number {
  assert.equal(got.length, expected.length);
  const scale = Math.max(1, ...expected.map(Math.abs));
  return Math.max(0, ...expected.map((value, i) => Math.abs((got[i] ?? NaN) - value))) / scale;
}

/** Keeps the largest deviation of a family of values, and what it was allowed to be. */
function ledger(): { note(family: string, deviation: number, allowed: number, where: string): void; lines(): string[] } {
  const worstOf = new Map<string, { deviation: number; allowed: number; where: string }>();
  return {
    note(family, deviation, allowed, where) {
      assert.ok(deviation <= allowed, `${family} at ${where}: ${deviation} of ${allowed}`);
      const before = worstOf.get(family);
      if (before === undefined || deviation > before.deviation) worstOf.set(family, { deviation, allowed, where });
    },
    lines: () =>
      [...worstOf].map(([family, { deviation, allowed, where }]) => `${family}: worst ${deviation.toExponential(1)} of ${allowed} (${where})`),
  };
}

test("the generators and their two derivatives are the reference's", (t) => {
  const book = ledger();
  for (const c of golden("hermite").cases) {
    const generators = new HermiteGenerators(c.w0);
    const x = Float64Array.from(c.x);
    const orders = [
      [0, VALUE, c.phi1, c.phi2],
      [1, FIRST, c.dphi1, c.dphi2],
      [2, SECOND, c.d2phi1, c.d2phi2],
    ] as const;
    for (const [order, allowed, phi1, phi2] of orders) {
      const got = generators.evaluate(x, order);
      book.note(`phi, derivative ${order}`, Math.max(worst(got.phi1, phi1), worst(got.phi2, phi2)), allowed, `w0 = ${c.w0}`);
    }
  }
  for (const line of book.lines()) t.diagnostic(line);
});

test("curves of the reference have its points and derivatives", (t) => {
  const book = ledger();
  for (const c of golden("hermite").curves) {
    // A curve of space is seen from two sides: its coordinates do not know of one another.
    for (const axes of c.points[0]?.length === 3 ? [[0, 1], [2, 0]] : [[0, 1]]) {
      const seen = (vectors: number[][]): number[] => vectors.flatMap((v) => axes.map((axis) => v[axis] ?? NaN));
      const curve = new HermiteCurve({ points: seen(c.points), tangents: seen(c.tangents), omega: c.w0 });
      const parameters = Float64Array.from(c.t);
      const orders = [
        [0, VALUE, c.r],
        [1, FIRST, c.dr],
        [2, SECOND, c.d2r],
      ] as const;
      for (const [order, allowed, values] of orders) {
        book.note(`curve, derivative ${order}`, worst(curve.evaluate(parameters, order), seen(values)), allowed, c.name);
      }
    }
  }
  for (const line of book.lines()) t.diagnostic(line);
});

test("the Bernstein basis and its derivative are the reference's", (t) => {
  const book = ledger();
  for (const c of golden("bernstein").cases) {
    const generators = new HermiteGenerators(c.w0);
    const x = Float64Array.from(c.x);
    const rows = (names: readonly (keyof typeof c)[]): number[] =>
      c.x.flatMap((_, i) => names.map((name) => (c[name] as number[])[i] ?? NaN));
    book.note("Bernstein", worst(generators.bernstein(x), rows(["b0", "b1", "b2", "b3"])), VALUE, `w0 = ${c.w0}`);
    const slopes = rows(["db0", "db1", "db2", "db3"]);
    book.note("Bernstein, derivative 1", worst(generators.bernstein(x, 1), slopes), FIRST, `w0 = ${c.w0}`);
  }
  for (const line of book.lines()) t.diagnostic(line);
});

test("refinement masks of any arity at any level are the reference's", (t) => {
  const book = ledger();
  const { dyadic, mary } = golden("masks");
  for (const c of dyadic) {
    const mask = new HermiteGenerators(c.w0).mask(2, c.j);
    assert.deepEqual(Array.from(mask.subarray(4, 8), (entry) => entry + 0), [1, 0, 0, 1], "H[0] of an interpolating scheme is the identity");
    const got = [...mask.subarray(0, 4), ...mask.subarray(8, 12)];
    book.note("dyadic masks", worst(got, [...c.Hm1.flat(), ...c.Hp1.flat()]), VALUE, `w0 = ${c.w0}, level ${c.j}`);
  }
  for (const c of mary) {
    assert.deepEqual(c.n, Array.from({ length: 2 * c.m - 1 }, (_, i) => i - c.m + 1));
    const mask = new HermiteGenerators(c.w0).mask(c.m, c.j);
    book.note("masks of other arity", worst(mask, c.H.flat(2)), VALUE, `arity ${c.m}, w0 = ${c.w0}`);
  }
  for (const line of book.lines()) t.diagnostic(line);
});

test("Gram entries and Riesz bounds are the reference's", (t) => {
  const book = ledger();
  for (const c of golden("gram").cases) {
    const generators = new HermiteGenerators(c.w0);
    const gram = generators.gram();
    for (const name of ["a", "b", "c", "d", "e"] as const) {
      book.note("Gram entries", Math.abs(gram[name] / c[name] - 1), GRAM, `${name}, w0 = ${c.w0}`);
    }
    const { lower, upper } = generators.rieszBounds();
    book.note("Riesz bounds", Math.max(Math.abs(lower / c.alpha - 1), Math.abs(upper / c.beta - 1)), RIESZ, `w0 = ${c.w0}`);
  }
  for (const line of book.lines()) t.diagnostic(line);
});

/** The largest relative distance of interleaved points from a circle about the origin. */
function offCircle(points: Float64Array, radius: number): number {
  let off = 0;
  for (let i = 0; i < points.length; i += 2) {
    off = Math.max(off, Math.abs(Math.hypot(points[i] ?? NaN, points[i + 1] ?? NaN) - radius));
  }
  return off / radius;
}

test("a two-point circle of radius 5 is within 2e-15 everywhere", (t) => {
  const circle = HermiteCurve.ellipse({ center: [0, 0], radii: [5, 5], count: 2 });
  const sampled = offCircle(circle.sample(100_003), 5);
  const evaluated = offCircle(circle.evaluate(Float64Array.from({ length: 100_003 }, (_, i) => i / 31)), 5);
  assert.ok(Math.max(sampled, evaluated) <= 2e-15, `${sampled} sampled, ${evaluated} evaluated`);
  t.diagnostic(`worst ${Math.max(sampled, evaluated).toExponential(1)} of 2e-15`);
});

/** Curves of every kind: frequencies, lengths and tangents of their own, open and closed. */
function curves(): HermiteCurve[] {
  const points = [0, 0, 10, 1, 12, 9, 3, 8];
  const tangents = [8, -3, 6, 7, -9, 4, -5, -8];
  const tangentsIn = [8, -3, 4, 9, -9, 4, 7, -8];
  return [
    HermiteCurve.ellipse({ center: [1, 2], radii: [5, 3], rotation: 0.4, count: 3 }),
    new HermiteCurve({ points, tangents, tangentsIn, omega: Float64Array.of(0, 1e-8, 1.5, 3), lengths: [1, 2, 0.5, 1] }),
    new HermiteCurve({ points, tangents, closed: false, space: "hyperbolic", omega: 20 }),
    new HermiteCurve({ points, tangents, closed: false, space: "polynomial" }),
  ];
}

test("refining and inserting leave every curve where it was", (t) => {
  let largest = 0;
  for (const curve of curves()) {
    const [, end] = curve.domain;
    const parameters = Float64Array.from({ length: 997 }, (_, i) => (end * i) / 997);
    const before = curve.evaluate(parameters);
    const size = Math.max(...before.map(Math.abs));
    let refined = curve;
    for (const arity of [2, 3, 5, 2]) refined = refined.refine(arity);
    let inserted = curve;
    for (const share of [0.1, 0.5, 0.77, 0.012]) inserted = inserted.insert(share * end);
    assert.equal(inserted.points.length, curve.points.length + 8);
    for (const after of [refined.evaluate(parameters), inserted.evaluate(parameters)]) {
      const off = Math.max(...after.map((value, i) => Math.abs(value - (before[i] ?? NaN)))) / size;
      assert.ok(off <= STAYS, `moved by ${off}`);
      largest = Math.max(largest, off);
    }
  }
  t.diagnostic(`worst ${largest.toExponential(1)} of ${STAYS}`);
});

test("the polygons of both subdivision schemes end on the curve", (t) => {
  let largest = 0;
  for (const curve of curves()) {
    const polygon = curve.subdivide(8);
    const size = Math.max(...polygon.map(Math.abs));
    const found = curve.nearestAll(polygon.slice(0, 2000));
    for (let i = 3; i < found.length; i += 4) largest = Math.max(largest, (found[i] ?? NaN) / size);
  }
  assert.ok(largest <= STAYS, `${largest}`);
  t.diagnostic(`hermite: worst ${largest.toExponential(1)} of ${STAYS}`);
  const [circle] = curves();
  const distance = (levels: number): number => {
    const found = circle?.nearestAll(circle.subdivide(levels, { scheme: "scalar" })) ?? new Float64Array();
    return Math.max(...found.filter((_, i) => i % 4 === 3));
  };
  // The scalar scheme's points approach the curve by a factor of 4 a level.
  assert.ok(distance(6) < distance(4) / 15, `${distance(4)} at level 4, ${distance(6)} at level 6`);
});
