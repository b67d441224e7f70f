import { partsOf } from "../../document/curve/parts.ts";
import type { Contour, CurveDocument } from "../../document/document.ts";
import { bezierPolygon, combOf } from "../../kernel/curve/overlays/comb.ts";
import { documentBounds, subdivided } from "../../kernel/curve/samples.ts";
import { drawKnot } from "../markers.ts";
import { isDense, isSeen, partPath } from "../outlines.ts";
import { inPage, inScreen, onScreen, pathOfPoints, sightOf, type Scene } from "../scene.ts";

/** Overlays that explain a curve: its comb, its control polygon, the subdivision polygons, its knots. Loaded when one is shown first. */

/** What lies below the curve, from the paper up. */
export function drawBelow(scene: Scene): void {
  drawSubdivision(scene);
  drawPolygon(scene);
  drawComb(scene);
}

const mostTeeth = 1024;

/** Teeth at right angles to the curve on its convex side, as long as the curvature is great. */
function drawComb(scene: Scene): void {
  const { state, palette } = scene;
  if (!state.settings.overlays.comb || state.originalOnly) return;
  const context = inPage(scene);
  const { zoom } = state.view;
  context.strokeStyle = palette.handle;
  const half = halfExtent(scene);
  const scale = state.settings.combScale * combScale(scene.origin, half);
  for (const contour of state.curve.contours) {
    const { teeth, envelope } = combPaths(scene, contour, half, scale);
    context.globalAlpha = 0.55;
    context.lineWidth = 1 / zoom;
    context.stroke(teeth);
    context.globalAlpha = 1;
    context.lineWidth = 1.25 / zoom;
    context.stroke(envelope);
  }
}

interface CombPaths {
  readonly scale: number;
  readonly teeth: Path2D;
  readonly envelope: Path2D;
}

/** An immutable contour's comb only changes with the scale. */
const combs = new WeakMap<Contour, CombPaths>();

/** Half the larger side of the drawing: all contours' combs have one scale. */
function halfExtent({ state }: Scene): number {
  const box = documentBounds(state.curve);
  return box === null ? 0 : Math.max(box.maxX - box.minX, box.maxY - box.minY) / 2;
}

const scales = new WeakMap<CurveDocument, number>();
/** Places that tell how curved a contour is, and contours that tell it of a drawing. */
const [looksPerSegment, mostLookedAt] = [8, 64];

/**
 * Tooth per curvature at which nine teeth of ten are at most three tenths of the drawing's half: on a circle, of its
 * radius. Of the drawing as it was when a drag began, so that the scale stands still while it lasts.
 */
function combScale(document: CurveDocument, half: number): number {
  const known = scales.get(document);
  if (known !== undefined) return known;
  const bends = document.contours.slice(0, mostLookedAt).flatMap((contour) =>
    Array.from(combOf(document, contour, looksPerSegment)?.curvature ?? [], Math.abs)).filter((bend) => bend < Infinity).sort((a, b) => a - b);
  const scale = (0.3 * half) / Math.max(1 / half, bends[Math.floor(0.9 * bends.length)] ?? 0);
  scales.set(document, scale);
  return scale;
}

function combPaths({ state }: Scene, contour: Contour, half: number, scale: number): CombPaths {
  const known = combs.get(contour);
  if (known !== undefined && known.scale === scale) return known;
  const [teeth, envelope] = [new Path2D(), new Path2D()];
  const fresh = { scale, teeth, envelope };
  combs.set(contour, fresh);
  const segments = Math.max(1, contour.closed ? contour.points.length : contour.points.length - 1);
  const perSegment = Math.max(4, Math.min(48, Math.floor(mostTeeth / segments)));
  const comb = combOf(state.curve, contour, perSegment);
  if (comb === null) return fresh;
  // Near a cusp the curvature has no bound; a tooth of a good third of the drawing says enough.
  const longest = 0.75 * half;
  for (let i = 0; i < comb.curvature.length; i += 1) {
    const [x = 0, y = 0] = comb.points.subarray(2 * i, 2 * i + 2);
    const [dx = 0, dy = 0] = comb.tangents.subarray(2 * i, 2 * i + 2);
    const speed = Math.hypot(dx, dy);
    const raw = (comb.curvature[i] ?? 0) * scale;
    const first = i % perSegment === 0;
    if (!(speed > 0) || !Number.isFinite(raw)) continue;
    const tooth = Math.max(-longest, Math.min(longest, raw));
    const [tipX, tipY] = [x + (dy / speed) * tooth, y - (dx / speed) * tooth];
    teeth.moveTo(x, y);
    teeth.lineTo(tipX, tipY);
    // Curvature may jump from one segment to the next: the envelope says so by breaking off.
    if (first) envelope.moveTo(tipX, tipY);
    else envelope.lineTo(tipX, tipY);
  }
  return fresh;
}

const polygons = new WeakMap<Float64Array, Path2D>();

function polygonPath(document: CurveDocument, contour: Contour): Path2D {
  const points = bezierPolygon(document, contour);
  const path = polygons.get(points) ?? pathOfPoints(points, contour.closed);
  polygons.set(points, path);
  return path;
}

function drawPolygon(scene: Scene): void {
  const { state, palette } = scene;
  if (!state.settings.overlays.polygon || state.originalOnly) return;
  const context = inPage(scene);
  const { zoom } = state.view;
  context.strokeStyle = palette.line;
  context.lineWidth = 1 / zoom;
  context.setLineDash([4 / zoom, 4 / zoom]);
  const sight = sightOf(scene);
  for (const contour of state.curve.contours) {
    const parts = partsOf(state.curve, contour);
    if (parts.length === 1) context.stroke(polygonPath(state.curve, contour));
    // Where points are nearly dense, the polygon is nowhere beside the curve.
    else for (const part of parts) if (isSeen(state.curve, part, sight)) context.stroke(isDense(scene, part) ? partPath(scene, state.curve, part) : polygonPath(state.curve, part));
  }
  context.setLineDash([]);
}

/** The polygons of the subdivision scheme, fainter the coarser. */
function drawSubdivision(scene: Scene): void {
  const { state, palette } = scene;
  const steps = state.settings.subdivisionSteps;
  if ((!state.settings.overlays.subdivision && steps === 0) || state.originalOnly) return;
  const context = inPage(scene);
  context.strokeStyle = palette.point;
  context.lineWidth = 1 / state.view.zoom;
  const shown = Math.max(1, steps);
  for (let step = 0; step <= shown; step += 1) {
    context.globalAlpha = 0.2 + (0.7 * step) / shown;
    for (const contour of state.curve.contours) context.stroke(pathOfPoints(subdivided(state.curve, contour, step), contour.closed));
  }
  context.globalAlpha = 1;
}

export function drawKnots(scene: Scene): void {
  const { state, palette } = scene;
  if (!state.settings.overlays.knots || state.originalOnly) return;
  const context = inScreen(scene);
  const { minX, minY, maxX, maxY } = sightOf(scene);
  let last = { x: Infinity, y: Infinity };
  for (const { points } of state.curve.contours) {
    for (const point of points) {
      if (point.x < minX || point.y < minY || point.x > maxX || point.y > maxY) continue;
      const at = onScreen(scene, point);
      // Of those beside one another at the same pixel one is seen.
      if (Math.abs(at.x - last.x) < 0.5 && Math.abs(at.y - last.y) < 0.5) continue;
      drawKnot(context, at, palette);
      last = at;
    }
  }
}
