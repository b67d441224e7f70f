// What a pointer does to curves: it finds what lies under it, turns handles, and pulls the curve.

import assert from "node:assert/strict";
import { test } from "node:test";

import { type Curve, ExplineError, HermiteCurve, InterpolatingCurve, bendCurve, handlesOf, hitTest, jointOf, moveHandle, movePoint, parsePath, tangentWeights } from "expline";
import * as edit from "expline/edit";

/** A few ulp of places below 100, times the weights of a drag, which are below 100. */
const EXACT = 1e-11;

function only(d: string): HermiteCurve {
  const [curve] = parsePath(d);
  assert.ok(curve);
  return curve;
}

/** Curves of every kind of segment, even and uneven lengths, open and closed. */
const CURVES: Readonly<Record<string, () => HermiteCurve>> = {
  "two cubics": () => only("M0 0C10 20 30 20 40 0C50 -20 70 -20 80 0"),
  "a circle": () => HermiteCurve.ellipse({ center: [5, 5], radii: [30, 30], count: 3 }),
  "an arc beside a line and a cubic": () => only("M0 0A20 10 30 0 1 40 0L60 5C70 8 90 9 80 40Z"),
  "hyperbolic segments of uneven lengths": () =>
    new HermiteCurve({ points: [0, 0, 30, 5, 50, -10], tangents: [20, 10, 12, -8, 9, 3], closed: false, space: "hyperbolic", omega: 0.8, lengths: [1.5, 0.7] }),
  "through points": () => HermiteCurve.through([0, 0, 20, 5, 30, 30, 5, 25]),
};

function assertNear(actual: readonly number[] | Float64Array, expected: readonly number[], tolerance: number, what: string): void {
  assert.equal(actual.length, expected.length, what);
  expected.forEach((value, i) => assert.ok(Math.abs((actual[i] ?? NaN) - value) <= tolerance, `${what}: [${Array.from(actual).join(", ")}] is not [${expected.join(", ")}]`));
}

/** Whether the tangents on both sides of a point are one line. */
function isSmooth({ tangents, tangentsIn }: HermiteCurve, i: number): boolean {
  const [a = 0, b = 0] = tangentsIn.subarray(2 * i);
  const [c = 0, d = 0] = tangents.subarray(2 * i);
  return a * c + b * d > 0 && Math.abs(a * d - b * c) <= 1e-9 * Math.hypot(a, b) * Math.hypot(c, d);
}

test("the nearest point or handle within reach is found, a point before a handle, and the curve only where there is neither", () => {
  const curve = only("M0 0C0 0 30 20 40 0C44 -8 70 -20 80 0");
  const at = (x: number, y: number) => hitTest([curve], x, y, { reach: 5, handles: "all" });
  assert.deepEqual(at(41, 1), { kind: "point", curve: 0, index: 1, distance: Math.SQRT2 });
  assert.deepEqual(at(0, 1), { kind: "point", curve: 0, index: 0, distance: 1 }, "its handle lies in the point");
  assert.deepEqual(at(31, 20), { kind: "handle", curve: 0, index: 1, side: "in", distance: 1 });
  assert.deepEqual(at(43, -5.5)?.kind, "handle", "nearer than the point");
  const { x, y } = curve.nearest(20, 8);
  assert.deepEqual(at(x, y + 1)?.kind, "curve");
  assert.equal(at(20, 60), undefined);
  assert.equal(hitTest([curve], 31, 20, { reach: 5 }), undefined, "handles are not shown unless they are named");
  assert.equal(hitTest([curve], 31, 20, { reach: 5, handles: [[0]] }), undefined);
  assert.equal(hitTest([curve], 31, 20, { reach: 5, handles: [[1]] })?.kind, "handle");
  assert.equal(hitTest([curve], x, y + 1, { reach: 5, curveReach: 0.5 }), undefined);
  assert.equal(hitTest([], 0, 0, { reach: 5 }), undefined);
});

