import { TensorSurface } from "expline/slim";
import type { NetDirection, Root, SurfaceDocument } from "../../document/surface/surface.ts";
import { documentOf, isSample, markSample, reducedSurface, refinedSurface, surfaceOf } from "./surface.ts";

/**
 * Other nets for a surface: coarser, or with another number of points. Exact for shapes that the generators span;
 * measured for others.
 */

/** The number of points on the surface in a direction: what "net size" counts. */
export function netSize(document: SurfaceDocument): readonly [number, number] {
  const surface = surfaceOf(document);
  if (surface === null) return [0, 0];
  const size = ([from, to]: readonly [number, number], closed: boolean): number => Math.round(to - from) + (closed ? 0 : 1);
  return [size(surface.domain.u, surface.u.closed), size(surface.domain.v, surface.v.closed)];
}

interface Rows {
  /** Consecutive rows, each of points with three numbers. */
  readonly rows: readonly Float64Array[];
}

/** The surface at level 0 on so many points in each direction. */
export function resizedSurface(document: SurfaceDocument, sizeU: number, sizeV: number): SurfaceDocument {
  const surface = surfaceOf(document);
  const { u, v } = document;
  if (surface === null || u === undefined || v === undefined) return document;
  const [fineU, fineV] = [resized(u, surface.domain.u, sizeU), resized(v, surface.domain.v, sizeV)];
  const columns: Float64Array[] = fineU.parameters.map((at) => {
    const fixed = new Float64Array(fineV.parameters.length).fill(at);
    return surface.evaluate(fixed, Float64Array.from(fineV.parameters));
  });
  const along = columns.map((row) => flattened(extended(split(row), fineV)));
  const rows = extended({ rows: along }, fineU).rows;
  const direction = ({ roots, closed }: Resized, count: number): { roots: Root[]; count: number; closed: boolean } => ({ roots: [...roots], count, closed });
  const net = flattened({ rows });
  const next = documentOf(document.sample, new TensorSurface({
    net, u: direction(fineU, rows.length), v: direction(fineV, net.length / 3 / rows.length),
  }));
  if (isSample(document)) markSample(next);
  return next;
}

interface Resized {
  readonly roots: readonly Root[];
  readonly closed: boolean;
  /** Where the points on the surface stand, in the old units. */
  readonly parameters: readonly number[];
}

function resized({ roots, closed }: NetDirection, [from, to]: readonly [number, number], size: number): Resized {
  const segments = closed ? size : size - 1;
  const step = (to - from) / segments;
  const parameters = Array.from({ length: size }, (_, i) => (i === segments ? to : from + i * step));
  return { closed, parameters, roots: roots.map(({ re, im }) => ({ re: re * step, im: im * step })) };
}

function split(row: Float64Array): Rows {
  return { rows: Array.from({ length: row.length / 3 }, (_, i) => row.slice(3 * i, 3 * i + 3)) };
}

function flattened({ rows }: Rows): Float64Array {
  const width = rows[0]?.length ?? 0;
  const flat = new Float64Array(width * rows.length);
  rows.forEach((row, i) => flat.set(row, i * width));
  return flat;
}

/** An open direction needs rows beyond its ends: what the generators span goes on by its own recurrence. */
function extended({ rows }: Rows, { roots, closed }: Resized): Rows {
  if (closed) return { rows };
  const beyond = roots.length - 2;
  const factors = rows.length >= roots.length ? recurrence(roots) : [2, -1];
  const grown = [...rows];
  for (let k = 0; k < beyond; k += 1) grown.push(next(grown, factors));
  grown.reverse();
  for (let k = 0; k < beyond; k += 1) grown.push(next(grown, factors));
  return { rows: grown.reverse() };
}

function next(rows: readonly Float64Array[], factors: readonly number[]): Float64Array {
  const fresh = new Float64Array(rows[0]?.length ?? 0);
  factors.forEach((factor, j) => {
    const row = rows[rows.length - 1 - j];
    if (row !== undefined) for (let i = 0; i < fresh.length; i += 1) fresh[i] = (fresh[i] ?? 0) + factor * (row[i] ?? 0);
  });
  return fresh;
}

/**
 * c[k] from the values before it, for every sequence of exponentials with these roots: −p₁, −p₂, … of Π (1 − e^α z).
 */
export function recurrence(roots: readonly Root[]): number[] {
  let [re, im] = [[1], [0]];
  for (const root of roots) {
    const size = Math.exp(root.re);
    const [a, b] = [-size * Math.cos(root.im), -size * Math.sin(root.im)];
    const at = (list: readonly number[], k: number): number => list[k] ?? 0;
    const grown = Array.from({ length: re.length + 1 }, (_, k) => k);
    const [oldRe, oldIm] = [re, im];
    re = grown.map((k) => at(oldRe, k) + a * at(oldRe, k - 1) - b * at(oldIm, k - 1));
    im = grown.map((k) => at(oldIm, k) + a * at(oldIm, k - 1) + b * at(oldRe, k - 1));
  }
  return re.slice(1).map((value) => 0 - value);
}

/** What a document was refined from without having been edited since: the way back down is exact. */
const grownFrom = new WeakMap<SurfaceDocument, SurfaceDocument>();

/** The surface at other levels, and the largest distance that going there moves it. */
export function atLevels(document: SurfaceDocument, levelU: number, levelV: number): { document: SurfaceDocument; moved: number } {
  if (levelU === document.levelU && levelV === document.levelV) return { document, moved: 0 };
  const root = grownFrom.get(document) ?? document;
  if (levelU >= root.levelU && levelV >= root.levelV) {
    const [byU, byV] = [levelU - root.levelU, levelV - root.levelV];
    if (byU === 0 && byV === 0) return { document: root, moved: 0 };
    const finer = refinedSurface(root, byU, byV);
    grownFrom.set(finer, root);
    return { document: finer, moved: 0 };
  }
  const [downU, downV] = [Math.max(0, document.levelU - levelU), Math.max(0, document.levelV - levelV)];
  const reduced = reducedSurface(document, downU, downV);
  const next = refinedSurface(reduced, Math.max(0, levelU - reduced.levelU), Math.max(0, levelV - reduced.levelV));
  return { document: next, moved: largestDistance(document, next) };
}

const compared = 97;

/** At equal parameters, over both surfaces. */
export function largestDistance(a: SurfaceDocument, b: SurfaceDocument): number {
  const [from, to] = [surfaceOf(a)?.mesh(compared, compared).positions, surfaceOf(b)?.mesh(compared, compared).positions];
  let worst = 0;
  for (let i = 0; i + 2 < Math.min(from?.length ?? 0, to?.length ?? 0); i += 3) {
    const step = (k: number): number => (from?.[i + k] ?? 0) - (to?.[i + k] ?? 0);
    worst = Math.max(worst, Math.hypot(step(0), step(1), step(2)));
  }
  return worst;
}
