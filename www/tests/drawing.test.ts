import assert from "node:assert/strict";
import { test } from "node:test";
import { replaceContour } from "../src/document/curve/commands.ts";
import { emptyCurve, type Contour } from "../src/document/document.ts";
import { addDrawing } from "../src/editor/curve/adding/drawing.ts";
import { contoursOfPath, Hand } from "./harness.ts";

/**
 * The pen among steps that are not its own: it goes on with the contour that it draws, wherever that is, and with no
 * other.
 */

const read = (d: string): Contour[] => contoursOfPath(d, emptyCurve.space);

/** Two places of the pen, in a drawing of open lines. */
function begun(lines: string): Hand {
  const hand = new Hand();
  if (lines !== "") addDrawing(hand.editor, "Import", { contours: read(lines) }, "replace");
  hand.editor.setSettings({ snap: false });
  hand.editor.patch({ tool: "pen" });
  return hand.click(300, 300).click(340, 300);
}

const places = ({ curve }: Hand): string[] => curve.contours.map(({ points }) => points.map(({ x, y }) => `${Math.round(x)},${Math.round(y)}`).join(" "));

test("a contour that is deleted before the one that is drawn does not put the pen on another", () => {
  const hand = begun("M0 0L50 0M0 50L50 50");
  hand.editor.dispatch({ name: "Delete", apply: (curve) => replaceContour(curve, 0) });
  hand.click(380, 340);
  assert.deepEqual(places(hand), ["0,50 50,50", "300,300 340,300 380,340"]);
  hand.editor.undo();
  hand.editor.undo();
  hand.click(380, 260);
  assert.deepEqual(places(hand), ["0,0 50,0", "0,50 50,50", "300,300 340,300 380,260"], "nor does its coming back");
});

test("where what was drawn is undone, an import in its place is not drawn on; redone, it goes on", () => {
  for (const imports of [true, false]) {
    const hand = begun("M0 0L50 0");
    hand.editor.undo();
    hand.editor.undo();
    if (imports) addDrawing(hand.editor, "Import", { contours: read("M0 90L50 90L90 90") }, "add");
    else hand.editor.redo();
    hand.click(300, 200);
    assert.deepEqual(places(hand).slice(1), imports ? ["0,90 50,90 90,90", "300,200"] : ["300,300 300,200"]);
  }
});

test("another drawing that is opened is not drawn on", () => {
  const hand = begun("");
  const { curve, ...rest } = hand.editor.getState();
  hand.editor.setState({ ...rest, curve: { ...curve, contours: read("M0 0L50 0L50 50L0 50") } });
  hand.click(300, 200);
  assert.deepEqual(places(hand), ["0,0 50,0 50,50 0,50", "300,200"]);
});

test("the contour that is drawn may be moved, as a whole and a point of it, and goes on from there", () => {
  const hand = begun("");
  hand.run("nudge-down");
  hand.run("select-all");
  hand.run("nudge-right");
  hand.click(380, 340);
  assert.deepEqual(places(hand), ["301,300 341,301 380,340"]);
});