test("among many curves what is found is the nearest of all points, and then of all handles that are shown", () => {
  const curves = Object.values(CURVES).map((make) => make());
  const shown = curves.map((curve, c) => Array.from({ length: curve.points.length / 2 }, (_, i) => i).filter((i) => (i + c) % 2 === 0));
  for (let k = 0; k < 400; k += 1) {
    const [x, y] = [((37 * k) % 110) - 10, ((53 * k) % 97) - 30];
    let expected: { kind: string; curve: number; index: number; distance: number } | undefined;
    const look = (kind: string, curve: number, index: number, [u, v]: readonly [number, number]): void => {
      const distance = Math.hypot(u - x, v - y);
      if (distance <= 9 && distance < (expected?.distance ?? Infinity)) expected = { kind, curve, index, distance };
    };
    curves.forEach((curve, c) => curve.points.forEach((px, i) => i % 2 === 0 && look("point", c, i / 2, [px, curve.points[i + 1] ?? 0])));
    curves.forEach((curve, c) => shown[c]?.forEach((i) => Object.values(handlesOf(curve, i)).forEach((end) => look("handle", c, i, end))));
    const hit = hitTest(curves, x, y, { reach: 9, curveReach: 0, handles: shown });
    if (expected === undefined) assert.ok(hit === undefined || hit.kind === "curve");
    else assert.deepEqual([hit?.kind, hit?.curve, hit?.kind === "curve" ? -1 : hit?.index, hit?.distance], Object.values(expected), `${x}, ${y}`);
  }
});

test("of several curves, of whatever kind, the nearest is found by its place in the list", () => {
  const curves = [HermiteCurve.ellipse({ center: [0, 0], radii: [10, 10], count: 2 }), new InterpolatingCurve({ points: [100, 0, 130, 5, 125, 40, 95, 30] })];
  assert.deepEqual(hitTest(curves, 100.5, 0, { reach: 2 }), { kind: "point", curve: 1, index: 0, distance: 0.5 });
  const hit = hitTest(curves, 0, 10.25, { reach: 2 });
  assert.ok(hit?.kind === "curve" && hit.curve === 0);
  assertNear([hit.x, hit.y, hit.distance], [0, 10, 0.25], EXACT, "the circle's top");
});

/** Curves side by side in rows of twenty, 50 apart. */
const manyCurves = (count: number): HermiteCurve[] =>
  Array.from({ length: count }, (_, i) => HermiteCurve.ellipse({ center: [50 * (i % 20), 50 * Math.floor(i / 20)], radii: [20, 15], count: 3 }));

test("of many curves only those within reach are asked how near they are", () => {
  const curves = manyCurves(400);
  const asked = new Set<number>();
  curves.forEach((curve, c) => {
    const { nearest } = curve;
    curve.nearest = (...place) => (asked.add(c), nearest.apply(curve, place));
  });
  // The top of the circle in row 3, column 7, and a place between four of them.
  assert.deepEqual(hitTest(curves, 350, 135.5, { reach: 2 })?.curve, 67);
  assert.equal(hitTest(curves, 375, 175, { reach: 4, handles: "all" }), undefined);
  assert.deepEqual([...asked], [67]);
});

test("a curve is found where it is now: after an edit of any kind, and not where it was", () => {
  const far = [1000, 700] as const;
  const hermite = only("M0 0C10 20 30 20 40 0C50 -20 70 -20 80 0");
  const local = new InterpolatingCurve({ points: [0, 0, 90, 20, 100, 110, 20, 90] }).refineAt(1.5, { levels: 1 });
  const spline = new InterpolatingCurve({ points: [0, 0, 90, 20, 100, 110, 20, 90] });
  const edits: readonly (readonly [string, Curve, () => void])[] = [
    ["a point", hermite, () => hermite.setPoint(1, ...far)],
    ["a tangent", hermite, () => hermite.setTangent(0, 3 * far[0], -2 * far[1])],
    ["a point that the curve interpolates", spline, () => spline.setPoint(2, ...far)],
    ["a point under a patch", local, () => local.setPoint(2, ...far)],
    ["a point of a patch", local, () => local.setPatchPoint(0, 2, -far[0], -far[1])],
  ];
  for (const [what, curve, edit] of edits) {
    assert.equal(hitTest([curve], 5000, 5000, { reach: 5, handles: "all" }), undefined, "both boxes are made");
    const before = curve.sample(9);
    edit();
    const after = curve.sample(99);
    for (let i = 0; i < 99; i += 1) {
      const [x = 0, y = 0] = after.subarray(2 * i);
      assert.ok(hitTest([curve], x, y, { reach: 1e-3, curveReach: 1e-3 }) !== undefined, `${what}: the curve at ${x}, ${y}`);
    }
    for (let i = 0; i < 9; i += 1) {
      const [x = 0, y = 0] = before.subarray(2 * i);
      const gone = curve.nearest(x, y).distance > 1e-3;
      assert.equal(hitTest([curve], x, y, { reach: 1e-3, curveReach: 1e-3 }) === undefined, gone, `${what}: where it was`);
    }
  }
  const handle = handlesOf(hermite, 0).out ?? [NaN, NaN];
  assert.equal(hitTest([hermite], ...handle, { reach: 1, handles: "all" })?.kind, "handle", "a handle far from the curve");
});

