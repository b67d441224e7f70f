/** Surfaces through the front door: the reference's numbers, meshes, files, and what is refused. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { ExplineError, type Root, type SurfaceMesh, TensorSurface, type TensorSurfaceJSON, fromJSON } from "expline";

interface Golden {
  name: string;
  alpha_u: [number, number][];
  alpha_v: [number, number][];
  m_u: number;
  m_v: number;
  closed_u: boolean;
  closed_v: boolean;
  from_u: number;
  from_v: number;
  net: number[];
  samples: number[][];
  generic_net: number[];
  generic_samples: number[][];
}

const { surfaces } = JSON.parse(readFileSync("tests/golden/splines/surfaces.json", "utf8")) as { surfaces: Golden[] };

const roots = (alpha: [number, number][]): Root[] => alpha.map(([re, im]) => ({ re, im }));

/** A surface of the reference with one of its nets. */
function surfaceOf(c: Golden, net: number[]): TensorSurface {
  const rows = (closed: boolean, m: number, from: number): number => (closed ? m : m * (from === 0 ? 1 : 2) + 3);
  return new TensorSurface({
    net: Float64Array.from(net),
    u: { roots: roots(c.alpha_u), count: rows(c.closed_u, c.m_u, c.from_u), closed: c.closed_u },
    v: { roots: roots(c.alpha_v), count: rows(c.closed_v, c.m_v, c.from_v), closed: c.closed_v },
  });
}

test("points and derivatives are the reference's, refined or not", (t) => {
  let worst = 0;
  for (const c of surfaces) {
    for (const [net, samples] of [[c.net, c.samples], [c.generic_net, c.generic_samples]] as const) {
      const plain = surfaceOf(c, net);
      const u = samples.map(([u = 0]) => c.m_u * (u - c.from_u));
      const v = samples.map(([, v = 0]) => c.m_v * (v - c.from_v));
      const size = 10 * Math.max(...net.map(Math.abs));
      for (const surface of [plain, plain.refine(1, 2)]) {
        for (const [at, du, dv, unit] of [[2, 0, 0, 1], [5, 1, 0, c.m_u], [8, 0, 1, c.m_v]] as const) {
          const got = surface.evaluate(u, v, du, dv);
          samples.forEach((sample, i) => {
            for (let k = 0; k < 3; k += 1) {
              const deviation = Math.abs((got[3 * i + k] ?? NaN) * unit - (sample[at + k] ?? NaN)) / (size * unit);
              assert.ok(deviation <= 2e-13, `${c.name}: ${deviation}`);
              worst = Math.max(worst, deviation);
            }
          });
        }
      }
    }
  }
  t.diagnostic(`surfaces: worst ${worst.toExponential(1)} of 2e-13`);
});

const shapes = {
  sphere: TensorSurface.sphere(1),
  "smallest sphere": TensorSurface.sphere(1, [3, 2]),
  ellipsoid: TensorSurface.ellipsoid([1, 2, 3]),
  torus: TensorSurface.torus(1, 0.4),
  cylinder: TensorSurface.cylinder(1, 2),
  "Roman surface": TensorSurface.romanSurface(1.4),
  saddle: TensorSurface.hyperbolicParaboloid(1, 1, 1),
  character: TensorSurface.character(),
};

test("a sphere is a sphere at every vertex, with normals that point outwards", () => {
  const mesh = TensorSurface.sphere(2).mesh(65, 65);
  assert.equal(mesh.positions.length, 3 * 65 * 65);
  assert.equal(mesh.withoutNormal, 0);
  for (let i = 0; i < mesh.positions.length; i += 3) {
    const [x = 0, y = 0, z = 0] = mesh.positions.subarray(i, i + 3);
    assert.ok(Math.abs(Math.hypot(x, y, z) - 2) < 1e-14);
    const [a = 0, b = 0, c = 0] = mesh.normals.subarray(i, i + 3);
    assert.ok(Math.hypot(a - x / 2, b - y / 2, c - z / 2) < 1e-7);
  }
});

