// Hostile input to curves: evaluation, refinement, approximation.

import assert from "node:assert/strict";

import { type ErrorDetails, HermiteCurve, type HermiteCurveOptions, parsePath, roots } from "expline";

import { type Case, testCases } from "./hostile.ts";

const SQUARE = [0, 0, 1, 0, 1, 1, 0, 1];

/** The smooth open curve through the unit square's corners; its domain is [0, 3]. */
const open = (): HermiteCurve => HermiteCurve.through(SQUARE, { closed: false });
const closed = (): HermiteCurve => HermiteCurve.through(SQUARE);

/** A curve with tangents of zero, so that only the points matter. */
function made(points: unknown, options: Partial<HermiteCurveOptions> = {}): HermiteCurve {
  const count = Array.isArray(points) || points instanceof Float64Array ? points.length : 4;
  return new HermiteCurve({ points: points as number[], tangents: new Float64Array(count), ...options });
}

/** A list of numbers that says what it is told to where it is asked for its length, the last of it ever after. */
function lying(...lengths: unknown[]): number[] {
  return new Proxy([0, 0, 1, 1], {
    get: (target, key) => (key === "length" ? (lengths.length > 1 ? lengths.shift() : lengths[0]) : (Reflect.get(target, key) as unknown)),
  });
}

const spread = (n: number, end: number): Float64Array => Float64Array.from({ length: n }, (_, i) => (end * i) / (n - 1));

function near(tolerance: number, expected: ArrayLike<number>): (got: Float64Array) => void {
  return (got) => {
    assert.equal(got.length, expected.length);
    got.forEach((value, i) => assert.ok(Math.abs(value - (expected[i] ?? NaN)) <= tolerance, `${value} at ${i}`));
  };
}

/** Hostile values get past the compiler here, as they do in JavaScript. */
const hostile = <T>(value: unknown): T => value as T;

/** Distance from a place to the open polyline of the square's corners. */
function toPolyline(x: number, y: number): number {
  const segments = [0, 1, 2].map((i) => SQUARE.slice(2 * i, 2 * i + 4) as [number, number, number, number]);
  return Math.min(
    ...segments.map(([ax, ay, bx, by]) => {
      const share = Math.min(1, Math.max(0, (x - ax) * (bx - ax) + (y - ay) * (by - ay)));
      return Math.hypot(x - ax - share * (bx - ax), y - ay - share * (by - ay));
    }),
  );
}

function within(maxError: number): (result: { path: Float64Array; maxError: number }) => void {
  return (result) => {
    assert.ok(result.maxError <= maxError, `${result.maxError} of ${maxError}`);
    assert.ok(result.path.length > 0 && result.path.length % 8 === 0);
  };
}

const cubicsOf = (d: string, tolerance: number): unknown => parsePath(d)[0]?.toCubics(tolerance);

