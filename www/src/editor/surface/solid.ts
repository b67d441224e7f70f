import type { NetRef } from "../../document/surface/surface.ts";
import type { Orbit } from "./orbit.ts";

/** How the surface is looked at and shown; no part of the drawing and never in its history. */

export type Shade = "solid" | "wire" | "normals" | "curvature" | "zebra";
export type DragAxis = "view" | "x" | "y" | "z" | "normal";

export interface SolidState {
  readonly orbit: Orbit;
  /** Radius of what fills the stage at 100 %: of the surface as it was opened or last fitted. 0 before that. */
  readonly full: number;
  readonly shade: Shade;
  /** Sides of a patch that is drawn, 4 … 64. */
  readonly tessellation: number;
  readonly axis: DragAxis;
  readonly net: boolean;
  readonly iso: boolean;
  readonly handles: boolean;
  /** The generators of the chosen point, standing on the surface. */
  readonly weights: boolean;
  readonly hover: NetRef | null;
  /** What is being dragged, and the axis it is held to. */
  readonly drag: { readonly points: readonly NetRef[]; readonly axis: DragAxis } | null;
  /** The view is being turned: a picture now is worth more than a fine one later. */
  readonly turning: boolean;
  /** Drawn by the graphics card; false: lines on the ordinary canvas. */
  readonly shaded: boolean;
}

/** Where one looks from first. */
export const startOrbit: Orbit = { yaw: 0.9, pitch: 0.55, distance: 5, target: [0, 0, 0] };

export const startSolid: SolidState = {
  orbit: startOrbit, full: 0, shade: "solid", tessellation: 16, axis: "view", net: true, iso: true,
  handles: true, weights: false, hover: null, drag: null, turning: false, shaded: false,
};
