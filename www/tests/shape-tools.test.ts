import assert from "node:assert/strict";
import { test } from "node:test";
import { pointAt, type Contour, type CurveDocument } from "../src/document/document.ts";
import { actionFor } from "../src/editor/actions/keymap.ts";
import { setFamily } from "../src/editor/curve/family-edits.ts";
import { framing, shaping } from "../src/editor/curve/on-demand.ts";
import { hintFor } from "../src/editor/hint.ts";
import { openSample } from "../src/editor/route.ts";
import { toScreen } from "../src/editor/pointer/camera.ts";
import { openState } from "../src/panels/files/report.ts";
import { writePath } from "../src/kernel/paths/export.ts";
import { measureCurve } from "../src/kernel/curve/measuring/measure.ts";
import { Hand, contoursOfPath, handOf, spread, touch } from "./harness.ts";

/** Ellipses and rectangles drawn with their tools, through pointers and keys alone. */

type Shape = "ellipse" | "rectangle";

const exact = { segments: "arcs", tolerance: 0.02, decimals: 3, relative: false } as const;

/** A hand with the tool, once it has come. */
async function holding(shape: Shape, hand = handOf([])): Promise<Hand> {
  hand.run(`tool-${shape}`);
  while (hand.editor.loading.size > 0) await Promise.all(hand.editor.loading);
  return hand;
}

/** The box of all points, which for ellipses are in the middle of its sides. */
function boxOf({ points }: Contour): readonly number[] {
  const [x, y] = [points.map((point) => point.x), points.map((point) => point.y)];
  return [Math.min(...x), Math.min(...y), Math.max(...x), Math.max(...y)];
}

function last(hand: Hand): Contour {
  const contour = hand.curve.contours.at(-1);
  assert.ok(contour, "something is drawn");
  return contour;
}

/** How far samples are from the equation of the ellipse in a box, relative to its radii. */
function ellipseError(samples: Float64Array, [left, top, right, bottom]: readonly number[] | [number, number, number, number]): number {
  const [x, y] = [((left ?? 0) + (right ?? 0)) / 2, ((top ?? 0) + (bottom ?? 0)) / 2];
  const [rx, ry] = [((right ?? 0) - (left ?? 0)) / 2, ((bottom ?? 0) - (top ?? 0)) / 2];
  let worst = 0;
  for (let i = 0; i < samples.length; i += 2) {
    worst = Math.max(worst, Math.abs((((samples[i] ?? 0) - x) / rx) ** 2 + (((samples[i + 1] ?? 0) - y) / ry) ** 2 - 1));
  }
  return worst;
}

/** How many arcs a path has, and nothing else: a command's letter is written once for several of them. */
function arcsIn(d: string): number {
  const [, numbers] = /^M[^A-Z]+A([^A-Z]+)Z$/u.exec(d) ?? [];
  return (numbers?.match(/-?\d*\.?\d+(?:e[+-]?\d+)?/gu)?.length ?? 0) / 7;
}

/** From corner to corner of the box 100, 150 … 340, 310. */
const corners = [[100, 150, 240, 160], [340, 310, -240, -160], [340, 150, -240, 160], [100, 310, 240, -160]] as const;

test("a drag from corner to corner draws the exact ellipse in that box, whichever corners they are", async () => {
  const drawn = [];
  for (const [x, y, dx, dy] of corners) {
    const hand = await holding("ellipse");
    hand.drag({ x, y }, dx, dy);
    assert.deepEqual(boxOf(last(hand)), [100, 150, 340, 310]);
    // A hundred roundings of numbers near 1.
    assert.ok(ellipseError(hand.sample(1000), [100, 150, 340, 310]) < 1e-13);
    assert.ok((measureCurve(hand.curve).modelError ?? 1) < 1e-14, "and the status says so");
    drawn.push(last(hand));
  }
  for (const contour of drawn) assert.deepEqual(contour, drawn[0], "nor does anything else depend on them");
});