test("what was dragged is computed again as the whole mesh would be, to the bit", () => {
  for (const surface of Object.values(shapes)) {
    const copy = new TensorSurface({ net: surface.net, u: surface.u, v: surface.v });
    const mesh = copy.mesh(50, 44);
    const single: SurfaceMesh = { ...copy.mesh(50, 44), positions: new Float32Array(6600), normals: new Float32Array(6600) };
    copy.mesh(50, 44, { out: single });
    for (const [i, j] of [[0, 0], [1, 2], [2, 1], [copy.u.count - 1, copy.v.count - 1]] as const) {
      copy.setPoint(i, j, 0.3, -0.2, 0.7);
      const { rows, cols } = copy.remesh(mesh, i, j);
      copy.remesh(single, i, j);
      assert.ok(rows[1] <= 50 && cols[1] <= 44);
      const whole = copy.mesh(50, 44);
      assert.deepEqual(mesh.positions, whole.positions);
      assert.deepEqual(mesh.normals, whole.normals);
      assert.deepEqual(single.positions, Float32Array.from(whole.positions));
    }
  }
});

test("a drag costs no new place in the engine, and an old surface is loaded again when it is asked", () => {
  const many = Array.from({ length: 9 }, (_, k) => TensorSurface.sphere(k + 1));
  for (const surface of many) surface.setPoint(1, 3, 9, 9, 9);
  many.forEach((surface, k) => {
    assert.deepEqual(Array.from(surface.evaluate(1, 2)).map((x) => Math.round(1e9 * x) / 1e9), [9, 9, 9]);
    assert.ok(Math.abs(Math.hypot(...surface.evaluate(5, 2)) - k - 1) < 1e-13);
  });
});

test("JSON gives every surface back to the last bit, patches and all", () => {
  for (const surface of Object.values(shapes)) {
    const patched = surface.refine(1, 0).refineAt(0.5, 0.5, { levels: 2, reach: 0.6 });
    patched.setPatchPoint(0, 1, 1, 0.1, 0.2, 0.3);
    for (const given of [surface, patched]) {
      const again = fromJSON(JSON.stringify(given)) as TensorSurface;
      assert.ok(again instanceof TensorSurface);
      assert.deepEqual(again.toJSON(), given.toJSON());
      assert.deepEqual(again.mesh(9, 9), given.mesh(9, 9));
      const { net, u, v, patches } = given;
      assert.deepEqual(new TensorSurface({ net, u, v, patches }).toJSON(), given.toJSON());
    }
  }
});

test("going down gives back what was refined, and says how far anything else is", () => {
  for (const [name, surface] of Object.entries(shapes)) {
    const finer = surface.refine(2, 1);
    const { surface: back, maxError } = finer.reduce(2, 1);
    assert.ok(maxError < 1e-12, `${name}: ${maxError}`);
    back.net.forEach((x, i) => assert.ok(Math.abs(x - (surface.net[i] ?? NaN)) < 1e-9));
    finer.setPoint(3, 3, 0.5, 0.5, 0.5);
    assert.ok(finer.reduce(1, 0).maxError > 1e-3);
  }
  assert.throws(() => shapes.torus.reduce(1, 0), { code: "E_RANGE" });
});

test("a patch leaves the mesh as it is, and its points move their surroundings only", () => {
  const surface = TensorSurface.torus(1, 0.4);
  const patched = surface.refineAt(3, 2, { levels: 2 });
  assert.deepEqual(patched.mesh(40, 30), surface.mesh(40, 30));
  const [patch] = patched.patches;
  assert.ok(patch !== undefined);
  assert.equal(patched.patchPoints(0).length, 3 * patch.u.count * patch.v.count);
  const mesh = patched.mesh(40, 30);
  patched.setPatchPoint(0, 4, 4, 0, 0, 1);
  assert.deepEqual(Array.from(patched.patchPoints(0).subarray(3 * (4 * patch.v.count + 4), 3 * (4 * patch.v.count + 5))).map((x) => x + 0), [0, 0, 1]);
  patched.remesh(mesh, 4, 4, 0);
  assert.deepEqual(mesh.positions, patched.mesh(40, 30).positions);
  let changed = 0;
  const before = surface.mesh(40, 30).positions;
  before.forEach((x, i) => (changed += x === mesh.positions[i] ? 0 : 1));
  assert.ok(changed > 0 && changed < 0.1 * before.length, `${changed} of ${before.length}`);
});

