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

/** Binary glTF. */
export function surfaceGltf(document: SurfaceDocument, sides: number): Uint8Array<ArrayBuffer> {
  return surfaceOf(document)?.toGltf({ ...meshSize(document, sides), name: document.sample }) ?? new Uint8Array();
}
