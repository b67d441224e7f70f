import type { SurfaceMesh as LibraryMesh, TensorSurface } from "expline/slim";
import type { NetDirection, NetRef, SurfaceDocument } from "../../document/surface/surface.ts";
import { beforeMove, surfaceOf } from "./surface.ts";

/** Surfaces as triangles, and what is known about the points of a net. */

/**
 * Rows and columns of vertices; a closed direction has its first row again at the end, so that parameters run on over
 * the seam.
 */
export interface SurfaceMesh {
  readonly rows: number;
  readonly cols: number;
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  /** Parameters of every vertex, in units of level 0. */
  readonly parameters: Float32Array;
  /** Gaussian curvature, only if it was asked for. */
  readonly curvature: Float32Array | null;
  /** Of the parameters. */
  readonly size: readonly [number, number];
}

/** More would stop a phone; a net of 32 × 32 then has 15 sides a patch. */
const mostVertices = 240_000;

/** Vertices of one direction so that `sides` fall on a segment of level 0. */
function verticesOf(length: number, sides: number): number {
  return Math.max(3, Math.round(length * sides) + 1);
}

interface Made {
  readonly sides: number;
  /** As the library makes it: no row and no column twice. */
  readonly own: LibraryMesh;
  readonly mesh: SurfaceMesh;
}

const meshes = new WeakMap<SurfaceDocument, Made>();

export function meshOf(document: SurfaceDocument, sides: number, withCurvature: boolean): SurfaceMesh | null {
  const known = meshes.get(document);
  if (known !== undefined && known.sides === sides && (!withCurvature || known.mesh.curvature !== null)) return known.mesh;
  const made = makeMesh(document, sides, withCurvature);
  if (made !== null) meshes.set(document, made);
  return made?.mesh ?? null;
}

/** How many triangles `meshOf` makes of a surface; none where it makes no mesh. */
export function trianglesOf(document: SurfaceDocument, sides: number): number {
  const surface = surfaceOf(document);
  if (surface === null) return 0;
  const { rows, cols } = gridOf(surface, sides);
  return 2 * (rows - 1) * (cols - 1);
}

function gridOf({ domain: { u, v } }: TensorSurface, sides: number): Pick<SurfaceMesh, "size" | "rows" | "cols"> {
  const size = [u[1] - u[0], v[1] - v[0]] as const;
  const wanted = verticesOf(size[0], sides) * verticesOf(size[1], sides);
  const scale = Math.min(1, Math.sqrt(mostVertices / wanted));
  return { size, rows: verticesOf(size[0], sides * scale), cols: verticesOf(size[1], sides * scale) };
}

function makeMesh(document: SurfaceDocument, sides: number, withCurvature: boolean): Made | null {
  const surface = surfaceOf(document);
  if (surface === null) return null;
  const { size, rows, cols } = gridOf(surface, sides);
  const { u, v } = surface;
  const [ownRows, ownCols] = [u.closed ? rows - 1 : rows, v.closed ? cols - 1 : cols];
  const own = movedMesh(document, sides) ?? surface.mesh(ownRows, ownCols);
  const spread = (from: Float64Array | Float32Array, width: number): Float32Array => {
    const to = new Float32Array(width * rows * cols);
    for (let i = 0; i < rows; i += 1) {
      const start = width * ownCols * (i % ownRows);
      to.set(from.subarray(start, start + width * ownCols), width * cols * i);
      if (cols > ownCols) to.set(from.subarray(start, start + width), width * (cols * i + ownCols));
    }
    return to;
  };
  const parameters = parametersOf(rows, cols, size);
  const curvature = withCurvature ? spread(curvatures(document, parameters, [rows, cols], [ownRows, ownCols]), 1) : null;
  return { sides, own, mesh: { rows, cols, size, parameters, curvature, positions: spread(own.positions, 3), normals: spread(own.normals, 3) } };
}

/** More points than this move most of a surface. */
const mostRemeshed = 8;

/** While points are dragged: the mesh before, and anew only what they touch of it. */
function movedMesh(document: SurfaceDocument, sides: number): LibraryMesh | null {
  const move = beforeMove(document);
  const surface = surfaceOf(document);
  const before = move === null ? undefined : meshes.get(move.from);
  if (move === null || surface === null || before === undefined || before.sides !== sides || move.points.length > mostRemeshed) return null;
  const mesh = { ...before.own, positions: before.own.positions.slice(), normals: before.own.normals.slice() };
  for (const { u, v, detail } of move.points) surface.remesh(mesh, u, v, detail);
  return mesh;
}

let lastParameters: Pick<SurfaceMesh, "rows" | "cols" | "size" | "parameters"> | null = null;

