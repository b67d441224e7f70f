import assert from "node:assert/strict";
import { test } from "node:test";
import { stateVersion, type DemoState } from "../src/document/document.ts";
import { emptyFit } from "../src/document/fit/fit.ts";
import { emptySurface } from "../src/document/surface/surface.ts";
import { emptyTrace } from "../src/document/trace/trace.ts";
import { FileError, parseState, readState, writeState, type FileErrorCode } from "../src/document/file/file.ts";
import { curveSamples } from "../src/document/curve/samples.ts";
import { Hand } from "./harness.ts";

/**
 * The file format under hostile input. Ids are those of the catalogue of hostile cases, adapted to this format's
 * fields.
 */

function stateOf(sample = 0): DemoState {
  const curve = curveSamples[sample]?.curve;
  assert.ok(curve !== undefined, "the sample exists");
  return { format: "expline-demo", version: stateVersion, mode: "curve", view: { zoom: 1, x: 400, y: 300 }, curve, fit: emptyFit, trace: emptyTrace, surface: emptySurface };
}

/** A small whole file with something put in its place. */
function file(parts: Readonly<Record<string, string>> = {}): string {
  const fields: Record<string, string> = { format: '"expline-demo"', version: "1", curve: curve("0, 0"), ...parts };
  return `{${Object.entries(fields).map(([name, value]) => `"${name}":${value}`).join(",")}}`;
}

function curve(place: string, more = ""): string {
  const [x = "0", y = "0"] = place.split(", ");
  const point = (a: string, b: string): string => `{"x":${a},"y":${b},"kind":"cusp","in":{"dx":0,"dy":0},"out":{"dx":0,"dy":0}}`;
  return `{"space":"trigonometric","omega":"auto","contours":[{"closed":false,"points":[${point("1", "1")},${point(x, y)}]${more}}]}`;
}

const refused: readonly (readonly [id: string, what: string, text: string, code: FileErrorCode, path: string | RegExp])[] = [
  ["JS-003", "null", "null", "E_SCHEMA", "$"],
  ["JS-004", "a list", "[]", "E_SCHEMA", "$"],
  ["JS-005", "no version", '{"format":"expline-demo","curve":{}}', "E_SCHEMA", "$.version"],
  ["JS-006", "a newer version", file({ version: "3" }), "E_UNSUPPORTED", "$.version"],
  ["JS-007", "a version that is text", file({ version: '"1"' }), "E_SCHEMA", "$.version"],
  ["JS-012", "a million levels of nesting", "[".repeat(1_000_000), "E_LIMIT", "$"],
  ["JS-014", "1e400 as a coordinate", file({ curve: curve("1e400, 0") }), "E_NOT_FINITE", "$.curve.contours[0].points[1].x"],
  ["JS-014b", "a coordinate beyond 1e9", file({ curve: curve("0, -2e9") }), "E_RANGE", "$.curve.contours[0].points[1].y"],
  ["JS-016", "a coordinate as text with a decimal comma", file({ curve: curve('"1;5", 0').replace("1;5", "1,5") }), "E_SCHEMA", "$.curve.contours[0].points[1].x"],
  ["JS-017", "a key twice", `{"version":1,"curve":{},"curve":{}}`, "E_SCHEMA", "$.curve"],
  ["JS-017b", "a key twice, once spelt with an escape", `{"version":1,"view":{"x":1,"\\u0078":2}}`, "E_SCHEMA", "$.view.x"],
  ["JS-024", "something after the end", `${file()} x`, "E_PARSE_JSON", "$"],
  ["JS-024b", "a file cut short", file().slice(0, -3), "E_PARSE_JSON", "$"],
  ["JS-025", "a hundred megabytes", " ".repeat(100 * 1024 * 1024), "E_LIMIT", "$"],
  ["JS-027", "more points than the page takes", file({ curve: `{"space":"polynomial","omega":0,"contours":[{"closed":true,"points":[${"1,".repeat(100_001)}1]}]}` }), "E_LIMIT", "$.curve.contours[0].points"],
  ["JS-029", "frequencies that are not one for each segment", file({ curve: curve("0, 0", ',"omega":[1,2,3]') }), "E_SCHEMA", "$.curve.contours[0].omega"],
  ["JS-030", "a contour without points", file({ curve: '{"space":"polynomial","omega":0,"contours":[{"closed":true,"points":[]}]}' }), "E_SCHEMA", /points$/u],
  ["JS-031", "a sample's name that is markup", file({ curve: curve("0, 0").replace("{", '{"sample":"<img onerror=x>",') }), "E_SCHEMA", "$.curve.sample"],
  ["JS-034", "a kind that is none", file({ curve: curve("0, 0").replace('"cusp"', '"hologram"') }), "E_SCHEMA", /kind$/u],
];

