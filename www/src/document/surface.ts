/** The surface: a net of control points in two directions, each with the generator that spans it. */

/** A root of a generator, in radians or 1 per unit of the parameter. Lists are closed under conjugation. */
export interface Root {
  readonly re: number;
  readonly im: number;
}

/** One direction of the net before any refinement. */
export interface NetDirection {
  readonly roots: readonly Root[];
  /** Rows of the net at level 0; an open direction has some beyond each end. */
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
}

export const emptySurface: SurfaceDocument = { sample: "surf-torus", levelU: 0, levelV: 0, support: [1, 1], patches: 0, net: [] };

/** A point of the net. */
export interface NetRef {
  readonly u: number;
  readonly v: number;
}

export const noNetPoints: readonly NetRef[] = [];

/** What an entry of the surface's history brings back. */
export interface SurfaceMoment {
  readonly surface: SurfaceDocument;
  readonly chosen: readonly NetRef[];
}
