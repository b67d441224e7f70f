import { ExplineError, TensorSurface } from "expline/slim";
import { emptySurface, type NetPoint, type NetRef, type Root, type SurfaceDocument } from "../../document/surface/surface.ts";

/** The library's surface of a document, and documents of the library's surfaces. */

const surfaces = new WeakMap<SurfaceDocument, TensorSurface>();

/**
 * The surface, or null: while no sample has been opened, and for a net of which the library makes none. Whoever hears
 * of one before its sample has taken its place may ask for it all the same.
 */
export function surfaceOf(document: SurfaceDocument): TensorSurface | null {
  try {
    return madeSurface(document);
  } catch (error) {
    if (error instanceof ExplineError) return null;
    throw error;
  }
}

/** The same; throws `ExplineError` when the library refuses it. */
export function madeSurface(document: SurfaceDocument): TensorSurface | null {
  const { u, v } = document;
  if (u === undefined || v === undefined) return null;
  const known = surfaces.get(document);
  if (known !== undefined) return known;
  const surface = new TensorSurface({
    net: netArray(document),
    u: { ...u, level: document.levelU },
    v: { ...v, level: document.levelV },
    patches: (document.details ?? []).map((detail) => ({ ...detail, displacements: Float64Array.from(detail.displacements) })),
  });
  surfaces.set(document, surface);
  return surface;
}

function netArray({ net }: SurfaceDocument): Float64Array {
  const flat = new Float64Array(3 * net.length);
  net.forEach(({ x, y, z }, i) => flat.set([x, y, z], 3 * i));
  return flat;
}

/** What a library surface is as a document. */
export function documentOf(sample: string, surface: TensorSurface): SurfaceDocument {
  const [u, v] = [surface.u, surface.v];
  const flat = surface.net;
  const net: NetPoint[] = Array.from({ length: flat.length / 3 }, (_, i) => ({
    u: Math.floor(i / v.count),
    v: i % v.count,
    // + 0: a formula's −0 would not survive being written down.
    x: (flat[3 * i] ?? 0) + 0,
    y: (flat[3 * i + 1] ?? 0) + 0,
    z: (flat[3 * i + 2] ?? 0) + 0,
  }));
  const details = surface.patches.map((patch) => ({ u: patch.u, v: patch.v, displacements: Array.from(patch.displacements, (value) => value + 0) }));
  const document: SurfaceDocument = {
    sample, net,
    levelU: u.level ?? 0,
    levelV: v.level ?? 0,
    support: [supportOf(u), supportOf(v)],
    patches: segmentsOf(u) * segmentsOf(v),
    u: { roots: plainRoots(u.roots), count: u.count, closed: u.closed },
    v: { roots: plainRoots(v.roots), count: v.count, closed: v.closed },
    ...(details.length === 0 ? {} : { details }),
  };
  surfaces.set(document, surface);
  return document;
}

type Axis = TensorSurface["u"];

/** The library writes real roots as numbers. */
function plainRoots(roots: Axis["roots"]): Root[] {
  return roots.map((root) => (typeof root === "number" ? { re: root + 0, im: 0 } : { re: root.re + 0, im: root.im + 0 }));
}

/** Segments to each side that one point reaches: of the compact interpolator at level 0, of the B-spline above it. */
function supportOf({ roots, level = 0 }: Axis): number {
  return level === 0 ? roots.length - 1 : Math.ceil(roots.length / 2);
}

/** Segments of the grid that the net is on. */
function segmentsOf({ roots, count, closed, level = 0 }: Axis): number {
  if (closed) return count;
  return level === 0 ? count - (2 * roots.length - 3) : count - roots.length + 1;
}

export type SurfaceSampleId = "surf-sphere" | "surf-torus" | "surf-roman" | "surf-paraboloid" | "surf-cylinder" | "surf-character";

const makers: Readonly<Record<SurfaceSampleId, () => TensorSurface>> = {
  "surf-sphere": () => TensorSurface.sphere(1, [8, 6]),
  "surf-torus": () => TensorSurface.torus(1, 0.4, [8, 8]),
  "surf-roman": () => TensorSurface.romanSurface(1.6, [8, 8]),
  "surf-paraboloid": () => TensorSurface.hyperbolicParaboloid(1, 1, 0.6),
  "surf-cylinder": () => TensorSurface.cylinder(0.7, 1.8, [8, 4]),
  "surf-character": () => TensorSurface.character(),
};