test("a patch of the finest level costs its own points: it is made, moved, kept and loaded", () => {
  const torus = TensorSurface.torus(3, 1);
  const patched = torus.refineAt(3, 2, { levels: 12, reach: 0.001 });
  const [patch] = patched.patches;
  assert.ok(patch !== undefined && patch.u.level === 12 && patch.u.count * patch.v.count < 100);
  patched.setPatchPoint(0, 4, 4, 0, 0, 5);
  assert.equal(patched.patchPoints(0)[3 * (4 * patch.v.count + 4) + 2], 5);
  const loaded = fromJSON(patched.toJSON());
  assert.deepEqual(loaded.patchPoints(0), patched.patchPoints(0));
  assert.deepEqual(loaded.evaluate(3, 2), patched.evaluate(3, 2));
  assert.throws(
    () => torus.refineAt(3, 2, { levels: 12 }),
    (error) => error instanceof ExplineError && error.code === "E_LIMIT" && error.limit === "maxSurfacePoints" && error.actual === 8192 ** 2,
  );
});

test("a grid as long as it may be has the vertices and curvatures of its places, in either direction", () => {
  const torus = TensorSurface.torus(3, 1).refineAt(3, 2);
  torus.setPatchPoint(0, 1, 1, 0, 0, 2);
  const [long, few] = [2_000_000, 2];
  for (const [rows, cols] of [[few, long], [long, few]] as const) {
    const mesh = torus.mesh(rows, cols);
    const { gaussian } = torus.meshCurvature(rows, cols);
    assert.equal(mesh.positions.length, 3 * 4_000_000);
    const places = [0, 65_535, 65_536, 1_048_576, 1_999_999].map((k) => (cols === long ? [0, k] : [k, 0]) as [number, number]);
    const { u, v } = torus.domain;
    for (const [i, j] of [...places, ...places.map(([i, j]) => (cols === long ? [1, j] : [i, 1]) as [number, number])]) {
      const [s, t] = [(u[1] * i) / rows, (v[1] * j) / cols];
      const at = i * cols + j;
      const apart = torus.evaluate(s, t).map((x, k) => Math.abs(x - (mesh.positions[3 * at + k] ?? NaN)));
      assert.ok(Math.max(...apart) < 1e-14, `vertex ${i}, ${j}`);
      const turned = torus.normal(s, t).map((x, k) => Math.abs(x - (mesh.normals[3 * at + k] ?? NaN)));
      assert.ok(Math.max(...turned) < 1e-12, `normal ${i}, ${j}`);
      assert.ok(Math.abs((torus.curvature(s, t).gaussian[0] ?? NaN) - (gaussian[at] ?? NaN)) < 1e-11, `curvature ${i}, ${j}`);
    }
  }
});

test("curvatures of a torus are the closed forms, in bulk as one by one", () => {
  const surface = TensorSurface.torus(3, 1, [8, 6]);
  const { gaussian, mean } = surface.meshCurvature(8, 60);
  for (let j = 0; j < 60; j += 1) {
    const cos = Math.cos((2 * Math.PI * j) / 60);
    assert.ok(Math.abs((gaussian[j] ?? NaN) - cos / (3 + cos)) < 1e-11);
    assert.ok(Math.abs((mean[j] ?? NaN) + (3 + 2 * cos) / (2 * (3 + cos))) < 1e-11);
    assert.ok(Math.abs((surface.curvature(0, j / 10).gaussian[0] ?? NaN) - (gaussian[j] ?? NaN)) < 1e-12);
  }
});

test("a long name is cut after 200 characters, never within one", () => {
  const nameOf = (name: string): string => TensorSurface.sphere(1).toObj({ rows: 3, cols: 3, name }).split("\n", 1)[0] ?? "";
  const [letter, longer] = ["a", "\u{1d4d0}"];
  assert.equal(nameOf(letter.repeat(300)), `o ${letter.repeat(200)}`);
  assert.equal(nameOf(letter + longer.repeat(300)), `o ${letter}${longer.repeat(199)}`);
});