for (const [id, what, text, code, path] of refused) {
  test(`${id} ${what} is refused with ${code}`, () => {
    assert.throws(
      () => parseState(text),
      (error: unknown) => {
        assert.ok(error instanceof FileError, String(error));
        assert.equal(error.code, code);
        if (typeof path === "string") assert.equal(error.path, path);
        else assert.match(error.path, path);
        assert.ok(error.message.length < 200, "the message holds none of the file");
        return true;
      },
    );
  });
}

test("JS-020 a field of somebody else's goes through the editor and into the next file as it was", () => {
  const { state } = parseState(file({ "x-vendor": '{"a":[1,null,"é"]}', __proto__x: '{"own":1}' }).replace("__proto__x", "__proto__"));
  const { editor } = new Hand();
  editor.setState(state, { fresh: true });
  editor.patch({ mode: "fit" });
  const again = parseState(writeState(editor.getState()));
  assert.deepEqual(Object.fromEntries(Object.entries(again.state).filter(([key]) => key === "x-vendor" || key === "__proto__")), JSON.parse('{"x-vendor":{"a":[1,null,"é"]},"__proto__":{"own":1}}'));
  assert.equal(({} as Record<string, unknown>)["own"], undefined);
  editor.setState(stateOf(), { fresh: true });
  assert.equal(Object.hasOwn(editor.getState(), "x-vendor"), false, "another file has none");
});

test("JS-008 JS-010 JS-019 a __proto__ key reaches nothing, and an unknown field is named", () => {
  const { state, warnings } = parseState(file({ __proto__x: "1", "x-vendor": "{}" }).replace("__proto__x", "__proto__"));
  assert.deepEqual(warnings.map(({ path }) => path), ["$.__proto__", "$.x-vendor"]);
  assert.equal(Object.getPrototypeOf(state), Object.prototype);
  assert.equal(({} as Record<string, unknown>)["1"], undefined);
});

test("JS-011 a setter that the page has put on Object.prototype is never run", (t) => {
  let hits = 0;
  Object.defineProperty(Object.prototype, "points", { set: () => { hits += 1; }, configurable: true });
  t.after(() => { delete (Object.prototype as Record<string, unknown>)["points"]; });
  assert.equal(parseState(file()).state.curve.contours[0]?.points.length, 2);
  assert.equal(hits, 0);
});

test("JS-021 minus zero is zero, once, so that a file comes back as it was written", () => {
  const { state } = parseState(file({ curve: curve("-0, -0.0") }));
  const point = state.curve.contours[0]?.points[1];
  assert.ok(Object.is(point?.x, 0) && Object.is(point?.y, 0));
  assert.deepEqual(parseState(writeState(state)).state, state);
});

test("JS-023 a byte order mark is no obstacle", () => {
  assert.equal(parseState(`\uFEFF${file()}`).state.curve.contours.length, 1);
});

test("JS-033 an object that holds itself is read without running in circles", () => {
  const cyclic: Record<string, unknown> = { ...stateOf() };
  cyclic["self"] = cyclic;
  assert.deepEqual(readState(cyclic), stateOf());
  const inside: Record<string, unknown> = { ...stateOf(), curve: { space: "polynomial", omega: 0, contours: [] as unknown[] } };
  (inside["curve"] as { contours: unknown[] }).contours.push(inside);
  assert.throws(() => readState(inside), FileError);
});

test("every sample comes back from its file with every bit", () => {
  for (let i = 0; i < curveSamples.length; i += 1) {
    const state = stateOf(i);
    assert.deepEqual(parseState(writeState(state)).state, state, state.curve.sample);
  }
});