/** The same array as before for the same grid: nothing then has to go to the graphics card again. */
function parametersOf(rows: number, cols: number, size: readonly [number, number]): Float32Array {
  const last = lastParameters;
  if (last !== null && last.rows === rows && last.cols === cols && last.size[0] === size[0] && last.size[1] === size[1]) return last.parameters;
  const parameters = new Float32Array(2 * rows * cols);
  for (let i = 0; i < rows; i += 1) {
    for (let j = 0; j < cols; j += 1) parameters.set([(size[0] * i) / (rows - 1), (size[1] * j) / (cols - 1)], 2 * (i * cols + j));
  }
  lastParameters = { rows, cols, size, parameters };
  return parameters;
}

/** Gaussian curvature at the vertices that are not repeated. */
function curvatures(document: SurfaceDocument, parameters: Float32Array, [, cols]: readonly [number, number], [rows, own]: readonly [number, number]): Float64Array {
  const surface = surfaceOf(document);
  const [u, v] = [new Float64Array(rows * own), new Float64Array(rows * own)];
  if (surface === null) return u;
  const [endU, endV] = [surface.domain.u[1], surface.domain.v[1]];
  for (let i = 0; i < rows; i += 1) {
    for (let j = 0; j < own; j += 1) {
      u[i * own + j] = Math.min(endU, parameters[2 * (i * cols + j)] ?? 0);
      v[i * own + j] = Math.min(endV, parameters[2 * (i * cols + j) + 1] ?? 0);
    }
  }
  return surface.curvature(u, v).gaussian;
}

/** The triangles of a grid, two to a cell. */
export function triangles(rows: number, cols: number): Uint32Array {
  const indices = new Uint32Array(6 * (rows - 1) * (cols - 1));
  let at = 0;
  for (let i = 0; i + 1 < rows; i += 1) {
    for (let j = 0; j + 1 < cols; j += 1) {
      const a = i * cols + j;
      indices.set([a, a + cols, a + 1, a + 1, a + cols, a + cols + 1], at);
      at += 6;
    }
  }
  return indices;
}

/** A point of the net as it is shown: where it is, and how the surface looks there. */
export interface ShownPoint {
  readonly ref: NetRef;
  readonly at: readonly [number, number, number];
  readonly normal: readonly [number, number, number];
  /** Its parameter, in units of level 0; an open direction's outermost ones lie outside the surface. */
  readonly parameter: readonly [number, number];
  /** On the surface, and not merely near it. */
  readonly on: boolean;
  /** Beyond an open end: it shapes the surface only near the edge. */
  readonly beyond?: boolean;
}

/** The parameter of row `i`. */
function parameterOf({ roots, closed }: NetDirection, level: number, i: number): number {
  const order = roots.length;
  if (level === 0) return closed ? i : i - (order - 2);
  const step = 0.5 ** level;
  return (closed ? i + (order % 2 === 1 ? 0.5 : 0) : i + 1 - order / 2) * step;
}

const shownPoints = new WeakMap<SurfaceDocument, readonly ShownPoint[]>();

/** The points that can be taken hold of: not the mirrored rows behind a pole, and each pole once. */
export function netPoints(document: SurfaceDocument): readonly ShownPoint[] {
  const known = shownPoints.get(document);
  if (known !== undefined) return known;
  const fresh = [...basePoints(document), ...detailPoints(document)];
  shownPoints.set(document, fresh);
  return fresh;
}

function basePoints(document: SurfaceDocument): ShownPoint[] {
  const { u, v, levelU, levelV, net } = document;
  const surface = surfaceOf(document);
  if (u === undefined || v === undefined || surface === null) return [];
  const [polesU, polesV] = [polesOf(document, "u"), polesOf(document, "v")];
  const list = net.filter((point) => {
    const [a, b] = [parameterOf(u, levelU, point.u), parameterOf(v, levelV, point.v)];
    return isShown(a, surface.domain.u, polesU, point.v) && isShown(b, surface.domain.v, polesV, point.u);
  });
  const isWithin = (place: readonly [number, number] = [0, 0]): boolean =>
    (u.closed || inside(place[0], surface.domain.u)) && (v.closed || inside(place[1], surface.domain.v));
  const places = list.map((point) => [parameterOf(u, levelU, point.u), parameterOf(v, levelV, point.v)] as const);
  return withNormals(document, list.map((point, i) => ({
    ref: { u: point.u, v: point.v },
    at: [point.x, point.y, point.z] as const,
    parameter: places[i] ?? [0, 0],
    on: levelU === 0 && levelV === 0 && isWithin(places[i]),
    beyond: !isWithin(places[i]),
  })));
}

const hair = 1e-9;

