/** What every kind of curve can do, and what it answers. */
import type { MatrixLike, PointsLike, SpacePointsLike } from "./arguments.js";
import type { PathObject } from "./host.js";

/** A rectangle along the axes, in the user's unit; a box for a curve in space. */
export interface Bounds {
  /** The least x. */
  minX: number;
  /** The least y. */
  minY: number;
  /** The largest x. */
  maxX: number;
  /** The largest y. */
  maxY: number;
  /** The least z, of a curve in space only. */
  minZ?: number;
  /** The largest z, of a curve in space only. */
  maxZ?: number;
}

/** A place on a curve and how far it is from the place that was asked about. */
export interface Nearest {
  /** The parameter. */
  t: number;
  /** Where the curve is there. */
  x: number;
  /** Where the curve is there. */
  y: number;
  /** Of a curve in space only. */
  z?: number;
  /** How far that is, in the user's unit, never negative. */
  distance: number;
}

/** An ellipse, or the arc of one that runs from angle `start` over `sweep`, in radians from the first axis. */
export interface Ellipse {
  /** Where its centre is. */
  center: [number, number];
  /** The two half axes. */
  radii: [number, number];
  /** Angle of the first axis, in radians from the x axis towards the y axis. */
  rotation: number;
  /** Where it begins, as an angle on the circle of which it is an image. */
  start: number;
  /** How far it runs from there: ±2π for a whole ellipse, negative where it turns from y towards x. */
  sweep: number;
}

/** How a path is written. */
export interface PathOptions {
  /**
   * Largest distance between the path and the curve, in the user's unit. Default 0.02; below 1e-9 of the curve's
   * extent, or 1e-15 of its largest coordinate, it counts as that.
   */
  tolerance?: number | undefined;
  /**
   * Digits after the point, 0 to 17. Default: as few as the tolerance allows; 17 keeps every coordinate to the last
   * bit.
   */
  decimals?: number | undefined;
  /** Whether pieces of ellipses are written as arcs, `A`. Default true. */
  arcs?: boolean | undefined;
  /** Whether relative commands are used where they are shorter. Default false. */
  relative?: boolean | undefined;
}

/** Everything that every curve can do. */
export interface Curve {
  /** Whether the last point is joined to the first; then any t is accepted. */
  readonly closed: boolean;
  /** First and last parameter. Sums of lengths may be a rounding off. */
  readonly domain: readonly [number, number];
  /** 2 for a curve of the plane, 3 in space. */
  readonly dimension: 2 | 3;
  /**
   * Points, or derivatives by the parameter, at one or many t: all coordinates in turn. An open curve refuses t outside
   * its domain.
   */
  evaluate(t: number | Float64Array | readonly number[], derivative?: number, out?: Float64Array): Float64Array;
  /** `count` points evenly over the parameter; an open curve's last one is its end. */
  sample(count: number, options?: { out?: Float64Array | undefined; tangents?: boolean | undefined }): Float64Array;
  /** `count` points at equal distances along the curve. */
  sampleByLength(count: number, options?: { tolerance?: number | undefined }): Float64Array;
  /** A polyline that is nowhere farther from the curve than `tolerance`, in the user's unit. */
  flatten(tolerance: number): Float64Array;
  /** Cubic Béziers within `tolerance`, 8 numbers each (12 in space); `maxError` is proved. */
  toCubics(tolerance: number): { path: Float64Array; maxError: number };
  /** SVG path data; `maxError` is how far what is written is from the curve. */
  toPathD(options?: PathOptions): { d: string; maxError: number };
  /** The same as a `Path2D`, in browsers. */
  toPath2D(options?: PathOptions): PathObject;
  /** The ellipse, or the arc of one, that the curve is made of; undefined for cubics, however near one they are. */
  asEllipse(tolerance?: number): Ellipse | undefined;
  /** Its length, to an absolute tolerance; default 1e-9 of its size. */
  length(tolerance?: number): number;
  /**
   * The parameter up to which the curve has the given length: from 0 to its own, of a closed curve no more than one
   * round.
   */
  parameterAtLength(length: number, tolerance?: number): number;
  /** The signed area of a closed curve of the plane. */
  area(): number;
  /** The centre of gravity of that area. */
  centroid(): { x: number; y: number };
  /** The smallest box around the curve itself. */
  bounds(): Bounds;
  /** The point of the curve that is nearest to a place. */
  nearest(x: number, y: number, z?: number): Nearest;
  /** The nearest point to each of many places: t, the point, and the distance in turn. */
  nearestAll(places: PointsLike | SpacePointsLike): Float64Array;
  /** The signed curvature, in 1 per unit. */
  curvature(t: number | Float64Array | readonly number[]): Float64Array;
  /** The image under an affine map: six numbers in the plane, 16 in space. */
  transform(matrix: MatrixLike): Curve;
  /** Plain data, of which `fromJSON` makes the same curve to the last bit. */
  toJSON(): object;
}
