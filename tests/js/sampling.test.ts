// Many points at once, which the package makes in blocks.

import assert from "node:assert/strict";
import { test } from "node:test";

import { HermiteCurve } from "expline";

test("points that are made in blocks are those that are made alone, also where blocks are long", () => {
  for (const closed of [true, false]) {
    const curve = HermiteCurve.through([[0, 0], [90, 20], [100, 110], [20, 90]], { closed });
    const [from, to] = curve.domain;
    // Blocks have 8,192 points, of 262,144 points and more 131,072.
    for (const count of [20_000, 2 ** 18 - 1, 2 ** 18, 300_001]) {
      for (const tangents of [false, true]) {
        const all = curve.sample(count, { tangents });
        const each = tangents ? 4 : 2;
        assert.equal(all.length, each * count);
        for (const i of [0, 8191, 8192, 16_384, 131_071, 131_072, 262_143, 262_144, count - 1].filter((place) => place < count)) {
          const t = from + ((to - from) * i) / (closed ? count : count - 1);
          const alone = [...curve.evaluate(t), ...(tangents ? curve.evaluate(t, 1) : [])];
          const off = Math.max(...alone.map((value, k) => Math.abs(value - (all[each * i + k] ?? NaN))));
          // Of coordinates of a hundred, and derivatives of a few hundred, a few roundings.
          assert.ok(off < 1e-12, `point ${i} of ${count} is ${off} off`);
        }
      }
    }
  }
});
