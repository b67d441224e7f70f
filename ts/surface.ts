/** Surfaces: a net of points, smooth in both directions, exact for quadrics. */
import {
  LARGEST,
  type MatrixLike,
  type OwnBytes,
  affine,
  coordinate,
  finite,
  integer,
  patchNumber,
  options as checkOptions,
  overLimit,
  rootList,
  wrong,
} from "./core.js";
import { type MeshFileOptions, fileOptions, gltfOf, objOf } from "./surface/mesh-files.js";
import { type Direction, MAX_LEVEL, type SurfacePatch, type TensorSurfaceOptions, checkedSurface, netOf, place } from "./surface/surface-arguments.js";
import { type DirectionData, NAME, type PatchData, SurfaceData, readSurface } from "./surface/surface-data.js";
import { copy, peek, result } from "./surface/surface-engine.js";
import { type TensorSurfaceJSON, surfaceJSON } from "./surface/surface-json.js";
import { type MeshRegion, type SurfaceMesh, curvatures, mend, newMesh, refill, sizes } from "./surface/surface-mesh.js";
import { halves, pairwise } from "./surface/surface-places.js";
import { shape, three } from "./surface/surface-shapes.js";

export type { MeshFileOptions } from "./surface/mesh-files.js";
export type { Direction, SurfacePatch, TensorSurfaceOptions } from "./surface/surface-arguments.js";
export type { PatchWindow } from "./surface/surface-data.js";
export { initSurface, initSurfaceSync } from "./surface/surface-engine.js";
export type { DirectionJSON, TensorSurfaceJSON } from "./surface/surface-json.js";
export type { MeshRegion, SurfaceMesh } from "./surface/surface-mesh.js";
/** @internal */
export { checkedSurface } from "./surface/surface-arguments.js";

/** The most vertices of a text: about 250 MB, half of what engines allow. */
const MAX_WRITTEN = 1_000_000;

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
 * A closed direction of `count` points is periodic on [0, count], an open one lives on [0, count − (2·n₀ − 3)], with
 * row n₀ − 2 at 0. Refined directions keep the parameter. Moving a point changes the surface within n₀ − 1 units of it
 * and nowhere else.
 */
export class TensorSurface {
  /** Bundles shorten names: this one is what a console shows. @internal */
  static readonly name = NAME;

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

  /**
   * A sphere about the origin: u runs round, v from the south pole (0, 0, −radius) to the north pole. `segments`: units
   * in u and v, at least 3 and 2, at most 1024, by default [8, 4].
   *
   * @throws {ExplineError} E_RANGE of a `radius` that is not above 0, and of `segments`; as do all shapes here.
   * @example
   * ```js
   * const { positions, normals, indices } = TensorSurface.sphere(5).mesh(64, 33);
   * console.log(positions.length, normals.length, indices.length % 3); // → 6336 6336 0
   * ```
   */
  static sphere(radius: number, segments?: readonly [number, number]): TensorSurface {
    return surfaceOf(shape("sphere", 0, [["radius", radius]], segments, [8, 4]));
  }

  /**
   * An ellipsoid about the origin with its half axes along x, y and z, otherwise as {@link TensorSurface.sphere}, also
   * in `segments`.
   */
  static ellipsoid(radii: readonly [number, number, number] | Float32Array | Float64Array, segments?: readonly [number, number]): TensorSurface {
    return surfaceOf(shape("ellipsoid", 1, three("ellipsoid", "radii", radii), segments, [8, 4]));
  }

  /**
   * A torus about the z axis: u runs round the axis at distance `radius`, v round the tube, of radius `tube`; both
   * above 0. `segments` at least 3, by default [8, 6].
   */
  static torus(radius: number, tube: number, segments?: readonly [number, number]): TensorSurface {
    return surfaceOf(shape("torus", 2, [["radius", radius], ["tube", tube]], segments, [8, 6]));
  }

  /**
   * A cylinder about the z axis, without lids, from z = −height/2 to height/2. `segments` at least 3 and 1, by default
   * [8, 2].
   */
  static cylinder(radius: number, height: number, segments?: readonly [number, number]): TensorSurface {
    return surfaceOf(shape("cylinder", 3, [["radius", radius], ["height", height]], segments, [8, 2]));
  }