test("handles of cubics end at the control points of the Bézier; a free end has one handle", () => {
  const curve = only("M0 0C1 2 3 5 4 0C6 -2 8 -3 9 0");
  assert.deepEqual(Object.keys(handlesOf(curve, 0)), ["out"]);
  assert.deepEqual(Object.keys(handlesOf(curve, 2)), ["in"]);
  assertNear(handlesOf(curve, 0).out ?? [], [1, 2], EXACT, "leaving");
  assertNear(handlesOf(curve, 1).in ?? [], [3, 5], EXACT, "arriving");
  assertNear(handlesOf(curve, 1).out ?? [], [6, -2], EXACT, "leaving");
});

test("points of path data are told smooth from corners, so that a dragged handle keeps what they are", () => {
  const curve = only("M0 0C1 2 3 5 4 5C6 5 8 -3 9 0L15 2");
  assert.deepEqual([0, 1, 2, 3].map((i) => jointOf(curve, i)), ["cusp", "smooth", "cusp", "cusp"]);
  for (const [i, x, y] of [[1, 5, 7], [2, 8, -4]] as const) {
    const before = jointOf(curve, i);
    moveHandle(curve, i, "in", x, y, before);
    assert.equal(jointOf(curve, i), before, `point ${i}`);
  }
  // Back on itself is a corner, however straight the line.
  assert.equal(jointOf(only("M0 0L10 0L5 0"), 1), "cusp");
});

for (const [name, make] of Object.entries(CURVES)) {
  test(`a handle goes where it is put, and the other follows as the joint asks: ${name}`, () => {
    const turned = (joint?: "smooth" | "symmetric" | "cusp") => {
      const curve = make();
      const before = { points: curve.points, ...handlesOf(curve, 1) };
      moveHandle(curve, 1, "out", 37, 21, joint);
      assert.deepEqual(curve.points, before.points);
      const { in: into = [NaN, NaN], out = [NaN, NaN] } = handlesOf(curve, 1);
      assertNear(out, [37, 21], EXACT, "the handle");
      return { curve, before, into };
    };
    const { curve, before, into } = turned();
    assert.ok(isSmooth(curve, 1));
    const [x = 0, y = 0] = curve.points.subarray(2);
    const length = ([u, v]: readonly number[] = []): number => Math.hypot((u ?? NaN) - x, (v ?? NaN) - y);
    assertNear([length(into)], [length(before.in)], EXACT, "the other handle's length");
    assertNear(turned("symmetric").into, [2 * x - 37, 2 * y - 21], EXACT, "the mirror image");
    assertNear(turned("cusp").into, before.in ?? [], EXACT, "the handle that stays");
  });

  test(`the place that is pulled goes where it is pulled, points stay and smooth points stay smooth: ${name}`, () => {
    let from = 0;
    for (const length of make().lengths) {
      for (const x of [0.11, 0.25, 0.5, 0.8]) {
        const curve = make();
        const { points } = curve;
        const smooth = Array.from({ length: points.length / 2 }, (_, i) => isSmooth(curve, i));
        const t = from + x * length;
        bendCurve(curve, t, 33, -12);
        assertNear(curve.evaluate(t), [33, -12], EXACT, `at ${t}`);
        assert.deepEqual(curve.points, points);
        smooth.forEach((was, i) => assert.ok(!was || isSmooth(curve, i), `point ${i} is a corner after a pull at ${t}`));
      }
      from += length;
    }
  });

  test(`tangents weigh what the curve moves by when they change: ${name}`, () => {
    const curve = make();
    const count = curve.points.length / 2;
    let from = 0;
    Array.from(curve.lengths).forEach((length, segment) => {
      const t = from + 0.3 * length;
      from += length;
      const weights = tangentWeights(curve, t);
      const moved = (i: number, side: "in" | "out"): number => {
        const other = make();
        const list = side === "in" ? other.tangentsIn : other.tangents;
        other.setTangent(i, (list[2 * i] ?? 0) + 1, list[2 * i + 1] ?? 0, side);
        return (other.evaluate(t)[0] ?? NaN) - (curve.evaluate(t)[0] ?? NaN);
      };
      assertNear([moved(segment, "out"), moved((segment + 1) % count, "in")], [...weights], EXACT, `segment ${segment}`);
    });
  });
}