const opened = new Map<string, SurfaceDocument>();

/** A sample's surface; null for a name that is none. */
export function surfaceSample(id: string): SurfaceDocument | null {
  const known = opened.get(id);
  if (known !== undefined) return known;
  if (!Object.hasOwn(makers, id)) return null;
  const document = documentOf(id, makers[id as SurfaceSampleId]());
  opened.set(id, document);
  return document;
}

/** Whether it is still the sample that it began as, at whatever level. */
export function isSample(document: SurfaceDocument): boolean {
  return opened.get(document.sample) === document || untouched.has(document);
}

/** Refined samples: they have the shape that they are named after. */
const untouched = new WeakSet<SurfaceDocument>();

/** Says that a document has the shape of its sample on another net. */
export function markSample(document: SurfaceDocument): void {
  untouched.add(document);
}

/** The document with its sample opened, if it only names one. */
export function openedSurface(document: SurfaceDocument): SurfaceDocument {
  if (document.net.length > 0) return document;
  return surfaceSample(document.sample) ?? surfaceSample(emptySurface.sample) ?? document;
}

/** Which surface another one was made of by moving points, and which points. It is not kept alive for this. */
const moves = new WeakMap<SurfaceDocument, { readonly from: WeakRef<SurfaceDocument>; readonly points: readonly NetRef[] }>();

/** What a surface was before some of its points were moved; null where nothing is known. */
export function beforeMove(document: SurfaceDocument): { readonly from: SurfaceDocument; readonly points: readonly NetRef[] } | null {
  const move = moves.get(document);
  const from = move?.from.deref();
  return move === undefined || from === undefined ? null : { from, points: move.points };
}

/** The same surface with points moved to new places. Poles stay smooth: what hangs together moves together. */
export function withNetPoints(document: SurfaceDocument, places: readonly (NetRef & { readonly x: number; readonly y: number; readonly z: number })[]): SurfaceDocument {
  const now = surfaceOf(document);
  if (now === null) return document;
  // Setting a point changes a surface of the library: the one of the document stays as it is.
  const surface = new TensorSurface({ net: now.net, u: now.u, v: now.v, patches: now.patches });
  for (const { u, v, detail, x, y, z } of places) {
    if (detail === undefined) surface.setPoint(u, v, x, y, z);
    else surface.setPatchPoint(detail, u, v, x, y, z);
  }
  const next = documentOf(document.sample, surface);
  moves.set(next, { from: new WeakRef(document), points: places });
  return next;
}

/** The nearest surface on a net that is coarser by so many levels. */
export function reducedSurface(document: SurfaceDocument, byU: number, byV: number): SurfaceDocument {
  const surface = surfaceOf(document);
  if (surface === null || (byU === 0 && byV === 0)) return document;
  return documentOf(document.sample, surface.reduce(byU, byV).surface);
}

/** The same shape on a net that is finer by so many levels. */
export function refinedSurface(document: SurfaceDocument, byU: number, byV: number): SurfaceDocument {
  const surface = surfaceOf(document);
  if (surface === null || (byU === 0 && byV === 0)) return document;
  const finer = documentOf(document.sample, surface.refine(byU, byV));
  if (isSample(document)) untouched.add(finer);
  return finer;
}

/** `rows` × `cols` points on a uniform parameter grid: closed i / rows of the way round, open i / (rows − 1). */
export function meshPoints(document: SurfaceDocument, rows: number, cols: number): Float64Array {
  return surfaceOf(openedSurface(document))?.mesh(rows, cols).positions ?? new Float64Array(0);
}

/** Finer control points around a place, none elsewhere; the shape stays. */
export function refinedHere(document: SurfaceDocument, { parameter: [u, v] }: { readonly parameter: readonly [number, number] }): SurfaceDocument {
  const surface = surfaceOf(document);
  if (surface === null) return document;
  const [fromU, toU] = surface.domain.u;
  const [fromV, toV] = surface.domain.v;
  const finer = documentOf(document.sample, surface.refineAt(Math.max(fromU, Math.min(toU, u)), Math.max(fromV, Math.min(toV, v)), { levels: 1 }));
  if (isSample(document)) markSample(finer);
  return finer;
}
