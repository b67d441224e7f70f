// Scores a drawing of closed outlines against the true ones. Distances are in pixels of the picture.

import { Outline, cleaned, round } from "./outline.mjs";
import { Places } from "./places.mjs";
import { Raster } from "./raster.mjs";
import { readFilled } from "./svg.mjs";

/** Drawings are compared as areas at this size at least. */
const AREA_SIZE = 1024;
/** What a raster shows of a corner or a tight bend. */
const ZONE = 1.5;

const scaled = (contours, size) => contours.map((contour) => contour.map((p) => p.map((v) => v * size)));

/** The ink of elements painted in their order on white paper. */
function painted(elements, size, side) {
  const paper = new Float32Array(side * side).fill(1);
  for (const { shade, contours, rule } of elements) {
    const cover = new Raster(side, side).add(contours, side / size).coverage(rule);
    for (let i = 0; i < cover.length; i++) paper[i] += cover[i] * (shade - paper[i]);
  }
  return paper.map((value) => 1 - value);
}

/** The true outlines, prepared once for one size. `contours` are in the unit square. */
export function truth(shape, size) {
  const contours = cleaned(scaled(shape.contours, size));
  const side = Math.max(AREA_SIZE, size);
  const outline = new Outline(contours, size <= 512 ? 0.125 : 0.25);
  const breaks = outline.joints.filter((j) => Math.abs(j.turn) >= 10).flatMap((j) => [j.x, j.y]);
  return {
    size,
    side,
    segments: shape.segments,
    outline,
    ink: painted([{ shade: 0, contours, rule: "nonzero" }], size, side),
    zone: new Places(Float64Array.from([...breaks, ...outline.tight()])),
    corners: lonely(outline),
    turning: outline.totalTurning(),
  };
}

/** Corners of 30° and more with no other turning of 10° within 3 px along the outline. */
function lonely(outline) {
  const all = outline.corners(10);
  return all.filter((corner) => {
    if (Math.abs(corner.turn) < 30) return false;
    const length = outline.lengths[corner.contour];
    return all.every((o) => o === corner || o.contour !== corner.contour || round(o.along, corner.along, length) >= 3);
  });
}

/** The elements whose outlines count: the ink, and lighter ones where these erase some of it. */
function inkOf(elements, ink, size, side) {
  const dark = elements.filter((e) => e.shade < 0.5 && e.contours.length > 0);
  const first = elements.findIndex((e) => e.shade < 0.5);
  const light = first < 0 ? [] : elements.slice(first).filter((e) => e.shade >= 0.5 && e.contours.length > 0);
  if (light.length === 0) return dark;
  const alone = painted(dark, size, side);
  let [changed, total] = [0, 0];
  for (let i = 0; i < ink.length; i++) {
    changed += Math.abs(alone[i] - ink[i]);
    total += ink[i];
  }
  return changed > 0.1 * Math.max(1, total) ? [...dark, ...light] : dark;
}

function likeness(a, b) {
  let [both, any] = [0, 0];
  for (let i = 0; i < a.length; i++) {
    both += Math.min(a[i], b[i]);
    any += Math.max(a[i], b[i]);
  }
  return both / Math.max(1e-9, any);
}

/** Distances from one outline's samples to another: mean, mean of squares, largest, and each with its weight. */
function distances(from, to) {
  const out = { mean: 0, square: 0, most: 0, all: [], samples: new Int32Array(from.count) };
  for (let i = 0; i < from.count; i++) {
    const { distance, sample } = to.nearest(from.places[2 * i], from.places[2 * i + 1]);
    const weight = from.weights[i] / from.total;
    out.mean += distance * weight;
    out.square += distance * distance * weight;
    out.most = Math.max(out.most, distance);
    out.all.push([distance, weight]);
    out.samples[i] = sample;
  }
  return out;
}

function percentile(pairs, share) {
  pairs.sort((a, b) => a[0] - b[0]);
  const total = pairs.reduce((sum, [, weight]) => sum + weight, 0);
  let sum = 0;
  for (const [distance, weight] of pairs) {
    sum += weight;
    if (sum >= share * total) return distance;
  }
  return pairs[pairs.length - 1][0];
}