test("SU-018: an OBJ file reads back as the mesh to the last bit, and a name in it is no line", () => {
  const surface = TensorSurface.character();
  const mesh = surface.mesh(16, 12);
  const lines = surface.toObj({ rows: 16, cols: 12, name: "a\nf 1 2 3" }).split("\n");
  const of = (kind: string): number[][] => lines.filter((l) => l.startsWith(`${kind} `)).map((l) => l.slice(kind.length + 1).split(" ").map(parseFloat));
  assert.deepEqual(of("v").flat(), Array.from(mesh.positions));
  assert.deepEqual(of("vn").flat(), Array.from(mesh.normals));
  assert.deepEqual(of("f").flat().map((i) => i - 1), Array.from(mesh.indices));
  assert.deepEqual(lines.filter((l) => l.startsWith("o ")), ["o a_f 1 2 3"]);
});

interface Gltf {
  asset: { version: string };
  buffers: { byteLength: number }[];
  bufferViews: { byteOffset: number; byteLength: number }[];
  accessors: { bufferView: number; componentType: number; count: number; type: string; min?: number[]; max?: number[] }[];
  meshes: { primitives: { attributes: Record<string, number>; indices: number }[] }[];
}

test("a glTF file is complete in itself and says the truth about its buffers", () => {
  for (const [name, surface] of Object.entries(shapes)) {
    const file = surface.toGltf({ rows: 20, cols: 15, name });
    const words = new DataView(file.buffer);
    const word = (at: number): number => words.getUint32(at, true);
    assert.deepEqual([word(0), word(4), word(8)], [0x46546c67, 2, file.length], "magic, version, length");
    const length = word(12);
    assert.equal(length % 4, 0);
    assert.equal(word(16), 0x4e4f534a);
    const json = JSON.parse(new TextDecoder().decode(file.subarray(20, 20 + length))) as Gltf;
    assert.equal(word(24 + length), 0x004e4942);
    const bytes = file.subarray(28 + length);
    assert.equal(word(20 + length), bytes.length);
    assert.equal(json.buffers[0]?.byteLength, bytes.length);
    assert.equal(json.asset.version, "2.0");
    const numbersOf = (i: number): Float32Array | Uint32Array => {
      const { bufferView, componentType, count, type } = json.accessors[i] ?? assert.fail("an accessor");
      const { byteOffset, byteLength } = json.bufferViews[bufferView] ?? assert.fail("a view");
      assert.equal(byteOffset % 4, 0);
      assert.ok(byteOffset + byteLength <= bytes.length);
      const size = count * (type === "VEC3" ? 3 : 1);
      assert.equal(byteLength, 4 * size);
      const part = bytes.slice(byteOffset, byteOffset + byteLength).buffer;
      return componentType === 5126 ? new Float32Array(part) : new Uint32Array(part);
    };
    const [primitive] = json.meshes[0]?.primitives ?? [];
    assert.ok(primitive !== undefined);
    const [positions, normals, indices] = [primitive.attributes["POSITION"] ?? -1, primitive.attributes["NORMAL"] ?? -1, primitive.indices].map(numbersOf);
    assert.ok(positions !== undefined && normals !== undefined && indices !== undefined);
    const mesh = surface.mesh(20, 15);
    assert.deepEqual(positions, Float32Array.from(mesh.positions));
    assert.deepEqual(indices, mesh.indices);
    assert.ok(indices.every((i) => i < positions.length / 3), "every triangle has vertices");
    for (let k = 0; k < 3; k += 1) {
      const axis: Float32Array | Uint32Array = positions.filter((_, i) => i % 3 === k);
      assert.equal(json.accessors[0]?.min?.[k], Math.min(...axis));
      assert.equal(json.accessors[0]?.max?.[k], Math.max(...axis));
    }
    for (let i = 0; i < normals.length; i += 3) assert.ok(Math.abs(Math.hypot(...normals.subarray(i, i + 3)) - 1) < 1e-6);
  }
});

test("the net's rows know their parameters, and the surface goes through them", () => {
  for (const surface of Object.values(shapes)) {
    const { net, domain, u, v } = surface;
    for (let i = 0; i < u.count; i += 1) {
      for (let j = 0; j < v.count; j += 1) {
        const [s, t] = surface.parameters(i, j);
        if (s < 0 || t < 0 || s > domain.u[1] || t > domain.v[1]) continue;
        const point = surface.evaluate(s, t);
        const at = 3 * (i * v.count + j);
        for (let k = 0; k < 3; k += 1) assert.ok(Math.abs((point[k] ?? NaN) - (net[at + k] ?? NaN)) < 1e-13);
      }
    }
  }
});

