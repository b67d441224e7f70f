import assert from "node:assert/strict";
import { test } from "node:test";
import { formatBytes, formatCoordinate, formatDeviation, parseTyped } from "../src/panels/controls/format.ts";

const typed: readonly (readonly [id: string, text: string, value: number | null])[] = [
  ["DM-027", "1,5", 1.5],
  ["DM-027b", "-0,25", -0.25],
  ["DM-027c", ".5", 0.5],
  ["DM-027d", " 12 ", 12],
  ["DM-027e", "1e2", 100],
  ["DM-027f", "\u22123", -3],
  ["DM-029", "476.00+10", 486],
  ["DM-029b", "2 * 3 - 1,5", 4.5],
  ["DM-029c", "100/8", 12.5],
  ["DM-029d", "1-2*-3/4", 2.5],
  ["DM-029e", "-5--2", -3],
  ["DM-029f", "120px", 120],
  ["DM-029g", "45 °", null],
  ["DM-029h", "45°", 45],
  ["DM-029i", "1/0", null],
  ["DM-029j", "5+", null],
  ["DM-029k", "5**2", null],
  ["DM-029l", "2e2+1", 201],
  ["DM-029m", "1e6+1", null],
  ["DM-028", "1e999", null],
  ["DM-028b", "abc", null],
  ["DM-028c", "", null],
  ["DM-028d", "0x10", null],
  ["DM-028e", "1,234,5", null],
  ["DM-028f", "NaN", null],
  ["DM-028g", "Infinity", null],
  ["DM-028h", "1 000", null],
  ["DM-028i", "2000000", null],
];

for (const [id, text, value] of typed) {
  test(`${id} typing ${JSON.stringify(text)} into a field up to 1e6 means ${value === null ? "nothing, and the old value stays" : value}`, () => {
    assert.equal(parseTyped(text, -1e6, 1e6), value);
  });
}

test("printed numbers are short, never localised and never minus zero", () => {
  assert.equal(formatDeviation(2.9e-16), "3e-16");
  assert.equal(formatDeviation(0.00273), "0.0027");
  assert.equal(formatDeviation(0), "0");
  assert.equal(formatCoordinate(-0.001), "0.00");
  assert.equal(formatCoordinate(1234.5), "1234.50");
  assert.equal(formatBytes(94), "94 B");
  assert.equal(formatBytes(1234), "1.23 kB");
});
