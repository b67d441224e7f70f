/** Meshes of surfaces as they are handed out, filled again, and mended where a point has moved. */
import { type Floats, MAX_OUTPUT, integer, lengthOfArray, overLimit, tagOf, wrong, wrongLength } from "../core.js";
import type { SurfaceData } from "./surface-data.js";
import { type SurfaceKernel, call, peek, result } from "./surface-engine.js";

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

/** Numbers of vertices. */
type Numbers = Float64Array | Float32Array;

/** The arrays of a mesh. */
interface Vertices {
  readonly positions: Numbers;
  readonly normals: Numbers;
}

/** Those of one that a caller hands in, read once. */
interface Target extends Vertices {
  readonly grid: Grid;
}

/** Whether it really holds floating-point numbers, of either width. */
function isFloats(value: unknown): value is Numbers {
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

/** First row, rows, first column and columns; counted round the end where the surface is closed. */
type Part = readonly [row: number, rows: number, col: number, cols: number];

/** So many columns, and so many vertices, at a time: what the engine needs for more is a multiple of what comes out. */
const MOST_COLUMNS = 1 << 16;
const MOST_VERTICES = 1 << 20;

/** The parts that a grid is worked out in: all but very large ones in a single one. */
function partsOf([rows, cols]: Grid): Part[] {
  const across = Math.min(cols, MOST_COLUMNS);
  const down = Math.min(rows, Math.floor(MOST_VERTICES / across));
  const parts: Part[] = [];
  for (let row = 0; row < rows; row += down) {
    for (let col = 0; col < cols; col += across) parts.push([row, Math.min(down, rows - row), col, Math.min(across, cols - col)]);
  }
  return parts;
}

/**
 * The runs of vertices of a part: number of the first in the grid and in the part, and how many. A line that runs
 * across the seam goes on at the beginning of the row.
 */
function runs([rows, cols]: Grid, [row, count, left, across]: Part, visit: (to: number, from: number, length: number) => void): void {
  const before = Math.min(across, cols - left);
  for (let k = 0; k < count; k += 1) {
    const to = cols * ((row + k) % rows);
    visit(to + left, across * k, before);
    if (before < across) visit(to, across * k + before, across - before);
  }
}

/**
 * Works out a part of a grid and puts it where it belongs in two arrays of `each` numbers a vertex: `body` leaves one
 * half of its numbers for each.
 */
function fill(op: string, grid: Grid, part: Part, halves: readonly Numbers[], each: number, body: (kernel: SurfaceKernel) => number): void {
  const total = call(op, body);
  const all = peek(total);
  runs(grid, part, (to, from, length) => {
    halves.forEach((array, i) => {
      const start = (i * total) / 2 + each * from;
      array.set(all.subarray(start, start + each * length), each * to);
    });
  });
}

/** Works out the vertices of a part; how many have no normal. */
function vertices(op: string, slot: number, grid: Grid, part: Part, { positions, normals }: Vertices): number {
  fill(op, grid, part, [positions, normals], 3, (kernel) => kernel.surface_mesh(slot, ...grid, ...part));
  return result(0);
}

/** Works out all vertices; how many have no normal. */
function allVertices(op: string, slot: number, grid: Grid, target: Vertices): number {
  return partsOf(grid).reduce((without, part) => without + vertices(op, slot, grid, part, target), 0);
}

/** Curvatures at all vertices. @internal */
export function curvatures(op: string, slot: number, grid: Grid): { gaussian: Float64Array; mean: Float64Array } {
  const [gaussian, mean] = [new Float64Array(grid[0] * grid[1]), new Float64Array(grid[0] * grid[1])];
  for (const part of partsOf(grid)) {
    fill(op, grid, part, [gaussian, mean], 1, (kernel) => kernel.surface_mesh_curvature(slot, ...grid, ...part));
  }
  return { gaussian, mean };
}

/** The triangles of a mesh: whole numbers that lie two by two where the kernel has its numbers. */
function triangles(op: string, slot: number, [rows, cols]: Grid): Uint32Array {
  const places = peek(call(op, (kernel) => kernel.surface_indices(slot, rows, cols)));
  return new Uint32Array(places.buffer, places.byteOffset, result(0)).slice();
}

/** A new mesh of the surface in a place of the kernel. @internal */
export function newMesh(op: string, slot: number, grid: Grid): SurfaceMesh & { positions: Floats; normals: Floats } {
  const indices = triangles(op, slot, grid);
  const [rows, cols] = grid;
  const [positions, normals] = [new Float64Array(3 * rows * cols), new Float64Array(3 * rows * cols)];
  const withoutNormal = allVertices(op, slot, grid, { positions, normals });
  return { rows, cols, positions, normals, indices, withoutNormal };
}

/** Fills a mesh of the same size again; its triangles stay. @internal */
export function refill(op: string, surface: SurfaceData, grid: Grid, out: unknown): SurfaceMesh {
  const target = targetOf(op, "out", out, grid);
  const mesh = writable(op, "out", out);
  mesh.withoutNormal = allVertices(op, surface.resident(op), grid, target);
  return mesh;
}

/** How many of the vertices have no normal. */
function withoutNormal(normals: Numbers): number {
  let count = 0;
  for (let k = 0; k < normals.length; k += 3) if (normals[k] === 0 && normals[k + 1] === 0 && normals[k + 2] === 0) count += 1;
  return count;
}

/**
 * Computes again what a control point of the net (`patch` −1) or of a patch touches, and says which part that is.
 * @internal
 */
export function mend(op: string, surface: SurfaceData, value: unknown, patch: number, row: number, col: number): MeshRegion {
  const target = targetOf(op, "mesh", value);
  const { grid, normals } = target;
  const mesh = writable(op, "mesh", value);
  // Now, when no getter of the mesh's can ask other surfaces any more.
  const slot = surface.resident(op);
  call(op, (kernel) => kernel.surface_touched(slot, ...grid, patch, row, col));
  const part = [result(0), result(1), result(2), result(3)] as const;
  let before = 0;
  runs(grid, part, (to, _, length) => (before += withoutNormal(normals.subarray(3 * to, 3 * (to + length)))));
  mesh.withoutNormal += vertices(op, slot, grid, part, target) - before;
  return { rows: [part[0], part[1]], cols: [part[2], part[3]] };
}
