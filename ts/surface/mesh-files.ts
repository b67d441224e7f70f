/** Meshes as files that other programs read: Wavefront OBJ and binary glTF 2.0. */
import { options as checkOptions, wrong } from "../core.js";
import { type SurfaceMesh, sizes } from "./surface-mesh.js";

/** How a surface is written to a file. */
export interface MeshFileOptions {
  /** Vertices in u, 64 by default. */
  rows?: number | undefined;
  /** Vertices in v, 64 by default. */
  cols?: number | undefined;
  /**
   * Name of the object; what is not a letter, digit, space, dot, underscore or hyphen becomes an underscore. Cut after
   * 200 characters.
   */
  name?: string | undefined;
}

/** The options of a file, checked. @internal */
export function fileOptions(op: string, options: unknown): { rows: number; cols: number; name: string } {
  const { rows = 64, cols = 64, name = "surface" } = checkOptions(op, options, ["rows", "cols", "name"]);
  if (typeof name !== "string") throw wrong("E_TYPE", op, "name", name, "string");
  const [m, n] = sizes(op, rows, cols);
  // No literal: engines look all letters up while they read one, at the import of whoever writes no file.
  const strange = new RegExp("[^\\p{L}\\p{N} ._-]", "gu");
  const [cut = ""] = /^[^]{0,200}/u.exec(name) ?? [];
  return { rows: m, cols: n, name: cut.replace(strange, "_") };
}

/** A mesh as OBJ text: every number as JavaScript writes it, so that reading gives the same bits. @internal */
export function objOf({ positions, normals, indices }: SurfaceMesh, name: string): string {
  const lines = [`o ${name}`];
  for (const [what, list] of [["v", positions], ["vn", normals]] as const) {
    for (let i = 0; i < list.length; i += 3) lines.push(`${what} ${list[i]} ${list[i + 1]} ${list[i + 2]}`);
  }
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => (indices[i + k] ?? 0) + 1);
    lines.push(`f ${a}//${a} ${b}//${b} ${c}//${c}`);
  }
  return `${lines.join("\n")}\n`;
}

/** Codes of the glTF 2.0 specification. */
const FLOAT = 5126;
const UNSIGNED_INT = 5125;
const VERTICES = 34962;
const TRIANGLES = 34963;
const GLB = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;

/** Least and largest coordinate of each axis, as single precision has them. */
function bounds(positions: Float32Array): { min: number[]; max: number[] } {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    min[i % 3] = Math.min(min[i % 3] ?? x, x);
    max[i % 3] = Math.max(max[i % 3] ?? x, x);
  });
  return { min, max };
}

/** A letter, or half of one, as JSON may have it. */
const escaped = (letter: string): string => `\\u${letter.charCodeAt(0).toString(16).padStart(4, "0")}`;

/** A mesh as GLB: header, JSON, then positions, normals and triangles in one buffer. @internal */
export function gltfOf(mesh: SurfaceMesh, name: string): Uint8Array<ArrayBuffer> {
  const positions = Float32Array.from(mesh.positions);
  const normals = Float32Array.from(mesh.normals);
  // glTF wants every normal of length 1; where the surface has none, any will do.
  for (let i = 0; i < normals.length; i += 3) if (!normals[i] && !normals[i + 1] && !normals[i + 2]) normals[i + 2] = 1;
  const bytes = 4 * (2 * positions.length + mesh.indices.length);
  const count = positions.length / 3;
  const view = (byteOffset: number, length: number, target: number): object => ({ buffer: 0, byteOffset, byteLength: 4 * length, target });
  const json = JSON.stringify({
    asset: { version: "2.0", generator: "expline" },
    scene: 0,
    scenes: [{ nodes: [0] }],
    // glTF has y upwards, the surface z.
    nodes: [{ mesh: 0, name, rotation: [-Math.SQRT1_2, 0, 0, Math.SQRT1_2] }],
    meshes: [{ name, primitives: [{ attributes: { POSITION: 0, NORMAL: 1 }, indices: 2, material: 0 }] }],
    materials: [{ doubleSided: true, pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: 0.6 } }],
    accessors: [
      { bufferView: 0, componentType: FLOAT, count, type: "VEC3", ...bounds(positions) },
      { bufferView: 1, componentType: FLOAT, count, type: "VEC3" },
      { bufferView: 2, componentType: UNSIGNED_INT, count: mesh.indices.length, type: "SCALAR" },
    ],
    bufferViews: [
      view(0, positions.length, VERTICES),
      view(4 * positions.length, normals.length, VERTICES),
      view(8 * positions.length, mesh.indices.length, TRIANGLES),
    ],
    buffers: [{ byteLength: bytes }],
  });
  // Of ASCII a byte is a letter: not every host has a TextEncoder.
  const ascii = json.replace(/[^\0-\x7f]/g, escaped);
  const text = Uint8Array.from(ascii, (letter) => letter.charCodeAt(0));
  const padded = Math.ceil(text.length / 4) * 4;
  const file = new Uint8Array(12 + 8 + padded + 8 + bytes);
  const header = new DataView(file.buffer);
  const put = (at: number, ...words: number[]): void => words.forEach((word, k) => header.setUint32(at + 4 * k, word, true));
  put(0, GLB, 2, file.length, padded, JSON_CHUNK);
  file.fill(0x20, 20, 20 + padded).set(text, 20);
  put(20 + padded, bytes, BINARY_CHUNK);
  let at = 28 + padded;
  // Little-endian, as the format and every machine with WebAssembly have it.
  for (const array of [positions, normals, mesh.indices]) {
    file.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength), at);
    at += array.byteLength;
  }
  return file;
}
