// Hostile path data and JSON.

import assert from "node:assert/strict";
import { test } from "node:test";

import { ExplineError, HermiteCurve, type JSONWarning, type PathWarning, fromJSON, parsePath } from "expline";

import { type Case, testCases } from "./hostile.ts";

const DOCUMENT = "of SVG documents, which the demo reads; the package reads path data";
const DRAWING = "of drawings with many objects, which are the demo's";

/** Hostile values get past the compiler here, as they do in JavaScript. */
const hostile = <T>(value: unknown): T => value as T;

interface Read {
  curves: HermiteCurve[];
  warnings: PathWarning[];
}

function read(d: string): Read {
  const warnings: PathWarning[] = [];
  const curves = parsePath(d, { onWarning: (warning) => warnings.push(warning) });
  return { curves, warnings };
}

const pointsOf = ({ curves }: Read): number[] => curves.flatMap((curve) => Array.from(curve.points));

/** As many curves with as many points, and where reading stopped, if it did. */
function drawn(points: number[], stopped?: number): (read: Read) => void {
  return (got) => {
    assert.deepEqual(got.curves.map((curve) => curve.points.length / 2), points);
    assert.deepEqual(got.warnings.map(({ code, offset }) => [code, offset]), stopped === undefined ? [] : [["W_PATH_TRUNCATED", stopped]]);
  };
}

const paths: Case[] = [
  { id: "SV-003", what: "no moveto", run: () => parsePath("L1 1"), refuses: { code: "E_PARSE_SVG", arg: "d", index: 0 } },
  { id: "SV-004", what: "an error in the middle keeps what came before", run: () => read("M0 0L1 1 L2 foo"), gives: drawn([2], 10) },
  {
    id: "SV-004b",
    what: "without onWarning the same is an error that carries what came before",
    run: () => {
      try {
        return parsePath("M0 0L1 1 L2 foo");
      } catch (error) {
        assert.ok(error instanceof ExplineError);
        assert.equal((error.partial as HermiteCurve[]).length, 1);
        throw error;
      }
    },
    refuses: { code: "E_PARSE_SVG", arg: "d", index: 12, bound: "a number" },
  },
  {
    id: "SV-005",
    what: "packed arc flags",
    run: () => read("M200,120h-25a25,25 0 1125,25z"),
    gives: (got: Read) => assert.deepEqual(pointsOf(got), pointsOf(read("M200,120h-25a25,25 0 1 1 25,25z"))),
  },
  { id: "SV-007", what: "numbers without separators", run: () => read("M.5.5.5-.5"), gives: (got: Read) => assert.deepEqual(pointsOf(got), [0.5, 0.5, 0.5, -0.5]) },
  { id: "SV-008", what: "an exponent, then a dot: a point alone, then a number that is left over", run: () => read("M2e2.0 3"), gives: (got: Read) => assert.deepEqual([got.curves.length, got.warnings.length], [0, 1]) },
  { id: "SV-010", what: "1e999", run: () => parsePath("M1e999 0L1 1"), refuses: { code: "E_RANGE", arg: "d", bound: "|x| <= 1e9" } },
  { id: "SV-011", what: "relative coordinates that overflow", run: () => parsePath("M1e308 0l1e308 0l1e308 0"), refuses: { code: "E_RANGE", arg: "d" } },
  { id: "SV-012", what: "NaN in the text", run: () => parsePath("MNaN NaNaNaN NaN NaN 1 0 NaN NaNZ"), refuses: { code: "E_PARSE_SVG", arg: "d", index: 1 } },
  { id: "SV-013", what: "an arc of radius 1e300", run: () => parsePath("M0 0A1e300 1e300 0 0 1 10 10"), refuses: { code: "E_RANGE", arg: "d" } },
  {
    id: "SV-014",
    what: "an arc of radius 1e8, which is within bounds",
    run: () => read("M0 0A1e8 1e8 0 0 1 10 10"),
    gives: ({ curves: [arc] }: Read) => assert.ok(arc !== undefined && arc.points.length / 2 <= 64 && arc.sample(100).every(Number.isFinite)),
  },
  { id: "SV-016", what: "negative radii are taken without their sign", run: () => read("M0 0A-5 -5 0 0 1 9 9"), gives: (got: Read) => assert.deepEqual(pointsOf(got), pointsOf(read("M0 0A5 5 0 0 1 9 9"))) },
  { id: "SV-017", what: "an arc to its own start is left out", run: () => read("M1 1A5 5 0 1 1 1 1L2 2"), gives: drawn([2]) },
  { id: "SV-018", what: "ten million lines", run: () => parsePath(`M0 0${"L1 1".repeat(1e7)}`), refuses: { code: "E_LIMIT", arg: "d", limit: "maxPathBytes" } },
  { id: "SV-019", what: "a million moves", run: () => parsePath("M1 1".repeat(1e6)), refuses: { code: "E_LIMIT", arg: "d", limit: "maxSubpaths" } },
  { id: "SV-020", what: "a NUL byte", run: () => read("M0 0\0L1 1"), gives: (got: Read) => assert.deepEqual([got.curves.length, got.warnings.length], [0, 1]) },
  { id: "SV-023", what: "a comma is a separator, never a decimal", run: () => read("M1,5 2,5 3,5"), gives: (got: Read) => assert.deepEqual(pointsOf(got), [1, 5, 2, 5, 3, 5]) },
  { id: "SV-024", what: "numbers after Z", run: () => read("M0 0L1 0Z 5 5"), gives: ({ curves, warnings }: Read) => assert.deepEqual([curves.length, warnings.length], [1, 1]) },
  { id: "SV-054", what: "nothing infinite is ever written", run: () => parsePath("M1e999 0L1 1Z"), refuses: { code: "E_RANGE", arg: "d" } },
  { id: "SV-101", what: "path data that is a number", run: () => parsePath(hostile(5)), refuses: { code: "E_TYPE", arg: "d", bound: "string" } },
  { id: "SV-102", what: "characters beyond ASCII", run: () => parsePath("M0 0L1 1é"), refuses: { code: "E_PARSE_SVG", arg: "d", index: 8 } },
  { id: "SV-103", what: "a lone surrogate", run: () => parsePath("\ud800"), refuses: { code: "E_PARSE_SVG", arg: "d", index: 0 } },
  { id: "SV-104", what: "no text is no path", run: () => parsePath(""), gives: (curves: HermiteCurve[]) => assert.deepEqual(curves, []) },
  ...["SV-025", "SV-027", "SV-028", "SV-029", "SV-030", "SV-031", "SV-032", "SV-033", "SV-036", "SV-038", "SV-039", "SV-040"].map((id) => ({ id, what: "", senseless: DOCUMENT })),
  ...["SV-042", "SV-044", "SV-046", "SV-049", "SV-050", "SV-051", "SV-052"].map((id) => ({ id, what: "", senseless: DOCUMENT })),
];

