// The reference values of exponential B-splines and interpolators, through the JavaScript interface.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { ExponentialBSpline, Interpolator, type Root, roots } from "expline";

type Pairs = readonly (readonly [number, number])[];
interface SplineCase {
  name: string;
  alpha: Pairs;
  t: number[];
  /** Values, then each derivative. */
  d: number[][];
}
interface InterpolatorCase {
  name: string;
  alpha: Pairs;
  lam: number[];
  t: number[];
  d: number[][];
  riesz: [number, number];
  beta_riesz: [number, number];
  lebesgue: number;
}
interface Refinement {
  filters: { name: string; alpha: Pairs; m: number; h: number[] }[];
  prefilters: { name: string; alpha: Pairs; m0: number; g: number[] }[];
}

function golden(name: string): unknown {
  return JSON.parse(readFileSync(`tests/golden/splines/${name}.json`, "utf8"));
}

const list = (pairs: Pairs): Root[] => pairs.map(([re, im]) => (im === 0 ? re : { re, im }));
const largest = (values: ArrayLike<number>): number => Math.max(...Array.from(values, Math.abs));
const interpolator = ({ alpha }: { alpha: Pairs }): Interpolator =>
  new Interpolator(list(alpha), { beyondPi: alpha.some(([, im]) => Math.abs(im) >= Math.PI) });

function near(got: ArrayLike<number>, expected: readonly number[], allowed: number, where: string): number {
  assert.equal(got.length, expected.length, where);
  let worst = 0;
  expected.forEach((value, i) => {
    const off = Math.abs((got[i] ?? NaN) - value);
    assert.ok(off <= allowed, `${where} [${i}]: ${got[i]} is ${off} from ${value}, allowed ${allowed}`);
    worst = Math.max(worst, off / allowed);
  });
  return worst;
}

test("exponential B-splines and their derivatives are the reference's to 2e-13 of the largest", (t) => {
  let worst = 0;
  for (const c of (golden("exponential_bsplines") as { cases: SplineCase[] }).cases) {
    const spline = new ExponentialBSpline(list(c.alpha));
    assert.equal(spline.order, c.alpha.length);
    const x = Float64Array.from(c.t, (value) => value - c.alpha.length / 2);
    c.d.forEach((expected, order) => {
      worst = Math.max(worst, near(spline.evaluate(x, order), expected, 2e-13 * largest(expected), `${c.name} ${order}`));
    });
  }
  t.diagnostic(`worst: ${worst.toFixed(3)} of what is allowed`);
});

test("interpolators have the reference's λ, values, Riesz bounds and Lebesgue constants", (t) => {
  const worst = { lambda: 0, phi: 0, riesz: 0 };
  for (const c of (golden("interpolators") as { cases: InterpolatorCase[] }).cases) {
    const generator = interpolator(c);
    const sum = 1 + 2 * c.lam.reduce((total, value) => total + Math.abs(value), 0);
    const lambda = near(generator.lambda, c.lam, 1e-12 * largest(c.lam), `${c.name} λ`);
    const [phi = NaN] = c.d.map((expected, order) => {
      const allowed = 1e-13 * sum * Math.max(1, largest(expected));
      return near(generator.evaluate(Float64Array.from(c.t), order), expected, allowed, `${c.name} φ ${order}`);
    });
    const { lower, upper } = generator.rieszBounds();
    const riesz = near([lower, upper], c.riesz, 1e-11 * c.riesz[1], `${c.name} Riesz`);
    worst.lambda = Math.max(worst.lambda, lambda);
    worst.phi = Math.max(worst.phi, phi);
    worst.riesz = Math.max(worst.riesz, riesz);
    const spline = new ExponentialBSpline(generator.roots).rieszBounds();
    near([spline.lower, spline.upper], c.beta_riesz, 1e-11 * c.beta_riesz[1], `${c.name} β`);
    // The reference looked at 40 places only.
    assert.ok(generator.lebesgue >= c.lebesgue - 1e-12 && generator.lebesgue < 1.01 * c.lebesgue, c.name);
  }
  t.diagnostic(`worst shares of what is allowed: ${JSON.stringify(worst)}`);
});

test("filters are the reference's to 2e-14 of the largest tap", () => {
  const { filters, prefilters } = golden("refinement") as Refinement;
  for (const c of filters) {
    const taps = new ExponentialBSpline(list(c.alpha)).refinementFilter(c.m);
    near(taps, c.h, 2e-14 * largest(c.h), `${c.name} h, m = ${c.m}`);
  }
  for (const c of prefilters) {
    near(interpolator(c).preFilter(c.m0), c.g, 2e-14 * largest(c.g), `${c.name} g, m0 = ${c.m0}`);
  }
});

test("lists of roots by what they keep", () => {
  assert.deepEqual(roots.polynomials(3), [0, 0, 0, 0]);
  const im = (2 * Math.PI) / 5;
  assert.deepEqual(roots.ellipse(5), [0, { re: 0, im }, { re: 0, im: -im }]);
  assert.equal(roots.harmonics(9, 3).length, 7);
  assert.deepEqual(roots.hyperbola(0.5), [0, 0.5, -0.5]);
  assert.deepEqual(roots.union(roots.polynomials(1), roots.hyperbola(1)), [0, 0, 1, -1]);
  assert.deepEqual(Interpolator.forEllipse(5).roots, roots.ellipse(5));
});
