import assert from "node:assert/strict";
import { before } from "node:test";
import init, { initSpline, initSurface, parsePath } from "expline/slim";
import type { Contour, ControlPoint, CurveDocument, Space } from "../src/document/document.ts";
import { curveSample } from "../src/document/curve/samples.ts";
import { toScreen } from "../src/editor/pointer/camera.ts";
import { createEditor } from "../src/editor/create-editor.ts";
import { loadCurve } from "../src/editor/curve/edits.ts";
import { levelling, renewing } from "../src/editor/curve/on-demand.ts";
import type { Editor, Modifiers } from "../src/editor/editor.ts";
import type { PointerKind } from "../src/editor/pointer/hit-test.ts";
import { createPointerInput, type PointerInput } from "../src/editor/pointer/pointer-input.ts";
import type { PointerRecord } from "../src/editor/pointer/pointer-record.ts";
import { registerStandardActions } from "../src/editor/actions/standard-actions.ts";
import { contourFrom } from "../src/kernel/curve/points/contours.ts";
import { samplePoints } from "../src/kernel/curve/samples.ts";
import { createPenTool } from "../src/tools/pen/pen-tool.ts";
import { createTools } from "../src/tools/tools.ts";

// In Node the engine finds itself; the page tells it where the bundler has put it.
before(() => Promise.all([init(), initSpline(), initSurface(), renewing.load(), levelling.load()]));

/** Contours of a path's `d`, as the library reads it. */
export function contoursOfPath(d: string, space: Space = "trigonometric"): Contour[] {
  return parsePath(d).map((curve) => contourFrom(curve, space));
}

/** The editor without a browser: pointers and keys in, documents out. Places are in document units. */
export class Hand {
  readonly editor: Editor;
  readonly input: PointerInput;
  held: Modifiers = { shift: false, alt: false, mod: false };
  kind: PointerKind = "mouse";
  time = 0;
  #at = { x: 0, y: 0 };

  constructor(sample?: string) {
    this.editor = createEditor(() => this.time);
    registerStandardActions(this.editor);
    this.input = createPointerInput(this.editor, createTools(this.editor, new AbortController().signal, createPenTool(this.editor)));
    if (sample === undefined) return;
    const found = curveSample(sample);
    assert.ok(found, `no sample named ${sample}`);
    loadCurve(this.editor, "Open", found.curve);
    this.editor.setState(this.editor.getState(), { fresh: true });
    // Tests that drag say where to, to the last digit.
    this.editor.setSettings({ snap: false });
  }

  get curve(): CurveDocument {
    return this.editor.state.value.curve;
  }

  point(index: number, contour = 0): ControlPoint {
    const point = this.curve.contours[contour]?.points[index];
    assert.ok(point, `no point ${contour}:${index}`);
    return point;
  }

  get selected(): string[] {
    return this.editor.state.value.selection.points.map((ref) => `${ref.contour}:${ref.index}`);
  }

  /** Interleaved points of a contour. */
  sample(count: number, contour = 0): Float64Array {
    const shape = this.curve.contours[contour];
    assert.ok(shape, `no contour ${contour}`);
    return samplePoints(this.curve, shape, count);
  }

  #record(button = 0, id = 1): Parameters<PointerInput["down"]>[0] {
    const { view, stage } = this.editor.state.value;
    return { id, kind: this.kind, button, screen: toScreen(view, stage, this.#at), modifiers: this.held, time: this.time };
  }

  /** Time passes; two presses further apart than this are not a double-click. */
  wait(milliseconds = 1000): this {
    this.time += milliseconds;
    return this;
  }

  moveTo(x: number, y: number): this {
    this.#at = { x, y };
    this.input.move(this.#record());
    this.input.flush();
    return this;
  }

  press(): this {
    this.input.down(this.#record());
    return this;
  }

  release(): this {
    this.input.up(this.#record());
    return this;
  }

  keys(held: Partial<Modifiers>): this {
    this.held = { shift: false, alt: false, mod: false, ...held };
    this.input.modifiers(this.held);
    return this;
  }

  click(x: number, y: number): this {
    return this.wait().moveTo(x, y).press().release();
  }

  doubleClick(x: number, y: number): this {
    this.click(x, y);
    this.time += 80;
    return this.press().release();
  }

  /** From one place by a step, in a few moves, as a hand does. */
  drag(from: { x: number; y: number }, dx: number, dy: number): this {
    this.wait().moveTo(from.x, from.y).press();
    for (const part of [0.2, 0.5, 0.8, 1]) this.moveTo(from.x + dx * part, from.y + dy * part);
    return this.release();
  }

  /** The end of a handle. */
  handle(index: number, side: "in" | "out", contour = 0): { x: number; y: number } {
    const point = this.point(index, contour);
    return { x: point.x + point[side].dx, y: point.y + point[side].dy };
  }

  run(action: string): this {
    this.wait();
    this.editor.actions.run(action);
    return this;
  }
}

/** The largest distance between two samplings of one length. */
export function largestDistance(a: Float64Array, b: Float64Array): number {
  assert.equal(a.length, b.length);
  let worst = 0;
  for (let i = 0; i < a.length; i += 2) worst = Math.max(worst, Math.hypot((a[i] ?? 0) - (b[i] ?? 0), (a[i + 1] ?? 0) - (b[i + 1] ?? 0)));
  return worst;
}

/** A closed curve of many points, with waves and a cusp here and there. */
export function longContour(count: number): Contour {
  const step = (2 * Math.PI) / count;
  const place = (t: number): readonly [number, number] => {
    const radius = 250 + 30 * Math.sin(11 * t);
    return [400 + radius * Math.cos(t), 300 + radius * Math.sin(t)];
  };
  const points = Array.from({ length: count }, (_, i): ControlPoint => {
    const [[x, y], [x0, y0], [x1, y1]] = [place(i * step), place((i - 0.5) * step), place((i + 0.5) * step)];
    const out = { dx: (x1 - x0) / 3, dy: (y1 - y0) / 3 };
    const isCusp = i % 50 === 17;
    return { x, y, kind: isCusp ? "cusp" : "symmetric", in: { dx: -out.dx, dy: -out.dy }, out: isCusp ? { dx: 1.25 * out.dx, dy: 1.25 * out.dy } : out };
  });
  return { family: "hermite", closed: true, points, support: 1 };
}

/** An editor with these contours on its stage. */
export function handOf(contours: readonly Contour[]): Hand {
  const hand = new Hand();
  loadCurve(hand.editor, "Open", { space: "trigonometric", omega: "auto", level: 0, contours });
  hand.editor.setState(hand.editor.getState(), { fresh: true });
  hand.editor.setSettings({ snap: false });
  return hand;
}

/** What a finger says. */
export function touch(id: number, x: number, y: number, time: number): PointerRecord {
  return { id, kind: "touch", button: 0, screen: { x, y }, modifiers: { shift: false, alt: false, mod: false }, time };
}

/** Two fingers that begin 40 pixels from each other, at a time, and spread to three times that. */
export function spread(input: PointerInput, from: number): void {
  input.down(touch(1, 280, 300, from));
  input.down(touch(2, 320, 300, from + 40));
  for (let i = 1; i <= 10; i += 1) {
    input.move(touch(1, 280 - 4 * i, 300, from + 40 + 16 * i));
    input.move(touch(2, 320 + 4 * i, 300, from + 41 + 16 * i));
    input.flush();
  }
}