const evaluation: Case[] = [
  { id: "EV-001", what: "no points", run: () => made([]), refuses: { code: "E_TOO_FEW_POINTS", arg: "points", bound: ">= 2" } },
  { id: "EV-002", what: "one point", run: () => made([3, 4], { closed: false }), refuses: { code: "E_TOO_FEW_POINTS", arg: "points", bound: ">= 2" } },
  {
    id: "EV-004",
    what: "two points, closed: legal for Hermite curves, ω = π",
    run: () => made([0, 0, 1, 0]).evaluate(0.5),
    gives: near(1e-15, [0.5, 0]),
  },
  { id: "EV-007", what: "NaN at index 5", run: () => made([0, 0, 1, 0, 1, NaN, 0, 1]), refuses: { code: "E_NOT_FINITE", arg: "points", index: 5 } },
  {
    id: "EV-009",
    what: "a coordinate just over the bound",
    run: () => made([0, 0, 1000000100, 0]),
    refuses: { code: "E_RANGE", arg: "points", index: 2, bound: "|x| <= 1e9" },
  },
  { id: "EV-011", what: "coordinates whose difference overflows", run: () => made([-1e308, 0, 1e308, 0]), refuses: { code: "E_RANGE", arg: "points", index: 0 } },
  { id: "EV-013", what: "t below the domain of an open curve", run: () => open().evaluate(-0.001), refuses: { code: "E_RANGE", arg: "t", bound: "[0, 3]" } },
  { id: "EV-014", what: "t one ulp beyond the domain", run: () => open().evaluate(3.0000000000000004), refuses: { code: "E_RANGE", arg: "t", bound: "[0, 3]" } },
  { id: "EV-015", what: "t = -0", run: () => open().evaluate(-0), gives: near(0, [0, 0]) },
  {
    id: "EV-016",
    what: "ten million parameters",
    run: () => open().evaluate(new Float64Array(1e7)),
    refuses: { code: "E_LIMIT", arg: "t", limit: "maxEvalPoints" },
  },
  {
    id: "EV-018",
    what: "omega = 1e-8, where the naive formula loses all digits",
    run: () => HermiteCurve.through(SQUARE, { closed: false, omega: 1e-8 }).evaluate(spread(65, 3)),
    gives: (got: Float64Array) => near(1e-12, open().evaluate(spread(65, 3)))(got),
  },
  {
    id: "EV-019",
    what: "omega = 1e-155, whose square underflows",
    run: () => HermiteCurve.through(SQUARE, { closed: false, omega: 1e-155 }).evaluate(spread(65, 3)),
    gives: (got: Float64Array) => near(1e-12, open().evaluate(spread(65, 3)))(got),
  },
  {
    id: "EV-020",
    what: "no jump at any switch between series and closed form",
    run: () => {
      // The switches are inside; wherever they are, frequencies this close together give the same curve.
      const at = (omega: number, space: "trigonometric" | "hyperbolic"): Float64Array =>
        made(SQUARE, { closed: false, space, omega, tangents: [1, 2, 3, -1, 0, 1, -2, 2] }).evaluate(spread(65, 3));
      let worst = 0;
      for (let omega = 1e-3; omega < 6; omega *= 1.03) {
        for (const space of ["trigonometric", "hyperbolic"] as const) {
          const [before, after] = [at(omega * (1 - 1e-12), space), at(omega * (1 + 1e-12), space)];
          before.forEach((value, i) => (worst = Math.max(worst, Math.abs(value - (after[i] ?? NaN)))));
        }
      }
      return worst;
    },
    // 2e-12 of ω turns into about 2e-12 of the curve where ω nears 2π; a jump would be there at small ω, too.
    gives: (worst: number) => assert.ok(worst <= 1e-10, `${worst}`),
  },
  {
    id: "EV-022",
    what: "hyperbolic omega = 1e4, the upper bound, is the polyline",
    run: () => HermiteCurve.through(SQUARE, { closed: false, space: "hyperbolic", omega: 1e4 }).sample(301),
    gives: (points: Float64Array) => {
      for (let i = 0; i < points.length; i += 2) assert.ok(toPolyline(points[i] ?? NaN, points[i + 1] ?? NaN) <= 1e-3);
    },
  },
  { id: "EV-023", what: "negative omega", run: () => made(SQUARE, { omega: -1 }), refuses: { code: "E_RANGE", arg: "omega" } },
  {
    id: "EV-024",
    what: "trigonometric omega = 2π, the pole",
    run: () => made(SQUARE, { omega: 2 * Math.PI }),
    refuses: { code: "E_RANGE", arg: "omega", bound: "6.283184307179586" },
  },
  {
    id: "EV-024a",
    what: "a segment too long for the omega that was left to us",
    run: () => made(SQUARE, { lengths: [1, 1, 4, 1] }),
    refuses: { code: "E_RANGE", arg: "lengths", index: 2, bound: "3.99999936338" },
  },
  {
    id: "EV-024b",
    what: "a segment too long for the omega that was given",
    run: () => made(SQUARE, { omega: Math.PI / 2, lengths: [1, 1, 4, 1] }),
    refuses: { code: "E_RANGE", arg: "omega", index: 2 },
  },
  {
    id: "EV-025",
    what: "all points the same",
    run: () => HermiteCurve.through(new Float64Array(14).fill(5)).sample(33),
    gives: near(1e-14, new Float64Array(66).fill(5)),
  },
  {
    id: "EV-026",
    what: "all points on a line",
    run: () => HermiteCurve.through(Float64Array.from({ length: 100 }, (_, i) => (i % 2 === 0 ? i : 2 * i - 2))).sample(101),
    gives: (points: Float64Array) => {
      for (let i = 0; i < points.length; i += 2) {
        assert.ok(Math.abs(2 * (points[i] ?? NaN) - (points[i + 1] ?? NaN)) <= 1e-9 * 100);
      }
    },
  },
  {
    id: "EV-027",
    what: "knots that coincide, as a length of 0",
    run: () => made(SQUARE, { closed: false, lengths: [0.5, 0, 0.5] }),
    refuses: { code: "E_DEGENERATE", arg: "lengths", index: 1 },
  },
  {
    id: "EV-029",
    what: "knots one ulp apart",
    run: () => made(SQUARE, { closed: false, lengths: [0.5, 1.1e-16, 0.5] }),
    refuses: { code: "E_DEGENERATE", arg: "lengths", index: 1 },
  },
  {
    id: "EV-031",
    what: "curvature where the speed is zero: no number, so an error that carries the other values",
    run: () => {
      try {
        return made([0, 0, 0, 0, 1, 1], { closed: false }).curvature(Float64Array.of(0, 0.5));
      } catch (error) {
        const { partial } = error as ErrorDetails;
        assert.deepEqual(partial, Float64Array.of(0, 0));
        throw error;
      }
    },
    refuses: { code: "E_DEGENERATE", arg: "t", index: 0 },
  },
  { id: "EV-032", what: "length of a curve of no extent", run: () => made([2, 2, 2, 2]).length(), gives: (length: number) => assert.equal(length, 0) },
  {
    id: "EV-033",
    what: "the parameter at more than the whole length",
    run: () => {
      const curve = open();
      return curve.parameterAtLength(curve.length() + 1e-6);
    },
    refuses: { code: "E_RANGE", arg: "length" },
  },
  { id: "EV-036", what: "points as strings", run: () => made(["0", "0", "1", "1"]), refuses: { code: "E_TYPE", arg: "points", bound: "number" } },
  { id: "EV-037", what: "points is null", run: () => made(null), refuses: { code: "E_TYPE", arg: "points" } },
  {
    id: "EV-038",
    what: "an array that lies about its length",
    run: () =>
      new HermiteCurve({
        points: new Proxy([0, 0, 1, 1], { get: (target, key) => (key === "length" ? 1e9 : (Reflect.get(target, key) as unknown)) }),
        tangents: SQUARE,
      }),
    refuses: { code: "E_TYPE", arg: "points", bound: "number" },
  },
  { id: "EV-038b", what: "points that say their length is −1", run: () => HermiteCurve.through(lying(-1)), refuses: { code: "E_TYPE", arg: "points" } },
  { id: "EV-038c", what: "points whose length is a list that says it is long", run: () => HermiteCurve.through(lying({ length: 1e9 })), refuses: { code: "E_TOO_FEW_POINTS", arg: "points" } },
  { id: "EV-038d", what: "roots that say their length is −1", run: () => roots.union(lying(-1)), refuses: { code: "E_LIMIT", arg: "lists", limit: "maxRoots" } },
  { id: "EV-038e", what: "roots whose length is longer when it is asked for again", run: () => roots.union(lying(2, 1e9)), gives: (list: unknown) => assert.deepEqual(list, [0, 0]) },
  {
    id: "EV-040",
    what: "points on a SharedArrayBuffer: copied once, the copy is checked and used",
    run: () => {
      const shared = new Float64Array(new SharedArrayBuffer(64));
      const curve = made(shared);
      shared.fill(NaN);
      return curve.sample(9);
    },
    gives: near(0, new Float64Array(18)),
  },
];

