import { partsOf } from "../../document/curve/parts.ts";
import type { PagePoint } from "../../editor/pointer/camera.ts";
import { cubicsOf } from "../../kernel/paths/paths.ts";
import { partPath } from "../outlines.ts";
import { contourPath, inPage, inScreen, onScreen, pathOfCubics, pathOfPoints, type Scene } from "../scene.ts";

/**
 * What tools show while they work: the curve before the drag, guides, marquee, the pen's next segment, where a point
 * would go in, the loupe. Loaded when a pointer has something to show first.
 */

export function drawSketch(scene: Scene): void {
  drawProposal(scene);
  drawInsertion(scene);
  drawRubber(scene);
  if (scene.state.sketch.joint !== null) drawRing(scene, scene.state.sketch.joint, 12);
  drawStroke(scene);
  drawGuides(scene);
  drawMarquee(scene);
  drawLoupe(scene);
}

/** Dotted: the curve as it was when the drag began. */
export function drawBefore(scene: Scene): void {
  const { state, palette, origin } = scene;
  if (origin === state.curve || state.drag === null) return;
  const context = inPage(scene);
  const { zoom } = state.view;
  context.strokeStyle = palette.original;
  context.lineWidth = 1.5 / zoom;
  context.lineCap = "round";
  context.setLineDash([0.01 / zoom, 4 / zoom]);
  const contours = new Set(state.curve.contours);
  const changed = origin.contours.filter((contour) => !contours.has(contour));
  const kept = new Set(state.curve.contours.flatMap((contour) => partsOf(state.curve, contour)));
  for (const contour of changed) {
    for (const part of partsOf(origin, contour)) if (!kept.has(part)) context.stroke(partPath(scene, origin, part));
  }
  context.setLineDash([]);
  context.lineCap = "butt";
}

function drawProposal(scene: Scene): void {
  const { state, palette } = scene;
  const { proposal } = state.sketch;
  if (proposal === null) return;
  const context = inPage(scene);
  context.strokeStyle = palette.warn;
  context.lineWidth = 2 / state.view.zoom;
  context.setLineDash([8 / state.view.zoom, 5 / state.view.zoom]);
  for (const contour of proposal.contours) context.stroke(contourPath(scene, proposal, contour));
  context.setLineDash([]);
}

/** The place on the curve where a double-click inserts a point. */
function drawInsertion(scene: Scene): void {
  const { state, palette } = scene;
  if (state.hover.kind !== "curve" || state.drag !== null || state.tool !== "select") return;
  const context = inScreen(scene);
  const at = onScreen(scene, state.hover);
  context.beginPath();
  context.arc(at.x, at.y, 4, 0, 2 * Math.PI);
  context.fillStyle = palette.canvas;
  context.fill();
  context.strokeStyle = palette.point;
  context.lineWidth = 1.5;
  context.stroke();
}

function drawRubber(scene: Scene): void {
  const { state, palette } = scene;
  const { rubber } = state.sketch;
  if (rubber === null) return;
  const context = inPage(scene);
  context.strokeStyle = palette.point;
  context.lineWidth = 1.5 / state.view.zoom;
  context.stroke(pathOfCubics(cubicsOf(state.curve, rubber.contour, 0.05 / state.view.zoom), false));
  const end = rubber.contour.points[1];
  if (end !== undefined) drawRing(scene, end, rubber.closing ? 8 : 3.5);
}

function drawRing(scene: Scene, place: PagePoint, radius: number): void {
  const context = inScreen(scene);
  const at = onScreen(scene, place);
  context.beginPath();
  context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
  context.strokeStyle = scene.palette.point;
  context.lineWidth = 1.5;
  context.stroke();
}

function drawStroke(scene: Scene): void {
  const { state, palette } = scene;
  const { stroke } = state.sketch;
  if (stroke.length < 2) return;
  const context = inPage(scene);
  context.strokeStyle = palette.point;
  context.lineWidth = 1.5 / state.view.zoom;
  context.lineJoin = "round";
  context.stroke(pathOfPoints(Float64Array.from(stroke.flat()), false));
}

function drawGuides(scene: Scene): void {
  const { state, palette } = scene;
  if (state.sketch.guides.length === 0) return;
  const context = inScreen(scene);
  context.strokeStyle = palette.cusp;
  context.fillStyle = palette.cusp;
  context.lineWidth = 1;
  for (const guide of state.sketch.guides) {
    const [from, to] = [onScreen(scene, guide.from), onScreen(scene, guide.to)];
    context.beginPath();
    context.moveTo(from.x, from.y);
    context.lineTo(to.x, to.y);
    context.stroke();
    // A small cross at the end that the drag was drawn to.
    context.fillRect(from.x - 3, from.y - 0.5, 6, 1);
    context.fillRect(from.x - 0.5, from.y - 3, 1, 6);
  }
}

function drawMarquee(scene: Scene): void {
  const { state, palette } = scene;
  const { marquee } = state.sketch;
  if (marquee === null) return;
  const context = inScreen(scene);
  const [from, to] = [onScreen(scene, marquee.from), onScreen(scene, marquee.to)];
  const [x, y] = [Math.min(from.x, to.x), Math.min(from.y, to.y)];
  const [width, height] = [Math.abs(to.x - from.x), Math.abs(to.y - from.y)];
  context.fillStyle = palette.focus;
  context.globalAlpha = 0.1;
  context.fillRect(x, y, width, height);
  context.globalAlpha = 1;
  context.strokeStyle = palette.focus;
  context.lineWidth = 1;
  context.strokeRect(Math.round(x) + 0.5, Math.round(y) + 0.5, Math.round(width), Math.round(height));
}

const loupeRadius = 48;
const loupeZoom = 2;

/** A finger hides what it drags: the loupe shows it above. It copies the finished picture, so it is drawn last. */
function drawLoupe(scene: Scene): void {
  const { state, palette, ratio } = scene;
  const { finger } = state.sketch;
  if (finger === null) return;
  const context = inScreen(scene);
  const at = onScreen(scene, finger);
  const above = at.y - 96;
  // Near the top edge there is no room above: the loupe steps aside.
  const x = above > loupeRadius ? at.x : at.x + (at.x > state.stage.width / 2 ? -110 : 110);
  const centre = { x: Math.max(loupeRadius, Math.min(state.stage.width - loupeRadius, x)), y: Math.max(loupeRadius + 4, above) };
  const half = loupeRadius / loupeZoom;
  context.save();
  context.beginPath();
  context.arc(centre.x, centre.y, loupeRadius, 0, 2 * Math.PI);
  context.fillStyle = palette.canvas;
  context.fill();
  context.clip();
  context.drawImage(
    context.canvas,
    (at.x - half) * ratio, (at.y - half) * ratio, 2 * half * ratio, 2 * half * ratio,
    centre.x - loupeRadius, centre.y - loupeRadius, 2 * loupeRadius, 2 * loupeRadius,
  );
  context.restore();
  context.beginPath();
  context.arc(centre.x, centre.y, loupeRadius, 0, 2 * Math.PI);
  context.strokeStyle = palette.line;
  context.lineWidth = 1.5;
  context.stroke();
}
