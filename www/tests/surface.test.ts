import assert from "node:assert/strict";
import { before, test } from "node:test";
import init, { initSpline, initSurface } from "expline/slim";
import { objSize, surfaceObj } from "../src/kernel/surface/surface-files.ts";
import { emptySurface, sameNetPoint, type SurfaceDocument } from "../src/document/surface/surface.ts";
import { createEditor } from "../src/editor/create-editor.ts";
import type { Editor } from "../src/editor/editor.ts";
import { fittingDistance, projector, stepAlong, stepInView, type Orbit } from "../src/editor/surface/orbit.ts";
import { chooseNet, ensureSurface, nudgeNet, openSurfaceSample, refineHere, setNetSize, setSurfaceLevels } from "../src/editor/surface/surface-edits.ts";
import { meshOf, netPoints, triangles, trianglesOf } from "../src/kernel/surface/surface-mesh.ts";
import { largestDistance, recurrence } from "../src/kernel/surface/surface-net.ts";
import { ridgesOf } from "../src/kernel/surface/surface-weights.ts";
import { deviationOf } from "../src/kernel/surface/surface-truth.ts";
import { meshPoints } from "../src/kernel/surface/surface.ts";

before(() => Promise.all([init(), initSpline(), initSurface()]));

function opened(sample: string): Editor {
  let time = 0;
  // Two edits of these tests are never one quick run.
  const editor = createEditor(() => { time += 1000; return time; });
  editor.patch({ mode: "surface" });
  openSurfaceSample(editor, sample);
  editor.surfaceEdits.forget();
  return editor;
}

const surface = (editor: Editor): SurfaceDocument => editor.state.value.surface;
const stage = { left: 0, top: 0, width: 900, height: 700 };
const orbit: Orbit = { yaw: 0.7, pitch: 0.4, distance: 6, target: [0.1, -0.2, 0.3] };

test("a step in the view moves a point by the pixels that were asked for", () => {
  const at = [0.4, 0.5, -0.3] as const;
  const from = projector(orbit, stage)(at);
  const step = stepInView(orbit, stage, at, 37, -21);
  const to = projector(orbit, stage)([at[0] + step[0], at[1] + step[1], at[2] + step[2]]);
  // The step is parallel to the screen, so depth and with it the scale stay.
  assert.ok(Math.abs(to.x - from.x - 37) < 1e-9 && Math.abs(to.y - from.y + 21) < 1e-9 && Math.abs(to.depth - from.depth) < 1e-12);
});

test("a step along an axis stays on the axis and goes with the pointer", () => {
  const at = [0.4, 0.5, -0.3] as const;
  const step = stepAlong(orbit, stage, at, [0, 0, 1], 0, -40);
  assert.ok(step[0] === 0 && step[1] === 0 && step[2] > 0);
});

test("the whole of a ball is on the stage at the distance that fits it", () => {
  const ball = { center: [1, 2, 3] as const, radius: 2 };
  for (const box of [stage, { ...stage, width: 320 }]) {
    const project = projector({ ...orbit, target: ball.center, distance: fittingDistance(ball, box) }, box);
    for (let k = 0; k < 200; k += 1) {
      const [a, b] = [k * 0.9, Math.acos(1 - (2 * (k + 0.5)) / 200)];
      const place = project([1 + 2 * Math.cos(a) * Math.sin(b), 2 + 2 * Math.sin(a) * Math.sin(b), 3 + 2 * Math.cos(b)]);
      assert.ok(place.x >= 0 && place.x <= box.width && place.y >= 0 && place.y <= box.height);
    }
  }
});

test("what the generators span goes on by the recurrence of their roots", () => {
  const step = 0.37;
  const factors = recurrence([{ re: 0, im: 0 }, { re: 0, im: step }, { re: 0, im: -step }]);
  const at = (k: number): number => 2 - 0.5 * Math.cos(step * k) + 3 * Math.sin(step * k);
  const next = factors.reduce((sum, factor, j) => sum + factor * at(6 - j), 0);
  assert.ok(Math.abs(next - at(7)) < 1e-13);
});

for (const sample of ["surf-sphere", "surf-torus", "surf-cylinder"]) {
  test(`${sample} keeps its shape on other nets and at other levels`, () => {
    const editor = opened(sample);
    setNetSize(editor, "u", 11);
    setNetSize(editor, "v", 7);
    assert.ok((deviationOf(surface(editor)) ?? 1) < 1e-13);
    const before = surface(editor);
    setSurfaceLevels(editor, 2, 1);
    assert.ok(largestDistance(before, surface(editor)) < 1e-13);
    assert.equal(surface(editor).levelU, 2);
    setSurfaceLevels(editor, 0, 0);
    assert.equal(surface(editor), before);
    editor.undo();
    assert.equal(surface(editor).levelU, 2);
  });
}

test("a pole is taken hold of once, and the mirrored rows behind it not at all", () => {
  const editor = opened("surf-sphere");
  const points = netPoints(surface(editor));
  const poles = points.filter(({ at }) => Math.hypot(at[0], at[1]) < 1e-12);
  assert.equal(poles.length, 2);
  assert.ok(points.every(({ at }) => Math.abs(Math.hypot(...at) - 1) < 1e-12));
});