test("a damaged file never half opens: any byte changed gives a whole state or an error of ours", () => {
  const text = writeState(stateOf(3));
  for (let at = 0; at < text.length; at += 7) {
    const damaged = `${text.slice(0, at)}\u0001${text.slice(at + 1)}`;
    try {
      const { state } = parseState(damaged);
      assert.equal(state.format, "expline-demo");
    } catch (error) {
      assert.ok(error instanceof FileError, String(error));
    }
  }
});

test("a file of version 1 opens as it was written, and is written again as the present version", () => {
  const { state } = parseState(file({ version: "1", surface: '{"sample":"surf-sphere","levelU":0,"levelV":0,"support":[1,1],"patches":0,"net":[]}' }));
  assert.equal(state.version, stateVersion);
  assert.deepEqual(state.surface, { ...emptySurface, sample: "surf-sphere" });
  assert.deepEqual(parseState(writeState(state)).state, state);
});

const finer = '"family":"interpolating","roots":[{"re":0,"im":0},{"re":0,"im":1},{"re":0,"im":-1}],"grid":{"step":0.5,"offset":-1.25,"count":4},"order":3';

test("an interpolating contour keeps its roots, its order and its grid", () => {
  const [contour] = parseState(file({ curve: curve("1, 2", `,${finer}`) })).state.curve.contours;
  assert.deepEqual(contour?.grid, { step: 0.5, offset: -1.25, count: 4 });
  assert.deepEqual(contour?.roots?.[2], { re: 0, im: -1 });
  assert.equal(contour?.order, 3);
});

for (const [what, fields, path] of [
  ["a grid without the roots of its splines", '"family":"interpolating","grid":{"step":0.5,"offset":0,"count":4}', "roots"],
  ["roots on a Hermite contour", '"roots":[{"re":0,"im":0},{"re":0,"im":0},{"re":0,"im":0}]', "roots"],
  ["a frequency for each segment of an interpolating contour", '"family":"interpolating","omega":[1]', "omega"],
  ["an order that there is not", '"family":"interpolating","order":6', "order"],
] as const) {
  test(`${what} is refused`, () => {
    assert.throws(() => parseState(file({ curve: curve("1, 2", `,${fields}`) })), (error: unknown) => error instanceof FileError && error.path === `$.curve.contours[0].${path}`);
  });
}

test("a surface's net is a whole rectangle, or the file is refused", () => {
  const direction = { roots: [{ re: 0, im: 0 }, { re: 0, im: 1 }, { re: 0, im: -1 }], count: 2, closed: true };
  const at = (u: number, v: number): object => ({ u, v, x: u, y: v, z: 0.5 });
  const surface = { sample: "surf-torus", levelU: 0, levelV: 0, support: [2, 2], patches: 4, u: direction, v: direction, net: [at(0, 0), at(0, 1), at(1, 0), at(1, 1)] };
  const { state } = parseState(file({ surface: JSON.stringify(surface) }));
  assert.deepEqual(state.surface, surface);
  assert.throws(() => parseState(file({ surface: JSON.stringify({ ...surface, net: [at(0, 0), at(1, 0), at(0, 1)] }) })), FileError);
});

test("a file that is looked at from nearer than it can be drawn opens as near as it can be", () => {
  const seen = (state: DemoState, zoom: number): number => readState({ ...state, view: { zoom, x: 1, y: 2 } }).view.zoom;
  const state = stateOf();
  const xs = state.curve.contours.flatMap(({ points }) => points.map(({ x }) => x));
  const width = Math.max(...xs) - Math.min(...xs);
  // Chromium draws four million pixels in milliseconds, forty in seconds, and the outlines of more than that perhaps
  // never.
  assert.ok(Math.abs(seen(state, 1e9) * width - 4e6) < 1, `${seen(state, 1e9) * width} px across`);
  assert.equal(seen(state, 6000), 6000);
  const data = [[0, 0], [10, 0], [20, 4000], [30, 0]] as const;
  assert.equal(seen({ ...state, mode: "fit", fit: { ...emptyFit, data } }, 1e6), 1000);
  assert.ok(seen({ ...state, mode: "trace", trace: { ...emptyTrace, sample: "trace-star" } }, 1e9) <= 4e6 / 2048);
});
