// Rows about interpolating curves and about surfaces.

import { closedCubicFromBreakPoints, cubicPointAt } from "@thi.ng/geom-splines";
import { Vector3, Vector4 } from "three";
import { NURBSSurface } from "three/addons/curves/NURBSSurface.js";

import { SEGMENTS, points } from "./curve.mjs";
import { here } from "./harness.mjs";

// verb-nurbs asks for a window when it is loaded.
globalThis.window ??= globalThis;
const { default: verb } = await import("verb-nurbs");

const MANY = 1_000_000;
/** Some libraries take microseconds a point: they make fewer of them. */
const SOME = 16_384;
const pairs = Array.from({ length: SEGMENTS }, (_, i) => [points[2 * i], points[2 * i + 1]]);

/** How far a curve is from the 16 points that it should go through: `at(i)` is its point i. */
function missed(at) {
  let worst = 0;
  for (let i = 0; i < SEGMENTS; i++) {
    const [x, y] = at(i);
    worst = Math.max(worst, Math.hypot(x - pairs[i][0], y - pairs[i][1]));
  }
  return `through its points but for ${worst.toExponential(1)}`;
}

function interpolation({ expline, curve, interpolator }) {
  const ours = new expline.InterpolatingCurve({ points });
  const out = new Float64Array(2 * MANY);
  const at = (count) => (i) => out.subarray((2 * count * i) / SEGMENTS, (2 * count * i) / SEGMENTS + 2);
  const pieces = closedCubicFromBreakPoints(pairs, 1 / 3, true);
  // Open: a knot more, at the first point again.
  const spline = verb.geom.NurbsCurve.byPoints([...pairs, pairs[0]].map(([x, y]) => [x, y, 0]), 3);
  const byOne = (point) => () => {
    const place = [0, 0];
    for (let i = 0; i < SOME; i++) {
      const [x, y] = point((i * SEGMENTS) / SOME, place);
      out[2 * i] = x;
      out[2 * i + 1] = y;
    }
  };
  const row = (name, action, units, note) => ({ name, measure: here(action), units, note });
  return {
    unit: "point",
    contestants: [
      row("expline, 4 weights a point", () => ours.sample(MANY, { out }), MANY, () => missed(at(MANY))),
      row("expline's Hermite kernel, 4", () => curve.sample(MANY, { out }), MANY, () => missed(at(MANY))),
      row("curve-interpolator", byOne((t, place) => interpolator.getPointAtTime(t / SEGMENTS, place)), SOME, () => missed(at(SOME))),
      row("@thi.ng/geom-splines", byOne((t, place) => cubicPointAt(place, ...pieces[Math.floor(t)], t % 1)), SOME, () => missed(at(SOME))),
      // Its parameter follows the chords: what it misses cannot be told by t.
      row("verb-nurbs", byOne((t) => spline.point(t / SEGMENTS)), SOME, () => ""),
    ],
    targets: [["expline's Hermite kernel, 4", 1 / 1.5], ["curve-interpolator", 20], ["@thi.ng/geom-splines", 20], ["verb-nurbs", 100]],
  };
}

const RADIUS = 3;
const TUBE = 1;

/** Largest distance of vertices from the torus, and of normals from its own. */
function offTorus(positions, normals) {
  let off = 0;
  let turned = 0;
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = positions.subarray(i, i + 3);
    const rim = Math.hypot(x, y);
    off = Math.max(off, Math.abs(Math.hypot(rim - RADIUS, z) - TUBE));
    if (normals === undefined) continue;
    const expected = [(x * (1 - RADIUS / rim)) / TUBE, (y * (1 - RADIUS / rim)) / TUBE, z / TUBE];
    const sense = Math.sign(expected.reduce((sum, e, k) => sum + e * normals[i + k], 0));
    turned = Math.max(turned, Math.hypot(...expected.map((e, k) => e - sense * normals[i + k])));
  }
  return `off ${off.toExponential(1)}${normals === undefined ? ", no normals" : `, normals ${turned.toExponential(1)}`}`;
}