const refinement: Case[] = [
  {
    id: "RF-001",
    what: "levels = 0 is a copy of the points",
    run: () => closed().subdivide(0),
    gives: near(0, SQUARE),
  },
  { id: "RF-003", what: "levels = 2.5", run: () => closed().subdivide(2.5), refuses: { code: "E_RANGE", arg: "levels", bound: "integer" } },
  { id: "RF-004", what: "levels = 2³², 0 in 32 bits", run: () => closed().subdivide(2 ** 32), refuses: { code: "E_RANGE", arg: "levels" } },
  { id: "RF-005", what: "24 levels on 4 points", run: () => closed().subdivide(24), refuses: { code: "E_LIMIT", arg: "levels", limit: "maxOutputPoints" } },
  { id: "RF-006", what: "53 levels", run: () => closed().subdivide(53), refuses: { code: "E_RANGE", arg: "levels" } },
  { id: "RF-007", what: "NaN among the points", run: () => made([0, 0, NaN, 1, 1, 1]), refuses: { code: "E_NOT_FINITE", arg: "points", index: 2 } },
  {
    id: "RF-009",
    what: "a circle of a million points, refined once",
    run: () => HermiteCurve.ellipse({ center: [0, 0], radii: [1, 1], count: 1_000_000 }).refine().sample(10_007),
    gives: (points: Float64Array) => {
      for (let i = 0; i < points.length; i += 2) {
        assert.ok(Math.abs(Math.hypot(points[i] ?? NaN, points[i + 1] ?? NaN) - 1) <= 1e-9);
      }
    },
  },
  {
    id: "RF-010",
    what: "every second point a duplicate",
    run: () => {
      const angle = (i: number): number => (Math.PI * Math.floor(i / 4)) / 8;
      const points = Float64Array.from({ length: 128 }, (_, i) => (i % 2 === 0 ? Math.cos(angle(i)) : Math.sin(angle(i))));
      return HermiteCurve.through(points).subdivide(6);
    },
    gives: (points: Float64Array) => assert.ok(points.every((value) => Math.abs(value) <= 2)),
  },
  {
    id: "RF-014",
    what: "another number of tangents than of points",
    run: () => new HermiteCurve({ points: SQUARE, tangents: [1, 0] }),
    refuses: { code: "E_LENGTH", arg: "tangents", bound: "8" },
  },
  {
    id: "RF-015",
    what: "an out that is too small stays as it is",
    run: () => {
      const out = new Float64Array(4).fill(7);
      try {
        return closed().sample(32, { out });
      } finally {
        assert.deepEqual(out, new Float64Array(4).fill(7));
      }
    },
    refuses: { code: "E_LENGTH", arg: "out", bound: ">= 64" },
  },
  {
    id: "RF-016",
    what: "out lies over the parameters (points are copied, so they cannot be overwritten)",
    run: () => {
      const shared = new Float64Array(9);
      return closed().evaluate(shared.subarray(0, 4), 0, shared.subarray(1));
    },
    refuses: { code: "E_TYPE", arg: "out", bound: "overlap" },
  },
  { id: "RF-017", what: "tolerance 0", run: () => closed().flatten(0), refuses: { code: "E_RANGE", arg: "tolerance", bound: "> 0" } },
];