test("of all pulls that take the curve there, the tangents change least", () => {
  const make = CURVES["two cubics"];
  assert.ok(make);
  const [before, curve] = [make(), make()];
  const t = 0.35;
  bendCurve(curve, t, 20, 22);
  const [leaving, arriving] = tangentWeights(before, t);
  const change = [0, 1].map((axis) => [(curve.tangents[axis] ?? 0) - (before.tangents[axis] ?? 0), (curve.tangentsIn[2 + axis] ?? 0) - (before.tangentsIn[2 + axis] ?? 0)] as const);
  // The least change is along the weights: any other that moves the place as far adds something at right angles to
  // them.
  for (const [out, into] of change) assert.ok(Math.abs(out * arriving - into * leaving) <= EXACT, `${out}, ${into}`);
});

test("a point that is moved takes its handles along, and straight sides stay straight", () => {
  const moved = (d: string, i: number, x: number, y: number): HermiteCurve => {
    const curve = only(d);
    movePoint(curve, i, x, y);
    return curve;
  };
  const drawn = (curve: HermiteCurve): string => curve.toPathD({ tolerance: 1e-6 }).d;
  assert.equal(drawn(moved("M0 0H100V80H0Z", 2, 130, 95)), drawn(only("M0 0L100 0L130 95L0 80Z")), "the corner of a rectangle");
  assert.equal(drawn(moved("M0 0H50H100V80Z", 1, 50, -30)), drawn(only("M0 0L50 -30L100 0V80Z")), "a point on a side");
  assert.equal(drawn(moved("M0 0L10 0L20 5", 0, -5, -5)), drawn(only("M-5 -5L10 0L20 5")), "an open end");
  assert.equal(drawn(moved("M0 0C3 3 6 6 30 30L30 0", 1, 50, 10)), drawn(only("M0 0C5 1 10 2 50 10L30 0")), "a cubic along its chord keeps its pace");
  const cubics = "M0 0C10 20 30 20 40 0C50 -20 70 -20 80 0";
  const plain = only(cubics);
  plain.setPoint(1, 44, 5);
  assert.deepEqual(moved(cubics, 1, 44, 5).toJSON(), plain.toJSON(), "no side is straight");
  const rounded = moved("M10 10H90V50A20 20 0 0 1 70 70H10Z", 1, 110, 0);
  assert.ok([2, 3].every((i) => isSmooth(rounded, i)), "the arc goes on as the side that leads to it");
  assert.match(drawn(rounded), /^M10 10 110 0 90 50C[\d. ]+H10Z$/);
  const twoPoints = moved("M0 0L10 0Z", 1, 10, 10);
  assert.equal(drawn(twoPoints), drawn(only("M0 0L10 10Z")));
  const back = moved("M0 0H100V80Z", 1, 0, 0);
  movePoint(back, 1, 100, 0);
  assert.ok(back.flatten(1e-9).length === 6 && back.area() === 4000, "a side without length is straight again");
});

test("near a point the curve follows by a part of the way, and no tangent grows beyond measure", () => {
  const curve = HermiteCurve.ellipse({ center: [0, 0], radii: [10, 10], count: 4 });
  bendCurve(curve, 1 + 1e-6, 0, 30);
  assert.ok(Math.max(...curve.tangents.map(Math.abs)) < 1000);
});

