import assert from "node:assert/strict";
import { test } from "node:test";
import { Problem } from "../src/document/problem.ts";
import { readPoints } from "../src/io/rows.ts";

const three = [[1.5, 2.5], [3.5, 4], [5, -6.25]];

test("points are read as tables of any country have them", () => {
  for (const text of [
    "1.5,2.5\n3.5,4\n5,-6.25", "1.5 2.5\n3.5 4\n5 -6.25\n", "x,y\n1.5,2.5\n3.5,4\n5,-6.25", "1.5\t2.5\r\n3.5\t4\r\n5\t-6.25\r\n", "1.5;2.5\n3.5;4\n5;-6.25",
    // With a comma in fractions, as spreadsheets write them in much of Europe, to files and to the clipboard.
    "1,5;2,5\n3,5;4\n5;-6,25", "x;y\n1,5;2,5\n3,5;4\n5;-6,25\n", "1,5\t2,5\n3,5\t4\n5\t-6,25",
  ]) assert.deepEqual(readPoints(text).points, three, JSON.stringify(text));
});

test("a list of points is read however a program has set it", () => {
  const named = three.map(([x, y]) => ({ x, y }));
  for (const value of [three, named]) for (const space of [0, 2, "\t"]) assert.deepEqual(readPoints(JSON.stringify(value, null, space)).points, three);
});

test("a row without two numbers is named, and a missing number is not 0", () => {
  for (const [text, line] of [
    ["1,2\n3,\n5,6", 2], ["1;2\n3;4\n;6", 3], ["1,2\n,4\n5,6", 2], ["1\t2\n3\n", 2], ["x,y,z\n1,2,3\n4,5,6", 2], ["1,2,3\n4,5,6", 1], ["0,0\n1e12,5", 2],
  ] as const) {
    assert.throws(() => readPoints(text), (error) => error instanceof Problem && error.id === "points-rows" && error.details.line === line, JSON.stringify(text));
  }
});
