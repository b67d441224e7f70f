// Affine maps of everything that has points, through the front door: the image of every place, and what a matrix may
// not be.

import assert from "node:assert/strict";
import { test } from "node:test";

import { type Curve, BSplineCurve, ExplineError, HermiteCurve, InterpolatingCurve, LocalCurve, TensorSurface, fromJSON } from "expline";
import { Euler, Matrix4, Quaternion, Vector3 } from "three";

const PLANE = [0.5, 1.5, -2, 0.25, 3, -4];
const POINTS = [0, 0, 4, 1, 5, 5, 1, 6, -2, 3];
const SPACE_POINTS = [[0, 0, 1], [4, 1, 0], [5, 5, 2], [1, 6, -1], [-2, 3, 0]];
/** Turned, stretched and moved, as an object of three.js is. */
const placed = new Matrix4().compose(new Vector3(3, -4, 5), new Quaternion().setFromEuler(new Euler(0.3, 1.1, -0.7)), new Vector3(2, 0.5, 1.5));

/** Where a matrix takes a point. */
function taken(matrix: readonly number[], place: ArrayLike<number>): number[] {
  const [x = 0, y = 0, z = 0] = Array.from(place);
  if (matrix.length === 16) return new Vector3(x, y, z).applyMatrix4(new Matrix4().fromArray(matrix)).toArray();
  const [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0] = matrix;
  return [a * x + c * y + e, b * x + d * y + f];
}

/** Images of size 10 that are sums of a dozen roundings. */
function assertImage(what: string, matrix: readonly number[], before: Float64Array, after: Float64Array, each: number): void {
  assert.equal(after.length, before.length);
  for (let i = 0; i < before.length; i += each) {
    for (const [k, should] of taken(matrix, before.subarray(i, i + each)).entries()) {
      const is = after[i + k] ?? NaN;
      assert.ok(Math.abs(is - should) < 1e-13, `${what}: ${is} for ${should}`);
    }
  }
}

function patched(curve: InterpolatingCurve): LocalCurve {
  const local = curve.refineAt(1.5, { levels: 2 });
  local.setPatchPoint(0, 1, 3, 3, 3);
  return local;
}

const inSpace = (closed: boolean): InterpolatingCurve => new InterpolatingCurve({ points: SPACE_POINTS, closed });
const inPlane = (closed: boolean): InterpolatingCurve => new InterpolatingCurve({ points: POINTS, closed });

for (const [what, curve, kind] of [
  ["a Hermite curve with corners", new HermiteCurve({ points: POINTS, tangents: POINTS, tangentsIn: POINTS.map((x) => 3 - x), lengths: [1, 2, 0.5, 1, 1] }), HermiteCurve],
  ["an open Hermite curve", new HermiteCurve({ points: POINTS, tangents: POINTS, closed: false, space: "hyperbolic", omega: 2 }), HermiteCurve],
  ["an interpolating curve", inPlane(true), InterpolatingCurve],
  ["an open interpolating curve in space", inSpace(false), InterpolatingCurve],
  ["a B-spline curve whose steps are thirds", inPlane(true).refine(2, { m: 3 }), BSplineCurve],
  ["an open B-spline curve in space", inSpace(false).refine(1), BSplineCurve],
  ["a curve with a patch", patched(inPlane(true)), LocalCurve],
  ["a curve with a patch in space", patched(inSpace(true)), LocalCurve],
] as const) {
  test(`${what}: its image has the image of every place, its kind and its domain, and can be kept`, () => {
    const matrix = curve.dimension === 2 ? PLANE : placed.elements;
    const before = JSON.stringify(curve);
    const image: Curve = curve.transform(matrix);
    assert.ok(image instanceof kind);
    assert.deepEqual([image.domain, image.closed, image.dimension], [curve.domain, curve.closed, curve.dimension]);
    assertImage(what, matrix, curve.sample(200), image.sample(200), curve.dimension);
    assert.deepEqual((fromJSON(image.toJSON()) as Curve).sample(50), image.sample(50));
    assert.equal(JSON.stringify(curve), before, "the curve itself stays");
  });
}

test("a surface is placed as three.js places its mesh, with its patches and its normals", () => {
  const surface = TensorSurface.torus(3, 1).refineAt(2, 2);
  surface.setPatchPoint(0, 1, 1, 1, 4, 1);
  const before = surface.toJSON();
  const image = surface.transform(placed.elements);
  assert.deepEqual(image.domain, surface.domain);
  assert.deepEqual(image.parameters(2, 3), surface.parameters(2, 3));
  const [mesh, moved] = [surface.mesh(20, 20), image.mesh(20, 20)];
  assertImage("positions", placed.elements, mesh.positions, moved.positions, 3);
  const turned = new Matrix4().copy(placed).invert().transpose();
  for (let i = 0; i < mesh.normals.length; i += 3) {
    const should = new Vector3().fromArray(mesh.normals, i).transformDirection(turned);
    assert.ok(should.distanceTo(new Vector3().fromArray(moved.normals, i)) < 1e-12);
  }
  image.setPatchPoint(0, 0, 0, 9, 9, 9);
  image.setPoint(0, 0, 9, 9, 9);
  assert.deepEqual(surface.toJSON(), before, "the two share nothing");
});

