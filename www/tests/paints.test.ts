import assert from "node:assert/strict";
import { test } from "node:test";
import { paintLayers } from "../src/document/paint-layers.ts";
import { curveSample } from "../src/document/curve/samples.ts";
import type { Contour, CurveDocument, Line } from "../src/document/document.ts";
import { emptied, fitDefaults, withoutDisc, withStrokes, type Pair } from "../src/document/fit/fit.ts";
import { FileError, parseState, writeState } from "../src/document/file/file.ts";
import { resample, setClosed } from "../src/editor/curve/contour-edits.ts";
import { loadCurve } from "../src/editor/curve/edits.ts";
import { refineCurveHere, setFamily } from "../src/editor/curve/family-edits.ts";
import { applyProposal, setLevel } from "../src/editor/curve/level-edits.ts";
import { subjectOf } from "../src/editor/fit/fit-question.ts";
import { pngPaths } from "../src/io/picture/png.ts";
import { inkOfFiles, writeSvg } from "../src/io/svg/svg-write.ts";
import { exportPath, writePath } from "../src/kernel/paths/export.ts";
import { inkedContours, outcomeOfKept } from "../src/kernel/trace/outcome.ts";
import { Hand, contoursOfPath, handOf } from "./harness.ts";

/** Areas in colours: what a traced picture is in Curve. */

const ink = "#2e7d5a";

function inked(sample: string, color: string | null = ink): CurveDocument {
  const curve = curveSample(sample)?.curve;
  assert.ok(curve !== undefined);
  const { sample: _name, ...rest } = curve;
  return { ...rest, contours: curve.contours.map((contour) => (color === null ? contour : { ...contour, ink: color })) };
}

const edits: readonly (readonly [string, (hand: Hand) => unknown])[] = [
  ...["insert", "delete", "delete-open", "duplicate", "reverse", "start-here", "cusp", "reset-handles", "turn-right", "grow", "flip-across", "nudge-left"].map(
    (id): [string, (hand: Hand) => unknown] => [id, (hand) => hand.run(id)],
  ),
  ["a level up and down", (hand) => {
    setLevel(hand.editor, 1);
    hand.drag(hand.point(1), 5, 5);
    setLevel(hand.editor, 0);
    applyProposal(hand.editor);
  }],
  ["opened, and its ends joined", (hand) => {
    setClosed(hand.editor, false);
    hand.editor.patch({ selection: { points: [0, 7].map((index) => ({ contour: 0, index })), handle: null } });
    hand.run("join");
  }],
  ["another number of points", (hand) => resample(hand.editor, 13)],
  ["a point that is dragged", (hand) => hand.drag(hand.point(0), 10, 20)],
  ["the other family, refined, and back", (hand) => {
    setFamily(hand.editor, "interpolating");
    hand.run("select-all");
    setLevel(hand.editor, 1);
    setLevel(hand.editor, 0);
    refineCurveHere(hand.editor);
    hand.editor.undo();
    setFamily(hand.editor, "hermite");
  }],
];

for (const [name, edit] of edits) {
  test(`a contour keeps its colour: ${name}`, async () => {
    const hand = new Hand();
    loadCurve(hand.editor, "Open", inked("circle-8"));
    hand.editor.setSettings({ snap: false });
    const before = hand.curve;
    hand.editor.patch({ selection: { points: [{ contour: 0, index: 3 }], handle: null } });
    edit(hand);
    await Promise.all(hand.editor.loading);
    assert.notEqual(hand.curve, before, "something was done");
    assert.ok(hand.curve.contours.length > 0);
    for (const contour of hand.curve.contours) assert.equal(contour.ink, ink);
    assert.deepEqual(parseState(writeState(hand.editor.getState())).state.curve, hand.curve);
  });
}

test("contours of one colour are one layer where they follow each other, the lowest first", () => {
  const contours = ["#111111", "#111111", "#eeeeee", "#111111", null].map((color): Contour | undefined => inked("heart", color).contours[0]);
  const curve: CurveDocument = { ...inked("heart"), contours: contours.flatMap((contour) => contour ?? []) };
  assert.deepEqual(paintLayers(curve).map((layer) => [layer.ink, layer.drawing.contours.length]), [["#111111", 2], ["#eeeeee", 1], ["#111111", 1], [undefined, 1]]);
  const plain = inked("heart", null);
  assert.deepEqual(paintLayers(plain), [{ drawing: plain }]);
});

