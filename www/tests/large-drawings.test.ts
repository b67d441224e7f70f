import assert from "node:assert/strict";
import { test } from "node:test";
import { setKinds } from "../src/document/curve/commands.ts";
import { omegaOf, segmentCount, type Contour, type ControlPoint, type CurveDocument } from "../src/document/document.ts";
import { snapPlace } from "../src/editor/pointer/snapping.ts";
import { hitTest } from "../src/editor/pointer/hit-test.ts";
import { initialState } from "../src/editor/initial-state.ts";
import { abridged } from "../src/panels/code/snippets.ts";
import { handOf, longContour } from "./harness.ts";

/** What a drawing of very many points must not cost: counted, not timed. */

/** A list that counts how often one of its entries is read. */
function counted<T>(list: readonly T[]): { list: readonly T[]; reads(): number } {
  let reads = 0;
  const proxy = new Proxy(list, {
    get(target, key, receiver) {
      if (typeof key === "string" && /^\d+$/u.test(key)) reads += 1;
      return Reflect.get(target, key, receiver) as unknown;
    },
  });
  return { list: proxy, reads: () => reads };
}

test("the frequencies of all segments of a contour take one look at its lengths, not one for each segment", () => {
  const points = longContour(500).points;
  const lengths = counted(points.map((_, i) => 1 + (i % 3)));
  const contour: Contour = { family: "hermite", closed: true, points, lengths: lengths.list as number[] };
  const curve: CurveDocument = { space: "trigonometric", omega: "auto", level: 0, contours: [contour] };
  const segments = segmentCount(contour);
  const all = Array.from({ length: segments }, (_, i) => omegaOf(curve, contour, i));
  const whole = points.reduce((sum, _, i) => sum + 1 + (i % 3), 0);
  assert.ok(all.every((omega) => omega === (2 * Math.PI) / whole));
  assert.ok(lengths.reads() <= segments, `${lengths.reads()} lengths were read`);
});

test("changing one point of very many looks at that one alone, and leaves all others the same objects", () => {
  const contour = longContour(3000);
  const kinds: number[] = [];
  const points = contour.points.map((point, i) => Object.defineProperty({ ...point }, "kind", { enumerable: true, get: () => (kinds.push(i), point.kind) }));
  const curve: CurveDocument = { space: "trigonometric", omega: "auto", level: 0, contours: [{ ...contour, points }] };
  const next = setKinds({ points: [{ contour: 0, index: 7 }], handle: null }, "cusp").apply(curve).contours[0]?.points ?? [];
  assert.deepEqual([...new Set(kinds)], [7]);
  assert.equal(next[7]?.kind, "cusp");
  assert.deepEqual(next.flatMap((point, i) => (point === points[i] ? [] : [i])), [7]);
});

/** By going through all of them, as the sentence says. */
function nearest(points: readonly ControlPoint[], distance: (point: ControlPoint) => number, reach: number): ControlPoint | undefined {
  const within = points.filter((point) => distance(point) <= reach);
  const least = Math.min(...within.map(distance));
  return within.filter((point) => distance(point) === least).at(-1);
}

test("a place snaps onto the nearest point in reach, else to the nearest column and row", () => {
  const { points } = longContour(400);
  const moving = { points: [{ contour: 0, index: 0 }], handle: null };
  const curve: CurveDocument = { space: "trigonometric", omega: "auto", level: 0, contours: [{ family: "hermite", closed: true, points }] };
  const others = points.slice(1);
  for (let i = 0; i < 300; i += 1) {
    const at = { x: 140 + ((i * 97) % 521), y: 40 + ((i * 61) % 519) };
    const reach = 6 / 2;
    const onto = nearest(others, ({ x, y }) => Math.hypot(x - at.x, y - at.y), reach);
    const [column, row] = [nearest(others, ({ x }) => Math.abs(x - at.x), reach), nearest(others, ({ y }) => Math.abs(y - at.y), reach)];
    const found = snapPlace(curve, moving, at, 2, null);
    assert.deepEqual(found.value, onto === undefined ? { x: column?.x ?? at.x, y: row?.y ?? at.y } : { x: onto.x, y: onto.y }, `at ${at.x}, ${at.y}`);
  }
});

test("the pointer finds the nearest of very many points at any zoom", () => {
  const hand = handOf([longContour(2000)]);
  const { points } = longContour(2000);
  for (const zoom of [0.5, 1, 8]) {
    const state = { ...initialState, ...hand.editor.state.value, stage: { left: 0, top: 0, width: 800, height: 600 }, view: { zoom, x: 400, y: 300 } };
    for (const index of [0, 321, 1999]) {
      const { x = 0, y = 0 } = points[index] ?? {};
      // A hair beside it, and nearer to it than half-way to the next.
      const found = hitTest(state, { x: 400 + (x - 400) * zoom + 0.01, y: 300 + (y - 300) * zoom }, "mouse");
      assert.ok(found.kind === "point" && found.point.index === index, `zoom ${zoom}, point ${index}`);
    }
  }
});

test("a very long program is shown by its two ends, and says how much is left out; any other whole", () => {
  const short = "x".repeat(100_000);
  assert.equal(abridged(short), short);
  const long = `begin${"x".repeat(1_000_000)}end`;
  const shown = abridged(long);
  assert.ok(shown.startsWith("begin") && shown.endsWith("end") && shown.length < 101_000);
  assert.match(shown, /900,008 characters/);
});