const cubics: Case[] = [
  { id: "BZ-001", what: "a cubic with a zero first handle", run: () => cubicsOf("M0,0 C0,0 80,1 2,1", 1), gives: within(1) },
  { id: "BZ-002", what: "a sliver", run: () => cubicsOf("M1,0.7 L4.1,2 L4.4,2.1 L0,0 Z", 2), gives: within(2) },
  { id: "BZ-003", what: "five ordinary points", run: () => cubicsOf("M412,183.9 L407,185 L419,184.89 L418.8,184.89 L417,184 Z", 2), gives: within(2) },
  { id: "BZ-004", what: "tolerance 0", run: () => cubicsOf("M0,0 C10,10 10,0 0,10", 0), refuses: { code: "E_RANGE", arg: "tolerance", bound: "> 0" } },
  { id: "BZ-005", what: "tolerance NaN", run: () => cubicsOf("M0,0 C10,10 10,0 0,10", NaN), refuses: { code: "E_NOT_FINITE", arg: "tolerance" } },
  {
    id: "BZ-008",
    what: "hyperbolic segments with omega 200",
    run: () => HermiteCurve.through(SQUARE, { space: "hyperbolic", omega: 200 }).toCubics(0.01),
    gives: within(0.01),
  },
  { id: "BZ-009", what: "offset of a point-cubic", senseless: "there is no offset" },
  { id: "BZ-011", what: "offset past the radius of curvature", senseless: "there is no offset" },
  { id: "BZ-012", what: "empty dash pattern", senseless: "there are no dashes" },
  { id: "BZ-013", what: "dash pattern of zeros", senseless: "there are no dashes" },
  { id: "BZ-015", what: "negative dash", senseless: "there are no dashes" },
  {
    id: "BZ-018",
    what: "ten thousand cusps",
    run: () => {
      const points = Float64Array.from({ length: 20_000 }, (_, i) => (i % 2 === 0 ? i : i % 4) / 100);
      return made(points, { closed: false, omega: 1 }).toCubics(1e-6);
    },
    gives: within(1e-6),
  },
];

/** 80 bytes that may become others: of a later library than the tests are checked against. */
function resizable(): ArrayBuffer & { resize(bytes: number): void } {
  const Resizable = ArrayBuffer as unknown as new (bytes: number, options: { maxByteLength: number }) => ArrayBuffer & { resize(bytes: number): void };
  return new Resizable(80, { maxByteLength: 160 });
}

