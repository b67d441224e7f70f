import type { ScreenPoint } from "../../editor/pointer/camera.ts";
import type { KnotType } from "../../kernel/fit/knots.ts";
import type { Palette } from "../palette.ts";

/**
 * Knots by kind: a filled square, a ring, and a square with a hole where both are. Sizes are CSS pixels at any zoom.
 */

const halo = 1.5;

function colorOf(type: KnotType, palette: Palette): string {
  return type === "linear" ? palette.linear : type === "cubic" ? palette.cubic : palette.coinc;
}

function square(context: CanvasRenderingContext2D, { x, y }: ScreenPoint, half: number): void {
  context.rect(x - half, y - half, 2 * half, 2 * half);
}

function disc(context: CanvasRenderingContext2D, { x, y }: ScreenPoint, radius: number): void {
  context.moveTo(x + radius, y);
  context.arc(x, y, radius, 0, 2 * Math.PI);
}

/** Half the mark's size. */
const sizes: Readonly<Record<KnotType, number>> = { linear: 4.5, cubic: 5.5, coincident: 6 };

export interface KnotMarkState {
  readonly over: boolean;
  readonly chosen: boolean;
  /** The stage has the keyboard focus, and this is the knot that it is on. */
  readonly focused: boolean;
}

export function drawKnotMark(context: CanvasRenderingContext2D, at: ScreenPoint, type: KnotType, { over, chosen, focused }: KnotMarkState, palette: Palette): void {
  const size = sizes[type] + (chosen ? 1 : 0);
  const shape = type === "cubic" ? disc : square;
  const color = colorOf(type, palette);
  if (over) {
    context.globalAlpha *= 0.22;
    context.fillStyle = color;
    context.beginPath();
    disc(context, at, size + 6);
    context.fill();
    context.globalAlpha /= 0.22;
  }
  context.fillStyle = palette.canvas;
  context.beginPath();
  shape(context, at, size + halo);
  context.fill();
  if (type === "cubic") {
    context.strokeStyle = color;
    context.lineWidth = 3;
    context.beginPath();
    disc(context, at, size - 1.5);
    context.stroke();
  } else {
    context.fillStyle = color;
    context.beginPath();
    square(context, at, size);
    context.fill();
    if (type === "coincident") {
      context.fillStyle = palette.canvas;
      context.beginPath();
      disc(context, at, 2.5);
      context.fill();
    }
  }
  if (chosen) {
    context.strokeStyle = color;
    context.lineWidth = 1.5;
    context.beginPath();
    disc(context, at, size + 5);
    context.stroke();
  }
  if (!focused) return;
  for (const [ring, width] of [[palette.canvas, 5], [palette.focus, 2]] as const) {
    context.strokeStyle = ring;
    context.lineWidth = width;
    context.beginPath();
    disc(context, at, size + 8);
    context.stroke();
  }
}
