import assert from "node:assert/strict";
import { before, test } from "node:test";
import { parsePath } from "expline/slim";
import { rectangleIn } from "../src/document/curve/drawing/shapes.ts";
import type { Contour } from "../src/document/document.ts";
import { parseState } from "../src/document/file/file.ts";
import { writeState } from "../src/document/file/write.ts";
import { cornerGrips } from "../src/editor/curve/corners/grips.ts";
import { hasSharp, radiusOf } from "../src/editor/curve/corners/chosen.ts";
import { roundCorners } from "../src/editor/curve/corners/rounding.ts";
import { setFamily } from "../src/editor/curve/family-edits.ts";
import { rounding } from "../src/editor/curve/on-demand.ts";
import { hitTest } from "../src/editor/pointer/hit-test.ts";
import { hintFor } from "../src/editor/hint.ts";
import { readShareHash, shareLink } from "../src/io/link/share.ts";
import { hermiteOf } from "../src/kernel/curve/curve-cache.ts";
import { writePath } from "../src/kernel/paths/export.ts";
import { Hand, contoursOfPath, handOf, largestDistance } from "./harness.ts";

/** Rounding corners in the editor: what is chosen, what is said, and how the history has it. */

before(() => rounding.load());

const rectangle = rectangleIn({ minX: 100, minY: 50, maxX: 300, maxY: 150 });

function choose(hand: Hand, ...refs: readonly (readonly [contour: number, index: number])[]): Hand {
  hand.editor.patch({ selection: { points: refs.map(([contour, index]) => ({ contour, index })), handle: null } });
  return hand;
}

const radius = (hand: Hand): number | null => radiusOf(hand.editor.state.value);
const hint = (hand: Hand): string => hintFor(hand.editor.state.value);
const near = (actual: number | null, expected: number): void => assert.ok(actual !== null && Math.abs(actual - expected) <= 1e-9 * (1 + expected), `${actual} is not ${expected}`);

/** Each corner as [x, y, radius] of its arc's centre, from path data alone. */
function arcsOf(hand: Hand): string[] {
  const d = writePath(hand.curve, { segments: "arcs", tolerance: 1e-6, decimals: 6, relative: false });
  return [...d.matchAll(/A?(-?[\d.]+)[ ,](-?[\d.]+)[ ,]0[ ,]?0[ ,]?[01]/gu)].map(([, a, b]) => `${a} ${b}`);
}

test("Round corners gives all that is chosen one radius, in one step that undo takes back", () => {
  const hand = handOf([rectangle]).run("select-all");
  const start = hand.curve;
  hand.run("round-corners");
  assert.equal(hint(hand), "4 corners rounded, radius 20.");
  near(radius(hand), 20);
  assert.equal(hand.selected.length, 8, "the whole contour stays selected");
  const after = hand.curve;
  hand.run("undo");
  assert.deepEqual(hand.curve, start);
  assert.equal(radius(hand), 0);
  assert.doesNotMatch(hint(hand), /rounded/u, "what was said goes with what was done");
  hand.run("redo");
  assert.deepEqual(hand.curve, after);
  near(radius(hand), 20);
});

test("one corner, or some of several contours, and afterwards the ends of their arcs are selected", () => {
  const hand = choose(handOf([rectangle, contoursOfPath("M400 0L500 0L500 100")[0] as Contour]), [0, 1], [1, 1]);
  roundCorners(hand.editor, 15);
  assert.deepEqual(hand.selected, ["0:1", "0:2", "1:1", "1:2"]);
  assert.deepEqual(arcsOf(hand), ["15 15", "15 15"]);
  near(radius(hand), 15);
  choose(hand, [0, 1]);
  near(radius(hand), 15);
  assert.equal(hasSharp(hand.editor.state.value), false);
});

test("a radius that there is no room for is limited, and that is said", () => {
  const hand = handOf([rectangle]).run("select-all");
  roundCorners(hand.editor, 400);
  assert.equal(hint(hand), "4 corners rounded, radius 50; there is no room for more.");
  near(radius(hand), 50);
  const kite = choose(handOf(contoursOfPath("M0 0L100 0L110 40L0 300Z")), [0, 0], [0, 1], [0, 2]);
  roundCorners(kite.editor, 30);
  assert.match(hint(kite), /^3 corners rounded, radii from [\d.]+ to 30; \d of them (?:has|have) no room for 30\.$/u);
});

test("the radius of round corners can be changed again, down from as round as they can be, and 0 makes them sharp", () => {
  const square = rectangleIn({ minX: 0, minY: 0, maxX: 100, maxY: 100 });
  const hand = handOf([square]).run("select-all");
  const start = hand.curve;
  for (const asked of [10, 70, 25]) {
    roundCorners(hand.editor, asked);
    near(radius(hand), Math.min(asked, 50));
  }
  assert.deepEqual(arcsOf(hand), ["25 25", "25 25", "25 25", "25 25"]);
  roundCorners(hand.editor, 0);
  assert.deepEqual(hand.curve, start);
});