/** The mean angle between tangents in degrees, away from corners; undefined where there is no such place. */
function tangentError(true_, samples, traced, zone) {
  let [sum, total, count] = [0, 0, 0];
  for (let i = 0; i < true_.count; i++) {
    if (zone.distance(true_.places[2 * i], true_.places[2 * i + 1]) <= 2.5) continue;
    const [ax, ay] = [true_.tangents[2 * i], true_.tangents[2 * i + 1]];
    const [bx, by] = [traced.tangents[2 * samples[i]], traced.tangents[2 * samples[i] + 1]];
    const angle = Math.abs(Math.atan2(ax * by - ay * bx, ax * bx + ay * by)) * (180 / Math.PI);
    sum += Math.min(angle, 180 - angle) * true_.weights[i];
    total += true_.weights[i];
    count++;
  }
  return count > 10 ? sum / total : undefined;
}

/** True corners found, missed, invented and doubled. */
function corners(goal, traced) {
  const found = traced.corners(20);
  const pairs = [];
  goal.corners.forEach((a, i) => found.forEach((b, j) => pairs.push([Math.hypot(a.x - b.x, a.y - b.y), i, j])));
  const [met, used] = [new Set(), new Set()];
  let error = 0;
  for (const [distance, i, j] of pairs.filter((p) => p[0] <= ZONE).sort((a, b) => a[0] - b[0])) {
    if (met.has(i) || used.has(j)) continue;
    met.add(i);
    used.add(j);
    error += distance;
  }
  const rest = found.filter((c, j) => !used.has(j) && Math.abs(c.turn) >= 30);
  return {
    cornersTrue: goal.corners.length,
    cornersHit: met.size,
    cornersError: error,
    cornersFalse: rest.filter((c) => goal.zone.distance(c.x, c.y) > ZONE).length,
    cornersDouble: rest.filter((c) => goal.corners.some((t) => Math.hypot(t.x - c.x, t.y - c.y) <= ZONE)).length,
    missed: goal.corners.filter((_, i) => !met.has(i)),
  };
}

/** Everything measured of one drawing; undefined where nothing is drawn. */
export function score(goal, svg) {
  const elements = readFilled(svg, goal.size);
  const ink = painted(elements, goal.size, goal.side);
  const counted = inkOf(elements, ink, goal.size, goal.side);
  const contours = counted.flatMap((e) => e.contours);
  if (contours.length === 0) return undefined;
  const traced = new Outline(contours, goal.size <= 512 ? 0.125 : 0.25);
  const [there, back] = [distances(traced, goal.outline), distances(goal.outline, traced)];
  const kinks = traced.joints.filter((j) => Math.abs(j.turn) > 5 && goal.zone.distance(j.x, j.y) > ZONE);
  return {
    mean: 0.5 * (there.mean + back.mean),
    rms: Math.sqrt(0.5 * (there.square + back.square)),
    hausdorff: Math.max(there.most, back.most),
    p99: percentile([...there.all, ...back.all], 0.99),
    iou: likeness(ink, goal.ink),
    angle: tangentError(goal.outline, back.samples, traced, goal.zone),
    wiggle: traced.totalTurning() / goal.turning,
    segments: counted.reduce((sum, e) => sum + e.segments, 0),
    segmentsTrue: goal.segments,
    ...corners(goal, traced),
    kinks: kinks.length,
    bytes: Buffer.byteLength(svg),
  };
}

/** One row of a table from the scores of many pictures. */
export function summary(scores) {
  const drawn = scores.filter((s) => s !== undefined);
  const over = (key) => drawn.map((s) => s[key]).filter((v) => v !== undefined);
  const sum = (key) => over(key).reduce((a, b) => a + b, 0);
  const mean = (key) => sum(key) / Math.max(1, over(key).length);
  const hits = sum("cornersHit");
  return {
    failed: scores.length - drawn.length,
    mean: mean("mean"),
    hausdorff: mean("hausdorff"),
    p99: mean("p99"),
    iou: mean("iou"),
    angle: mean("angle"),
    wiggle: mean("wiggle"),
    segments: sum("segments") / Math.max(1, sum("segmentsTrue")),
    recall: hits / Math.max(1, sum("cornersTrue")),
    precision: hits / Math.max(1, hits + sum("cornersFalse") + sum("cornersDouble")),
    cornerError: sum("cornersError") / Math.max(1, hits),
    kinks: sum("kinks") / Math.max(1, drawn.length),
    bytes: mean("bytes"),
  };
}
