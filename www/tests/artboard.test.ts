import assert from "node:assert/strict";
import { before, test } from "node:test";
import init from "expline/slim";
import { artboardOf, settingOf, sheetOf, type Artboard, type Box } from "../src/document/artboard.ts";
import { FileError, parseState, writeState } from "../src/document/file/file.ts";
import { emptyCurve, type DemoState } from "../src/document/document.ts";
import type { FitDocument } from "../src/document/fit/fit.ts";
import { createEditor } from "../src/editor/create-editor.ts";
import { addDrawing } from "../src/editor/curve/adding/drawing.ts";
import { clearCurve, loadCurve } from "../src/editor/curve/edits.ts";
import { bringStrokes, simplifyInFit } from "../src/editor/fit/bring.ts";
import { clearFit } from "../src/editor/fit/fit-edits.ts";
import { pngSize } from "../src/io/picture/png-size.ts";
import { writeSvg } from "../src/io/svg/svg-write.ts";
import { contoursOfPath } from "./harness.ts";

/** An icon goes out on the sheet that it came in on. */

before(() => init());

const icon: Artboard = { x: 0, y: 0, width: 24, height: 24 };
const box = (minX: number, minY: number, maxX: number, maxY: number): Box => ({ minX, minY, maxX, maxY });

function viewBoxOf(of: Box | null, artboard: Artboard | undefined, filled = true): number[] {
  const svg = writeSvg({ title: "", d: "M0 0H1V1Z", box: of, filled, ...(artboard === undefined ? {} : { artboard }) });
  const found = /viewBox="([^"]*)" width="([^"]*)" height="([^"]*)"/u.exec(svg);
  assert.ok(found !== null);
  const viewBox = (found[1] ?? "").split(" ").map(Number);
  assert.deepEqual(viewBox.slice(2), [Number(found[2]), Number(found[3])]);
  return viewBox;
}

test("a file's viewBox is the artboard, to the digit, wherever on it the drawing lies", () => {
  assert.deepEqual(viewBoxOf(box(3.2, 4, 20, 19.5), icon), [0, 0, 24, 24]);
  assert.deepEqual(viewBoxOf(box(3.2, 4, 20, 19.5), icon, false), [0, 0, 24, 24]);
  assert.deepEqual(viewBoxOf(box(-0.004, 0, 24.01, 24), icon), [0, 0, 24, 24], "nobody sees a thousandth of it");
  assert.deepEqual(viewBoxOf(box(-10, 5, 0, 6), { x: -12.5, y: 0.25, width: 100.125, height: 7 }), [-12.5, 0.25, 100.125, 7]);
  assert.deepEqual(viewBoxOf(box(3.2, 4, 20, 19.5), undefined), [3, 4, 17, 16], "without one it is the drawing's box");
  assert.deepEqual(viewBoxOf(null, icon), [0, 0, 24, 24]);
});

test("what was moved out of its artboard is in the viewBox all the same, with its line", () => {
  assert.deepEqual(viewBoxOf(box(-5.5, 4, 20, 30.2), icon), [-5.5, 0, 29.5, 30.2]);
  assert.deepEqual(viewBoxOf(box(2, -0.13, 20, 20), icon), [0, -0.2, 24, 24.2]);
  const [x = 0, y = 0, width = 0, height = 0] = viewBoxOf(box(0, 4, 24, 20), icon, false);
  // The line is 2 of 256 units wide, and reaches out of both sides.
  assert.ok(x < -0.09 && x + width > 24.09 && y === 0 && height === 24);
});

test("a picture shows the artboard and nothing around it, small ones as large as other pictures", () => {
  const size = (of: Box | null, artboard: Artboard | undefined, filled: boolean, scale = 1): unknown => pngSize({ box: of, filled, ...(artboard === undefined ? {} : { artboard }) }, scale);
  assert.deepEqual(size(box(3, 4, 20, 20), icon, true), { width: 256, height: 256 });
  assert.deepEqual(size(box(3, 4, 20, 20), icon, false, 4), { width: 1024, height: 1024 });
  assert.deepEqual(size(box(3, 4, 20, 20), { x: 0, y: 0, width: 512, height: 256 }, true, 2), { width: 1024, height: 512 });
  assert.deepEqual(size(box(0, 0, 512, 256), undefined, true), { width: 544, height: 288 }, "without one there is a margin");
  assert.deepEqual(size(box(-128, 0, 100, 100), { x: 0, y: 0, width: 256, height: 256 }, true), { width: 384, height: 256 });
  assert.deepEqual(size(box(0, 0, 4000, 3000), undefined, true), { width: 4032, height: 3032 });
  for (const units of [4065, 5e3, 51_500, 1e9]) {
    assert.deepEqual(size(box(0, 0, units, units), undefined, true), { width: 4096, height: 4096 }, `${units}: as large as browsers draw`);
    assert.deepEqual(size(null, { x: 0, y: 0, width: units, height: units / 2 }, true), { width: 4064, height: 2032 });
    assert.equal(size(null, { x: 0, y: 0, width: units, height: units / 2 }, true, 2), null, "and no larger");
  }
  for (const side of [7, 11, 13, 15, 20, 24, 48, 100, 255]) {
    assert.deepEqual(size(null, { x: 0, y: 0, width: side, height: side }, true), { width: 256, height: 256 }, `${side}: no pixel for a rounding`);
  }
});