test("a finer edit is projected away only when it is asked for twice, and the move is said", () => {
  const editor = opened("surf-torus");
  setSurfaceLevels(editor, 1, 1);
  const [point] = netPoints(surface(editor));
  assert.ok(point !== undefined);
  chooseNet(editor, [point.ref]);
  nudgeNet(editor, 10, 0);
  const edited = surface(editor);
  setSurfaceLevels(editor, 0, 0);
  assert.equal(surface(editor), edited);
  assert.match(editor.notices.value?.kind === "toast" ? editor.notices.value.text : "", /would move the surface/);
  setSurfaceLevels(editor, 0, 0);
  assert.equal(surface(editor).levelU, 0);
});

test("refining a place keeps the surface to the last bit and is one step of the history", () => {
  const editor = opened("surf-torus");
  const before = meshPoints(surface(editor), 40, 40);
  const [, point] = netPoints(surface(editor));
  assert.ok(point !== undefined);
  chooseNet(editor, [point.ref]);
  refineHere(editor);
  assert.equal(surface(editor).details?.length, 1);
  assert.deepEqual(meshPoints(surface(editor), 40, 40), before);
  assert.deepEqual(editor.state.value.chosen, [point.ref], "what was chosen is so still, to be worked on");
  assert.ok(netPoints(surface(editor)).some(({ ref }) => sameNetPoint(ref, point.ref)));
  editor.undo();
  assert.equal(surface(editor).details, undefined);
});

test("a surface that no library could draw gives way to its sample, and says so", () => {
  const editor = createEditor(() => 0);
  const direction = { roots: [{ re: 1, im: 1 }, { re: 0, im: 0 }, { re: 0, im: 0 }], count: 2, closed: true };
  const net = [0, 1].flatMap((u) => [0, 1].map((v) => ({ u, v, x: u, y: v, z: 0 })));
  const broken: SurfaceDocument = { ...emptySurface, net, u: direction, v: direction };
  editor.setState({ ...editor.getState(), mode: "surface", surface: broken });
  ensureSurface(editor);
  assert.equal(surface(editor).sample, "surf-torus");
  assert.ok(surface(editor).net.length > 4);
  assert.equal(editor.notices.value?.kind, "error");
});

for (const sample of ["surf-sphere", "surf-torus", "surf-paraboloid", "surf-cylinder", "surf-character"]) {
  test(`${sample}: a mesh in which only what moved is made anew has the bits of one made from nothing`, () => {
    const editor = opened(sample);
    const [first] = netPoints(surface(editor));
    assert.ok(first !== undefined);
    chooseNet(editor, [first.ref]);
    refineHere(editor);
    const points = netPoints(surface(editor));
    for (const chosen of [[points[0]], [points.at(-1)], [points[Math.floor(points.length / 2)], points[1]]]) {
      chooseNet(editor, chosen.flatMap((point) => point?.ref ?? []));
      meshOf(surface(editor), 12, false);
      nudgeNet(editor, 0.1, -0.07);
      const moved = meshOf(surface(editor), 12, false);
      // A copy of the document has no past.
      const fresh = meshOf(structuredClone(surface(editor)), 12, false);
      assert.deepEqual(moved, fresh);
    }
  });
}

test("the generators of a control point are 1 at its own place, 0 at every other on the surface, and the same along both lines", () => {
  for (const [sample, u, v] of [["surf-torus", 2, 5], ["surf-sphere", 3, 3], ["surf-character", 4, 6]] as const) {
    const document = surface(opened(sample));
    const ridges = ridgesOf(document, { u, v });
    assert.equal(ridges.length, 2);
    const own = netPoints(document).find(({ ref }) => ref.u === u && ref.v === v);
    assert.ok(own !== undefined);
    for (const [k, { weights, places }] of ridges.entries()) {
      const parameter = own.parameter[k] ?? 0;
      const perUnit = (weights.length - 1) / (meshOf(document, 4, false)?.size[k] ?? 1);
      weights.forEach((weight, i) => {
        if (i % perUnit !== 0) return;
        const at = i / perUnit;
        const period = (k === 0 ? document.u : document.v)?.closed === true ? (weights.length - 1) / perUnit : Infinity;
        const expected = Math.abs(at - parameter) < 1e-9 || Math.abs(Math.abs(at - parameter) - period) < 1e-9 ? 1 : 0;
        assert.ok(Math.abs(weight - expected) < 1e-9, `${sample} ${k} at ${at}: ${weight}`);
        if (expected === 1) assert.ok(Math.hypot(...own.at.map((value, c) => value - (places[3 * i + c] ?? 0))) < 1e-9);
      });
      assert.ok(weights.some((weight) => weight > 0.3 && weight < 0.7), "it acts between its neighbours, too");
    }
  }
});

test("the triangles that the status counts are those that are drawn, also where a tessellation would be too fine", () => {
  for (const sample of ["surf-torus", "surf-cylinder", "surf-sphere"]) {
    const document = surface(opened(sample));
    for (const sides of [4, 16, 20, 64]) {
      const mesh = meshOf(document, sides, false);
      assert.ok(mesh !== null);
      assert.equal(trianglesOf(document, sides), triangles(mesh.rows, mesh.cols).length / 3);
    }
  }
  assert.equal(trianglesOf(emptySurface, 16), 0);
});

test("the size of an OBJ file is said before it is written, to a twentieth", () => {
  for (const sample of ["surf-torus", "surf-sphere", "surf-character"]) {
    const document = surface(opened(sample));
    for (const sides of [2, 3, 16, 40, 64]) {
      const [said, written] = [objSize(document, sides), surfaceObj(document, sides).length];
      assert.ok(Math.abs(said / written - 1) < 0.05, `${sample}, ${sides}: ${said} of ${written}`);
    }
  }
});
