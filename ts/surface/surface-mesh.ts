/** Meshes of surfaces as they are handed out, filled again, and mended where a point has moved. */
import { type Floats, MAX_OUTPUT, integer, lengthOfArray, overLimit, tagOf, wrong, wrongLength } from "../core.js";
import type { SurfaceData } from "./surface-data.js";
import { call, peek, result } from "./surface-engine.js";

/** Triangles of a surface. */
export interface SurfaceMesh {
  /** Vertices: `rows` in u, `cols` in v. */
  readonly rows: number;
  /** Vertices in v. */
  readonly cols: number;
  /** Three numbers for each vertex, row by row. */
  readonly positions: Float64Array | Float32Array;
  /** Unit normals, ∂u × ∂v; at poles their limit; 0, 0, 0 where the surface has none. */
  readonly normals: Float64Array | Float32Array;
  /** Three vertices for each triangle, counterclockwise as seen from where the normals point. */
  readonly indices: Uint32Array;
  /** How many vertices have no normal, as their surroundings are a point or a line. */
  withoutNormal: number;
}

/** Rows and columns of a mesh, counted round its end where the surface is closed. */
export interface MeshRegion {
  /** First row, and how many. */
  rows: readonly [number, number];
  /** First column, and how many. */
  cols: readonly [number, number];
}

/** Vertices in u and in v. @internal */
export type Grid = readonly [rows: number, cols: number];

/** How many vertices a mesh is to have. @internal */
export function sizes(op: string, rows: unknown, cols: unknown): Grid {
  const grid = [integer(op, "rows", rows, 2, MAX_OUTPUT), integer(op, "cols", cols, 2, MAX_OUTPUT)] as const;
  if (grid[0] * grid[1] > MAX_OUTPUT) throw overLimit(op, "rows × cols", "maxOutputPoints", MAX_OUTPUT, grid[0] * grid[1]);
  return grid;
}

/** The arrays of a mesh that a caller hands in, read once. */
interface Target {
  readonly grid: Grid;
  readonly positions: Float64Array | Float32Array;
  readonly normals: Float64Array | Float32Array;
}

/** Whether it really holds floating-point numbers, of either width. */
function isFloats(value: unknown): value is Float64Array | Float32Array {
  return /^Float(?:32|64)Array$/.test(String(tagOf(value)));
}

/** A mesh of ours, or one like it, that is as large as it says, or as it should be. */
function targetOf(op: string, arg: "mesh" | "out", value: unknown, wanted?: Grid): Target {
  const { rows, cols, positions, normals } = (value ?? {}) as Partial<SurfaceMesh>;
  if (!isFloats(positions) || !isFloats(normals)) throw wrong("E_TYPE", op, arg, value, "a mesh of this package");
  const grid = wanted ?? sizes(op, rows, cols);
  const needed = 3 * grid[0] * grid[1];
  for (const array of [positions, normals]) {
    const length = lengthOfArray(op, arg, array);
    if (length !== needed) throw wrongLength(op, arg, length, String(needed));
  }
  return { grid, positions, normals };
}

/** Refuses a mesh that is frozen before anything of it is written. */
function writable(op: string, arg: "mesh" | "out", value: unknown): SurfaceMesh {
  const mesh = value as SurfaceMesh;
  if (!Reflect.set(mesh, "withoutNormal", mesh.withoutNormal)) throw wrong("E_TYPE", op, arg, value, "a mesh that can be written to");
  return mesh;
}

/** All vertices, as they lie in the kernel: positions, then normals. */
function vertices(op: string, slot: number, grid: Grid): { positions: Float64Array; normals: Float64Array } {
  const all = peek(call(op, (kernel) => kernel.surface_mesh(slot, ...grid, 0, grid[0], 0, grid[1])));
  return { positions: all.subarray(0, all.length / 2), normals: all.subarray(all.length / 2) };
}

/** The triangles of a mesh: whole numbers that lie two by two where the kernel has its numbers. */
function triangles(op: string, slot: number, [rows, cols]: Grid): Uint32Array {
  const places = peek(call(op, (kernel) => kernel.surface_indices(slot, rows, cols)));
  return new Uint32Array(places.buffer, places.byteOffset, result(0)).slice();
}

/** A new mesh of the surface in a place of the kernel. @internal */
export function newMesh(op: string, slot: number, grid: Grid): SurfaceMesh & { positions: Floats; normals: Floats } {
  const indices = triangles(op, slot, grid);
  const { positions, normals } = vertices(op, slot, grid);
  const [rows, cols] = grid;
  return { rows, cols, positions: positions.slice() as Floats, normals: normals.slice() as Floats, indices, withoutNormal: result(0) };
}

/** Fills a mesh of the same size again; its triangles stay. @internal */
export function refill(op: string, surface: SurfaceData, grid: Grid, out: unknown): SurfaceMesh {
  const target = targetOf(op, "out", out, grid);
  const mesh = writable(op, "out", out);
  const { positions, normals } = vertices(op, surface.resident(op), grid);
  target.positions.set(positions);
  target.normals.set(normals);
  mesh.withoutNormal = result(0);
  return mesh;
}

/** How many of the vertices have no normal. */
function withoutNormal(normals: Float64Array | Float32Array): number {
  let count = 0;
  for (let k = 0; k < normals.length; k += 3) if (normals[k] === 0 && normals[k + 1] === 0 && normals[k + 2] === 0) count += 1;
  return count;
}

/**
 * Computes again what a control point of the net (`patch` −1) or of a patch touches, and says which part that is.
 * @internal
 */
export function mend(op: string, surface: SurfaceData, value: unknown, patch: number, row: number, col: number): MeshRegion {
  const { grid, positions, normals } = targetOf(op, "mesh", value);
  const mesh = writable(op, "mesh", value);
  const [rows, cols] = grid;
  // Now, when no getter of the mesh's can ask other surfaces any more.
  const slot = surface.resident(op);
  call(op, (kernel) => kernel.surface_touched(slot, ...grid, patch, row, col));
  const [first, count, left, across] = [result(0), result(1), result(2), result(3)];
  const total = call(op, (kernel) => kernel.surface_mesh(slot, ...grid, first, count, left, across));
  const all = peek(total);
  // A line that runs across the seam goes on at the beginning of the row.
  const before = 3 * Math.min(across, cols - left);
  let without = 0;
  for (const [array, start] of [[positions, 0], [normals, total / 2]] as const) {
    for (let k = 0; k < count; k += 1) {
      const line = all.subarray(start + 3 * across * k, start + 3 * across * (k + 1));
      const to = 3 * cols * ((first + k) % rows);
      for (const [part, at] of [[line.subarray(0, before), to + 3 * left], [line.subarray(before), to]] as const) {
        if (array === normals) without += withoutNormal(part) - withoutNormal(array.subarray(at, at + part.length));
        array.set(part, at);
      }
    }
  }
  mesh.withoutNormal += without;
  return { rows: [first, count], cols: [left, across] };
}