test("an ellipse goes out as two arcs, a rectangle as lines, to the last decimal", async () => {
  const [round, straight] = [await holding("ellipse"), await holding("rectangle")];
  for (const hand of [round, straight]) hand.drag({ x: 100, y: 150 }, 240, 160);
  assert.equal(writePath(round.curve, exact), "M340 230A120 80 0 0 1 100 230 120 80 0 0 1 340 230Z");
  assert.equal(writePath(straight.curve, exact), "M100 150H340V310H100Z");
});

test("a rectangle has four lines and four corners, and a dragged corner leaves lines", async () => {
  const hand = await holding("rectangle");
  hand.drag({ x: 100, y: 150 }, 240, 160);
  assert.deepEqual(last(hand).points.map(({ x, y, kind }) => [x, y, kind]), [[100, 150, "cusp"], [340, 150, "cusp"], [340, 310, "cusp"], [100, 310, "cusp"]]);
  hand.run("tool-select").click(700, 550).drag({ x: 340, y: 310 }, 20, 30);
  assert.equal(writePath(hand.curve, exact), "M100 150H340L360 340 100 310Z");
});

test("Shift makes sides equal, Alt begins in the middle, and both count at once and no longer than they are held", async () => {
  for (const shape of ["ellipse", "rectangle"] as const) {
    const hand = await holding(shape);
    hand.wait().moveTo(400, 300).press().moveTo(500, 340).moveTo(520, 250);
    const shown = (): readonly number[] => boxOf(last(hand));
    assert.deepEqual(shown(), [400, 250, 520, 300]);
    hand.keys({ shift: true });
    assert.deepEqual(shown(), [400, 180, 520, 300], "the longer side counts");
    hand.keys({ shift: true, alt: true });
    assert.deepEqual(shown(), [280, 180, 520, 420]);
    hand.keys({ alt: true });
    assert.deepEqual(shown(), [280, 250, 520, 350]);
    hand.keys({});
    assert.deepEqual(shown(), [400, 250, 520, 300]);
    hand.release();
    assert.deepEqual(shown(), [400, 250, 520, 300]);
  }
});

test("Space moves what is being drawn, and the drag goes on from there", async () => {
  const hand = await holding("rectangle");
  hand.wait().moveTo(100, 100).press().moveTo(200, 150);
  hand.input.space(true);
  hand.moveTo(230, 190).moveTo(240, 200);
  assert.deepEqual(boxOf(last(hand)), [140, 150, 240, 200]);
  hand.input.space(false);
  hand.moveTo(300, 260).release();
  assert.deepEqual(boxOf(last(hand)), [140, 150, 300, 260]);
  assert.equal(hand.editor.state.value.space, false);
});

test("a drag is one entry of the history and chooses what it drew; the tool stays up", async () => {
  const hand = await holding("ellipse", new Hand("heart"));
  const { curve } = hand;
  hand.drag({ x: 100, y: 100 }, 60, 40);
  assert.deepEqual(hand.selected, ["1:0", "1:1", "1:2", "1:3"]);
  assert.deepEqual(hand.curve.contours.slice(0, 1), curve.contours, "the others are as they were");
  assert.equal(hand.editor.state.value.undoName, "Ellipse");
  assert.equal(hand.editor.state.value.tool, "ellipse");
  const drawn = hand.curve;
  hand.run("undo");
  assert.equal(hand.curve, curve);
  assert.equal(hand.editor.state.value.canUndo, false);
  hand.run("redo");
  assert.equal(hand.curve, drawn);
});

test("Escape leaves all as it was: drawing, selection and history", async () => {
  const hand = await holding("rectangle", new Hand("heart"));
  hand.editor.patch({ selection: { points: [{ contour: 0, index: 2 }], handle: null } });
  const { curve } = hand;
  hand.wait().moveTo(100, 100).press().moveTo(200, 150);
  assert.equal(hand.curve.contours.length, 2, "it is seen while it is drawn");
  assert.equal(hand.input.cancel(), true);
  hand.moveTo(300, 200).release();
  assert.equal(hand.curve, curve);
  assert.deepEqual(hand.selected, ["0:2"]);
  assert.equal(hand.editor.state.value.canUndo, false);
  assert.equal(hand.editor.state.value.drag, null);
});