test("arcs between lines are corners to whoever opens the file; those between curves know their radius while they are as they were made", () => {
  const hand = handOf([rectangle]).run("select-all");
  roundCorners(hand.editor, 20);
  const opened = handOf(parseState(writeState(hand.editor.getState())).state.curve.contours).run("select-all");
  near(radius(opened), 20);
  roundCorners(opened.editor, 30);
  assert.deepEqual(arcsOf(opened), ["30 30", "30 30", "30 30", "30 30"]);
  roundCorners(opened.editor, 0);
  assert.equal(opened.curve.contours[0]?.points.length, 4);
  assert.ok(largestDistance(opened.sample(400), handOf([rectangle]).sample(400)) < 1e-9, "the old rectangle");

  const heart = choose(new Hand("heart"), [0, 3]);
  const start = heart.curve;
  roundCorners(heart.editor, 50);
  roundCorners(heart.editor, 20);
  near(radius(heart), 20);
  const once = choose(new Hand("heart"), [0, 3]);
  roundCorners(once.editor, 20);
  assert.deepEqual(heart.curve.contours, once.curve.contours, "as if it had been 20 at once");
  roundCorners(heart.editor, 0);
  assert.deepEqual(heart.curve.contours, start.contours);
});

test("files, links and paths keep the arcs: to the last bit, and as arcs of the radius", async () => {
  const hand = handOf([rectangle]).run("select-all");
  roundCorners(hand.editor, 20);
  const state = hand.editor.getState();
  assert.deepEqual(parseState(writeState(state)).state.curve, state.curve);
  assert.deepEqual((await readShareHash((await shareLink(state)).hash)).curve, state.curve);
  const d = writePath(hand.curve, { segments: "arcs", tolerance: 0.02, decimals: 4, relative: false });
  assert.equal(d.replace(/\s+/gu, " "), "M100 70A20 20 0 0 1 120 50H280A20 20 0 0 1 300 70V130A20 20 0 0 1 280 150H120A20 20 0 0 1 100 130Z");
  const [back] = parsePath(d);
  assert.ok(back && Math.abs(back.area() - (200 * 100 - (4 - Math.PI) * 400)) < 1e-6, "its area is the rectangle's without four corners");
});

test("moved and turned it keeps its radius; a circle, an ellipse and smooth points have no corners", () => {
  const hand = handOf([rectangle]).run("select-all");
  roundCorners(hand.editor, 20);
  hand.run("turn-right").run("nudge-right-far").run("flip-across");
  near(radius(hand), 20);
  for (const sample of ["circle-2", "circle-8", "blob-16", "sine"]) assert.equal(radius(new Hand(sample).run("select-all")), null, sample);
  hand.run("select-none");
  assert.equal(radius(hand), null);
  const ends = choose(handOf(contoursOfPath("M0 0L100 0L100 100")), [0, 0], [0, 2]);
  assert.equal(radius(ends), null, "open ends are no corners");
});

test("what cannot be rounded is refused with its reason, and nothing changes", () => {
  const refusal = (hand: Hand): string => {
    const start = hand.curve;
    hand.run("round-corners");
    assert.equal(hand.curve, start);
    assert.equal(hand.editor.state.value.canUndo, false);
    return hint(hand);
  };
  assert.equal(refusal(choose(handOf(contoursOfPath("M0 0L100 0L0 0.5")), [0, 1])), "The sides of this corner lie on each other, and no circle fits between them.");
  assert.equal(refusal(choose(new Hand("circle-8"), [0, 1])), "Select a corner: a point where the direction changes.");
  const bow = new Hand("heart");
  bow.editor.dispatch({ name: "Space", apply: (curve) => ({ ...curve, space: "hyperbolic", omega: 1 }) });
  bow.editor.setState(bow.editor.getState(), { fresh: true });
  assert.equal(refusal(choose(bow, [0, 3])), "Arcs are trigonometric, and this contour has hyperbolic curves.");
  const round = handOf([rectangle]).run("select-all");
  roundCorners(round.editor, 20);
  const before = round.curve;
  round.run("round-corners");
  assert.equal(round.curve, before);
  assert.match(hint(round), /are round/u);
  for (const odd of [NaN, -5, -Infinity]) {
    roundCorners(round.editor, odd);
    assert.equal(round.curve, before, String(odd));
  }
  const through = choose(new Hand("heart"), [0, 3]);
  setFamily(through.editor, "interpolating");
  assert.equal(radius(choose(through, [0, 3])), null);
});

