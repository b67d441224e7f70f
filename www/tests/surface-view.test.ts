import assert from "node:assert/strict";
import { before, test } from "node:test";
import init, { initSpline, initSurface } from "expline/slim";
import { actionFor } from "../src/editor/actions/keymap.ts";
import { createEditor } from "../src/editor/create-editor.ts";
import type { Editor } from "../src/editor/editor.ts";
import { frameOf, projector, type Vector } from "../src/editor/surface/orbit.ts";
import { chooseNet, openSurfaceSample, turnView } from "../src/editor/surface/surface-edits.ts";
import { registerSurfaceActions } from "../src/editor/surface/surface-actions.ts";
import { surfaceView } from "../src/editor/surface/surface-view.ts";

before(() => Promise.all([init(), initSpline(), initSurface()]));

const stage = { left: 0, top: 0, width: 900, height: 700 };

function looking(sample: string): Editor {
  const editor = createEditor(() => 0);
  editor.patch({ mode: "surface", stage });
  openSurfaceSample(editor, sample);
  editor.surfaceEdits.forget();
  return editor;
}

function pressed(editor: Editor, key: string): void {
  const action = actionFor(editor, key);
  assert.ok(action !== undefined, `${key} does something`);
  editor.actions.run(action.id);
}

const eyeOf = (editor: Editor): Vector => frameOf(editor.state.value.solid.orbit).eye;

/** Where the line of sight through a place of the stage meets the sphere of radius 1 first. */
function onSphere(editor: Editor, x: number, y: number): Vector {
  const { eye, right, up, back } = frameOf(editor.state.value.solid.orbit);
  const scale = stage.height / (2 * Math.tan((16 * Math.PI) / 180));
  const [a, b] = [(x - stage.width / 2) / scale, (stage.height / 2 - y) / scale];
  const along = [0, 1, 2].map((k) => a * right[k]! + b * up[k]! - back[k]!);
  const dot = (p: readonly number[], q: readonly number[]): number => p[0]! * q[0]! + p[1]! * q[1]! + p[2]! * q[2]!;
  const [aa, ab, bb] = [dot(along, along), dot(along, eye), dot(eye, eye) - 1];
  const t = (-ab - Math.sqrt(ab * ab - aa * bb)) / aa;
  return [eye[0] + t * along[0]!, eye[1] + t * along[1]!, eye[2] + t * along[2]!];
}

test("zooming at a place of the surface leaves it under the pointer and never leads through it", () => {
  const editor = looking("surf-sphere");
  const view = surfaceView(editor);
  const at = { x: 610, y: 240 };
  const place = onSphere(editor, at.x, at.y);
  for (let notch = 0; notch < 40; notch += 1) view.zoom(1.1, at);
  const { x, y } = projector(editor.state.value.solid.orbit, stage)(place);
  // The mesh that is met is a little nearer or farther than the sphere, along the line of sight alone: unseen.
  assert.ok(Math.hypot(x - at.x, y - at.y) < 1e-6, `${x}, ${y}`);
  assert.ok(Math.abs(view.zoomNow - 20) < 1e-9, "as near as in every mode");
  assert.ok(Math.hypot(...eyeOf(editor)) > 1, "outside");
});

test("buttons and keys zoom at what is in the middle, and do not lead through it either", () => {
  const editor = looking("surf-sphere");
  const view = surfaceView(editor);
  for (let press = 0; press < 20; press += 1) view.zoom(1.25, null);
  assert.ok(Math.hypot(...eyeOf(editor)) > 1);
  view.fit();
  view.zoomTo(20);
  assert.ok(Math.hypot(...eyeOf(editor)) > 1);
  assert.ok(Math.abs(view.zoomNow - 20) < 1e-9);
});

test("zooming in and out at one place, on the surface and beside it, is as if nothing had been", () => {
  for (const at of [{ x: 500, y: 300 }, { x: 20, y: 30 }]) {
    const editor = looking("surf-sphere");
    const view = surfaceView(editor);
    const before = projector(editor.state.value.solid.orbit, stage)([0.3, 0.2, 0.1]);
    for (const factor of [1.1, 1.1, 1.1, 1 / 1.1, 1 / 1.1, 1 / 1.1]) view.zoom(factor, at);
    const after = projector(editor.state.value.solid.orbit, stage)([0.3, 0.2, 0.1]);
    // The place that is met again is found with the single precision of a mesh.
    assert.ok(Math.hypot(after.x - before.x, after.y - before.y) < 0.01);
  }
});

test("what two fingers take hold of follows them as they spread and move", () => {
  const editor = looking("surf-sphere");
  const place = onSphere(editor, 400, 300);
  const pinch = surfaceView(editor).pinch({ x: 350, y: 300 }, { x: 450, y: 300 });
  editor.patch(pinch.update({ x: 330, y: 300 }, { x: 470, y: 300 }));
  editor.patch(pinch.update({ x: 400, y: 360 }, { x: 600, y: 360 }));
  const { x, y } = projector(editor.state.value.solid.orbit, stage)(place);
  // Seen from nearer, a place that is a hair off the mesh moves by a hair less or more.
  assert.ok(Math.hypot(x - 500, y - 360) < 0.5, `${x}, ${y}`);
});

test("arrows turn the view while nothing is selected, Alt finely, Shift pans; with a point selected they move it", () => {
  const editor = looking("surf-torus");
  editor.modes.set("surface", { label: "Surface", tool: {} as never, view: surfaceView(editor) });
  registerSurfaceActions(editor, () => false);
  const { surface, solid: { orbit } } = editor.state.value;
  const degrees = (angle: number): number => (angle * 180) / Math.PI;
  pressed(editor, "ArrowLeft");
  pressed(editor, "ArrowUp");
  pressed(editor, "Alt+ArrowUp");
  const turned = editor.state.value.solid.orbit;
  assert.ok(Math.abs(degrees(turned.yaw - orbit.yaw) - 15) < 1e-9, "what faces the eye goes left");
  assert.ok(Math.abs(degrees(turned.pitch - orbit.pitch) + 16) < 1e-9, "and up");
  assert.deepEqual(turned.target, orbit.target);
  const middle = (): number => projector(editor.state.value.solid.orbit, stage)(orbit.target).x;
  const before = middle();
  pressed(editor, "Shift+ArrowRight");
  assert.ok(Math.abs(middle() - before - 40) < 1e-9);
  assert.equal(editor.state.value.surface, surface, "nothing of it is an edit");
  assert.equal(editor.state.value.canUndo, false);
  chooseNet(editor, [{ u: 0, v: 0 }]);
  const looked = editor.state.value.solid.orbit;
  pressed(editor, "ArrowUp");
  assert.notEqual(editor.state.value.surface, surface);
  assert.deepEqual(editor.state.value.solid.orbit, looked);
});

test("where one looks from is said when no hand has turned the view", () => {
  const editor = looking("surf-torus");
  const said: string[] = [];
  editor.notices.subscribe((notice) => notice !== null && "text" in notice && said.push(notice.text));
  for (let i = 0; i < 4; i += 1) turnView(editor, 0, -15);
  assert.match(said.at(-1) ?? "", /^Seen from 52 degrees around, 28 degrees below$/u);
  for (let i = 0; i < 30; i += 1) turnView(editor, 0, 15);
  assert.match(said.at(-1) ?? "", /90 degrees above$/u);
});