test("the size is said while it changes and when it is drawn; who has no keys is told of none", async () => {
  for (const kind of ["mouse", "touch"] as const) {
    const hand = await holding("ellipse");
    const now = (): string => hintFor(hand.editor.state.value);
    hand.kind = kind;
    hand.editor.patch({ touch: kind === "touch", hint: "" });
    const told = [now()];
    hand.wait().moveTo(100, 100).press().moveTo(220, 180);
    assert.match(now(), /^120 × 80\b/u);
    told.push(now());
    hand.release();
    assert.match(now(), /^Ellipse, 120 × 80\./u);
    told.push(now());
    hand.run("undo");
    assert.equal(now(), told[0], "what was undone is not spoken of");
    hand.wait().moveTo(100, 100).press().moveTo(220, 180);
    hand.input.cancel();
    assert.equal(now(), told[0], "nor is what was given up");
    if (kind === "touch") for (const text of told) assert.doesNotMatch(text, /click|shift|\balt\b|enter\b|press v/iu);
    else assert.match(told[0] ?? "", /Shift for a circle.*Alt from the centre.*Enter/u);
    hand.run("tool-rectangle");
    assert.match(now(), /square/u);
    hand.run("tool-select");
    assert.doesNotMatch(now(), /corner to corner/u);
  }
});

test("a click makes a circle of a round size around it, a second click on it no other, and a wheel makes it suit the view", async () => {
  const hand = await holding("ellipse");
  hand.doubleClick(300, 200);
  assert.deepEqual(hand.curve.contours.map(boxOf), [[250, 150, 350, 250]]);
  hand.editor.patch({ view: { ...hand.editor.state.value.view, zoom: 0.25 } });
  hand.click(700, 800);
  assert.deepEqual(boxOf(last(hand)), [450, 550, 950, 1050]);
});

test("Enter makes one in the middle of what is seen, and once more beside it", async () => {
  const hand = await holding("rectangle");
  hand.editor.patch({ view: { zoom: 1, x: 123.4, y: -56.7 } });
  const enter = async (): Promise<void> => {
    assert.equal(hand.input.finish(), false);
    // With points chosen, too.
    assert.equal(actionFor(hand.editor, "Enter")?.id, "place-shape");
    hand.run("place-shape");
    while (hand.editor.loading.size > 0) await Promise.all(hand.editor.loading);
  };
  await enter();
  assert.deepEqual(boxOf(last(hand)), [73, -107, 173, -7]);
  assert.deepEqual(hand.selected.length, 4);
  await enter();
  await enter();
  assert.deepEqual(hand.curve.contours.map((contour) => boxOf(contour)[0]), [73, 93, 113]);
  hand.run("tool-select");
  assert.equal(actionFor(hand.editor, "Enter")?.id, "insert", "as it does with other tools");
});

test("corners snap to points and to the grid, Shift's squares too, and Ctrl lets go of both", async () => {
  const hand = await holding("rectangle", new Hand("heart"));
  const target = hand.point(3);
  hand.editor.setSettings({ snap: true });
  hand.wait().moveTo(100, 100).press().moveTo(target.x + 3, target.y - 2);
  assert.deepEqual(boxOf(last(hand)), [100, 100, target.x, target.y]);
  assert.match(hintFor(hand.editor.state.value), /snapped on point 4/u);
  hand.keys({ mod: true });
  assert.deepEqual(boxOf(last(hand)), [100, 100, target.x + 3, target.y - 2]);
  hand.keys({}).input.cancel();
  hand.release().run("clear");
  hand.editor.setOverlay("grid", true);
  hand.drag({ x: 103, y: 98 }, 61, 44);
  assert.deepEqual(boxOf(last(hand)), [100, 100, 160, 140]);
  hand.run("clear").keys({ shift: true }).drag({ x: 103, y: 98 }, 61, 44).keys({});
  assert.deepEqual(boxOf(last(hand)), [100, 100, 160, 160]);
});

