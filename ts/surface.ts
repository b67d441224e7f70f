/** Surfaces: a net of points, smooth in both directions, exact for quadrics. */
import {
  LARGEST,
  MAX_EVALUATIONS,
  MAX_OUTPUT,
  type Floats,
  type Root,
  coordinate,
  count as checkCount,
  finite,
  flag,
  integer,
  isFloat64Array,
  lengthOfArray,
  numbers,
  options as checkOptions,
  overLimit,
  rootList,
  rootNumbers,
  within,
  wrong,
  wrongLength,
} from "./core.js";
import { type MeshFileOptions, gltfOf, objOf } from "./mesh-files.js";
import { type DirectionData, type PatchData, type PatchWindow, SurfaceData, readSurface } from "./surface-data.js";
import { type SurfaceKernel, call, copy, peek, result, write } from "./surface-engine.js";
import { type TensorSurfaceJSON, surfaceJSON } from "./surface-json.js";

export type { MeshFileOptions } from "./mesh-files.js";
export type { PatchWindow } from "./surface-data.js";
export { initSurface, initSurfaceSync } from "./surface-engine.js";
export type { DirectionJSON, TensorSurfaceJSON } from "./surface-json.js";

/** How a net runs in one of its two directions. */
export interface Direction {
  /** The roots of the generator, per unit of the parameter; closed under conjugation and under negation. */
  roots: readonly Root[];
  /** How many points: 3 or more where closed, else 2·n₀ − 2 or more (n₀ at a level above 0). */
  count: number;
  /** Whether the last point is followed by the first. */
  closed: boolean;
  /** 0, the default: points on the surface, one for each unit. k: B-spline control points near it, 2ᵏ for each unit. At most 12. */
  level?: number | undefined;
}

/** A patch of finer control points over a part of a surface, as plain data. */
export interface SurfacePatch {
  /** Level of the patch's grid in u, its first row there, and how many rows. */
  u: PatchWindow;
  /** The same in v. */
  v: PatchWindow;
  /** How far each control point was moved from where the refined net has it: three numbers each, v fastest. */
  displacements: Float64Array;
}

/** What a {@link TensorSurface} is made from. */
export interface TensorSurfaceOptions {
  /** 3-D points, three numbers each, row by row: v runs fastest. */
  net: Float64Array | readonly number[];
  /** From row to row. */
  u: Direction;
  /** Along a row. */
  v: Direction;
  /** Detail, as `patches` of another surface gives it. */
  patches?: readonly SurfacePatch[] | undefined;
}

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

const NAME = "TensorSurface";
/** The most points of a net. */
const MAX_NET = 4_194_304;
/** The finest level. */
const MAX_LEVEL = 12;

/** The arrays of a surface, and the proof that it is one. */
let dataOf: (surface: TensorSurface, op: string) => SurfaceData;

/** The surface that the kernel left in its output. */
function derived(count: number): TensorSurface {
  return surfaceOf(readSurface(count));
}

/** Makes a surface of arrays that the kernel or a check has vouched for. @internal */
export function surfaceOf(data: SurfaceData): TensorSurface {
  return new TensorSurface(data as unknown as TensorSurfaceOptions);
}

/**
 * A surface through a net of points: Σ net[k, l]·φ(u − k)·φ(v − l).
 *
 * A closed direction of `count` points is periodic on [0, count], an open one lives on [0, count − (2·n₀ − 3)], with row n₀ − 2 at 0. Refined
 * directions keep the parameter. Moving a point changes the surface within n₀ − 1 units of it and nowhere else.
 */
export class TensorSurface {
  readonly #data: SurfaceData;