/** A circle as a rational quadratic: places and weights of its nine control points, and its knots. */
const CIRCLE = Array.from({ length: 9 }, (_, k) => {
  const angle = (k * Math.PI) / 4;
  const weight = k % 2 === 0 ? 1 : Math.SQRT1_2;
  return { x: Math.cos(angle) / weight, y: Math.sin(angle) / weight, weight };
});
const KNOTS = [0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1];

/** The torus as 9 × 9 control points. */
const NURBS = CIRCLE.map((u) =>
  CIRCLE.map((v) => {
    const rim = RADIUS + TUBE * v.x;
    return { x: rim * u.x, y: rim * u.y, z: TUBE * v.y, w: u.weight * v.weight };
  }),
);

function surface({ expline }) {
  const size = 256;
  const few = 64;
  const torus = expline.TensorSurface.torus(RADIUS, TUBE, [16, 16]);
  const mesh = torus.mesh(size, size);
  const positions = new Float64Array(3 * few * few);
  const normals = new Float64Array(3 * few * few);
  const each = (vertex) => () => {
    for (let i = 0; i < few; i++) for (let j = 0; j < few; j++) vertex(i / few, j / few, 3 * (few * i + j));
  };
  const three = new NURBSSurface(2, 2, KNOTS, KNOTS, NURBS.map((row) => row.map(({ x, y, z, w }) => new Vector4(x, y, z, w))));
  const nurbs = verb.geom.NurbsSurface.byKnotsControlPointsWeights(
    2,
    2,
    KNOTS,
    KNOTS,
    NURBS.map((row) => row.map(({ x, y, z }) => [x, y, z])),
    NURBS.map((row) => row.map(({ w }) => w)),
  );
  const place = new Vector3();
  return {
    unit: "vertex",
    contestants: [
      { name: "expline", measure: here(() => torus.mesh(size, size, { out: mesh })), units: size * size, note: () => offTorus(mesh.positions, mesh.normals) },
      {
        name: "three, NURBSSurface",
        measure: here(each((u, v, at) => {
          three.getPoint(u, v, place);
          place.toArray(positions, at);
        })),
        units: few * few,
        note: () => offTorus(positions),
      },
      {
        name: "verb-nurbs",
        measure: here(each((u, v, at) => {
          // All in one call: point, ∂u and ∂v.
          const [[point, byV], [byU]] = nurbs.derivatives(u, v, 1);
          positions.set(point, at);
          const normal = [byU[1] * byV[2] - byU[2] * byV[1], byU[2] * byV[0] - byU[0] * byV[2], byU[0] * byV[1] - byU[1] * byV[0]];
          const length = Math.hypot(...normal);
          for (let k = 0; k < 3; k++) normals[at + k] = normal[k] / length;
        })),
        units: few * few,
        note: () => offTorus(positions, normals),
      },
    ],
    targets: [["three, NURBSSurface", 20], ["verb-nurbs", 50]],
  };
}

function drag({ expline }) {
  const torus = expline.TensorSurface.torus(RADIUS, TUBE, [16, 16]);
  const part = torus.mesh(180, 180);
  const whole = torus.mesh(180, 180);
  let k = 0;
  const move = () => torus.setPoint(5, 5, 2 + 0.01 * (k++ % 7), 2, 1);
  const same = () => {
    torus.remesh(part, 5, 5);
    torus.mesh(180, 180, { out: whole });
    return part.positions.every((x, i) => x === whole.positions[i]) ? "the same bits" : "NOT the same";
  };
  const row = (name, action) => ({ name, measure: here(action), units: 1, note: same });
  return {
    unit: "move",
    contestants: [
      row("expline, the part it touches", () => (move(), torus.remesh(part, 5, 5))),
      row("expline, the whole mesh", () => (move(), torus.mesh(180, 180, { out: whole }))),
    ],
    targets: [["expline, the whole mesh", 4]],
  };
}

/** Titles and what makes the contestants. */
export const smoothRows = [
  ["interpolating curve, points one by one", interpolation],
  ["surface mesh with normals", surface],
  ["one point of 16 × 16 moved, 64 800 triangles", drag],
];