test("curves that share a patch or points with their image or with what was left of them share nothing that can change", () => {
  const curve = patched(inPlane(true));
  const without = curve.withoutPatch(0);
  const json = JSON.stringify(curve);
  without.setPoint(0, 9, 9);
  curve.transform(PLANE).setPatchPoint(0, 0, 9, 9);
  assert.equal(JSON.stringify(curve), json);
});

test("what comes back from an inverse in double or in single precision is an affine map", () => {
  const back = placed.clone().invert();
  const curve = inSpace(true);
  const there = curve.transform(placed.elements);
  for (const [matrix, near] of [[back.elements, 1e-13], [Float32Array.from(back.elements), 1e-5]] as const) {
    const again = there.transform(matrix).sample(20);
    curve.sample(20).forEach((x, i) => assert.ok(Math.abs(x - (again[i] ?? NaN)) < near));
  }
});

test("a map that undoes itself gives 0, never −0, so that JSON can carry every number", () => {
  for (const thing of [inPlane(true), patched(inPlane(true)), HermiteCurve.ellipse({ center: [0, 0], radii: [1, 1], count: 2 })]) {
    assert.doesNotMatch(JSON.stringify(thing.transform([-1, 0, 0, -1, -0, -0]).toJSON(), (_, x: unknown) => (Object.is(x, -0) ? "minus" : x)), /minus/);
  }
});

const changed = (i: number, entry: number): number[] => placed.elements.map((x, k) => (k === i ? entry : x));
const real = [0.5, -0.5, 0.25, -0.25];

for (const [what, thing, matrix, code, argument, words] of [
  ["five numbers", inPlane(true), [1, 0, 0, 1, 0], "E_LENGTH", "matrix", "matrix has length 5; expected 6"],
  ["six numbers in space", inSpace(true), PLANE, "E_LENGTH", "matrix", "matrix has length 6; expected 16"],
  ["twelve numbers for a surface", TensorSurface.sphere(1), placed.elements.slice(0, 12), "E_LENGTH", "matrix", "matrix has length 12; expected 16"],
  ["NaN", patched(inPlane(true)), [1, 0, NaN, 1, 0, 0], "E_NOT_FINITE", "matrix[2]", "matrix[2] is NaN; expected a finite number"],
  ["text", inPlane(true), "none", "E_TYPE", "matrix", 'matrix is "none"; expected Float64Array or an array of numbers'],
  ["a perspective", TensorSurface.sphere(1), changed(3, 0.5), "E_RANGE", "matrix[3]", "matrix[3] is 0.5; expected a finite number with |x| <= 0.000001"],
  ["rows where columns should be", inSpace(true), placed.clone().transpose().elements, "E_RANGE", "matrix[3]", "matrix[3] is 3; expected a finite number with |x| <= 0.000001"],
  ["a last entry of 2", inSpace(true), changed(15, 2), "E_RANGE", "matrix[15]", "matrix[15] is 2; expected a number in [0.999999, 1.000001]"],
  ["points beyond the bound", inPlane(true), [1e9, 0, 0, 1, 0, 0], "E_RANGE", "matrix", "matrix gives 4000000000; expected a finite number with |x| <= 1e9"],
  ["tangents beyond theirs", new HermiteCurve({ points: [0, 0, 1, 0], tangents: [8e9, 0, 1, 0] }), [2, 0, 0, 1, 0, 0], "E_RANGE", "matrix", "matrix gives 16000000000; expected a finite number with |x| <= 8e9"],
  ["numbers beyond all bounds", TensorSurface.sphere(1), changed(0, 1e308).map((x, i) => (i === 4 ? 1e308 : x)), "E_RANGE", "matrix", undefined],
  ["a translation of a curve without a root 0", new InterpolatingCurve({ points: POINTS, roots: real }), PLANE, "E_DEGENERATE", "matrix[4]", "matrix[4] = 3 has no unique answer: what has no root 0 cannot be moved"],
] as const) {
  test(`a matrix is refused, and nothing changes: ${what}`, () => {
    const before = JSON.stringify(thing);
    assert.throws(
      () => thing.transform(matrix as never),
      (error) => {
        assert.ok(error instanceof ExplineError);
        assert.deepEqual([error.code, error.argument, error.arg], [code, argument, "matrix"]);
        if (words !== undefined) assert.equal(error.message, `transform: ${words} [${code}]`);
        return true;
      },
    );
    assert.equal(JSON.stringify(thing), before);
  });
}

test("without a root 0 a curve is still turned and stretched exactly", () => {
  const curve = new InterpolatingCurve({ points: POINTS, roots: real });
  const linear = [...PLANE.slice(0, 4), 0, 0];
  assertImage("linear", linear, curve.sample(100), curve.transform(linear).sample(100), 2);
});

test("what sets all points, tangents or a net at once says so when it refuses", () => {
  const curve = HermiteCurve.ellipse({ center: [0, 0], radii: [1, 1], count: 4 });
  const spline = inPlane(true);
  const surface = TensorSurface.sphere(1);
  for (const [op, set] of [
    ["points", () => (curve.points = [NaN, ...curve.points.slice(1)])],
    ["tangents", () => (curve.tangents = [1])],
    ["tangentsIn", () => (curve.tangentsIn = [1, 2])],
    ["points", () => (spline.points = [1, 2])],
    ["net", () => (surface.net = [1])],
  ] as const) {
    assert.throws(set, (error) => error instanceof ExplineError && error.op === op && error.arg === op, op);
  }
});