test("a call that throws says which argument is wrong, and changes nothing", () => {
  const curve = HermiteCurve.ellipse({ center: [0, 0], radii: [10, 10], count: 4 });
  const line = only("M0 0L10 0");
  const before = JSON.stringify(curve);
  const reach = { reach: 1 };
  for (const [run, code, argument] of [
    [() => bendCurve(curve, 0.05, 1e9, 0), "E_RANGE", "tangent"],
    [() => bendCurve(curve, Number.NaN, 0, 0), "E_NOT_FINITE", "t"],
    [() => bendCurve(line, 1.5, 0, 0), "E_RANGE", "t"],
    [() => bendCurve({} as HermiteCurve, 0, 0, 0), "E_TYPE", "curve"],
    [() => moveHandle(curve, 4, "out", 0, 0), "E_RANGE", "i"],
    [() => moveHandle(curve, 0, "both" as "in", 0, 0), "E_RANGE", "side"],
    [() => moveHandle(curve, 0, "in", 0, Infinity), "E_NOT_FINITE", "y"],
    [() => moveHandle(curve, 0, "in", 0, 0, "round" as "cusp"), "E_RANGE", "joint"],
    [() => moveHandle(line, 0, "in", 0, 0), "E_RANGE", "side"],
    [() => moveHandle(line, 1, "out", 0, 0), "E_RANGE", "side"],
    [() => handlesOf(curve, -1), "E_RANGE", "i"],
    [() => jointOf(curve, 4), "E_RANGE", "i"],
    [() => movePoint(curve, 4, 0, 0), "E_RANGE", "i"],
    [() => movePoint(line, 0, 0, Number.NaN), "E_NOT_FINITE", "y"],
    [() => movePoint(new InterpolatingCurve({ points: [0, 0, 1, 0, 1, 1] }) as unknown as HermiteCurve, 0, 0, 0), "E_TYPE", "curve"],
    [() => tangentWeights(curve, "1" as unknown as number), "E_TYPE", "t"],
    [() => hitTest(curve as unknown as HermiteCurve[], 0, 0, reach), "E_TYPE", "curves"],
    [() => hitTest([curve, {} as HermiteCurve], 0, 0, reach), "E_TYPE", "curves[1]"],
    [() => hitTest(new Array<HermiteCurve>(3), 0, 0, reach), "E_TYPE", "curves[0]"],
    [() => hitTest([new InterpolatingCurve({ points: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 1]] })], 0, 0, reach), "E_TYPE", "curves[0]"],
    [() => hitTest([curve], 0, 0, { reach: -1 }), "E_RANGE", "reach"],
    [() => hitTest([curve], 0, 0, { reach: 1, handles: [[7]] }), "E_RANGE", "handles[0][0]"],
    [() => hitTest([curve], 0, 0, { reach: 1, handles: "some" as "all" }), "E_TYPE", "handles"],
  ] as const) {
    assert.throws(run, (error) => error instanceof ExplineError && error.code === code && error.argument === argument, `${code} ${argument}`);
  }
  assert.equal(JSON.stringify(curve), before);
  assert.deepEqual(line.toJSON(), only("M0 0L10 0").toJSON());
});

test("expline/edit has the same functions, and loads no wasm of its own", () => {
  assert.equal(edit.hitTest, hitTest);
  assert.equal(edit.bendCurve, bendCurve);
});

test("a curve of another copy of the package is refused as such, and what is no curve as what it is", async () => {
  const slim = await import("expline/slim");
  await slim.default();
  const foreign = slim.HermiteCurve.ellipse({ center: [0, 0], radii: [5, 5], count: 3 });
  assert.throws(() => movePoint(foreign, 0, 1, 1), { code: "E_TYPE", argument: "curve", message: /: curve is a curve of another copy of expline, as expline\/slim is beside expline; expected a HermiteCurve / });
  assert.throws(() => hitTest([only("M0 0L9 9"), foreign], 0, 0, { reach: 1 }), { code: "E_TYPE", argument: "curves[1]", message: /: curves\[1\] is a curve of another copy of expline, / });
  const none = { get [Symbol.toStringTag](): string { throw new Error("mine"); } };
  assert.throws(() => bendCurve(none as unknown as HermiteCurve, 0, 1, 1), { code: "E_TYPE", message: /: curve is an object; / });
});