const CURVE = HermiteCurve.through([0, 0, 10, 1, 7.25, 1e-7, 0.1, 123456789.123]);
const EXTREME = [5e8, 1e-7, 0, 0.1, 123456789.123, -5e8];
const NUMBER = /^-?[0-9]*\.?[0-9]+$/;

const printing: Case[] = [
  {
    id: "SX-004",
    what: "numbers are written in one grammar and read back as they were",
    run: () => new HermiteCurve({ points: EXTREME, tangents: new Float64Array(6), closed: false, omega: 0 }).toPathD({ decimals: 17 }).d,
    gives: (d: string) => {
      for (const number of d.replace(/[A-Za-z]/g, " ").replace(/-/g, " -").split(/[\s,]+/)) {
        for (const piece of number.match(/-?\d*\.?\d+/g) ?? []) assert.match(piece, NUMBER);
      }
      assert.doesNotMatch(d, /inf|nan|e\+/i);
      assert.deepEqual(Array.from(parsePath(d)[0]?.points ?? []), EXTREME);
    },
  },
  {
    id: "SX-005",
    what: "the host's language changes nothing",
    run: () => {
      const number = Object.getOwnPropertyDescriptor(Number.prototype, "toString");
      Number.prototype.toString = () => "1.234,5";
      try {
        return HermiteCurve.through([1234.5, 0, 0, 1], { closed: false, omega: 0 }).toPathD().d;
      } finally {
        if (number !== undefined) Object.defineProperty(Number.prototype, "toString", number);
      }
    },
    gives: (d: string) => assert.match(d, /^M1234\.5 0[ LC]/),
  },
  { id: "SX-007", what: "400 decimals", run: () => CURVE.toPathD({ decimals: 400 }), refuses: { code: "E_RANGE", arg: "decimals" } },
  {
    id: "SX-009",
    what: "with 17 decimals points come back to the last bit",
    run: () => {
      let seed = 1;
      const random = (): number => (seed = (seed * 48_271) % 2_147_483_647) / 2_147_483_647;
      const points = Float64Array.from({ length: 200 }, () => 100 * random());
      const lines = new HermiteCurve({ points, tangents: points.map((_, i) => (points[(i + 2) % 200] ?? 0) - (points[i] ?? 0)), closed: false, omega: 0 });
      return [points, parsePath(lines.toPathD({ decimals: 17 }).d)[0]?.points.filter((_, i, all) => i < 2 || i > all.length - 3)];
    },
    gives: ([points, ends]: [Float64Array, Float64Array]) => assert.deepEqual(Array.from(ends), [...points.subarray(0, 2), ...points.subarray(198)]),
  },
  ...["SX-001", "SX-002", "SX-003", "SX-012", "SX-013"].map((id) => ({ id, what: "", senseless: DRAWING })),
];