function inside(value: number, [from, to]: readonly [number, number]): boolean {
  return value >= from - hair && value <= to + hair;
}

/** Which ends of an open direction are drawn together in one place. */
interface Poles {
  readonly start: boolean;
  readonly end: boolean;
}

function isShown(value: number, [from, to]: readonly [number, number], poles: Poles, around: number): boolean {
  if (poles.start && (value < from - hair || (value <= from + hair && around > 0))) return false;
  return !(poles.end && (value > to + hair || (value >= to - hair && around > 0)));
}

function polesOf(document: SurfaceDocument, which: "u" | "v"): Poles {
  const surface = surfaceOf(document);
  const own = document[which];
  const other = document[which === "u" ? "v" : "u"];
  if (surface === null || own === undefined || other === undefined || own.closed || !other.closed) return { start: false, end: false };
  const [from, to] = surface.domain[which];
  return { start: isPole(document, which, from), end: isPole(document, which, to) };
}

const around = 5;

/** Whether the surface has one place only all along an end. */
function isPole(document: SurfaceDocument, which: "u" | "v", end: number): boolean {
  const surface = surfaceOf(document);
  if (surface === null) return false;
  const [from, to] = surface.domain[which === "u" ? "v" : "u"];
  const along = Float64Array.from({ length: around }, (_, i) => from + ((to - from) * i) / around);
  const fixed = new Float64Array(around).fill(end);
  const places = which === "u" ? surface.evaluate(fixed, along) : surface.evaluate(along, fixed);
  let worst = 0;
  for (let i = 3; i < places.length; i += 1) worst = Math.max(worst, Math.abs((places[i] ?? 0) - (places[i % 3] ?? 0)));
  return worst < 1e-9;
}

function detailPoints(document: SurfaceDocument): ShownPoint[] {
  const { u, v } = document;
  const surface = surfaceOf(document);
  if (u === undefined || v === undefined || surface === null) return [];
  return (document.details ?? []).flatMap((detail, d) => {
    const points = surface.patchPoints(d);
    const list: Omit<ShownPoint, "normal">[] = [];
    for (let i = 0; i < detail.u.count; i += 1) {
      for (let j = 0; j < detail.v.count; j += 1) {
        const at = 3 * (i * detail.v.count + j);
        list.push({
          ref: { u: i, v: j, detail: d },
          at: [points[at] ?? 0, points[at + 1] ?? 0, points[at + 2] ?? 0],
          parameter: [parameterOf(u, detail.u.level, detail.u.first + i), parameterOf(v, detail.v.level, detail.v.first + j)],
          on: false,
        });
      }
    }
    return withNormals(document, list);
  });
}

function withNormals(document: SurfaceDocument, list: readonly Omit<ShownPoint, "normal">[]): ShownPoint[] {
  const surface = surfaceOf(document);
  if (surface === null) return [];
  const clamp = (value: number, [from, to]: readonly [number, number], closed: boolean): number =>
    closed ? from + ((((value - from) % (to - from)) + (to - from)) % (to - from)) : Math.max(from, Math.min(to, value));
  const u = Float64Array.from(list, (point) => clamp(point.parameter[0], surface.domain.u, surface.u.closed));
  const v = Float64Array.from(list, (point) => clamp(point.parameter[1], surface.domain.v, surface.v.closed));
  const normals = surface.normal(u, v);
  return list.map((point, i) => ({ ...point, normal: [normals[3 * i] ?? 0, normals[3 * i + 1] ?? 0, normals[3 * i + 2] ?? 0] }));
}

export interface Extent {
  readonly center: readonly [number, number, number];
  readonly radius: number;
}

const extents = new WeakMap<SurfaceDocument, Extent>();

/** A ball around the surface. */
export function extentOf(document: SurfaceDocument): Extent {
  const known = extents.get(document);
  if (known !== undefined) return known;
  const positions = surfaceOf(document)?.mesh(24, 24).positions ?? new Float64Array(0);
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  positions.forEach((value, i) => {
    least[i % 3] = Math.min(least[i % 3] ?? value, value);
    most[i % 3] = Math.max(most[i % 3] ?? value, value);
  });
  const middle = (k: number): number => (positions.length === 0 ? 0 : ((least[k] ?? 0) + (most[k] ?? 0)) / 2);
  const center = [middle(0), middle(1), middle(2)] as const;
  let radius = 0;
  for (let i = 0; i + 2 < positions.length; i += 3) {
    radius = Math.max(radius, Math.hypot((positions[i] ?? 0) - center[0], (positions[i + 1] ?? 0) - center[1], (positions[i + 2] ?? 0) - center[2]));
  }
  const extent = { center, radius: Math.max(radius, 1e-6) };
  extents.set(document, extent);
  return extent;
}