test("a file and a picture have each layer in its colour, by the rule of the drawing", () => {
  const layers = [{ color: "#111111", d: "M0 0H9V9Z" }, { d: "M1 1H2V2Z" }];
  for (const filling of [undefined, "nonzero"] as const) {
    const how = { d: "", box: null, filled: true, layers, ...(filling === undefined ? {} : { filling }) };
    const svg = writeSvg({ title: "", ...how });
    const found = [...svg.matchAll(/<path d="([^"]+)" fill="([^"]+)"(?: fill-rule="(\w+)")?/gu)].map(([, d, color, rule = "nonzero"]) => ({ d, fill: { color, alpha: 1, rule } }));
    assert.deepEqual(found.map(({ fill }) => [fill.color, fill.rule]), [["#111111", filling ?? "evenodd"], ["#1b1f24", filling ?? "evenodd"]]);
    assert.deepEqual(pngPaths({ ...how, scale: 1, paper: null }), found);
  }
});

test("a file and a picture have what shows through as it is, and lines as lines", () => {
  const layers = [{ color: "#11223380", d: "M0 0H9V9Z" }, { isLine: true, d: "M1 1H2V2Z" }];
  const how = { d: "", box: { minX: 0, minY: 0, maxX: 9, maxY: 9 }, filled: true, layers };
  const svg = writeSvg({ title: "", ...how });
  assert.match(svg, /<path d="M0 0H9V9Z" fill="#112233" fill-opacity="0.502" fill-rule="evenodd"\/>/u);
  assert.match(svg, /<path d="M1 1H2V2Z" fill="none" stroke="#1b1f24" stroke-width="[.\d]+" stroke-linejoin="round"\/>/u);
  assert.ok(Number(/viewBox="(\S+)/u.exec(svg)?.[1]) < 0, "with room for the line");
  assert.deepEqual(pngPaths({ ...how, scale: 1, paper: null }), [{ d: "M0 0H9V9Z", fill: { color: "#11223380", alpha: 1, rule: "evenodd" } }, { d: "M1 1H2V2Z", stroke: "#1b1f24" }]);
});

test("a layer is written as it is in the path of all", () => {
  const curve = inked("heart");
  const both: CurveDocument = { ...curve, contours: [...curve.contours, ...inked("glyph", "#b02a30").contours] };
  for (const segments of ["arcs", "cubics", "polyline"] as const) {
    const options = { segments, tolerance: 0.02, decimals: 2, relative: true };
    const layers = paintLayers(both).map(({ drawing }) => writePath(drawing, options));
    assert.equal(layers.length, 2);
    assert.equal(layers.join(""), exportPath(both, options).d);
  }
});

test("outlines that come back without their picture have the colours that they were traced in", () => {
  const { contours } = inked("glyph");
  const colored = [...contours, ...inked("heart", "#b02a30").contours];
  const outcome = outcomeOfKept({ name: "a.png", width: 10, height: 10, contours: colored });
  assert.deepEqual([outcome.colors, outcome.layers], [[ink, "#b02a30"], [...contours.map(() => 0), 1]]);
  assert.deepEqual(inkedContours(outcome), colored);
  const plain = outcomeOfKept({ name: "a.png", width: 10, height: 10, contours: inked("heart", null).contours });
  assert.deepEqual([plain.colors, plain.layers], [[], []]);
});

const line: Line = { width: 2, color: "#336699", cap: "round" };

test("strokes keep the colours and lines of their contours as they are added to, erased, written and read", () => {
  const stroke = (x: number): Pair[] => Array.from({ length: 9 }, (_, i): Pair => [x + i, i % 2]);
  const plain = withStrokes({ ...fitDefaults, data: [] }, [{ places: stroke(0) }]);
  assert.equal("paints" in plain, false);
  const fit = withStrokes(plain, [{ places: [], ink: "#000000" }, { places: stroke(100), ink }, { places: stroke(200), ink: "none", line }]);
  assert.deepEqual(fit.paints, [{}, { ink }, { ink: "none", line }]);
  assert.deepEqual(withStrokes(fit, [{ places: stroke(300) }]).paints, [...fit.paints ?? [], {}]);
  assert.deepEqual(withoutDisc(fit, 4, 0, 20).paints, [{ ink }, { ink: "none", line }], "one less");
  assert.deepEqual(withoutDisc(fit, 104, 0, 2).paints, fit.paints, "a part of one");
  assert.equal("paints" in withoutDisc(withoutDisc(fit, 104, 0, 20), 204, 0, 20), false);
  assert.equal("paints" in emptied(fit), false);
  assert.deepEqual(subjectOf(fit, false)?.strokes.map((each) => [each.ink, each.line]), [[undefined, undefined], [ink, undefined], ["none", line]]);
  const state = { ...new Hand().editor.getState(), fit };
  assert.deepEqual(parseState(writeState(state)).state.fit, fit);
  for (const strange of [[{ ink }], [{}, { ink }, {}, {}], [{}, { ink }, { ink: "red" }], [{}, {}, null], ink]) {
    const text = JSON.stringify({ ...state, fit: { ...fit, paints: strange } });
    assert.throws(() => parseState(text), (error: unknown) => error instanceof FileError && error.message.includes("$.fit.paints"), text);
  }
});

test("a line is read as it was written, and one that is none is refused, with its place", () => {
  const state = new Hand("circle-2").editor.getState();
  const withLine = (found: unknown): string =>
    JSON.stringify({ ...state, curve: { ...state.curve, contours: state.curve.contours.map((contour) => ({ ...contour, line: found })) } });
  for (const fine of [line, { width: 0.25 }, { width: 1e9, cap: "square", join: "bevel" }, { width: 1, color: "#33669980", join: "round" }, { width: 1, dashes: [4, 0.5, 0], dashOffset: -2 }]) {
    for (const { line: found } of parseState(withLine(fine)).state.curve.contours) assert.deepEqual(found, fine);
  }
  for (const strange of [2, {}, { width: 0 }, { width: 1e10 }, { width: "2" }, { width: 2, color: "none" }, { width: 2, cap: "butt" }, { width: 2, join: "miter" }, null,
    { width: 2, dashes: [] }, { width: 2, dashes: [0, 0] }, { width: 2, dashes: [3, -1] }, { width: 2, dashes: "3 1" }, { width: 2, dashes: Array.from({ length: 257 }, () => 1) }, { width: 2, dashOffset: "1" }]) {
    const text = withLine(strange);
    assert.throws(() => parseState(text), (error: unknown) => error instanceof FileError && error.message.includes("$.curve.contours[0].line"), text);
  }
});

test("contours are drawn together where colour and line are the same, whichever object says so", () => {
  const [one] = new Hand("circle-2").editor.getState().curve.contours;
  assert.ok(one !== undefined, "a circle");
  const all = [{ line }, { line: { ...line } }, { line: { ...line, dashes: [2, 1] } }, { line: { ...line, dashes: [2, 1] } }, { line: { width: 2, color: "#336699" } }, { line, ink }, { ink }, {}].map((paint) => ({ ...one, ...paint }));
  const layers = paintLayers({ ...new Hand("circle-2").editor.getState().curve, contours: all });
  assert.deepEqual(layers.map((layer) => [layer.ink, layer.line, layer.drawing.contours.length]),
    [[undefined, line, 2], [undefined, { ...line, dashes: [2, 1] }, 2], [undefined, { width: 2, color: "#336699" }, 1], [ink, line, 1], [ink, undefined, 1], [undefined, undefined, 1]]);
});

test("a file draws lines as wide as they are, over their areas, with room for them", () => {
  const d = "M0 0H100";
  const box = { minX: 0, minY: 0, maxX: 100, maxY: 100 };
  const layers = [{ d, isLine: true, line }, { d, color: "#ffcc00", line: { width: 8, join: "bevel", dashes: [1 / 3, 2], dashOffset: 4 } as const }, { d, isLine: true }];
  const text = writeSvg({ title: "t", d: "", box, filled: true, layers });
  const paths = [...text.matchAll(/<path d="[^"]*" ([^/]*)\/>/gu)].map(([, how]) => how);
  assert.deepEqual(paths.slice(0, 2), [
    'fill="none" stroke="#336699" stroke-width="2" stroke-linecap="round"',
    `fill="#ffcc00" fill-rule="evenodd" stroke="${inkOfFiles}" stroke-width="8" stroke-linejoin="bevel" stroke-dasharray="0.333333 2" stroke-dashoffset="4"`,
  ]);
  assert.match(paths[2] ?? "", /^fill="none" stroke="[^"]*" stroke-width="0\.781" stroke-linejoin="round"$/u, "two pixels of 256");
  const [x = NaN, y = NaN, width = NaN, height = NaN] = (/viewBox="([^"]*)"/u.exec(text)?.[1] ?? "").split(" ").map(Number);
  assert.ok(x <= -4 && y <= -4 && x + width >= 104 && y + height >= 104, "half of the widest line is beside the box");
  const drawn = pngPaths({ d: "", box, scale: 1, paper: null, filled: true, layers });
  assert.deepEqual(drawn.map((path) => [path.fill?.color, path.stroke, path.line?.width]), [[undefined, "#336699", 2], ["#ffcc00", inkOfFiles, 8], [undefined, inkOfFiles, undefined]]);
});

test("a colour that is none is refused, with its place", () => {
  const state = new Hand("circle-2").editor.getState();
  for (const fine of ["#336699", "#33669980", "none"]) {
    const text = JSON.stringify({ ...state, curve: { ...state.curve, contours: state.curve.contours.map((contour) => ({ ...contour, ink: fine })) } });
    for (const { ink: found } of parseState(text).state.curve.contours) assert.equal(found, fine);
  }
  for (const strange of ["red", "#fff", "None", "#12345G", "#1234567", 'url("x")', 5]) {
    const text = JSON.stringify({ ...state, curve: { ...state.curve, contours: state.curve.contours.map((contour) => ({ ...contour, ink: strange })) } });
    assert.throws(() => parseState(text), (error: unknown) => error instanceof FileError && error.message.includes("$.curve.contours[0].ink"), text);
  }
});

test("what is chosen goes over all colours or below them, stays chosen, and is one step of the history", async () => {
  const [square, dot, hole] = contoursOfPath("M0 0H90V90H0ZM30 30H60V60H30ZM40 40H50V50H40Z");
  assert.ok(square && dot && hole);
  const hand = handOf([{ ...square, ink: "#204080" }, { ...dot, ink: "#ffcc00" }, { ...hole, ink: "#ffcc00" }]);
  const chosen = [...dot.points.map((_, index) => ({ contour: 1, index })), ...hole.points.map((_, index) => ({ contour: 2, index }))];
  hand.editor.patch({ selection: { points: chosen, handle: null } });
  const firsts = (): number[] => hand.curve.contours.map(({ points }) => points[0]?.x ?? NaN);
  const runs = (): (string | undefined)[] => paintLayers(hand.curve).map(({ ink: color }) => color);
  hand.run("to-back");
  assert.deepEqual([firsts(), runs()], [[30, 40, 0], ["#ffcc00", "#204080"]]);
  assert.deepEqual([...new Set(hand.selected.map((ref) => ref[0]))], ["0", "1"]);
  hand.run("to-front");
  assert.deepEqual([firsts(), runs()], [[0, 30, 40], ["#204080", "#ffcc00"]]);
  assert.deepEqual(hand.editor.state.value.undoName, "Bring to front");
  hand.run("undo").run("undo");
  assert.deepEqual(firsts(), [0, 30, 40]);
  const plain = new Hand("glyph").run("select-all");
  assert.equal(plain.editor.actions.get("to-front")?.enabled?.(plain.editor.state.value), false, "of one paint nothing lies over anything");
});
