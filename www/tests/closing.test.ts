import assert from "node:assert/strict";
import { before, test } from "node:test";
import init, { parsePath } from "expline/slim";
import * as icons from "simple-icons";
import { joined } from "../src/document/curve/whole/rearranging.ts";
import { emptyCurve, type Contour } from "../src/document/document.ts";
import { curveOf } from "../src/kernel/curve/curve-cache.ts";
import { closedByLine, joinedNearly, nearIn } from "../src/kernel/paths/closing.ts";
import { contoursOfPath } from "./harness.ts";

/** What is filled is closed. The oracle is the same path data with the Z that they lack, read by the library. */

before(() => init());

const closedAsArea = (contour: Contour, near = nearIn([contour])): Contour => closedByLine(joinedNearly(joined(contour), near));

function places(contour: Contour): Float64Array {
  const curve = curveOf({ ...emptyCurve, contours: [contour] }, contour);
  assert.ok(curve !== null);
  return curve.flatten(1e-4);
}

/** How far the contour is from what the path data with a Z draw. */
function awayFrom(contour: Contour, d: string): number {
  const [whole] = parsePath(d);
  assert.ok(whole !== undefined);
  const nearest = whole.nearestAll(places(contour));
  let worst = 0;
  for (let i = 3; i < nearest.length; i += 4) worst = Math.max(worst, nearest[i] ?? 0);
  return worst;
}

test("an open outline that is filled is closed by the line that the filling has, exactly", () => {
  for (const d of ["M0 0H20V20H5", "M0 0C5 -9 15 -9 20 0S10 30 5 20", "M0 0A10 10 0 0 1 20 0", "M3 1Q9 12 -4 20L-9 4"]) {
    const [open] = contoursOfPath(d, "trigonometric");
    assert.ok(open !== undefined && !open.closed);
    const contour = closedAsArea(open);
    assert.ok(contour.closed && contour.points.length === open.points.length, d);
    // Polylines within 1e-4, and sums of rounding.
    assert.ok(awayFrom(contour, `${d}Z`) < 1e-9, `${d}: ${awayFrom(contour, `${d}Z`)}`);
  }
});

test("ends that were meant to be one are one point, and what was drawn open stays open", () => {
  const [nearly] = contoursOfPath("M0 0H20V20H.001V.002", "trigonometric");
  const [open] = contoursOfPath("M0 0H20V20H.5V.5", "trigonometric");
  const [line] = contoursOfPath("M0 0L20 10", "trigonometric");
  assert.ok(nearly !== undefined && open !== undefined && line !== undefined);
  const contour = joinedNearly(nearly, nearIn([nearly]));
  assert.ok(contour.closed && contour.points.length === 4);
  assert.deepEqual([contour.points[0]?.x, contour.points[0]?.y], [0, 0]);
  assert.equal(joinedNearly(open, nearIn([open])), open);
  assert.equal(closedAsArea(line), line, "a line of two points encloses nothing");
});

test("no logo of simple-icons has an open outline once it is filled, and none is moved by more than its file's digits", () => {
  let wereOpen = 0;
  for (const icon of Object.values(icons)) {
    if (!("path" in icon)) continue;
    const contours = contoursOfPath(icon.path, "trigonometric").map(joined);
    const near = nearIn(contours);
    for (const contour of contours) {
      if (contour.closed) continue;
      const area = closedAsArea(contour, near);
      if (!area.closed) {
        assert.ok(contour.points.length <= 2, `${icon.slug} has an open outline of ${contour.points.length} points`);
        continue;
      }
      wereOpen += 1;
      const last = contour.points.at(-1);
      const kept = area.points.length === contour.points.length ? area.points.at(-1) : area.points[0];
      assert.ok(last !== undefined && kept !== undefined);
      // Seven units of the third decimal, at the end of many relative commands.
      assert.ok(Math.hypot(last.x - kept.x, last.y - kept.y) < 0.007, icon.slug);
    }
  }
  assert.ok(wereOpen > 500, String(wereOpen));
});
