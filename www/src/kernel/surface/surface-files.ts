import type { SurfaceDocument } from "../../document/surface/surface.ts";
import { surfaceOf } from "./surface.ts";

/** A surface as files that other programs read. */

export interface MeshSize {
  readonly rows: number;
  readonly cols: number;
}

/** Vertices in each direction when a segment is cut into so many sides. */
export function meshSize(document: SurfaceDocument, sides: number): MeshSize {
  const surface = surfaceOf(document);
  if (surface === null) return { rows: 2, cols: 2 };
  const count = ([from, to]: readonly [number, number], closed: boolean): number => Math.max(3, Math.round((to - from) * sides) + (closed ? 0 : 1));
  return { rows: count(surface.domain.u, surface.u.closed), cols: count(surface.domain.v, surface.v.closed) };
}

export function surfaceObj(document: SurfaceDocument, sides: number): string {
  return surfaceOf(document)?.toObj({ ...meshSize(document, sides), name: document.sample }) ?? "";
}

/** So many vertices of a mesh are written to find out what one takes. */
const mostWritten = 5000;

/** Characters of the OBJ: counted, or of a large mesh by what those of a small one take. */
export function objSize(document: SurfaceDocument, sides: number): number {
  const { rows, cols } = meshSize(document, sides);
  if (rows * cols <= mostWritten || sides <= 2) return surfaceObj(document, sides).length;
  const fewer = Math.max(2, Math.floor(sides * Math.sqrt(mostWritten / (rows * cols))));
  const small = meshSize(document, fewer);
  const count = small.rows * small.cols;
  // Six indices to each triangle, two triangles to a vertex; each as long as the numbers up to the last.
  const longer = 12 * (meanDigits(rows * cols) - meanDigits(count));
  return Math.round(rows * cols * (surfaceObj(document, fewer).length / count + longer));
}

/** Of the numbers from 1 on. */
function meanDigits(last: number): number {
  let sum = 0;
  for (let first = 1; first <= last; first *= 10) sum += last - first + 1;
  return sum / last;
}

/** Binary glTF. */
export function surfaceGltf(document: SurfaceDocument, sides: number): Uint8Array<ArrayBuffer> {
  return surfaceOf(document)?.toGltf({ ...meshSize(document, sides), name: document.sample }) ?? new Uint8Array();
}
