/** Surfaces as plain data. */
import { type Root, rootList } from "../core.js";
import type { DirectionData, PatchWindow, SurfaceData } from "./surface-data.js";

/** One direction of a net as plain data. */
export interface DirectionJSON {
  /** What this direction reproduces. */
  roots: Root[];
  /** Rows of the net. */
  count: number;
  /** Whether the last row is followed by the first. */
  closed: boolean;
  /** Only where it is not 0. */
  level?: number;
}

/** A `TensorSurface` as plain data. Fields that a newer version wrote are kept. */
export interface TensorSurfaceJSON {
  /** What it is. */
  type: "TensorSurface";
  /** Of the format; a file of a newer one is refused. */
  version: 1;
  /** Three numbers for each point, v fastest. */
  net: number[];
  /** From row to row of the net. */
  u: DirectionJSON;
  /** Along a row. */
  v: DirectionJSON;
  /** Only where there are some. */
  patches?: { u: PatchWindow; v: PatchWindow; displacements: number[] }[];
  [unknown: string]: unknown;
}

function direction({ roots, count, closed, level }: DirectionData): DirectionJSON {
  return { roots: rootList(roots), count, closed, ...(level === 0 ? {} : { level }) };
}

/** A surface's arrays as plain data. @internal */
export function surfaceJSON({ net, u, v, patches, extra }: SurfaceData): TensorSurfaceJSON {
  const list = patches.map((patch) => ({ u: { ...patch.u }, v: { ...patch.v }, displacements: Array.from(patch.displacements) }));
  return {
    type: "TensorSurface",
    version: 1,
    net: Array.from(net),
    u: direction(u),
    v: direction(v),
    ...(list.length === 0 ? {} : { patches: list }),
    ...extra,
  };
}