test("what has no height is no shape: nothing is drawn, and it is said", async () => {
  const hand = await holding("ellipse");
  hand.drag({ x: 100, y: 100 }, 80, 0);
  assert.deepEqual(hand.curve.contours, []);
  assert.equal(hand.editor.state.value.canUndo, false);
  assert.match(hintFor(hand.editor.state.value), /no height/u);
});

test("in every space, at every frequency and in small and large drawings it is an ellipse", async () => {
  for (const space of ["trigonometric", "hyperbolic", "polynomial"] as const) {
    for (const omega of ["auto", 0.7] as const) {
      for (const zoom of [1, 1e-5, 1e5]) {
        const hand = await holding("ellipse");
        hand.editor.dispatch({ name: "Settings", apply: (curve): CurveDocument => ({ ...curve, space, omega }) });
        hand.editor.patch({ view: { zoom, x: 0, y: 0 } });
        hand.drag({ x: -120 / zoom, y: -80 / zoom }, 240 / zoom, 160 / zoom);
        const box = [-120 / zoom, -80 / zoom, 120 / zoom, 80 / zoom];
        assert.ok(ellipseError(hand.sample(500), box) < 1e-12, `${space}, ${omega}, ${zoom}`);
        const d = writePath(hand.curve, { ...exact, tolerance: 0.02 / zoom, decimals: zoom > 1 ? 9 : 3 });
        assert.equal(arcsIn(d), 2, d);
      }
    }
  }
});

test("as an interpolating contour an ellipse that was drawn is the same ellipse", async () => {
  const hand = await holding("ellipse", new Hand("blob-16"));
  hand.drag({ x: 100, y: 150 }, 240, 160);
  assert.equal(last(hand).family, "hermite", "as what the pen draws");
  setFamily(hand.editor, "interpolating");
  assert.deepEqual(hand.curve.contours.map(({ family }) => family), ["interpolating", "interpolating"]);
  assert.ok(ellipseError(hand.sample(1000, 1), [100, 150, 340, 310]) < 1e-12);
  assert.equal(hand.curve.contours[0], new Hand("blob-16").curve.contours[0], "the one that was there is as it was");
});

/** Whether a place is filled, by the path that Export writes and the rule that goes with it: a polygon of the path. */
function isFilled(hand: Hand, x: number, y: number): boolean {
  const around = hand.curve.contours.reduce((sum, _, c) => {
    const [places, step] = [hand.sample(2000, c), 2];
    let turn = 0;
    for (let i = 0; i < places.length; i += step) {
      const [ax, ay] = [(places[i] ?? 0) - x, (places[i + 1] ?? 0) - y];
      const [bx, by] = [(places[(i + step) % places.length] ?? 0) - x, (places[(i + step + 1) % places.length] ?? 0) - y];
      turn += Math.atan2(ax * by - ay * bx, ax * bx + ay * by);
    }
    return sum + Math.round(turn / (2 * Math.PI));
  }, 0);
  return hand.curve.filling === "nonzero" ? around !== 0 : around % 2 !== 0;
}

for (const way of ["clockwise", "counterclockwise"] as const) {
  test(`in a drawing that the winding number fills, a shape within another is a hole, and one that laps over it one with it: ${way}`, async () => {
    const [plate] = contoursOfPath(way === "clockwise" ? "M100 100H500V400H100Z" : "M100 100V400H500V100Z");
    assert.ok(plate);
    for (const shape of ["ellipse", "rectangle"] as const) {
      const hand = await holding(shape, handOf([plate]));
      hand.editor.dispatch({ name: "", apply: (curve) => ({ ...curve, filling: "nonzero" }) });
      hand.drag({ x: 200, y: 150 }, 80, 80);
      assert.ok(!isFilled(hand, 240, 190) && isFilled(hand, 300, 300), "a hole");
      assert.match(hintFor(hand.editor.state.value), /cut out\. Reverse in its menu fills it/u);
      hand.drag({ x: 220, y: 170 }, 40, 40);
      assert.ok(isFilled(hand, 240, 190) && !isFilled(hand, 210, 190), "a mark in the hole");
      hand.drag({ x: 450, y: 300 }, 100, 80);
      assert.ok(isFilled(hand, 470, 340) && isFilled(hand, 530, 340) && isFilled(hand, 460, 310), "one shape");
      assert.doesNotMatch(hintFor(hand.editor.state.value), /Reverse/u);
      hand.drag({ x: 475, y: 335 }, 12, 12);
      assert.ok(isFilled(hand, 481, 341), "what two cover");
      assert.doesNotMatch(hintFor(hand.editor.state.value), /cut out/u, "is not said to be cut");
      hand.click(390, 210);
      assert.ok(!isFilled(hand, 390, 210), "a click's, too");
    }
  });
}

