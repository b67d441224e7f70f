import { strokesOf, type FitDocument } from "../../document/fit/fit.ts";
import { cubicsOfFit, feetOf, partsInPlace, teethOf, type FitOutcome, type FittedStroke } from "../../kernel/fit/outcome.ts";
import { inPage, inScreen, onScreen, pathOfCubics, type Scene } from "../scene.ts";

/** What Fit draws of the data and of the curve; the marks of knots are elsewhere. */

const dot = 1.25;
/** So few are places that somebody chose: they are seen beside the curve that runs over them. */
const [fewDots, largeDot] = [48, 2.75];
/** More dots than this would be a stripe: then every second, third … one is drawn, and the way between them. */
const mostDots = 3000;

const dots = new WeakMap<object, { readonly zoom: number; readonly path: Path2D }>();

/** The data as dots of the same size at any zoom. */
export function drawData(scene: Scene, strength: number): void {
  const { state, palette } = scene;
  const { data } = state.fit;
  const context = inPage(scene);
  const { zoom } = state.view;
  context.globalAlpha = strength;
  if (data.length > mostDots || strength === 1) drawRawLine(scene, data.length > mostDots ? 1.25 : 0.75);
  const known = dots.get(data);
  const path = known !== undefined && known.zoom === zoom ? known.path : new Path2D();
  if (known?.path !== path) {
    const radius = (data.length <= fewDots ? largeDot : dot) / zoom;
    const step = Math.ceil(data.length / mostDots);
    for (let i = 0; i < data.length; i += step) {
      const [x = 0, y = 0] = data[i] ?? [];
      path.moveTo(x + radius, y);
      path.arc(x, y, radius, 0, 2 * Math.PI);
    }
    dots.set(data, { zoom, path });
  }
  context.fillStyle = palette.original;
  context.fill(path);
  context.globalAlpha = 1;
}

const lines = new WeakMap<object, { readonly cell: number; readonly path: Path2D }>();

/** The way from point to point, as it was drawn. */
function drawRawLine(scene: Scene, width: number): void {
  const { fit, view } = scene.state;
  // Powers of two, so that zooming seldom makes a new path.
  const cell = fit.data.length > mostDots ? 1 / 2 ** Math.ceil(Math.log2(view.zoom)) : 0;
  const known = lines.get(fit.data);
  const path = known?.cell === cell ? known.path : rawLine(fit, cell);
  lines.set(fit.data, { cell, path });
  const context = inPage(scene);
  context.strokeStyle = scene.palette.original;
  context.lineWidth = width / view.zoom;
  context.stroke(path);
}

/**
 * Of very many points, the steps of the way that lead to where it has not been (to a cell of at most a pixel), or far
 * from one place to another.
 */
function rawLine(fit: FitDocument, cell: number): Path2D {
  const path = new Path2D();
  const been = new Set<number>();
  for (const { from, to } of strokesOf(fit)) {
    let isDrawn = false;
    for (let i = from; i < to; i += 1) {
      const [x, y] = fit.data[i] ?? [0, 0];
      const [lastX, lastY] = fit.data[Math.max(from, i - 1)] ?? [x, y];
      const place = cell === 0 ? i : Math.round(x / cell) * 2 ** 26 + Math.round(y / cell);
      const isNew = !been.has(place) || Math.hypot(x - lastX, y - lastY) > 4 * cell;
      been.add(place);
      if (isNew && !isDrawn) path.moveTo(lastX, lastY);
      if (isNew && i > from) path.lineTo(x, y);
      isDrawn = isNew;
    }
  }
  return path;
}

export function drawCurve(scene: Scene, outcome: FitOutcome): void {
  const context = inPage(scene);
  context.strokeStyle = scene.palette.curve;
  context.lineWidth = 2 / scene.state.view.zoom;
  context.lineJoin = "round";
  for (const { curve } of outcome.strokes) context.stroke(pathOfCubics(cubicsOfFit(curve), curve.closed));
}

/** From every point to its place on the curve. */
export function drawResiduals(scene: Scene, outcome: FitOutcome): void {
  const context = inPage(scene);
  context.strokeStyle = scene.palette.warn;
  context.lineWidth = 1 / scene.state.view.zoom;
  for (const stroke of outcome.strokes) context.stroke(residualsOf(stroke));
}

const residuals = new WeakMap<FittedStroke, Path2D>();

function residualsOf(stroke: FittedStroke): Path2D {
  const known = residuals.get(stroke);
  if (known !== undefined) return known;
  const path = new Path2D();
  const [{ points }, feet] = [stroke, feetOf(stroke)];
  for (let i = 0; i + 1 < points.length; i += 2) {
    path.moveTo(points[i] ?? 0, points[i + 1] ?? 0);
    path.lineTo(feet[i] ?? 0, feet[i + 1] ?? 0);
  }
  residuals.set(stroke, path);
  return path;
}

/** A broad line behind the curve, coloured by how far the points there are from it. */
export function drawHeat(scene: Scene, outcome: FitOutcome): void {
  const context = inPage(scene);
  const { heat } = scene.palette;
  context.lineWidth = 6 / scene.state.view.zoom;
  context.lineCap = "round";
  for (const stroke of outcome.strokes) {
    heatOf(stroke, outcome.max, heat.length).forEach((path, i) => {
      context.strokeStyle = heat[i] ?? "";
      context.stroke(path);
    });
  }
  context.lineCap = "butt";
}