const more: Case[] = [
  { id: "EV-101", what: "an unknown option", run: () => made(SQUARE, hostile({ omga: 1 })), refuses: { code: "E_TYPE", arg: "omga", bound: "omega" } },
  { id: "EV-102", what: "an odd number of coordinates", run: () => made([1, 2, 3]), refuses: { code: "E_LENGTH", arg: "points", bound: "even" } },
  { id: "EV-103", what: "a derivative of order 1.5", run: () => open().evaluate(1, 1.5), refuses: { code: "E_RANGE", arg: "derivative" } },
  { id: "EV-104", what: "t is a string", run: () => open().evaluate(hostile("0.5")), refuses: { code: "E_TYPE", arg: "t" } },
  { id: "EV-105", what: "NaN among the parameters", run: () => open().evaluate([0, 1, NaN]), refuses: { code: "E_NOT_FINITE", arg: "t", index: 2 } },
  {
    id: "EV-106",
    what: "an array whose buffer was transferred",
    run: () => {
      const points = Float64Array.from(SQUARE);
      structuredClone(points.buffer, { transfer: [points.buffer] });
      return made(points);
    },
    refuses: { code: "E_DETACHED", arg: "points" },
  },
  {
    id: "EV-106a",
    what: "an array of fixed length whose buffer has shrunk to nothing",
    run: () => {
      const buffer = resizable();
      const points = new Float64Array(buffer, 0, 10);
      buffer.resize(0);
      return made(points);
    },
    refuses: { code: "E_DETACHED", arg: "points" },
  },
  {
    id: "EV-106b",
    what: "an array of no numbers, whose buffer lives and may change its size",
    run: () => made(new Float64Array(resizable(), 8, 0)),
    refuses: { code: "E_TOO_FEW_POINTS", arg: "points" },
  },
  {
    id: "EV-107",
    what: "a typed array of another kind",
    run: () => made(hostile<number[]>(new BigInt64Array(8))),
    refuses: { code: "E_TYPE", arg: "points" },
  },
  { id: "EV-108", what: "an object that says it is a Float64Array", run: () => made({ [Symbol.toStringTag]: "Float64Array", length: 4 }), refuses: { code: "E_TYPE", arg: "points" } },
  { id: "EV-109", what: "a hole in an array", run: () => made([0, 0, hostile<number>(undefined), 1]), refuses: { code: "E_TYPE", arg: "points", index: 2 } },
  { id: "EV-110", what: "a pair of three", run: () => made(hostile<number[]>([[0, 0], [1, 2, 3]])), refuses: { code: "E_TYPE", arg: "points", index: 1 } },
  { id: "EV-111", what: "no options at all", run: () => new HermiteCurve(hostile(undefined)), refuses: { code: "E_TYPE", arg: "points" } },
  { id: "EV-112", what: "a curve as the options", run: () => new HermiteCurve(hostile(open())), refuses: { code: "E_TYPE", arg: "options" } },
  { id: "EV-113", what: "a radius of zero", run: () => HermiteCurve.ellipse({ center: [0, 0], radii: [0, 1], count: 4 }), refuses: { code: "E_RANGE" } },
  { id: "EV-114", what: "an ellipse of one point", run: () => HermiteCurve.ellipse({ center: [0, 0], radii: [1, 1], count: 1 }), refuses: { code: "E_TOO_FEW_POINTS", arg: "count" } },
  { id: "EV-115", what: "the area of an open curve", run: () => open().area(), refuses: { code: "E_DEGENERATE" } },
  { id: "EV-116", what: "the place nearest to NaN", run: () => open().nearest(NaN, 0), refuses: { code: "E_NOT_FINITE", arg: "x" } },
  { id: "EV-117", what: "removing a point that is not there", run: () => open().remove(4), refuses: { code: "E_RANGE", arg: "i" } },
  { id: "EV-118", what: "a matrix of five numbers", run: () => open().transform(hostile([1, 0, 0, 1, 0])), refuses: { code: "E_LENGTH", arg: "matrix" } },
  { id: "EV-119", what: "a map that throws points beyond the bound", run: () => open().transform([1e10, 0, 0, 1, 0, 0]), refuses: { code: "E_RANGE", arg: "matrix" } },
  { id: "EV-120", what: "sampling no points", run: () => open().sample(0), refuses: { code: "E_RANGE", arg: "count" } },
  { id: "EV-121", what: "sampling five million points", run: () => open().sample(5e6), refuses: { code: "E_LIMIT", arg: "count", limit: "maxOutputPoints" } },
  { id: "EV-122", what: "a centre of three numbers", run: () => HermiteCurve.ellipse({ center: hostile([0, 0, 0]), radii: [1, 1], count: 4 }), refuses: { code: "E_LENGTH", arg: "center", bound: "2" } },
  { id: "EV-123", what: "a negative radius", run: () => HermiteCurve.ellipse({ center: [0, 0], radii: [1, -1], count: 4 }), refuses: { code: "E_RANGE", arg: "radii", bound: "(0, 1e9]" } },
  {
    id: "EV-124",
    what: "points of no more than 1e-160, which once kept the length from ending",
    run: () => new HermiteCurve({ points: [0, 0, 0, 0], tangents: [1e-160, 1e-160, -1e-160, -1e-160] }).length(),
    gives: (length: number) => assert.ok(length >= 0 && length <= 1e-139),
  },
];

testCases("curves", [...evaluation, ...refinement, ...cubics, ...more]);