const THREE: Root[] = [0, 0, 0];
/** One control point of a grid of level 1, or a few in v. */
const patchAt = (first: number, count = 1) => ({ u: { level: 1, first: 0, count: 1 }, v: { level: 1, first, count }, displacements: new Float64Array(3 * count) });
const grid = (rows: number, cols: number): Float64Array => Float64Array.from({ length: 3 * rows * cols }, (_, i) => Math.sin(i));
const made = (rows: number, cols: number, net: unknown = grid(rows, cols), closed = false): TensorSurface => {
  return new TensorSurface({ net: net as Float64Array, u: { roots: THREE, count: rows, closed: false }, v: { roots: THREE, count: cols, closed } });
};

/** Hostile inputs, and what each gives. */
test("a mesh whose getters ask other surfaces is filled from its own", () => {
  const surface = new TensorSurface({ net: shapes.torus.net, u: shapes.torus.u, v: shapes.torus.v });
  const { normals, positions, ...mesh } = surface.mesh(9, 8);
  // More than an engine keeps.
  const others = [1, 2, 3, 4, 5, 6].map((radius) => TensorSurface.sphere(radius));
  const asking = { ...mesh, normals, get positions() { return others.forEach((other) => other.evaluate(1, 1)), positions; } };
  surface.setPoint(1, 2, 0.3, -0.2, 0.7);
  surface.remesh(asking, 1, 2);
  assert.deepEqual(positions, surface.mesh(9, 8).positions);
  surface.setPoint(1, 2, 0.9, 0.2, 0.1);
  surface.mesh(9, 8, { out: asking });
  assert.deepEqual(positions, surface.mesh(9, 8).positions);
});

