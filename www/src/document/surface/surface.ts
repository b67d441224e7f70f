/** The surface: a net of control points in two directions, each with the generator that spans it. */

/** A root of a generator, in radians or 1 per unit of the parameter. Lists are closed under conjugation. */
export interface Root {
  readonly re: number;
  readonly im: number;
}

/** One direction of the net. */
export interface NetDirection {
  /** Per unit of level 0, whatever the level is. */
  readonly roots: readonly Root[];
  /** Rows of the net at its level; an open direction has some beyond each end. */
  readonly count: number;
  readonly closed: boolean;
}

export interface NetPoint {
  readonly u: number;
  readonly v: number;
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

export interface SurfaceDocument {
  readonly sample: string;
  readonly levelU: number;
  readonly levelV: number;
  /** How many segments to each side moving one point may change, in either direction. */
  readonly support: readonly [number, number];
  readonly patches: number;
  /** Row-major, v fastest, at the present level. Empty: the sample has not been opened yet. */
  readonly net: readonly NetPoint[];
  /** Absent exactly while the net is empty. */
  readonly u?: NetDirection;
  readonly v?: NetDirection;
  /** Places that were refined on their own. */
  readonly details?: readonly Detail[];
}

/** Some consecutive control points of a finer level; closed directions go on from the first after the last. */
export interface NetWindow {
  readonly level: number;
  readonly first: number;
  readonly count: number;
}

/**
 * A window of finer control points, each displaced from where the coarser ones put it. Without displacement it changes
 * nothing.
 */
export interface Detail {
  readonly u: NetWindow;
  readonly v: NetWindow;
  /** Three numbers a point, row-major, v fastest. */
  readonly displacements: readonly number[];
}

export const emptySurface: SurfaceDocument = { sample: "surf-torus", levelU: 0, levelV: 0, support: [1, 1], patches: 0, net: [] };

/** A point of the net, or of a detail: then counted within its window. */
export interface NetRef {
  readonly u: number;
  readonly v: number;
  readonly detail?: number;
}

export function sameNetPoint(a: NetRef, b: NetRef): boolean {
  return a.u === b.u && a.v === b.v && a.detail === b.detail;
}

export function isChosen(chosen: readonly NetRef[], point: NetRef): boolean {
  return chosen.some((other) => sameNetPoint(other, point));
}

export const noNetPoints: readonly NetRef[] = [];

/** What an entry of the surface's history brings back. */
export interface SurfaceMoment {
  readonly surface: SurfaceDocument;
  readonly chosen: readonly NetRef[];
}

/** Where the surface is looked at from, as a file keeps it. */
export interface SavedOrbit {
  readonly yaw: number;
  readonly pitch: number;
  readonly distance: number;
  readonly target: readonly [number, number, number];
}
