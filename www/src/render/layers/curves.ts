import { bezierGhost } from "../../kernel/bezier-ghost.ts";
import { contourPath, inPage, pathOfCubics, type Scene } from "../scene.ts";

/** The drawing itself, what it was before the drag, and the Bézier to compare with. */

export function drawFill(scene: Scene): void {
  const { state, palette } = scene;
  if (!state.settings.overlays.fill || state.originalOnly) return;
  const context = inPage(scene);
  const whole = new Path2D();
  for (const contour of state.curve.contours) if (contour.closed) whole.addPath(contourPath(scene, state.curve, contour));
  context.fillStyle = palette.point;
  context.globalAlpha = 0.08;
  // Holes of imported logos are holes, whichever way their contours run.
  context.fill(whole, "evenodd");
  context.globalAlpha = 1;
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
  for (const contour of origin.contours) {
    if (!state.curve.contours.includes(contour)) context.stroke(contourPath(scene, origin, contour));
  }
  context.setLineDash([]);
  context.lineCap = "butt";
}

export function drawBezier(scene: Scene): void {
  const { state, palette } = scene;
  if (!state.settings.overlays.bezier && !state.originalOnly) return;
  const context = inPage(scene);
  const { zoom } = state.view;
  context.strokeStyle = palette.warn;
  context.lineWidth = 1.5 / zoom;
  context.setLineDash([6 / zoom, 5 / zoom]);
  for (const contour of state.curve.contours) {
    const ghost = bezierGhost(state.curve, contour);
    if (ghost !== null) context.stroke(pathOfCubics(ghost.path, contour.closed));
  }
  context.setLineDash([]);
}

export function drawCurves(scene: Scene): void {
  const { state, palette } = scene;
  if (state.originalOnly) return;
  const context = inPage(scene);
  context.strokeStyle = palette.curve;
  context.lineWidth = 2 / state.view.zoom;
  context.lineJoin = "round";
  for (const contour of state.curve.contours) context.stroke(contourPath(scene, state.curve, contour));
}