const heats = new WeakMap<FittedStroke, readonly Path2D[]>();

/**
 * More chords than this are shorter than they are broad: then one is as long as several, and of the worst of their
 * errors.
 */
const mostChords = 2000;

/** The curve in short chords, each in the path of its error's step. */
function heatOf(stroke: FittedStroke, most: number, steps: number): readonly Path2D[] {
  const known = heats.get(stroke);
  if (known !== undefined) return known;
  const paths = Array.from({ length: steps }, () => new Path2D());
  const [{ points, parameters, curve }, feet] = [stroke, feetOf(stroke)];
  const order = Array.from(parameters, (_, i) => i).sort((a, b) => (parameters[a] ?? 0) - (parameters[b] ?? 0));
  if (curve.closed) order.push(order[0] ?? 0);
  const errorAt = (i: number): number => Math.hypot((points[2 * i] ?? 0) - (feet[2 * i] ?? 0), (points[2 * i + 1] ?? 0) - (feet[2 * i + 1] ?? 0));
  const stride = Math.ceil(order.length / mostChords);
  for (let start = 0; start + 1 < order.length; start += stride) {
    const some = order.slice(start, start + stride + 1);
    const [first = 0, last = 0] = [some[0], some.at(-1)];
    const error = some.reduce((worst, i, k) => Math.max(worst, k === 0 ? 0 : (errorAt(i) + errorAt(some[k - 1] ?? i)) / 2), 0);
    const path = paths[Math.min(steps - 1, Math.floor((steps * error) / Math.max(most, 1e-12)))];
    path?.moveTo(feet[2 * first] ?? 0, feet[2 * first + 1] ?? 0);
    path?.lineTo(feet[2 * last] ?? 0, feet[2 * last + 1] ?? 0);
  }
  heats.set(stroke, paths);
  return paths;
}

/** The straight part and the smooth part by themselves: their sum is the curve. */
export function drawParts(scene: Scene, outcome: FitOutcome): void {
  const { state, palette } = scene;
  const { zoom } = state.view;
  for (const stroke of outcome.strokes) {
    if (stroke.parts.length < 2) continue;
    partsInPlace(stroke).forEach((part, i) => {
      const context = inPage(scene);
      context.strokeStyle = i === 0 ? palette.linear : palette.cubic;
      context.lineWidth = 1.5 / zoom;
      context.setLineDash(i === 0 ? [7 / zoom, 4 / zoom] : [2 / zoom, 3 / zoom]);
      context.stroke(pathOfCubics(cubicsOfFit(part), part.closed));
      context.setLineDash([]);
      const [x = 0, y = 0] = part.evaluate(0);
      const at = onScreen(scene, { x, y });
      const screen = inScreen(scene);
      screen.font = palette.font;
      screen.fillStyle = i === 0 ? palette.linear : palette.cubic;
      screen.fillText(i === 0 ? "straight part" : "smooth part", at.x + 12, at.y + (i === 0 ? -8 : palette.em + 4));
    });
  }
}

const teethPerCurve = 480;

/** Curvature as teeth at right angles, on the convex side. */
export function drawFitComb(scene: Scene, outcome: FitOutcome): void {
  const { state, palette } = scene;
  const context = inPage(scene);
  const scale = 0.015 * outcome.diagonal * outcome.diagonal * state.settings.combScale;
  const longest = 0.25 * outcome.diagonal;
  context.strokeStyle = palette.handle;
  context.lineWidth = 1 / state.view.zoom;
  context.globalAlpha = 0.55;
  const path = new Path2D();
  for (const { curve } of outcome.strokes) {
    const { points, tangents, curvature } = teethOf(curve, Math.ceil(teethPerCurve / outcome.strokes.length));
    curvature.forEach((value, i) => {
      const [x = 0, y = 0] = points.subarray(2 * i, 2 * i + 2);
      const [dx = 0, dy = 0] = tangents.subarray(2 * i, 2 * i + 2);
      const speed = Math.hypot(dx, dy);
      if (!(speed > 0)) return;
      const tooth = Math.max(-longest, Math.min(longest, value * scale));
      path.moveTo(x, y);
      path.lineTo(x + (dy / speed) * tooth, y - (dx / speed) * tooth);
    });
  }
  context.stroke(path);
  context.globalAlpha = 1;
}

/** The stroke under the pen, and the eraser's rim. */
export function drawHand(scene: Scene): void {
  const { state, palette } = scene;
  const { stroke, brush } = state.fitView;
  const { zoom } = state.view;
  const context = inPage(scene);
  if (stroke.length > 1) {
    context.strokeStyle = palette.ink;
    context.lineWidth = 1.5 / zoom;
    context.lineJoin = "round";
    context.beginPath();
    stroke.forEach(([x, y], i) => (i === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
    context.stroke();
  }
  if (brush === null) return;
  context.strokeStyle = palette.ink2;
  context.lineWidth = 1 / zoom;
  context.beginPath();
  context.arc(brush.x, brush.y, 14 / zoom, 0, 2 * Math.PI);
  context.stroke();
}