const GOOD = { type: "HermiteCurve", version: 1, closed: false, space: "trigonometric", points: [0, 0, 1, 1], tangents: [1, 0, 0, 1], omega: 1 };
const text = (change: object): string => JSON.stringify({ ...GOOD, ...change });

function warned(value: unknown): { curve: HermiteCurve; warnings: JSONWarning[] } {
  const warnings: JSONWarning[] = [];
  return { curve: fromJSON(value, { onWarning: (warning) => warnings.push(warning) }) as HermiteCurve, warnings };
}

const json: Case[] = [
  { id: "JS-003", what: "null", run: () => fromJSON("null"), refuses: { code: "E_SCHEMA", path: "$" } },
  { id: "JS-004", what: "an array", run: () => fromJSON("[]"), refuses: { code: "E_SCHEMA", path: "$" } },
  { id: "JS-005", what: "no version", run: () => fromJSON(text({ version: undefined })), refuses: { code: "E_SCHEMA", path: "$.version" } },
  {
    id: "JS-008",
    what: "a __proto__ key pollutes nothing and is kept as an own field",
    run: () => warned(`${text({}).slice(0, -1)},"__proto__":{"polluted":1}}`),
    gives: ({ curve, warnings }: ReturnType<typeof warned>) => {
      assert.equal(({} as { polluted?: number }).polluted, undefined);
      assert.deepEqual(warnings, [{ code: "W_UNKNOWN_FIELD", path: "$.__proto__" }]);
      assert.ok(JSON.stringify(curve).includes('"__proto__":{"polluted":1}'));
      assert.equal(Object.getPrototypeOf(curve.toJSON()), Object.prototype);
    },
  },
  {
    id: "JS-010",
    what: "__proto__ inside an unknown field",
    run: () => fromJSON(`${text({}).slice(0, -1)},"style":{"__proto__":{"x":1}}}`).toJSON(),
    gives: (value: { style: object }) => assert.deepEqual([Object.keys(value.style), Object.getPrototypeOf(value.style)], [["__proto__"], Object.prototype]),
  },
  {
    id: "JS-011",
    what: "setters on Object.prototype see nothing",
    run: () => {
      let hits = 0;
      const names = ["points", "closed", "extra", "index", "argument", "x"];
      for (const name of names) Object.defineProperty(Object.prototype, name, { set: () => (hits += 1), configurable: true });
      try {
        const curve = fromJSON(text({ x: 1 }));
        assert.throws(() => fromJSON(text({ points: [0, 0, 1, "1"] })), ExplineError);
        fromJSON(curve.toJSON());
      } finally {
        for (const name of names) Reflect.deleteProperty(Object.prototype, name);
      }
      return hits;
    },
    gives: (hits: number) => assert.equal(hits, 0),
  },
  { id: "JS-012", what: "a million brackets", run: () => fromJSON("[".repeat(1e6)), refuses: { code: "E_LIMIT", limit: "maxDepth" } },
  { id: "JS-014", what: "1e400", run: () => fromJSON(text({}).replace("[0,0,1,1]", "[0,0,1e400,1]")), refuses: { code: "E_NOT_FINITE", path: "$.points[2]" } },
  { id: "JS-016", what: "a coordinate as text", run: () => fromJSON(text({ points: [0, 0, "1,5", 1] })), refuses: { code: "E_SCHEMA", path: "$.points[2]" } },
  { id: "JS-017", what: "two values under one name", run: () => fromJSON(text({}).replace('"omega":1', '"omega":1,"\\u006fmega":2')), refuses: { code: "E_SCHEMA", path: "$.omega", reason: "duplicate-key" } },
  {
    id: "JS-020",
    what: "an unknown field is kept",
    run: () => warned(text({ "x-vendor": { a: 1 } })),
    gives: ({ curve, warnings }: ReturnType<typeof warned>) => {
      assert.deepEqual(warnings, [{ code: "W_UNKNOWN_FIELD", path: '$["x-vendor"]' }]);
      assert.deepEqual(fromJSON(JSON.stringify(curve)).toJSON()["x-vendor"], { a: 1 });
    },
  },
  {
    id: "JS-021",
    what: "-0 becomes 0 once, and the rest is exact to the last bit",
    run: () => fromJSON({ ...GOOD, points: [-0, 5e-324, 0.1, 1 / 3], tangents: [-0, 1, 1e9, -1e-300] }),
    gives: (curve: HermiteCurve) => {
      assert.ok(curve.points.every((value) => !Object.is(value, -0)));
      const again = fromJSON(JSON.stringify(curve)) as HermiteCurve;
      assert.deepEqual(Buffer.from(again.points.buffer), Buffer.from(curve.points.buffer));
      assert.deepEqual(again.toJSON(), curve.toJSON());
    },
  },
  { id: "JS-023", what: "a byte order mark", run: () => fromJSON(`\ufeff${text({})}`), gives: (curve: HermiteCurve) => assert.equal(curve.points.length, 4) },
  { id: "JS-024", what: "something after the end", run: () => fromJSON(`${text({})} x`), refuses: { code: "E_PARSE_JSON", arg: "json" } },
  { id: "JS-025", what: "a hundred megabytes", run: () => fromJSON(text({}) + " ".repeat(1e8)), refuses: { code: "E_LIMIT", arg: "json", limit: "maxBytes" } },
  { id: "JS-027", what: "more than a million points", run: () => fromJSON({ ...GOOD, points: new Array(2_000_004).fill(0) }), refuses: { code: "E_LIMIT", limit: "maxPoints", path: "$.points" } },
  { id: "JS-028", what: "an unknown type", run: () => fromJSON(text({ type: "hologram" })), refuses: { code: "E_SCHEMA", path: "$.type" } },
  { id: "JS-031", what: "a name with invisible characters is kept as it is", run: () => fromJSON(text({ name: "\u202egnp.exe\u200b" })).toJSON()["name"], gives: (name: string) => assert.equal(name, "\u202egnp.exe\u200b") },
  { id: "JS-032", what: "a lone surrogate becomes U+FFFD", run: () => fromJSON(text({ name: "\ud800" })).toJSON()["name"], gives: (name: string) => assert.equal(name, "\ufffd") },
  {
    id: "JS-033",
    what: "an object that contains itself",
    run: () => {
      const value: Record<string, unknown> = { ...GOOD };
      value["objects"] = [value];
      return fromJSON(value);
    },
    refuses: { code: "E_SCHEMA", path: "$.objects[0]" },
  },
  { id: "JS-101", what: "a version of the future", run: () => fromJSON(text({ version: 2 })), refuses: { code: "E_UNSUPPORTED", path: "$.version" } },
  { id: "JS-102", what: "too few tangents", run: () => fromJSON(text({ tangents: [1, 0] })), refuses: { code: "E_SCHEMA", path: "$.tangents" } },
  { id: "JS-103", what: "a frequency beyond the pole", run: () => fromJSON(text({ omega: 7 })), refuses: { code: "E_RANGE", path: "$.omega" } },
  { id: "JS-104", what: "inherited fields do not count", run: () => fromJSON(Object.create(GOOD)), refuses: { code: "E_SCHEMA", path: "$.version" } },
  { id: "JS-105", what: "a function among the fields", run: () => fromJSON({ ...GOOD, run: () => 1 }), refuses: { code: "E_SCHEMA", path: "$.run" } },
  { id: "JS-106", what: "text that breaks off", run: () => fromJSON('{"type": "HermiteCurve'), refuses: { code: "E_PARSE_JSON", arg: "json" } },
  ...["JS-018", "JS-019", "JS-035"].map((id) => ({ id, what: "", senseless: DRAWING })),
];

testCases("text", [...paths, ...printing, ...json]);

test("every curve comes back from JSON to the last bit", () => {
  const curves = [
    CURVE,
    HermiteCurve.ellipse({ center: [0.1, 0.2], radii: [3, 1 / 3], rotation: 0.7, count: 7 }),
    CURVE.insert(0.3).insert(2.2),
    CURVE.refine(3),
    ...parsePath("M0 0C1 2 3 4 5 0.1A3 4 10 0 1 9 9Q8 7 6 5L0.7 0.3Z"),
  ];
  for (const curve of curves) {
    const again = fromJSON(JSON.parse(JSON.stringify(curve))) as HermiteCurve;
    assert.deepEqual(again.toJSON(), curve.toJSON());
    assert.deepEqual(again.sample(101), curve.sample(101));
    assert.deepEqual(again.omega, curve.omega);
    assert.deepEqual(again.lengths, curve.lengths);
    assert.deepEqual(again.tangentsIn, curve.tangentsIn);
  }
});