test("who clears a sample and draws has the comparison that explains the sample no longer, and can ask for it", async () => {
  const hand = new Hand();
  openSample(hand.editor, "circle-2");
  const compares = (): boolean => hand.editor.state.value.settings.overlays.bezier;
  assert.ok(compares());
  (await holding("ellipse", hand.run("clear"))).drag({ x: 100, y: 100 }, 80, 60);
  assert.ok(!compares());
  assert.ok((hand.run("overlay-bezier"), compares()));

  // The page has begun with the sample when what was kept comes back.
  const next = new Hand();
  openSample(next.editor, "circle-2");
  const landing = next.editor.getState();
  const shell = { editor: next.editor } as Parameters<typeof openState>[0];
  assert.ok(openState(shell, hand.editor.getState(), true));
  assert.ok(!next.editor.state.value.settings.overlays.bezier);
  assert.ok(openState(shell, landing, true));
  assert.ok(next.editor.state.value.settings.overlays.bezier, "a fresh start is the lesson again");
});

test("frames, levels, points and other families take an ellipse that was drawn like every other contour", async () => {
  await framing.load();
  await shaping.load();
  const hand = await holding("ellipse");
  hand.drag({ x: 100, y: 150 }, 240, 160).run("tool-select").run("turn-right").run("level-up").run("level-up").run("level-down").run("level-down");
  assert.equal(arcsIn(writePath(hand.curve, exact)), 2);
  // A point of four leaves the opposite half of the ellipse where it was.
  const before = hand.sample(400);
  const moved = pointAt(hand.curve, { contour: 0, index: 0 });
  assert.ok(moved);
  hand.click(790, 20).drag(moved, 30, 10);
  const after = hand.sample(400);
  for (let i = 200; i < 600; i += 1) assert.ok(Math.abs((after[i] ?? 0) - (before[i] ?? 1)) < 1e-9, "a quarter to three quarters of the way round");
});

test("drawn within a closed shape it is a hole, as a file's contours are", async () => {
  const hand = await holding("rectangle");
  hand.drag({ x: 100, y: 100 }, 300, 200).run("tool-ellipse").drag({ x: 200, y: 150 }, 100, 100);
  assert.equal(hand.curve.filling, undefined, "even-odd");
  assert.equal(hand.curve.contours.length, 2);
});

test("one finger draws; a second that comes at once draws nothing, and pinches", async () => {
  const hand = await holding("ellipse");
  const { input, editor } = hand;
  const at = toScreen(editor.state.value.view, editor.state.value.stage, { x: 100, y: 150 });
  input.down(touch(1, at.x, at.y, 0));
  input.move(touch(1, at.x + 240, at.y + 160, 400));
  input.flush();
  assert.deepEqual(editor.state.value.sketch.finger, { x: 340, y: 310 }, "the loupe shows what it hides");
  input.up(touch(1, at.x + 240, at.y + 160, 500));
  assert.deepEqual(boxOf(last(hand)), [100, 150, 340, 310]);
  const { curve, view } = editor.state.value;
  spread(input, 2000);
  for (const id of [1, 2]) input.up(touch(id, 300, 300, 2400));
  assert.equal(editor.state.value.curve, curve);
  assert.ok(editor.state.value.view.zoom > 2.5 * view.zoom);
});
