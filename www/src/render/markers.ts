import type { Kind } from "../document/document.ts";
import type { ScreenPoint } from "../editor/pointer/camera.ts";
import type { Palette } from "./palette.ts";

/** Marks of the stage: shape and colour both say what a thing is. Sizes are CSS pixels at any zoom. */

export interface MarkerState {
  readonly hovered: boolean;
  readonly selected: boolean;
  readonly focused: boolean;
}

const haloWidth = 1.5;

export function disc(context: CanvasRenderingContext2D, at: ScreenPoint, radius: number): void {
  context.beginPath();
  context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
}

export function diamond(context: CanvasRenderingContext2D, at: ScreenPoint, radius: number): void {
  context.beginPath();
  context.moveTo(at.x, at.y - radius);
  context.lineTo(at.x + radius, at.y);
  context.lineTo(at.x, at.y + radius);
  context.lineTo(at.x - radius, at.y);
  context.closePath();
}

/** What the pointer is over is surrounded by its own colour, faintly. */
export function halo(context: CanvasRenderingContext2D, color: string, outline: () => void): void {
  context.globalAlpha = 0.22;
  context.fillStyle = color;
  outline();
  context.fill();
  context.globalAlpha = 1;
}

/** A control point: a disc, or a diamond where it is a cusp. */
export function drawPoint(context: CanvasRenderingContext2D, at: ScreenPoint, kind: Kind, marker: MarkerState, palette: Palette): void {
  const shape = kind === "cusp" ? diamond : disc;
  const color = kind === "cusp" ? palette.cusp : palette.point;
  const radius = (kind === "cusp" ? 6.5 : 4.5) + (marker.selected ? 1 : 0);
  if (marker.hovered) halo(context, color, () => shape(context, at, radius + 5));
  context.fillStyle = palette.canvas;
  shape(context, at, radius + haloWidth);
  context.fill();
  context.fillStyle = color;
  shape(context, at, radius);
  context.fill();
  if (marker.selected) {
    context.strokeStyle = color;
    context.lineWidth = 1.5;
    shape(context, at, radius + 3.5);
    context.stroke();
  }
  if (marker.focused) drawFocus(context, at, radius + 5.5, palette);
}

/** A control point that is near the curve and not on it: a hollow diamond. */
export function drawVertex(context: CanvasRenderingContext2D, at: ScreenPoint, marker: MarkerState, palette: Palette): void {
  const radius = 5 + (marker.selected ? 1 : 0);
  if (marker.hovered) halo(context, palette.point, () => diamond(context, at, radius + 6));
  diamond(context, at, radius + haloWidth);
  context.fillStyle = palette.canvas;
  context.fill();
  diamond(context, at, radius);
  context.fillStyle = marker.selected ? palette.point : palette.canvas;
  context.fill();
  context.strokeStyle = palette.point;
  context.lineWidth = 1.5;
  context.stroke();
  if (marker.focused) drawFocus(context, at, radius + 5, palette);
}

/** The end of a handle: a hollow disc, filled while it is chosen. */
export function drawHandleEnd(context: CanvasRenderingContext2D, at: ScreenPoint, marker: MarkerState, palette: Palette): void {
  if (marker.hovered) halo(context, palette.handle, () => disc(context, at, 9));
  disc(context, at, 4 + haloWidth);
  context.fillStyle = palette.canvas;
  context.fill();
  disc(context, at, 4);
  context.fillStyle = marker.selected ? palette.handle : palette.canvas;
  context.fill();
  context.strokeStyle = palette.handle;
  context.lineWidth = 1.5;
  context.stroke();
  if (marker.focused) drawFocus(context, at, 9.5, palette);
}

/** A knot between segments: a small upright bar would hide the curve; a square ring does not. */
export function drawKnot(context: CanvasRenderingContext2D, at: ScreenPoint, palette: Palette): void {
  context.strokeStyle = palette.line;
  context.lineWidth = 1.5;
  context.strokeRect(at.x - 7, at.y - 7, 14, 14);
}

/** The ring of the point that the keyboard is at. */
export function drawFocus(context: CanvasRenderingContext2D, at: ScreenPoint, radius: number, palette: Palette): void {
  disc(context, at, radius + 1);
  context.strokeStyle = palette.canvas;
  context.lineWidth = 5;
  context.stroke();
  context.strokeStyle = palette.focus;
  context.lineWidth = 2;
  context.stroke();
}

/** Beside the first point, along the direction in which the path runs. */
export function drawStart(context: CanvasRenderingContext2D, at: ScreenPoint, direction: { dx: number; dy: number }, palette: Palette): void {
  const size = Math.hypot(direction.dx, direction.dy);
  if (size < 1e-9) return;
  const [ux, uy] = [direction.dx / size, direction.dy / size];
  // To the right of the way it runs, clear of the point and of the curve.
  const [x, y] = [at.x + 13 * uy + 2 * ux, at.y - 13 * ux + 2 * uy];
  context.beginPath();
  context.moveTo(x + 4.5 * ux, y + 4.5 * uy);
  context.lineTo(x - 3 * ux - 3.5 * uy, y - 3 * uy + 3.5 * ux);
  context.lineTo(x - 3 * ux + 3.5 * uy, y - 3 * uy - 3.5 * ux);
  context.closePath();
  context.fillStyle = palette.line;
  context.fill();
}
