import assert from "node:assert/strict";
import { test } from "node:test";
import { rectangleIn } from "../src/document/curve/drawing/shapes.ts";
import { rounded } from "../src/kernel/curve/rounding/rounded.ts";
import type { CurveDocument } from "../src/document/document.ts";
import { contoursOfPath } from "./harness.ts";
const doc: CurveDocument = { space: "trigonometric", omega: "auto", level: 0, contours: [] };
test("look", () => {
  const rect = rectangleIn({ minX: 0, minY: 0, maxX: 200, maxY: 100 });
  for (const r of [20, 50, Infinity]) {
    const out = rounded(doc, rect, [0, 1, 2, 3], r);
    console.log(r, out.contour.points.map(({ x, y, kind }) => `${x},${y} ${kind}`), out.made, out.radii, out.contour.omega);
  }
  const [glyph] = contoursOfPath("M0 0 C 30 60 80 60 100 0 C 80 -20 20 -20 0 0 Z");
  assert.ok(glyph);
  for (const r of [0.5, 5, 10, Infinity]) {
    console.time("r");
    const out = rounded(doc, glyph, [0, 1], r);
    console.timeEnd("r");
    console.log(r, out.contour.points.map(({ x, y, kind }) => `${x},${y} ${kind}`), out.refused, out.radii, out.contour.omega);
  }
});
