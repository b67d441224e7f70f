import type { SurfaceMesh } from "./surface-mesh.ts";

/** What a line of sight meets first. */

type Vector = readonly [number, number, number];

/** How many times `along` it is from an eye to the first triangle of a mesh; null: the line meets none. */
export function firstMet(mesh: SurfaceMesh, eye: Vector, along: Vector): number | null {
  const { rows, cols } = mesh;
  let first = Infinity;
  for (let i = 0; i + 1 < rows; i += 1) {
    for (let j = 0; j + 1 < cols; j += 1) {
      const a = i * cols + j;
      first = Math.min(first, met(mesh, eye, along, a, a + cols, a + 1), met(mesh, eye, along, a + 1, a + cols, a + cols + 1));
    }
  }
  return first === Infinity ? null : first;
}

/** Cramer's rule for eye + t along = a + p (b − a) + q (c − a); infinite where the line misses the triangle. */
function met({ positions }: SurfaceMesh, eye: Vector, [dx, dy, dz]: Vector, a: number, b: number, c: number): number {
  const at = (vertex: number, k: number): number => positions[3 * vertex + k] ?? 0;
  const [ax, ay, az] = [at(a, 0), at(a, 1), at(a, 2)];
  const [ux, uy, uz] = [at(b, 0) - ax, at(b, 1) - ay, at(b, 2) - az];
  const [vx, vy, vz] = [at(c, 0) - ax, at(c, 1) - ay, at(c, 2) - az];
  const [hx, hy, hz] = [dy * vz - dz * vy, dz * vx - dx * vz, dx * vy - dy * vx];
  const volume = ux * hx + uy * hy + uz * hz;
  if (volume === 0) return Infinity;
  const [sx, sy, sz] = [eye[0] - ax, eye[1] - ay, eye[2] - az];
  const p = (sx * hx + sy * hy + sz * hz) / volume;
  if (p < 0 || p > 1) return Infinity;
  const [kx, ky, kz] = [sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux];
  const q = (dx * kx + dy * ky + dz * kz) / volume;
  if (q < 0 || p + q > 1) return Infinity;
  const t = (vx * kx + vy * ky + vz * kz) / volume;
  return t > 0 ? t : Infinity;
}