const REFUSED: readonly [string, () => unknown, Partial<ExplineError>][] = [
  ["SU-001 another length", () => made(4, 4, grid(4, 3)), { code: "E_LENGTH", argument: "net", bound: "48" }],
  ["SU-005 a product that wraps to 0", () => made(65536, 65536, []), { code: "E_LIMIT", argument: "net", limit: "maxSurfacePoints" }],
  ["SU-006 NaN", () => made(4, 4, grid(4, 4).fill(NaN, 35, 36)), { code: "E_NOT_FINITE", argument: "net[35]" }],
  ["SU-011 tessellate 1e5 × 1e5", () => made(4, 4).mesh(1e5, 1e5), { code: "E_LIMIT", arg: "rows", argument: "rows × cols" }],
  ["SU-013 too many indices", () => made(4, 4).mesh(40000, 40000), { code: "E_LIMIT", arg: "rows", argument: "rows × cols" }],
  ["SU-014 just beyond the end", () => made(4, 4).evaluate(1 + 4e-16, 0.5), { code: "E_RANGE", argument: "u" }],
  ["SU-015 two closed columns", () => made(4, 2, grid(4, 2), true), { code: "E_TOO_FEW_POINTS", argument: "v.count", bound: ">= 3" }],
  ["SU-017 refine 1000 × 1000 by 6 levels", () => made(1000, 1000).refine(6, 6), { code: "E_LIMIT", argument: "levels", limit: "maxSurfacePoints" }],
  ["a level beyond twelve in all", () => shapes.torus.refine(1, 0).refine(12, 0), { code: "E_LIMIT", argument: "levels", limit: "maxLevels", max: 12, actual: 13 }],
  ["no options", () => new TensorSurface(undefined as never), { code: "E_TYPE" }],
  ["an option that is not known", () => new TensorSurface({ net: [], u: {}, v: {}, w: 1 } as never), { code: "E_TYPE", argument: "w" }],
  ["an option of a direction that is not known", () => new TensorSurface({ net: [], u: { root: [] }, v: {} } as never), { code: "E_TYPE", argument: "u.root" }],
  ["a field of a direction that is not known", () => fromJSON({ ...shapes.torus.toJSON(), u: { ...shapes.torus.toJSON().u, note: 1 } }), { code: "E_SCHEMA", path: "$.u.note" }],
  ["no direction", () => new TensorSurface({ net: grid(4, 4) } as never), { code: "E_TYPE", argument: "u" }],
  ["a root without its conjugate", () => new TensorSurface({ net: grid(4, 4), u: { roots: [0, { re: 0, im: 1 }, 0], count: 4, closed: true }, v: { roots: THREE, count: 4, closed: true } }), { code: "E_DEGENERATE", argument: "u.roots[1]" }],
  ["a root that is too fast", () => new TensorSurface({ net: grid(4, 4), u: { roots: [0, { re: 0, im: 4 }, { re: 0, im: -4 }], count: 4, closed: true }, v: { roots: THREE, count: 4, closed: true } }), { code: "E_RANGE", argument: "u.roots[1]" }],
  ["a direction that does not stand for itself", () => new TensorSurface({ net: grid(4, 4), u: { roots: THREE, count: 4, closed: true }, v: { roots: [0, 1, 2], count: 4, closed: true } }), { code: "E_DEGENERATE", argument: "v.roots[1]" }],
  ["a patch of points that are moved too far", () => new TensorSurface({ net: grid(4, 4), u: { roots: THREE, count: 4, closed: true }, v: { roots: THREE, count: 4, closed: true }, patches: [{ u: { level: 1, first: 0, count: 1 }, v: { level: 1, first: 0, count: 1 }, displacements: Float64Array.of(0, 3e9, 0) }] }), { code: "E_RANGE", argument: "patches[0].displacements[1]" }],
  ["half a point", () => TensorSurface.sphere(1).setPoint(0.5, 1, 0, 0, 0), { code: "E_RANGE", argument: "i" }],
  ["a point that is not there", () => TensorSurface.sphere(1).setPoint(8, 1, 0, 0, 0), { code: "E_RANGE", argument: "i" }],
  ["a place that is not finite", () => TensorSurface.sphere(1).setPoint(1, 1, 0, Infinity, 0), { code: "E_NOT_FINITE", argument: "y" }],
  ["a sphere without size", () => TensorSurface.sphere(0), { code: "E_RANGE", argument: "radius" }],
  ["a sphere of two points", () => TensorSurface.sphere(1, [2, 2]), { code: "E_RANGE", argument: "segments[0]" }],
  ["two lists of different length", () => TensorSurface.sphere(1).evaluate([1, 2], [1]), { code: "E_LENGTH", argument: "v" }],
  ["a derivative of an order that is none", () => TensorSurface.sphere(1).evaluate(1, 1, 9), { code: "E_RANGE", argument: "du" }],
  ["a patch that is not there", () => TensorSurface.sphere(1).patchPoints(0), { code: "E_RANGE", argument: "patch" }],
  ["a mesh of someone else", () => TensorSurface.sphere(1).remesh({ rows: 4, cols: 4 } as never, 1, 1), { code: "E_TYPE", argument: "mesh" }],
  ["a mesh that lies about its size", () => TensorSurface.sphere(1).remesh({ ...TensorSurface.sphere(1).mesh(5, 5), rows: 50 }, 1, 1), { code: "E_LENGTH", argument: "mesh" }],
  ["a mesh to be filled again that is frozen", () => TensorSurface.sphere(1).mesh(5, 5, { out: Object.freeze({ ...TensorSurface.sphere(1).mesh(5, 5) }) }), { code: "E_TYPE", argument: "out" }],
  ["a text longer than an engine's", () => TensorSurface.sphere(1).toObj({ rows: 2000, cols: 2000 }), { code: "E_LIMIT", limit: "maxWrittenVertices" }],
  ["a forged this", () => Object.getOwnPropertyDescriptor(TensorSurface.prototype, "net")?.get?.call({}), { code: "E_TYPE", argument: "this" }],
  ["a file without a net", () => fromJSON({ type: "TensorSurface", version: 1, u: {}, v: {} }), { code: "E_SCHEMA", path: "$.net" }],
  ["a file with a short net", () => fromJSON({ ...shapes.torus.toJSON(), net: [1, 2, 3] }), { code: "E_SCHEMA", path: "$.net" }],
  ["a file with a patch beyond the grid", () => fromJSON({ ...shapes.torus.toJSON(), patches: [{ u: { level: 1, first: 99, count: 1 }, v: { level: 1, first: 0, count: 1 }, displacements: [0, 0, 0] }] }), { code: "E_RANGE", argument: "$.patches[0].u.first", path: "$.patches[0].u.first" }],
  ["a second patch beyond the grid", () => fromJSON({ ...shapes.torus.toJSON(), patches: [patchAt(0), patchAt(12)] }), { code: "E_RANGE", path: "$.patches[1].v.first", bound: "a number in [0, 11]" }],
  ["a patch of more rows than its grid has", () => new TensorSurface({ net: grid(4, 4), u: { roots: THREE, count: 4, closed: true }, v: { roots: THREE, count: 4, closed: true }, patches: [patchAt(0, 9)] }), { code: "E_RANGE", argument: "patches[0].v.count", bound: "a number in [1, 8]" }],
  ["a net of too few rows, after a patch that was refused", () => (assert.throws(() => fromJSON({ ...shapes.torus.toJSON(), patches: [patchAt(99)] })), made(4, 2, grid(4, 2), true)), { code: "E_TOO_FEW_POINTS", argument: "v.count" }],
  ["a field of a patch that is not known", () => fromJSON({ ...shapes.torus.toJSON(), patches: [{ ...patchAt(0), note: 1 }] }), { code: "E_SCHEMA", path: "$.patches[0].note" }],
];