  static {
    dataOf = (surface, op) => {
      if (typeof surface !== "object" || surface === null || !(#data in surface)) {
        throw wrong("E_TYPE", op, "this", surface, NAME);
      }
      return surface.#data;
    };
  }

  /**
   * A surface from its net. The arrays are copied.
   *
   * @throws {ExplineError} for whatever is wrong with the options; nothing is made then.
   */
  constructor(options: TensorSurfaceOptions) {
    this.#data = options instanceof SurfaceData ? options : checkedSurface(NAME, options);
  }

  /** A sphere about the origin: u runs round, v from the south pole (0, 0, −radius) to the north pole. `segments`: units in u and v, at least 3 and 2. */
  static sphere(radius: number, segments?: readonly [number, number]): TensorSurface {
    return shape("sphere", 0, [["radius", radius]], segments, [8, 4]);
  }

  /** An ellipsoid about the origin with its half axes along x, y and z, otherwise as {@link TensorSurface.sphere}. */
  static ellipsoid(radii: readonly [number, number, number], segments?: readonly [number, number]): TensorSurface {
    return shape("ellipsoid", 1, three("ellipsoid", "radii", radii), segments, [8, 4]);
  }

  /** A torus about the z axis: u runs round the axis at distance `radius`, v round the tube. `segments` at least 3. */
  static torus(radius: number, tube: number, segments?: readonly [number, number]): TensorSurface {
    return shape("torus", 2, [["radius", radius], ["tube", tube]], segments, [8, 6]);
  }

  /** A cylinder about the z axis, without lids, from z = −height/2 to height/2. `segments` at least 3 and 1. */
  static cylinder(radius: number, height: number, segments?: readonly [number, number]): TensorSurface {
    return shape("cylinder", 3, [["radius", radius], ["height", height]], segments, [8, 2]);
  }

  /** Steiner's Roman surface ½r²(cos a·sin 2b, sin a·sin 2b, sin 2a·cos² b), covered twice. `segments` at least 5. */
  static romanSurface(r: number, segments?: readonly [number, number]): TensorSurface {
    return shape("romanSurface", 4, [["r", r]], segments, [5, 5]);
  }

  /** A piece of x²/a² − y²/b² = z/h: (a·p·cosh q, b·p·sinh q, h·p²) for p and q from −1 to 1. `segments` at least 1. */
  static hyperbolicParaboloid(a: number, b: number, h: number, segments?: readonly [number, number]): TensorSurface {
    return shape("hyperbolicParaboloid", 5, [["a", a], ["b", b], ["h", h]], segments, [6, 6]);
  }

  /** A duckling, about 2 high: a modelled shape of 12 × 11 points, twice continuously differentiable. */
  static character(): TensorSurface {
    return shape("character", 6, [], undefined, [0, 0]);
  }

  /** First and last parameter in each direction. */
  get domain(): { u: readonly [number, number]; v: readonly [number, number] } {
    const { end } = dataOf(this, "domain");
    return { u: [0, end[0]], v: [0, end[1]] };
  }

  /** How the net runs in u: a copy. */
  get u(): Required<Direction> {
    return described(dataOf(this, "u").u);
  }

  /** How the net runs in v: a copy. */
  get v(): Required<Direction> {
    return described(dataOf(this, "v").v);
  }

  /** The net: a copy. Setting it moves all points at once; there must be as many as before. */
  get net(): Float64Array {
    return dataOf(this, "net").net.slice();
  }

  set net(value: Float64Array | readonly number[]) {
    const data = dataOf(this, "net");
    data.net.set(netOf(NAME, value, data.net.length));
    data.touch();
  }

  /** The patches of detail: copies. */
  get patches(): SurfacePatch[] {
    return dataOf(this, "patches").patches.map(({ u, v, displacements }) => {
      return { u: { ...u }, v: { ...v }, displacements: displacements.slice() };
    });
  }

  /** The parameters of net point (i, j); beyond the domain for the outer rows of an open direction. */
  parameters(i: number, j: number): [number, number] {
    const op = "parameters";
    const data = dataOf(this, op);
    const [row, col] = place(op, i, j, data.u.count, data.v.count);
    return [data.first[0] + row / 2 ** data.u.level, data.first[1] + col / 2 ** data.v.level];
  }

  /**
   * Points, or derivatives (`du` times by u, `dv` times by v), at pairs of parameters: x, y and z in turn.
   *
   * Derivatives up to n₀ − 2 are continuous. Closed directions take any parameter.
   */
  evaluate(u: number | Float64Array | readonly number[], v: number | Float64Array | readonly number[], du = 0, dv = 0): Float64Array {
    const op = "evaluate";
    const orders = [integer(op, "du", du, 0, 8), integer(op, "dv", dv, 0, 8)] as const;
    return pairwise(this, op, u, v, (kernel, slot, count) => kernel.surface_evaluate(slot, count, ...orders));
  }

  /** Unit normals ∂u × ∂v at pairs of parameters: at poles their limit, 0, 0, 0 where the surface has none. */
  normal(u: number | Float64Array | readonly number[], v: number | Float64Array | readonly number[]): Float64Array {
    return pairwise(this, "normal", u, v, (kernel, slot, count) => kernel.surface_evaluate(slot, count, 255, 0));
  }

  /** Gaussian curvature, and mean curvature with respect to the normal (negative on a sphere), at pairs of parameters. */
  curvature(
    u: number | Float64Array | readonly number[],
    v: number | Float64Array | readonly number[],
  ): { gaussian: Float64Array; mean: Float64Array } {
    return halves(pairwise(this, "curvature", u, v, (kernel, slot, count) => kernel.surface_curvature(slot, count)));
  }

  /**
   * Triangles between `rows` × `cols` vertices, uniform in u and v: at i/rows of a closed direction, at i/(rows − 1) of an open one.
   *
   * The triangles depend on `rows`, `cols` and on what is closed, not on the net. With `out`, a mesh of the same size is
   * filled again, whether it holds Float64Arrays or Float32Arrays; its triangles are left as they are.
   */
  mesh(rows: number, cols: number): SurfaceMesh & { positions: Float64Array; normals: Float64Array };
  mesh<M extends SurfaceMesh>(rows: number, cols: number, options: { out: M }): M;
  mesh(rows: number, cols: number, options?: { out?: SurfaceMesh }): SurfaceMesh {
    const op = "mesh";
    const data = dataOf(this, op);
    const { out } = checkOptions(op, options, ["out"]);
    const grid = sizes(op, rows, cols);
    const slot = data.resident(op);
    const numbersOfMesh = 3 * grid[0] * grid[1];
    if (out !== undefined) {
      const mesh = asMesh(op, out, grid);
      const count = call(op, (kernel) => kernel.surface_mesh(slot, ...grid, 0, grid[0], 0, grid[1]));
      const vertices = peek(count);
      mesh.positions.set(vertices.subarray(0, numbersOfMesh));
      mesh.normals.set(vertices.subarray(numbersOfMesh));
      mesh.withoutNormal = result(0);
      return mesh;
    }
    const indices = triangles(op, slot, grid);
    const count = call(op, (kernel) => kernel.surface_mesh(slot, ...grid, 0, grid[0], 0, grid[1]));
    const vertices = peek(count);
    return {
      rows: grid[0],
      cols: grid[1],
      positions: vertices.slice(0, numbersOfMesh),
      normals: vertices.slice(numbersOfMesh),
      indices,
      withoutNormal: result(0),
    };
  }

  /**
   * Computes the part of a mesh again that net point (i, j), or control point (i, j) of a patch, touches: to the last bit what
   * `mesh` would give. Returns which part.
   */
  remesh(mesh: SurfaceMesh, i: number, j: number, patch?: number): MeshRegion {
    const op = "remesh";
    const data = dataOf(this, op);
    const target = asMesh(op, mesh);
    const grid = [target.rows, target.cols] as const;
    const which = patch === undefined ? -1 : integer(op, "patch", patch, 0, data.patches.length - 1);
    const { u, v } = which < 0 ? data : (data.patches[which] as PatchData);
    const [row, col] = place(op, i, j, u.count, v.count);
    const slot = data.resident(op);
    call(op, (kernel) => kernel.surface_touched(slot, ...grid, which, row, col));
    const [first, count, left, across] = [result(0), result(1), result(2), result(3)];
    const total = call(op, (kernel) => kernel.surface_mesh(slot, ...grid, first, count, left, across));
    const vertices = peek(total);
    for (const [array, start] of [[target.positions, 0], [target.normals, total / 2]] as const) {
      for (let k = 0; k < count; k += 1) {
        const line = vertices.subarray(start + 3 * across * k, start + 3 * across * (k + 1));
        const to = 3 * target.cols * ((first + k) % target.rows);
        // A line that runs across the seam goes on at the beginning of the row.
        const before = 3 * Math.min(across, target.cols - left);
        array.set(line.subarray(0, before), to + 3 * left);
        array.set(line.subarray(before), to);
      }
    }
    return { rows: [first, count], cols: [left, across] };
  }

  /** Gaussian and mean curvature at the vertices of `mesh(rows, cols)`. */
  meshCurvature(rows: number, cols: number): { gaussian: Float64Array; mean: Float64Array } {
    const op = "meshCurvature";
    const data = dataOf(this, op);
    const grid = sizes(op, rows, cols);
    const slot = data.resident(op);
    return halves(copy(call(op, (kernel) => kernel.surface_mesh_curvature(slot, ...grid))));
  }

  /**
   * The same surface with a finer net: 2^levelsU times the points in u, 2^levelsV times in v.
   *
   * A refined direction holds control points near the surface; what is closed stays closed, and the parameter stays.
   */
  refine(levelsU: number, levelsV: number): TensorSurface {
    const op = "refine";
    const data = dataOf(this, op);
    const levels = [integer(op, "levelsU", levelsU, 0, MAX_LEVEL), integer(op, "levelsV", levelsV, 0, MAX_LEVEL)] as const;
    const slot = data.resident(op);
    return derived(call(op, (kernel) => kernel.surface_refine(slot, ...levels)));
  }

  /**
   * The nearest surface whose net is coarser by 2^levelsU and 2^levelsV, and the largest distance from this one, `maxError`. What was refined and
   * not changed comes back; level 0 goes through its points again.
   */
  reduce(levelsU: number, levelsV: number): { surface: TensorSurface; maxError: number } {
    const op = "reduce";
    const data = dataOf(this, op);
    const levels = [integer(op, "levelsU", levelsU, 0, data.u.level), integer(op, "levelsV", levelsV, 0, data.v.level)] as const;
    const slot = data.resident(op);
    const count = call(op, (kernel) => kernel.surface_reduce(slot, ...levels));
    return { maxError: result(4), surface: derived(count) };
  }

  /**
   * The same surface, to the last bit, with a patch of finer control points around (u, v): `levels` (default 1) doublings beyond the net's, all
   * within `reach` units (default 1) in each direction. The rest of the net stays as it is; its points take the detail along.
   */
  refineAt(
    u: number,
    v: number,
    options?: { levels?: number | undefined; reach?: number | undefined },
  ): TensorSurface {
    const op = "refineAt";
    const data = dataOf(this, op);
    const own = checkOptions(op, options, ["levels", "reach"]);
    const at = [finite(op, "u", u), finite(op, "v", v)] as const;
    const levels = own.levels === undefined ? 1 : integer(op, "levels", own.levels, 1, MAX_LEVEL);
    const reach = own.reach === undefined ? 1 : finite(op, "reach", own.reach);
    const slot = data.resident(op);
    return derived(call(op, (kernel) => kernel.surface_refine_at(slot, ...at, levels, reach)));
  }

  /** The control points of a patch, three numbers each, v fastest. */
  patchPoints(patch: number): Float64Array {
    const op = "patchPoints";
    const data = dataOf(this, op);
    const which = integer(op, "patch", patch, 0, data.patches.length - 1);
    const slot = data.resident(op);
    return copy(call(op, (kernel) => kernel.surface_patch_points(slot, which)));
  }

  /**
   * Moves net point (i, j).
   *
   * A smooth pole, where a whole row is one point, stays smooth: that row moves as one, and the rows beyond follow those inside.
   */
  setPoint(i: number, j: number, x: number, y: number, z: number): void {
    const op = "setPoint";
    const data = dataOf(this, op);
    const [row, col] = place(op, i, j, data.u.count, data.v.count);
    const to = [coordinate(op, "x", x), coordinate(op, "y", y), coordinate(op, "z", z)] as const;
    const slot = data.resident(op);
    const count = call(op, (kernel) => kernel.surface_set_point(slot, row, col, ...to));
    if (count > 0) data.net.set(peek(count));
    else data.net.set(to, 3 * (row * data.v.count + col));
    data.touchBoth();
  }

  /** Moves control point (i, j) of a patch, counted within it. */
  setPatchPoint(patch: number, i: number, j: number, x: number, y: number, z: number): void {
    const op = "setPatchPoint";
    const data = dataOf(this, op);
    const which = integer(op, "patch", patch, 0, data.patches.length - 1);
    const { u, v, displacements } = data.patches[which] as PatchData;
    const [row, col] = place(op, i, j, u.count, v.count);
    const to = [coordinate(op, "x", x), coordinate(op, "y", y), coordinate(op, "z", z)] as const;
    const slot = data.resident(op);
    call(op, (kernel) => kernel.surface_set_patch_point(slot, which, row, col, ...to));
    displacements.set([result(0), result(1), result(2)], 3 * (row * v.count + col));
    data.touchBoth();
  }

  /** A mesh as a Wavefront OBJ file, with normals. `rows` and `cols` default to 64, `name` to "surface". */
  toObj(options?: MeshFileOptions): string {
    const { rows, cols, name } = fileOptions("toObj", options);
    return objOf(this.mesh(rows, cols), name);
  }

  /** A mesh as a binary glTF 2.0 file (.glb), complete in itself. `rows` and `cols` default to 64, `name` to "surface". */
  toGltf(options?: MeshFileOptions): Uint8Array<ArrayBuffer> {
    const { rows, cols, name } = fileOptions("toGltf", options);
    return gltfOf(this.mesh(rows, cols), name);
  }

  /** The surface as plain data, for files and other threads; `fromJSON` is the inverse to the last bit. */
  toJSON(): TensorSurfaceJSON {
    return surfaceJSON(dataOf(this, "toJSON"));
  }
}

function described({ roots, count, closed, level }: DirectionData): Required<Direction> {
  return { roots: rootList(roots), count, closed, level };
}

/** A pair of indices within a net or a patch. */
function place(op: string, i: unknown, j: unknown, rows: number, cols: number): readonly [number, number] {
  return [integer(op, "i", i, 0, rows - 1), integer(op, "j", j, 0, cols - 1)];
}

function sizes(op: string, rows: unknown, cols: unknown): readonly [number, number] {
  const grid = [integer(op, "rows", rows, 2, MAX_OUTPUT), integer(op, "cols", cols, 2, MAX_OUTPUT)] as const;
  if (grid[0] * grid[1] > MAX_OUTPUT) throw overLimit(op, "rows", "maxOutputPoints", MAX_OUTPUT, grid[0] * grid[1]);
  return grid;
}

/** The triangles of a mesh: whole numbers that lie two by two where the kernel has its numbers. */
function triangles(op: string, slot: number, [rows, cols]: readonly [number, number]): Uint32Array {
  const places = peek(call(op, (kernel) => kernel.surface_indices(slot, rows, cols)));
  return new Uint32Array(places.buffer, places.byteOffset, result(0)).slice();
}

function isFloats(value: unknown): value is Float64Array | Float32Array {
  return value instanceof Float32Array || isFloat64Array(value);
}

/** A mesh of ours, or one like it, that is as large as it says. */
function asMesh(op: string, value: unknown, grid?: readonly [number, number]): SurfaceMesh {
  const mesh = value as Partial<SurfaceMesh> | null | undefined;
  const arg = grid === undefined ? "mesh" : "out";
  if (typeof mesh !== "object" || mesh === null || !isFloats(mesh.positions) || !isFloats(mesh.normals)) {
    throw wrong("E_TYPE", op, arg, value, "a mesh of this package");
  }
  const [rows, cols] = grid ?? sizes(op, mesh.rows, mesh.cols);
  for (const array of [mesh.positions, mesh.normals]) {
    if (array.length !== 3 * rows * cols) throw wrongLength(op, arg, array.length, String(3 * rows * cols));
  }
  return mesh as SurfaceMesh;
}

/** The two halves of what the kernel left. */
function halves(values: Float64Array): { gaussian: Float64Array; mean: Float64Array } {
  return { gaussian: values.slice(0, values.length / 2), mean: values.slice(values.length / 2) };
}

/** Answers at pairs of parameters. */
function pairwise(
  surface: TensorSurface,
  op: string,
  u: unknown,
  v: unknown,
  body: (kernel: SurfaceKernel, slot: number, count: number) => number,
): Floats {
  const data = dataOf(surface, op);
  const list = (arg: string, value: unknown): Floats => {
    return typeof value === "number" ? Float64Array.of(value) : numbers(op, arg, value, "maxEvalPoints", MAX_EVALUATIONS);
  };
  const [first, second] = [list("u", u), list("v", v)];
  if (second.length !== first.length) throw wrongLength(op, "v", second.length, String(first.length));
  const slot = data.resident(op);
  write(op, first, second);
  return copy(call(op, (kernel) => body(kernel, slot, first.length)));
}

function shape(
  name: string,
  which: number,
  lengths: readonly (readonly [string, unknown])[],
  segments: unknown,
  byDefault: readonly [number, number],
): TensorSurface {
  const op = `${NAME}.${name}`;
  const [a = 0, b = 0, c = 0] = lengths.map(([arg, value]) => finite(op, arg, value));
  let [m, n] = byDefault;
  if (segments !== undefined) {
    const given = numbers(op, "segments", segments, "maxPoints", 2);
    if (given.length !== 2) throw wrongLength(op, "segments", given.length, "2");
    [m, n] = [integer(op, "segments", given[0], 0, 0xffff), integer(op, "segments", given[1], 0, 0xffff)];
  }
  return derived(call(op, (kernel) => kernel.surface_shape(which, a, b, c, m, n), a));
}

function three(name: string, arg: string, value: unknown): [string, unknown][] {
  const op = `${NAME}.${name}`;
  const given = numbers(op, arg, value, "maxPoints", 3);
  if (given.length !== 3) throw wrongLength(op, arg, given.length, "3");
  return Array.from(given, (number) => [arg, number]);
}

/** A net's numbers: finite, within ±1e9, as many as there should be. */
function netOf(op: string, value: unknown, needed: number): Floats {
  const net = isFloat64Array(value) && lengthOfArray(op, "net", value) !== needed ? value : numbers(op, "net", value, "maxSurfacePoints", 3 * MAX_NET);
  if (net.length !== needed) throw wrongLength(op, "net", net.length, String(needed));
  return within(op, "net", net as Floats);
}

function directionOf(op: string, arg: string, value: unknown): DirectionData {
  if (value === undefined) throw wrong("E_TYPE", op, arg, value, "an object");
  const { roots, count, closed, level } = checkOptions(op, value, ["roots", "count", "closed", "level"]);
  return {
    roots: rootNumbers(op, roots, `${arg}.roots`),
    count: checkCount(op, `${arg}.count`, count, 0, "maxSurfacePoints", MAX_NET),
    closed: flag(op, `${arg}.closed`, closed, true),
    level: level === undefined ? 0 : integer(op, `${arg}.level`, level, 0, MAX_LEVEL),
  };
}

function patchOf(op: string, value: unknown, i: number): PatchData {
  const arg = `patches[${i}]`;
  const { u, v, displacements } = checkOptions(op, value, ["u", "v", "displacements"], arg);
  const windowOf = (name: string, given: unknown): PatchWindow => {
    const { level, first, count } = checkOptions(op, given, ["level", "first", "count"], `${arg}.${name}`);
    return {
      level: integer(op, `${arg}.${name}.level`, level, 1, MAX_LEVEL),
      first: integer(op, `${arg}.${name}.first`, first, 0, MAX_NET),
      count: integer(op, `${arg}.${name}.count`, count, 1, MAX_NET),
    };
  };
  const windows = { u: windowOf("u", u), v: windowOf("v", v) };
  const given = numbers(op, `${arg}.displacements`, displacements, "maxSurfacePoints", 3 * MAX_NET);
  const needed = 3 * windows.u.count * windows.v.count;
  if (given.length !== needed) throw wrongLength(op, `${arg}.displacements`, given.length, String(needed));
  given.forEach((number, k) => {
    if (!(Math.abs(number) <= 2 * LARGEST)) throw wrong("E_NOT_FINITE", op, `${arg}.displacements`, number, "|x| <= 2e9", k);
  });
  return { ...windows, displacements: given };
}

/** The arrays of a surface that a caller or a file describes, checked. @internal */
export function checkedSurface(op: string, options: unknown): SurfaceData {
  const own = checkOptions(op, options, ["net", "u", "v", "patches"]);
  const [u, v] = [directionOf(op, "u", own.u), directionOf(op, "v", own.v)];
  const points = u.count * v.count;
  if (points > MAX_NET) throw overLimit(op, "rows", "maxSurfacePoints", MAX_NET, points);
  const net = netOf(op, own.net, 3 * points);
  const patches = own.patches ?? [];
  if (!Array.isArray(patches)) throw wrong("E_TYPE", op, "patches", patches, "an array");
  if (patches.length > 4096) throw overLimit(op, "patches", "maxPatches", 4096, patches.length);
  // Array.from looks at holes, too.
  const list = Array.from(patches as unknown[], (patch, i) => patchOf(op, patch, i));
  const data = new SurfaceData(net, u, v, list);
  data.load(op);
  return data;
}

function fileOptions(op: string, options: unknown): { rows: number; cols: number; name: string } {
  const { rows = 64, cols = 64, name = "surface" } = checkOptions(op, options, ["rows", "cols", "name"]);
  if (typeof name !== "string") throw wrong("E_TYPE", op, "name", name, "string");
  const [m, n] = sizes(op, rows, cols);
  return { rows: m, cols: n, name: name.replace(/[^\p{L}\p{N} ._-]/gu, "_").slice(0, 200) };
}