  /**
   * Steiner's Roman surface ½r²(cos a·sin 2b, sin a·sin 2b, sin 2a·cos² b), covered four times. `segments` at least 5,
   * by default [5, 5].
   */
  static romanSurface(r: number, segments?: readonly [number, number]): TensorSurface {
    return surfaceOf(shape("romanSurface", 4, [["r", r]], segments, [5, 5]));
  }

  /**
   * A piece of x²/a² − y²/b² = z/h: (a·p·cosh q, b·p·sinh q, h·p²) for p and q from −1 to 1. `segments` at least 1, by
   * default [6, 6].
   */
  static hyperbolicParaboloid(a: number, b: number, h: number, segments?: readonly [number, number]): TensorSurface {
    return surfaceOf(shape("hyperbolicParaboloid", 5, [["a", a], ["b", b], ["h", h]], segments, [6, 6]));
  }

  /** A duckling, about 2 high: a modelled shape of 12 × 11 points, twice continuously differentiable. */
  static character(): TensorSurface {
    return surfaceOf(shape("character", 6, [], undefined, [0, 0]));
  }

  /** A surface is no plain object, as a curve is none. @internal */
  get [Symbol.toStringTag](): string {
    return NAME;
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
    data.net.set(netOf("net", value, data.net.length));
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
   *
   * @throws {ExplineError} E_RANGE of parameters outside the domain of an open direction, and of `du` or `dv` outside 0
   *   to 8; E_LENGTH where `u` and `v` are not as many.
   */
  evaluate(u: number | Float64Array | readonly number[], v: number | Float64Array | readonly number[], du = 0, dv = 0): Float64Array {
    const op = "evaluate";
    const orders = [integer(op, "du", du, 0, 8), integer(op, "dv", dv, 0, 8)] as const;
    return pairwise(dataOf(this, op), op, u, v, (kernel, slot, count) => kernel.surface_evaluate(slot, count, ...orders));
  }

  /** Unit normals ∂u × ∂v at pairs of parameters: at poles their limit, 0, 0, 0 where the surface has none. */
  normal(u: number | Float64Array | readonly number[], v: number | Float64Array | readonly number[]): Float64Array {
    const op = "normal";
    return pairwise(dataOf(this, op), op, u, v, (kernel, slot, count) => kernel.surface_evaluate(slot, count, 255, 0));
  }

  /**
   * Gaussian curvature, in 1 per unit squared, and mean curvature, in 1 per unit, with respect to the normal (negative
   * on a sphere), at pairs of parameters.
   */
  curvature(
    u: number | Float64Array | readonly number[],
    v: number | Float64Array | readonly number[],
  ): { gaussian: Float64Array; mean: Float64Array } {
    const op = "curvature";
    return halves(pairwise(dataOf(this, op), op, u, v, (kernel, slot, count) => kernel.surface_curvature(slot, count)));
  }

  /**
   * Triangles between `rows` × `cols` vertices, uniform in u and v: at i/rows of a closed direction, at i/(rows − 1) of
   * an open one.
   *
   * The triangles depend on `rows`, `cols` and on what is closed, not on the net. With `out`, a mesh of the same size
   * is filled again, whether it holds Float64Arrays or Float32Arrays; its triangles are left as they are.
   *
   * @throws {ExplineError} E_RANGE of `rows` or `cols` below 2, E_LIMIT where they are more than 4,000,000 vertices;
   *   E_LENGTH of an `out` of another size.
   */
  mesh(rows: number, cols: number): SurfaceMesh & { positions: Float64Array; normals: Float64Array };
  /**
   * Fills a mesh of the same size again, whether it holds Float64Arrays or Float32Arrays; its triangles are left as
   * they are.
   */
  mesh<M extends SurfaceMesh>(rows: number, cols: number, options: { out: M }): M;
  /** Fills `out` where there is one, and else makes a mesh. */
  mesh(rows: number, cols: number, options: { out?: SurfaceMesh | undefined } | undefined): SurfaceMesh;
  mesh(rows: number, cols: number, options?: { out?: SurfaceMesh | undefined }): SurfaceMesh {
    const op = "mesh";
    const data = dataOf(this, op);
    const { out } = checkOptions(op, options, ["out"]);
    const grid = sizes(op, rows, cols);
    return out === undefined ? newMesh(op, data.resident(op), grid) : refill(op, data, grid, out);
  }

  /**
   * Computes the part of a mesh again that net point (i, j), or control point (i, j) of a patch, touches: to the last
   * bit what `mesh` would give. Returns which part.
   *
   * @throws {ExplineError} E_RANGE of an `i` or `j` that the net, or the patch, has not; E_TYPE for what is no mesh,
   *   E_LENGTH for one of the wrong size.
   */
  remesh(mesh: SurfaceMesh, i: number, j: number, patch?: number): MeshRegion {
    const op = "remesh";
    const data = dataOf(this, op);
    const which = patch === undefined ? -1 : patchNumber(op, "patch", patch, data.patches.length);
    const { u, v } = which < 0 ? data : (data.patches[which] as PatchData);
    const [row, col] = place(op, i, j, u.count, v.count);
    return mend(op, data, mesh, which, row, col);
  }

  /** Gaussian and mean curvature at the vertices of `mesh(rows, cols)`. */
  meshCurvature(rows: number, cols: number): { gaussian: Float64Array; mean: Float64Array } {
    const op = "meshCurvature";
    const data = dataOf(this, op);
    const grid = sizes(op, rows, cols);
    return curvatures(op, data.resident(op), grid);
  }

  /**
   * The same surface with a finer net: 2^levelsU times the points in u, 2^levelsV times in v.
   *
   * A refined direction holds control points near the surface; what is closed stays closed, and the parameter stays.
   *
   * @throws {ExplineError} E_RANGE of levels outside 0 to 12; E_LIMIT where a direction's would be above 12, or the net
   *   have more than 4,194,304 points.
   */
  refine(levelsU: number, levelsV: number): TensorSurface {
    const op = "refine";
    const data = dataOf(this, op);
    const levels = [integer(op, "levelsU", levelsU, 0, MAX_LEVEL), integer(op, "levelsV", levelsV, 0, MAX_LEVEL)] as const;
    return derived(data.ask(op, (kernel, slot) => kernel.surface_refine(slot, ...levels)));
  }

  /**
   * The nearest surface whose net is coarser by 2^levelsU and 2^levelsV, and `maxError`, the largest distance from this
   * one, parameter by parameter, to about 1e-4 of itself. What was refined and not changed comes back; level 0 goes
   * through its points again.
   *
   * @throws {ExplineError} E_RANGE of more levels than the direction has.
   */
  reduce(levelsU: number, levelsV: number): { surface: TensorSurface; maxError: number } {
    const op = "reduce";
    const data = dataOf(this, op);
    const levels = [integer(op, "levelsU", levelsU, 0, data.u.level), integer(op, "levelsV", levelsV, 0, data.v.level)] as const;
    const count = data.ask(op, (kernel, slot) => kernel.surface_reduce(slot, ...levels));
    return { maxError: result(4), surface: derived(count) };
  }

  /**
   * The same surface, to the last bit, with a patch of finer control points around (u, v): `levels` (default 1)
   * doublings beyond the net's, all within `reach` units (default 1) in each direction. The rest of the net stays as it
   * is; its points take the detail along.
   *
   * @throws {ExplineError} E_RANGE of `u` or `v` outside an open direction, of `levels` outside 1 to 12, of `reach`
   *   outside 0 to 1e6; E_LIMIT where a direction's level would be above 12, or the patch have more than 4,194,304
   *   points; E_DEGENERATE of a `reach` within which there is no control point.
   */
  refineAt(
    u: number,
    v: number,
    options?: { levels?: number | undefined; reach?: number | undefined },
  ): TensorSurface {
    const op = "refineAt";
    const data = dataOf(this, op);
    const { levels = 1, reach = 1 } = checkOptions(op, options, ["levels", "reach"]);
    const at = [finite(op, "u", u), finite(op, "v", v)] as const;
    const how = [integer(op, "levels", levels, 1, MAX_LEVEL), finite(op, "reach", reach)] as const;
    return derived(data.ask(op, (kernel, slot) => kernel.surface_refine_at(slot, ...at, ...how)));
  }

  /**
   * The control points of a patch, three numbers each, v fastest.
   *
   * @throws {ExplineError} E_RANGE of a `patch` that there is not.
   */
  patchPoints(patch: number): Float64Array {
    const op = "patchPoints";
    const data = dataOf(this, op);
    const which = patchNumber(op, "patch", patch, data.patches.length);
    return copy(data.ask(op, (kernel, slot) => kernel.surface_patch_points(slot, which)));
  }

  /**
   * Moves net point (i, j).
   *
   * A smooth pole, where a whole row is one point, stays smooth: that row moves as one, and the rows beyond follow
   * those inside.
   *
   * @throws {ExplineError} E_RANGE of an `i` or `j` that the net has not, and of coordinates beyond ±1e9; nothing has
   *   moved then.
   */
  setPoint(i: number, j: number, x: number, y: number, z: number): void {
    const op = "setPoint";
    const data = dataOf(this, op);
    const [row, col] = place(op, i, j, data.u.count, data.v.count);
    const to = [coordinate(op, "x", x), coordinate(op, "y", y), coordinate(op, "z", z)] as const;
    const count = data.ask(op, (kernel, slot) => kernel.surface_set_point(slot, row, col, ...to));
    if (count > 0) data.net.set(peek(count));
    else data.net.set(to, 3 * (row * data.v.count + col));
    data.touchBoth();
  }

  /**
   * Moves control point (i, j) of a patch, counted within it.
   *
   * @throws {ExplineError} as {@link TensorSurface.setPoint} does, and E_RANGE of a `patch` that there is not.
   */
  setPatchPoint(patch: number, i: number, j: number, x: number, y: number, z: number): void {
    const op = "setPatchPoint";
    const data = dataOf(this, op);
    const which = patchNumber(op, "patch", patch, data.patches.length);
    const { u, v, displacements } = data.patches[which] as PatchData;
    const [row, col] = place(op, i, j, u.count, v.count);
    const to = [coordinate(op, "x", x), coordinate(op, "y", y), coordinate(op, "z", z)] as const;
    data.ask(op, (kernel, slot) => kernel.surface_set_patch_point(slot, which, row, col, ...to));
    displacements.set([result(0), result(1), result(2)], 3 * (row * v.count + col));
    data.touchBoth();
  }

  /**
   * The image under the affine map of a 4 × 4 matrix, 16 numbers column by column, as three.js has them in
   * `Matrix4.elements`; the last row is 0, 0, 0, 1. Exact to rounding; patches come along. Where the matrix reflects,
   * normals point to the other side.
   *
   * @throws {ExplineError} E_DEGENERATE of `matrix` for a translation where 0 is not among the roots of both
   *   directions: no net makes the image then.
   */
  transform(matrix: MatrixLike): TensorSurface {
    const op = "transform";
    const { net, u, v, patches, end, first } = dataOf(this, op);
    const image = affine(op, matrix, 3, u.roots, v.roots);
    const moved = patches.map((patch) => ({ ...patch, displacements: image(patch.displacements, 2 * LARGEST, 0) }));
    return surfaceOf(Object.assign(new SurfaceData(image(net), u, v, moved), { end, first }));
  }

  /**
   * A mesh as a Wavefront OBJ file, with normals. `rows` and `cols` default to 64, `name` to "surface".
   *
   * @throws {ExplineError} as {@link TensorSurface.mesh} does; E_LIMIT with `limit` "maxWrittenVertices" above
   *   1,000,000 vertices.
   */
  toObj(options?: MeshFileOptions): string {
    const op = "toObj";
    const { rows, cols, name } = fileOptions(op, options);
    if (rows * cols > MAX_WRITTEN) throw overLimit(op, "rows", "maxWrittenVertices", MAX_WRITTEN, rows * cols);
    return objOf(this.mesh(rows, cols), name);
  }

  /**
   * A mesh as a binary glTF 2.0 file (.glb), complete in itself. `rows` and `cols` default to 64, `name` to "surface".
   */
  toGltf(options?: MeshFileOptions): OwnBytes {
    const { rows, cols, name } = fileOptions("toGltf", options);
    return gltfOf(this.mesh(rows, cols), name);
  }

  /**
   * The surface as plain data, for files and for `postMessage`, which takes no surface; `fromJSON` is the inverse to
   * the last bit.
   */
  toJSON(): TensorSurfaceJSON {
    return surfaceJSON(dataOf(this, "toJSON"));
  }
}

function described(direction: DirectionData): Required<Direction> {
  return { ...direction, roots: rootList(direction.roots) };
}
