import type { ScreenPoint, StageBox } from "../pointer/camera.ts";

/**
 * The camera of the surface: it looks at a place from a distance, with z up. Everything that is on the screen is put
 * there by these formulas.
 */

export type Vector = readonly [number, number, number];

export interface Orbit {
  /** Turn about z, radians. */
  readonly yaw: number;
  /** Height of the eye, −π/2 … π/2. */
  readonly pitch: number;
  readonly distance: number;
  readonly target: Vector;
}

/** Vertical opening of the camera, radians. */
export const opening = (32 * Math.PI) / 180;
const steepest = Math.PI / 2 - 1e-3;

export function add(a: Vector, b: Vector, scale = 1): Vector {
  return [a[0] + scale * b[0], a[1] + scale * b[1], a[2] + scale * b[2]];
}

function subtract(a: Vector, b: Vector): Vector {
  return add(a, b, -1);
}

export function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function lengthOf(a: Vector): number {
  return Math.hypot(a[0], a[1], a[2]);
}

export function unit(a: Vector): Vector {
  const size = lengthOf(a);
  return size === 0 ? [0, 0, 0] : [a[0] / size, a[1] / size, a[2] / size];
}

export interface Frame3 {
  readonly eye: Vector;
  readonly right: Vector;
  readonly up: Vector;
  /** From the target to the eye. */
  readonly back: Vector;
}

export function frameOf({ yaw, pitch, distance, target }: Orbit): Frame3 {
  const back: Vector = [Math.cos(pitch) * Math.cos(yaw), Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch)];
  const right: Vector = [-Math.sin(yaw), Math.cos(yaw), 0];
  return { eye: add(target, back, distance), right, up: cross(back, right), back };
}

/** CSS pixels of one unit across at the distance 1. */
function focal(stage: StageBox): number {
  return stage.height / (2 * Math.tan(opening / 2));
}

export interface Projected extends ScreenPoint {
  /** Distance in front of the eye; not positive: behind it. */
  readonly depth: number;
}

/** The camera worked out once, for putting many points on the screen. */
export function projector(orbit: Orbit, stage: StageBox): (point: Vector) => Projected {
  const { eye, right, up, back } = frameOf(orbit);
  const scale = focal(stage);
  const [cx, cy] = [stage.width / 2, stage.height / 2];
  return (point) => {
    const away = subtract(point, eye);
    const depth = -dot(away, back);
    const factor = scale / Math.max(depth, 1e-9);
    return { x: cx + dot(away, right) * factor, y: cy - dot(away, up) * factor, depth };
  };
}

/** The line of sight through a place of the screen: one step along it is one unit of depth. */
export function sightThrough(orbit: Orbit, stage: StageBox, { x, y }: ScreenPoint): { readonly eye: Vector; readonly along: Vector } {
  const { eye, right, up, back } = frameOf(orbit);
  const scale = focal(stage);
  const across = add([0, 0, 0], right, (x - stage.width / 2) / scale);
  return { eye, along: subtract(add(across, up, (stage.height / 2 - y) / scale), back) };
}

/** The step in space, parallel to the screen, that moves a point by CSS pixels. */
export function stepInView(orbit: Orbit, stage: StageBox, at: Vector, dx: number, dy: number): Vector {
  const { eye, right, up, back } = frameOf(orbit);
  const perPixel = Math.max(-dot(subtract(at, eye), back), 1e-9) / focal(stage);
  return add(add([0, 0, 0], right, dx * perPixel), up, -dy * perPixel);
}

/** The step along a line in space whose picture comes nearest to a step of CSS pixels. */
export function stepAlong(orbit: Orbit, stage: StageBox, at: Vector, axis: Vector, dx: number, dy: number): Vector {
  const project = projector(orbit, stage);
  const direction = unit(axis);
  const small = orbit.distance * 1e-3;
  const [from, to] = [project(at), project(add(at, direction, small))];
  const [ax, ay] = [(to.x - from.x) / small, (to.y - from.y) / small];
  const size = ax * ax + ay * ay;
  // Seen end on, an axis has no picture to be drawn along: up is forward then.
  const perUnit = focal(stage) / orbit.distance;
  if (size < (0.08 * perUnit) ** 2) return add([0, 0, 0], direction, -dy / perUnit);
  return add([0, 0, 0], direction, (dx * ax + dy * ay) / size);
}

/** As a hand turns it that moves by CSS pixels. */
export function turned(orbit: Orbit, dx: number, dy: number): Orbit {
  return turnedBy(orbit, dx * 0.008, dy * 0.008);
}

/** What faces the eye goes to the right and down, by radians. */
export function turnedBy(orbit: Orbit, right: number, down: number): Orbit {
  const pitch = Math.max(-steepest, Math.min(steepest, orbit.pitch + down));
  return { ...orbit, yaw: (orbit.yaw - right) % (2 * Math.PI), pitch };
}

/** What is as far away as `at` goes with the hand. */
export function shifted(orbit: Orbit, stage: StageBox, dx: number, dy: number, at: Vector = orbit.target): Orbit {
  return { ...orbit, target: subtract(orbit.target, stepInView(orbit, stage, at, dx, dy)) };
}

/**
 * Closer by a factor to a place that stays where it is on the screen, twenty times nearer to twenty times farther than
 * what fits: 5 % as in every mode.
 */
export function dollied(orbit: Orbit, factor: number, fitting: number, to: Vector = orbit.target): Orbit {
  const distance = Math.max(fitting / 20, Math.min(fitting * 20, orbit.distance / factor));
  return { ...orbit, distance, target: add(to, subtract(orbit.target, to), distance / orbit.distance) };
}

export interface Ball {
  readonly center: Vector;
  readonly radius: number;
}

/** The distance from which a ball fits the stage with a margin. */
export function fittingDistance({ radius }: Pick<Ball, "radius">, stage: StageBox): number {
  const narrow = Math.min(1, stage.width / Math.max(1, stage.height));
  return (1.12 * Math.max(radius, 1e-9)) / Math.sin(Math.atan(Math.tan(opening / 2) * narrow));
}

/** The three views of a drawing board. */
export const boardViews: Readonly<Record<"front" | "side" | "top", { readonly yaw: number; readonly pitch: number }>> = {
  front: { yaw: -Math.PI / 2, pitch: 0 },
  side: { yaw: 0, pitch: 0 },
  top: { yaw: -Math.PI / 2, pitch: steepest },
};