for (const [name, run, expected] of REFUSED) {
  test(`refused: ${name}`, () => {
    assert.throws(run, (error) => {
      assert.ok(error instanceof ExplineError, String(error));
      for (const [key, value] of Object.entries(expected)) assert.equal(error[key as keyof ExplineError], value, `${key} of ${error.message}`);
      return true;
    });
  });
}

test("degenerate nets give finite meshes, and vertices without a normal are counted (SU-007, SU-008, SU-009, SU-016)", () => {
  assert.ok(Math.abs(Math.hypot(...TensorSurface.sphere(1).normal(0, 0)) - 1) < 1e-15);
  const point = made(4, 4, new Float64Array(48).fill(1));
  assert.deepEqual(Array.from(point.normal(0.5, 0.5)), [0, 0, 0]);
  const line = made(4, 4, Float64Array.from({ length: 48 }, (_, i) => (i % 3) * Math.floor(i / 3)));
  const mesh = line.mesh(8, 8);
  assert.ok(mesh.positions.every(Number.isFinite) && mesh.normals.every(Number.isFinite));
  assert.equal(mesh.withoutNormal, 64);
  const stiff = new TensorSurface({ net: grid(4, 4), u: { roots: THREE, count: 4, closed: false }, v: { roots: [0, 5, -5], count: 4, closed: false } });
  assert.ok(stiff.mesh(9, 9).positions.every(Number.isFinite));
});

test("a mesh that is there already is filled again, and one that is not is made", () => {
  let mesh: SurfaceMesh | undefined;
  const torus = TensorSurface.torus(3, 1);
  for (let frame = 0; frame < 2; frame += 1) {
    const before: SurfaceMesh | undefined = mesh;
    mesh = torus.mesh(4, 5, { out: mesh });
    assert.ok(before === undefined || before === mesh);
  }
  assert.deepEqual(mesh, torus.mesh(4, 5));
  assert.deepEqual(torus.mesh(4, 5, {}), torus.mesh(4, 5));
});

test("a displacement of −0 comes back from text as it is", () => {
  const { net, u, v } = TensorSurface.torus(3, 1).toJSON();
  const window = { level: 1, first: 0, count: 1 };
  const surface = new TensorSurface({ net, u, v, patches: [{ u: window, v: window, displacements: [-0, 1, -0] }] });
  assert.deepStrictEqual(fromJSON(JSON.parse(JSON.stringify(surface)) as TensorSurfaceJSON).toJSON(), surface.toJSON());
});

test("the patches of plain data make a surface, as its own patches do", () => {
  const surface = TensorSurface.torus(3, 1).refineAt(2, 3);
  surface.setPatchPoint(0, 1, 1, 5, 1, 1);
  const { net, u, v, patches = [] } = surface.toJSON();
  for (const detail of [patches, surface.patches]) {
    assert.deepEqual(new TensorSurface({ net, u, v, patches: detail }).toJSON(), surface.toJSON());
  }
});
