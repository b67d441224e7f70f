import { partsOf } from "../../document/curve/parts.ts";
import type { Contour, CurveDocument } from "../../document/document.ts";
import { bezierPolygon } from "../../kernel/curve/overlays/comb.ts";
import { curveOf, type AnyCurve } from "../../kernel/curve/curve-cache.ts";
import { subdivided } from "../../kernel/curve/samples.ts";
import { drawKnot } from "../markers.ts";
import { isDense, isSeen, partPath, stepOf } from "../outlines.ts";
import { inPage, inScreen, onScreen, pathOfPoints, sightOf, type Scene } from "../scene.ts";
import { drawComb } from "./comb.ts";
import { isCrowded } from "./points.ts";

/**
 * Overlays that explain a curve: its comb, its control polygon, the subdivision polygons, its knots. Loaded when one is
 * shown first.
 */

/** What lies below the curve, from the paper up. */
export function drawBelow(scene: Scene): void {
  drawSubdivision(scene);
  drawPolygon(scene);
  drawComb(scene);
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
  const sight = sightOf(scene);
  const parts = state.curve.contours.flatMap((contour) => {
    const all = partsOf(state.curve, contour);
    return all.length === 1 ? all : all.filter((part) => isSeen(state.curve, part, sight));
  });
  for (let step = 0; step <= shown; step += 1) {
    context.globalAlpha = 0.2 + (0.7 * step) / shown;
    for (const part of parts) context.stroke(subdivisionPath(scene, part, step));
  }
  context.globalAlpha = 1;
}

/** CSS pixels between vertices of a polygon up to which nobody tells it from the curve. */
const fine = 0.5;
const subdivisions = new WeakMap<AnyCurve, Path2D[]>();

function subdivisionPath(scene: Scene, part: Contour, step: number): Path2D {
  const { curve: document, view } = scene.state;
  if (isDense(scene, part) || (stepOf(part) * view.zoom) / 2 ** step < fine) return partPath(scene, document, part);
  const curve = curveOf(document, part);
  if (curve === null) return new Path2D();
  const known = subdivisions.get(curve) ?? [];
  subdivisions.set(curve, known);
  return (known[step] ??= pathOfPoints(subdivided(document, part, step), part.closed));
}

/**
 * CSS pixels in which one knot stands for all: so many that few rings run into one another where there are very many.
 */
const [knotsApart, manyApart] = [1, 14];

export function drawKnots(scene: Scene): void {
  const { state, palette } = scene;
  if (!state.settings.overlays.knots || state.originalOnly) return;
  const context = inScreen(scene);
  const { minX, minY, maxX, maxY } = sightOf(scene);
  const cells = new Set<number>();
  const apart = isCrowded(state.curve) ? manyApart : knotsApart;
  for (const { points } of state.curve.contours) {
    for (const point of points) {
      if (point.x < minX || point.y < minY || point.x > maxX || point.y > maxY) continue;
      const at = onScreen(scene, point);
      // Of those beside one another at the same place one is seen.
      const cell = Math.floor(at.x / apart) * 2 ** 20 + Math.floor(at.y / apart);
      if (cells.has(cell)) continue;
      cells.add(cell);
      drawKnot(context, at, palette);
    }
  }
}