test("Round corners leaves alone what is round, and the bowl of an R, which never had corners", () => {
  const hand = new Hand("glyph").run("select-all");
  assert.equal(radius(hand), 0);
  hand.run("round-corners");
  assert.equal(hint(hand), "9 corners rounded, radius 5.");
  near(radius(hand), 5);
  const mixed = choose(handOf([rectangle]), [0, 0]);
  roundCorners(mixed.editor, 30);
  mixed.run("select-all");
  assert.ok(Number.isNaN(radius(mixed)), "several radii");
  mixed.run("round-corners");
  assert.deepEqual(arcsOf(mixed).sort(), ["20 20", "20 20", "20 20", "30 30"]);
});

test("a corner that was rounded on a finer level stays where it is when the level goes down again", () => {
  const hand = new Hand("heart").run("level-up");
  const tip = hand.curve.contours[0]?.points.findIndex(({ y }) => y === 448) ?? -1;
  choose(hand, [0, tip]);
  roundCorners(hand.editor, 20);
  const [points, outline] = [hand.curve.contours[0]?.points.length ?? 0, hand.sample(4000)];
  hand.run("level-down");
  const lower = hand.curve.contours[0];
  assert.ok(lower && lower.points.length < points);
  const curve = hermiteOf(hand.curve, lower);
  for (let i = 0; i < outline.length; i += 2) assert.ok((curve?.nearest(outline[i] ?? 0, outline[i + 1] ?? 0).distance ?? 1) < 1e-9);
});

test("steps typed one after the other are one entry of the history", () => {
  const hand = handOf([rectangle]).run("select-all");
  const start = hand.curve;
  hand.wait();
  for (const asked of [1, 2, 3]) roundCorners(hand.editor, asked, "corner-radius");
  near(radius(hand), 3);
  hand.run("undo");
  assert.deepEqual(hand.curve, start);
});

test("a grip inside of each chosen corner rounds them all; Escape leaves them as they were, and letting go is one entry", async () => {
  const hand = handOf([rectangle]).run("select-all");
  while (hand.editor.loading.size > 0) await Promise.all(hand.editor.loading);
  const grips = cornerGrips(hand.editor.state.value);
  assert.equal(grips.length, 4);
  const start = hand.curve;
  const at = { x: 100 + 24 * Math.SQRT1_2, y: 50 + 24 * Math.SQRT1_2 };
  hand.wait().moveTo(at.x, at.y).press();
  hand.moveTo(at.x + 5, at.y + 5).moveTo(at.x + 18, at.y + 18);
  assert.equal(hint(hand), "radius 18", "the centre goes with the pointer");
  hand.input.cancel();
  hand.release();
  assert.equal(hand.curve, start);
  hand.drag(at, 18, 18);
  near(radius(hand), 18);
  assert.deepEqual(arcsOf(hand), ["18 18", "18 18", "18 18", "18 18"]);
  const [grip] = cornerGrips(hand.editor.state.value);
  assert.ok(grip);
  hand.drag({ x: 118 + 0.2 * Math.SQRT1_2, y: 68 }, 200, 200);
  near(radius(hand), 50);
  hand.run("undo").run("undo");
  assert.deepEqual(hand.curve, start);
  hand.editor.patch({ view: { ...hand.editor.state.value.view, zoom: 0.05 } });
  assert.equal(cornerGrips(hand.editor.state.value).length, 0, "where there is no room for them there are none");
});

test("no handle of a sharp corner is pressed in place of its grip", async () => {
  for (const kind of ["mouse", "touch"] as const) {
    const hand = choose(new Hand("heart"), [0, 0]);
    hand.editor.patch({ touch: kind === "touch" });
    while (hand.editor.loading.size > 0) await Promise.all(hand.editor.loading);
    const [grip] = cornerGrips(hand.editor.state.value);
    assert.ok(grip);
    assert.equal(hitTest(hand.editor.state.value, grip.screen, kind).kind, "empty");
  }
});

test("many corners are rounded at once, of those between curves as many as do not stop the page", () => {
  const waves = Array.from({ length: 200 }, (_, i) => `Q${20 * i + 10} 40 ${20 * (i + 1)} 0`).join("");
  const hand = handOf(contoursOfPath(`M0 0${waves}`)).run("select-all");
  roundCorners(hand.editor, 2);
  assert.equal(hand.curve.contours[0]?.points.length, 201 + 199);
  const more = handOf(contoursOfPath(`M0 0${Array.from({ length: 600 }, (_, i) => `Q${20 * i + 10} 40 ${20 * (i + 1)} 0`).join("")}`)).run("select-all");
  roundCorners(more.editor, 2);
  assert.match(hint(more), /at most 500 corners/u);
  const zigzag = handOf(contoursOfPath(`M0 0${Array.from({ length: 4000 }, (_, i) => `L${20 * (i + 1)} ${30 * ((i + 1) % 2)}`).join("")}`)).run("select-all");
  roundCorners(zigzag.editor, 2);
  assert.equal(zigzag.curve.contours[0]?.points.length, 4001 + 3999);
});
