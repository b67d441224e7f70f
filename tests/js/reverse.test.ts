// A curve run backwards, through the front door: every place from the other end, and nothing shared with the curve that
// it was made of.

import assert from "node:assert/strict";
import { test } from "node:test";

import { HermiteCurve } from "expline";

const POINTS = [0, 0, 4, 1, 5, 5, 1, 6, -2, 3];
const ARRIVING = POINTS.map((x) => 3 - x);

for (const [what, curve] of [
  ["a closed curve", new HermiteCurve({ points: POINTS, tangents: POINTS })],
  ["an open curve with corners", new HermiteCurve({ points: POINTS, tangents: POINTS, tangentsIn: ARRIVING, closed: false, space: "hyperbolic", omega: 2 })],
  ["a closed curve with corners, of uneven segments", new HermiteCurve({ points: POINTS, tangents: POINTS, tangentsIn: ARRIVING, omega: [1, 2, 0, 0.5, 1.5], lengths: [1, 2, 0.5, 1, 3] })],
  ["an open curve of two points", new HermiteCurve({ points: [0, 1, 2, 3], tangents: [1, 0, 0, -1], closed: false })],
] as const) {
  test(`${what}: reversed, it has every place of the other end and the opposite way there`, () => {
    const back = curve.reverse();
    const [, end] = curve.domain;
    assert.ok(Math.abs(back.domain[1] - end) <= Number.EPSILON * end, "the sum of the same lengths");
    assert.equal(back.closed, curve.closed);
    for (let k = 1; k < 40; k += 1) {
      const t = (end * (k + 0.37)) / 41;
      // Coordinates of about 10, and t and end − t each with a rounding.
      for (const [derivative, sign] of [[0, 1], [1, -1], [2, 1]] as const) {
        const [there, here] = [back.evaluate(t, derivative), curve.evaluate(end - t, derivative)];
        for (const axis of [0, 1]) {
          const off = Math.abs((there[axis] ?? NaN) - sign * (here[axis] ?? NaN));
          assert.ok(off < 1e-12, `derivative ${derivative} at ${t}: ${off}`);
        }
      }
    }
    assert.deepEqual(back.points.slice(0, 2), curve.closed ? curve.points.slice(0, 2) : curve.points.slice(-2), "a closed curve still starts at point 0");
    assert.deepStrictEqual(back.reverse().toJSON(), curve.toJSON(), "twice reversed it is the curve");
    assert.ok([...back.tangents, ...back.tangentsIn].every((x) => !Object.is(x, -0)), "JSON carries no −0");
  });
}

test("a reversed curve shares no number with its curve, and knows what was changed before", () => {
  const curve = new HermiteCurve({ points: POINTS, tangents: POINTS, tangentsIn: ARRIVING, closed: false, lengths: [1, 2, 3, 4] });
  curve.setPoint(1, 7, 7);
  const before = JSON.stringify(curve);
  const back = curve.reverse();
  assert.deepEqual(Array.from(back.points.slice(6, 8)), [7, 7]);
  back.setPoint(0, 9, 9);
  back.setTangent(0, 1, 2);
  assert.equal(JSON.stringify(curve), before);
  assert.deepEqual(Array.from(back.evaluate(0)), [9, 9]);
});
