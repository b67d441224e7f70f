/**
 * Contours, and the points that they are made of.
 *
 * A segment's shape depends only on its two points, the two handles that face each other and the angle ω·length, so
 * the handles are stored the way they are shown: as offsets, one third of the tangent vector times the parameter
 * length of their segment. Inserting, refining and importing stay exact because ω and length are kept per segment
 * wherever they are not the ordinary ones.
 */

import type { Painted } from "./painted.ts";
import type { Root } from "./surface/surface.ts";

export type { Line, Painted } from "./painted.ts";

export type Space = "trigonometric" | "hyperbolic" | "polynomial";

/** How the two handles of a point hang together: equal and opposite, opposite, or free. */
export type Kind = "symmetric" | "smooth" | "cusp";

export type Family = "hermite" | "interpolating";

export interface Offset {
  readonly dx: number;
  readonly dy: number;
}

export interface ControlPoint {
  readonly x: number;
  readonly y: number;
  readonly kind: Kind;
  /** The handle on the arriving side, relative to the point. */
  readonly in: Offset;
  /** The handle on the leaving side, relative to the point. */
  readonly out: Offset;
  /** The level at which refining made this point; absent for the points of level 0. */
  readonly level?: number;
  /** A finer control point: how far it was moved from where the points on the curve put it. */
  readonly moved?: Offset;
}

export interface Contour extends Painted {
  readonly family: Family;
  readonly closed: boolean;
  readonly points: readonly ControlPoint[];
  /**
   * How many segments on each side moving one point may change. A Hermite point changes its two neighbours' segments.
   */
  readonly support?: number;
  /** Radians per unit of the parameter, one number per segment; absent: the document's frequency. */
  readonly omega?: readonly number[];
  /** Parameter length of every segment; absent: all 1. */
  readonly lengths?: readonly number[];
  /** Where it differs from the document's (an imported arc in a hyperbolic document). */
  readonly space?: Space;
  /** Interpolating: how many roots its generator has; absent: 3. One more is one more continuous derivative. */
  readonly order?: Order;
  /** Interpolating: the roots themselves, where they do not follow from space, frequency and order. */
  readonly roots?: readonly Root[];
  /** Interpolating, above level 0: where its points stand, which are then near the curve and not on it. */
  readonly grid?: Grid;
  /**
   * Interpolating, at level 0: places with finer control points, which stand in `points` after those on the curve,
   * place by place.
   */
  readonly places?: readonly FinePlace[];
}

/** Some consecutive control points of the grid 2^−level. */
export interface FinePlace {
  readonly level: number;
  readonly first: number;
  readonly count: number;
}

export type Order = 3 | 4 | 5;

/** The grid of a refined interpolating contour. */
export interface Grid {
  /** Parameter from one point to the next. */
  readonly step: number;
  /** Parameter of the first point. */
  readonly offset: number;
  /** Number of points at level 0. */
  readonly count: number;
}
