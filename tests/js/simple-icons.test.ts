// Every logo of simple-icons, from path data to curves, back to path data and to curves again. Distances are measured
// by a reader and evaluator of the tests' own.

import assert from "node:assert/strict";
import { test } from "node:test";

import { HermiteCurve, parsePath } from "expline";
import * as simpleIcons from "simple-icons";

import { at, drawing, type Contour, type Piece, type Point } from "./drawing.ts";

/** What curves may be off the text's own formulas, on drawings of size 24: a hundred roundings of 3.6e-15. */
const EXACT = 4e-13;
/** Arcs longer than this are two segments; a little over π is a half turn in spite of rounding. */
const HALF_TURN = Math.PI + 1e-6;
/** To what the tests find distances that are next to nothing. */
const SEARCHED = 1e-7;
/** The tolerance that path data is asked for. */
const TOLERANCE = 1e-3;
/** Places on each piece at which distances are measured. */
const PLACES = [0, 0.21, 0.5, 0.83, 1];

const icons = Object.values(simpleIcons).filter(({ path }) => typeof path === "string");

/** The largest distance of a segment of the curve from its piece of the drawing, at equal parameters. */
function deviationOf(name: string, curve: HermiteCurve, { pieces, closed }: Contour): number {
  assert.equal(curve.closed, closed, name);
  let worst = 0;
  let segment = 0;
  for (const [k, piece] of pieces.entries()) {
    const [from, to] = [at(piece, 0), at(piece, 1)];
    // The line that closes a gap of a rounding is none.
    const closing = k + 1 === pieces.length && piece.kind === "bezier" && piece.points.length === 2;
    if (closing && Math.hypot(to[0] - from[0], to[1] - from[1]) < EXACT) continue;
    const count = piece.kind === "arc" && Math.abs(piece.sweep) > HALF_TURN ? 2 : 1;
    // A loop of one piece is two segments.
    const parts = pieces.length === 1 && closed && count === 1 ? curve.domain[1] : count;
    const places = PLACES.map((x) => Math.min(segment + x * parts, curve.domain[1]));
    const points = curve.evaluate(Float64Array.from(places));
    for (const [i, x] of PLACES.entries()) {
      if (curve.closed && places[i] === curve.domain[1]) continue;
      const [px, py] = at(piece, x);
      // The oracle's centre of a flat arc is as exact as its radius is large.
      const size = piece.kind === "arc" ? Math.max(1, Math.max(...piece.radii) / 24) : 1;
      worst = Math.max(worst, Math.hypot((points[2 * i] ?? NaN) - px, (points[2 * i + 1] ?? NaN) - py) / size);
    }
    segment += parts;
  }
  assert.equal(segment, curve.domain[1], `${name}: segments`);
  return worst;
}

/** The distance from a point to a piece, or more where the search ends in the wrong valley. */
function toPiece([px, py]: Point, piece: Piece): number {
  const apart = (x: number): number => {
    const [qx, qy] = at(piece, x);
    return Math.hypot(qx - px, qy - py);
  };
  let nearest = 0;
  for (let k = 1; k <= 8; k += 1) if (apart(k / 8) < apart(nearest)) nearest = k / 8;
  let [low, high] = [Math.max(0, nearest - 0.125), Math.min(1, nearest + 0.125)];
  for (let k = 0; k < 32; k += 1) {
    const [a, b] = [low + 0.382 * (high - low), low + 0.618 * (high - low)];
    if (apart(a) < apart(b)) high = b;
    else low = a;
  }
  return Math.min(apart((low + high) / 2), apart(nearest));
}

/** A bound of the piece's speed. */
function speedOf(piece: Piece): number {
  if (piece.kind === "arc") return Math.abs(piece.sweep) * Math.max(...piece.radii);
  const steps = piece.points.slice(1).map((p, k) => {
    const q = piece.points[k] ?? p;
    return Math.hypot(p[0] - q[0], p[1] - q[1]);
  });
  return steps.length * Math.max(...steps);
}

/**
 * The distance from a point to a piece, or `enough` where it is less and `most` where it is more: no valley is missed,
 * because none is deeper than the speed lets it be.
 */
function surelyToPiece([px, py]: Point, piece: Piece, enough: number, most: number): number {
  const speed = speedOf(piece);
  const apart = (x: number): number => {
    const [qx, qy] = at(piece, x);
    return Math.hypot(qx - px, qy - py);
  };
  let best = most;
  const open: [number, number, number, number][] = [[0, 1, apart(0), apart(1)]];
  for (let interval = open.pop(); interval; interval = open.pop()) {
    const [low, high, nearLow, nearHigh] = interval;
    best = Math.min(best, nearLow, nearHigh);
    if (best <= enough) return enough;
    if ((nearLow + nearHigh - speed * (high - low)) / 2 >= Math.max(enough, best - SEARCHED)) continue;
    const middle = (low + high) / 2;
    const near = apart(middle);
    open.push([low, middle, nearLow, near], [middle, high, near, nearHigh]);
  }
  return best;
}

interface Nearest {
  distance: number;
  piece: Piece;
}

/**
 * A piece of a contour that is near enough, sought around `guess` first, or else the nearest of all; `first` pieces are
 * looked at in any case.
 */