test("an artboard comes with the drawing that begins, stays through what is added and undone, and goes with it", () => {
  const editor = createEditor(() => 0);
  const board = (): unknown => editor.state.value.curve.artboard;
  const drawing = { contours: contoursOfPath("M2 2H20V20Z", "trigonometric") };
  const other = { ...drawing, artboard: { x: 0, y: 0, width: 512, height: 512 } };
  addDrawing(editor, "Import", { ...drawing, artboard: icon }, "add");
  assert.deepEqual(board(), icon, "there was nothing before");
  addDrawing(editor, "Import", other, "add");
  assert.deepEqual(board(), icon, "what is added lies on it");
  assert.deepEqual(parseState(writeState(editor.getState())).state.curve, editor.state.value.curve);
  addDrawing(editor, "Import", other, "replace");
  assert.deepEqual(board(), other.artboard);
  addDrawing(editor, "Import", drawing, "replace");
  assert.equal(board(), undefined);
  addDrawing(editor, "Import", other, "add");
  assert.equal(board(), undefined, "a drawing without one gets none from what is added to it");
  for (let i = 0; i < 3; i += 1) editor.undo();
  assert.deepEqual(board(), icon);
  clearCurve(editor);
  assert.equal(board(), undefined);
  editor.undo();
  loadCurve(editor, "Open", emptyCurve);
  assert.equal(board(), undefined);
});

test("a sheet that no drawing could lie on is none, in a picture and in a file", () => {
  const of = (left: number, top: number, right: number, bottom: number): unknown => artboardOf({ left, top, right, bottom });
  assert.deepEqual(of(-1, 2, 3, 5), { x: -1, y: 2, width: 4, height: 3 });
  for (const strange of [of(0, 0, 1e12, 1e12), of(0, 0, 0, 5), of(0, 0, NaN, 5), of(5, 0, 3, 5)]) assert.equal(strange, null);
  const state: DemoState = createEditor(() => 0).getState();
  for (const artboard of [{ ...icon, width: 0 }, { ...icon, x: "0" }, { x: 0, y: 0, width: 5 }, [0, 0, 24, 24]]) {
    const text = JSON.stringify({ ...state, curve: { ...state.curve, artboard } });
    assert.throws(() => parseState(text), (error: unknown) => error instanceof FileError && error.message.includes("$.curve.artboard"), text);
  }
  assert.deepEqual(sheetOf(icon, null), box(0, 0, 24, 24));
});

test("a drawing that is simplified in Fit comes back with its artboard and its filling; what is drawn there has neither", () => {
  const editor = createEditor(() => 0);
  const drawing = { contours: contoursOfPath("M2 2H20V20ZM8 4H18V14Z", "trigonometric"), artboard: icon, filling: "nonzero" as const };
  addDrawing(editor, "Import", drawing, "replace");
  simplifyInFit(editor);
  const fit = (): FitDocument => editor.state.value.fit;
  assert.deepEqual(settingOf(fit()), { artboard: icon, filling: "nonzero" });
  assert.deepEqual(parseState(writeState(editor.getState())).state.fit, fit());
  bringStrokes(editor, { name: "Import", strokes: [{ places: [[0, 0], [5, 5], [9, 0]] }] });
  assert.deepEqual(settingOf(fit()), { artboard: icon, filling: "nonzero" }, "what comes to it lies on it");
  clearFit(editor);
  assert.deepEqual(settingOf(fit()), {});
  editor.undo();
  bringStrokes(editor, { name: "Import", strokes: [{ places: [[0, 0], [5, 5], [9, 0]] }], instead: "all" });
  assert.deepEqual(settingOf(fit()), {});
});
