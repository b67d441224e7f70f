import assert from "node:assert/strict";
import { before, test } from "node:test";
import init from "expline/slim";
import { FileError, parseState, writeState } from "../src/document/file/file.ts";
import { emptyCurve, type Contour, type CurveDocument } from "../src/document/document.ts";
import { createEditor } from "../src/editor/create-editor.ts";
import { clearCurve, loadCurve } from "../src/editor/curve/edits.ts";
import { addDrawing } from "../src/editor/curve/adding/drawing.ts";
import { openInCurve } from "../src/editor/curve/open-in-curve.ts";
import { curveOf } from "../src/kernel/curve/curve-cache.ts";
import { filled, filledTogether, type FilledShape } from "../src/kernel/paths/filling.ts";
import { contoursOfPath } from "./harness.ts";

before(() => init());

/** What is inside of a drawing, by turns counted around places, which no raster of the page's has a part in. */

const contoursOf = (d: string): readonly Contour[] => contoursOfPath(d, "trigonometric");
const shape = (d: string, rule: CanvasFillRule = "nonzero", fill: string | null = "black"): FilledShape => ({ contours: contoursOf(d), rule, fill });
const all = (shapes: readonly FilledShape[]): ReturnType<typeof filled> => filled(shapes, "trigonometric");

/** How often the closed contours go around a place. */
function turnsAround(contours: readonly Contour[], x: number, y: number): number {
  let turns = 0;
  for (const contour of contours.filter(({ closed }) => closed)) {
    const flat = curveOf({ ...emptyCurve, contours }, contour)?.flatten(1e-3) ?? new Float64Array(0);
    let [around, before] = [0, Math.atan2((flat.at(-1) ?? 0) - y, (flat.at(-2) ?? 0) - x)];
    for (let i = 0; i + 1 < flat.length; i += 2) {
      const angle = Math.atan2((flat[i + 1] ?? 0) - y, (flat[i] ?? 0) - x);
      around += Math.atan2(Math.sin(angle - before), Math.cos(angle - before));
      before = angle;
    }
    turns += Math.round(around / (2 * Math.PI));
  }
  return turns;
}

function isInk({ contours, filling }: Pick<CurveDocument, "contours" | "filling">, x: number, y: number): boolean {
  const turns = turnsAround(contours, x, y);
  return filling === "none" ? false : filling === "nonzero" ? turns !== 0 : turns % 2 !== 0;
}

/** Squares of 10 units, clockwise on the screen and the other way round. */
const square = (x: number, y: number, size = 10): string => `M${x} ${y}h${size}v${size}h${-size}z`;
const backwards = (x: number, y: number, size = 10): string => `M${x} ${y}v${size}h${size}v${-size}z`;

test("a shape that overlaps itself is filled by the rule that it has, and even-odd stays where both show the same", () => {
  const two = square(0, 0) + square(5, 5);
  assert.ok(isInk(all([shape(two)]), 7, 7), "SVG's own rule fills it");
  assert.ok(!isInk(all([shape(two, "evenodd")]), 7, 7), "the other one leaves it out");
  const ring = square(0, 0, 30) + backwards(10, 10);
  for (const rule of ["nonzero", "evenodd"] as const) {
    const drawing = all([shape(ring, rule)]);
    assert.equal(drawing.filling, undefined, "a hole that runs backwards is one by both");
    assert.ok(!isInk(drawing, 15, 15) && isInk(drawing, 5, 5));
  }
  assert.deepEqual(all([shape(ring)]).contours, contoursOf(ring), "and nothing is turned");
});

test("a hole that runs the same way is one by even-odd, and ink by the winding number", () => {
  const disc = square(0, 0, 30) + square(10, 10);
  assert.ok(isInk(all([shape(disc, "nonzero")]), 15, 15));
  assert.ok(!isInk(all([shape(disc, "evenodd")]), 15, 15));
});

test("two shapes of one ink are one area where they overlap, whichever way they run and by whatever rule they are filled", () => {
  const ringed = square(20, 20, 30) + square(30, 30);
  for (const first of [square(0, 0, 25), backwards(0, 0, 25)]) {
    for (const rule of ["nonzero", "evenodd"] as const) {
      const drawing = all([shape(first), shape(ringed, "evenodd"), shape(square(100, 0), rule)]);
      assert.ok(isInk(drawing, 22, 22), "where they overlap");
      assert.ok(isInk(drawing, 5, 5) && isInk(drawing, 45, 45) && isInk(drawing, 105, 5), "where they do not");
      assert.ok(!isInk(drawing, 35, 35), "the hole of the shape with the other rule");
      assert.equal(drawing.contours.length, 4);
    }
  }
});

test("a shape of another colour on a shape is a hole in its ink", () => {
  const drawing = all([shape(square(0, 0, 30)), shape(square(10, 10), "nonzero", "#fff")]);
  assert.ok(!isInk(drawing, 15, 15) && isInk(drawing, 5, 5));
});