function nearestOn(contour: Contour, p: Point, guess: number, enough: number, first = 0): Nearest {
  const { pieces } = contour;
  const count = pieces.length;
  let best: Nearest | undefined;
  for (let k = 0; k < count; k += 1) {
    // guess, then one after it, one before it, two after it …
    const offset = (k + 1) >> 1;
    const piece = pieces[(((k % 2 ? guess + offset : guess - offset) % count) + count) % count];
    if (!piece) continue;
    const distance = toPiece(p, piece);
    if (!best || distance < best.distance) best = { distance, piece };
    if (k >= first && best.distance <= enough) break;
  }
  if (best && best.distance > enough) {
    for (const piece of pieces) {
      const distance = surelyToPiece(p, piece, enough, best.distance);
      if (distance < best.distance) best = { distance, piece };
      if (distance <= enough) break;
    }
  }
  assert.ok(best, "a contour has pieces");
  return best;
}

/** The largest distance of one drawing from another, and how many of its arcs lie on arcs there. */
function farthest(from: Contour, to: Contour, enough: number): { distance: number; arcs: number } {
  let distance = 0;
  let arcs = 0;
  for (const [k, piece] of from.pieces.entries()) {
    const guess = Math.round((k * to.pieces.length) / from.pieces.length);
    for (const x of PLACES) {
      const nearest = nearestOn(to, at(piece, x), guess, enough, x === 0.5 ? 4 : 0);
      distance = Math.max(distance, nearest.distance);
      if (piece.kind === "arc" && x === 0.5 && nearest.piece.kind === "arc") arcs += 1;
    }
  }
  return { distance, arcs };
}

const arcsIn = (contour: Contour): number => contour.pieces.filter(({ kind }) => kind === "arc").length;

test("every logo is read exactly", (t) => {
  let [worst, curveCount, segments] = [0, 0, 0];
  for (const { slug, path } of icons) {
    const curves = parsePath(path);
    const contours = drawing(path);
    assert.equal(curves.length, contours.length, `${slug}: contours`);
    for (const [k, curve] of curves.entries()) {
      const contour = contours[k];
      assert.ok(contour);
      const deviation = deviationOf(slug, curve, contour);
      assert.ok(deviation <= EXACT, `${slug}, contour ${k}: off by ${deviation}`);
      worst = Math.max(worst, deviation);
      curveCount += 1;
      segments += contour.pieces.length;
    }
  }
  assert.ok(icons.length > 3000, `${icons.length} logos`);
  t.diagnostic(`${icons.length} logos, ${curveCount} curves, ${segments} segments read: worst deviation ${worst.toExponential(1)} on drawings of size 24`);
});

test(`every logo goes to path data and back within ${TOLERANCE}, both ways`, (t) => {
  let [worst, reported, arcs, kept, written] = [0, 0, 0, 0, 0];
  for (const { slug, path } of icons) {
    const contours = drawing(path);
    for (const [k, curve] of parsePath(path).entries()) {
      const { d, maxError } = curve.toPathD({ tolerance: TOLERANCE });
      assert.ok(maxError <= TOLERANCE, `${slug}, contour ${k}: reports ${maxError}`);
      const [again, more] = parsePath(d);
      assert.ok(again && !more, `${slug}, contour ${k}: one curve again from ${d}`);
      const before = contours[k];
      const [after] = drawing(d);
      assert.ok(before && after);
      deviationOf(slug, again, after);
      const enough = maxError + SEARCHED;
      const there = farthest(before, after, enough);
      const back = farthest(after, before, enough);
      const distance = Math.max(there.distance, back.distance);
      assert.ok(distance <= TOLERANCE + SEARCHED, `${slug}, contour ${k}: ${distance} from the original: ${d}`);
      assert.ok(distance <= maxError + SEARCHED, `${slug}, contour ${k}: ${distance}, but ${maxError} was reported: ${d}`);
      assert.equal(there.arcs, arcsIn(before), `${slug}, contour ${k}: arcs stay arcs: ${d}`);
      worst = Math.max(worst, distance);
      reported = Math.max(reported, maxError);
      arcs += arcsIn(before);
      kept += arcsIn(after);
      written += d.length;
    }
  }
  t.diagnostic(
    `tolerance ${TOLERANCE}: worst distance ${worst.toExponential(2)} (reported ${reported.toExponential(2)}), ` +
      `${arcs} arcs in, ${kept} out (neighbours on one ellipse are joined), ${written} characters`,
  );
});

test("every logo's lines and Béziers come back to the last bit with 17 decimals", (t) => {
  let [same, curved] = [0, 0];
  for (const { slug, path } of icons) {
    for (const [k, curve] of parsePath(path).entries()) {
      const [again] = parsePath(curve.toPathD({ decimals: 17 }).d);
      assert.ok(again, slug);
      if (curve.omega.some((omega) => omega > 0)) {
        curved += 1;
        continue;
      }
      assert.deepEqual(again.toJSON(), curve.toJSON(), `${slug}, contour ${k}`);
      same += 1;
    }
  }
  t.diagnostic(`${same} curves without arcs are the same to the last bit; ${curved} have arcs`);
});