test("what is only stroked has no area, and says so beside what has one", () => {
  const alone = all([shape(square(0, 0), "nonzero", null)]);
  assert.deepEqual([alone.filling, alone.contours[0]?.ink], ["none", undefined]);
  const both = all([shape(square(0, 0, 30), "nonzero", null), shape(square(20, 0) + square(25, 5))]);
  assert.deepEqual(both.contours.map(({ ink }) => ink), ["none", undefined, undefined]);
  assert.equal(both.filling, "nonzero", "the line around has no part in the rule");
});

test("each colour is filled by itself: what lies on another makes no hole in it, and needs no rule", () => {
  const on = (fill: string, d: string): FilledShape => ({ ...shape(d, "nonzero", fill), ink: fill });
  const drawing = all([on("#111111", square(0, 0, 30)), on("#ee0000", square(10, 10)), on("#111111", square(12, 12, 5))]);
  assert.deepEqual([drawing.filling, drawing.contours.map(({ ink }) => ink)], [undefined, ["#111111", "#ee0000", "#111111"]]);
  const overlapping = all([on("#111111", square(0, 0, 30)), on("#ee0000", square(10, 10)), on("#ee0000", backwards(15, 15))]);
  const red = overlapping.contours.slice(1);
  assert.ok(isInk({ ...overlapping, contours: red }, 17, 17), "where two of one colour overlap");
});

test("lines that come to areas, and areas that come to lines, stay what they were", () => {
  const lines = { ...emptyCurve, ...all([shape(square(0, 0), "nonzero", null)]) };
  const areas = { ...emptyCurve, ...all([{ ...shape(square(5, 5)), ink: "#336699" }]) };
  for (const [before, added, inks] of [[lines, areas, ["none", "#336699"]], [areas, lines, ["#336699", "none"]]] as const) {
    const both = filledTogether(before, added);
    assert.deepEqual([both.filling, both.contours.map(({ ink }) => ink)], [undefined, inks]);
  }
  assert.deepEqual(filledTogether(lines, lines).filling, "none");
});

test("a pentagram is filled as SVG fills it, and a circle of two arcs needs no rule", () => {
  assert.ok(isInk(all([shape("M50 0L79 90L2 35L98 35L21 90Z")]), 50, 50));
  assert.equal(all([shape("M0 10a10 10 0 1 0 20 0a10 10 0 1 0 -20 0z")]).filling, undefined);
});

const overlapping = (): ReturnType<typeof filled> => all([shape(square(0, 0) + square(5, 5))]);

test("a drawing keeps how it is filled through files, edits and undo, and loses it with its contours", () => {
  const editor = createEditor(() => 0);
  const filling = (): unknown => editor.state.value.curve.filling;
  addDrawing(editor, "Import", overlapping(), "replace");
  assert.equal(filling(), "nonzero");
  const { state } = parseState(writeState(editor.getState()));
  assert.deepEqual(state.curve, editor.state.value.curve);
  addDrawing(editor, "Import", all([shape(square(50, 0))]), "replace");
  assert.equal(filling(), undefined, "what takes its place has its own");
  editor.undo();
  assert.equal(filling(), "nonzero");
  clearCurve(editor);
  assert.equal(filling(), undefined);
  editor.undo();
  openInCurve(editor, "Edit", { contours: contoursOf(square(0, 0)) }, () => "");
  assert.equal(filling(), undefined);
  editor.undo();
  assert.equal(filling(), "nonzero");
  loadCurve(editor, "Open", emptyCurve);
  assert.equal(filling(), undefined);
});

test("a file from before has none, and what is no way of filling is refused with its place", () => {
  const state = createEditor(() => 0).getState();
  assert.equal("filling" in parseState(writeState(state)).state.curve, false);
  const strange = JSON.stringify({ ...state, curve: { ...state.curve, filling: "evenodd!" } });
  assert.throws(() => parseState(strange), (error: unknown) => error instanceof FileError && error.code === "E_SCHEMA" && error.message.includes("$.curve.filling"));
});

test("a drawing that is added to another keeps its look, and the other one does too", () => {
  const ring = all([shape(square(100, 0, 30) + square(110, 10), "evenodd")]);
  for (const [first, second] of [[ring, overlapping()], [overlapping(), ring]] as const) {
    const editor = createEditor(() => 0);
    addDrawing(editor, "Import", first, "replace");
    addDrawing(editor, "Import", second, "add");
    const { curve, selection } = editor.state.value;
    assert.ok(isInk(curve, 7, 7) && isInk(curve, 105, 5));
    assert.ok(!isInk(curve, 115, 15), "its hole stays one");
    assert.equal(selection.points.every(({ contour }) => contour >= 2), true, "what was added is chosen");
    editor.undo();
    assert.deepEqual(editor.state.value.curve.contours, first.contours);
  }
});
