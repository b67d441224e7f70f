// Rows about SVG path data: 1000 cubics in and out.

import svgpath from "svgpath";

import { pathText } from "./curve.mjs";
import { here } from "./harness.mjs";
import { paper } from "./peers.mjs";

const DECIMALS = 3;

const row = (name, action, note) => ({ name, measure: here(action), units: 1, note });

function parse({ expline, kurbo, native }) {
  let result;
  return {
    unit: "call",
    contestants: [
      row("expline, wasm", () => (result = expline.parsePath(pathText)), () => `${result[0].lengths.length} segments`),
      { name: "expline, native", measure: native.measure("expline:parse"), units: 1, note: () => "" },
      { name: "kurbo, native", measure: native.measure("kurbo:parse"), units: 1, note: () => "" },
      row("kurbo, wasm", () => (kurbo.setText(pathText), (result = kurbo.parse_text())), () => `${result} elements`),
      row("svgpath", () => {
        result = svgpath(pathText);
        result.iterate(() => undefined);
      }, () => `${result.segments.length} elements`),
      row("paper", () => (result = new paper.Path({ pathData: pathText, insert: false })), () => `${result.segments.length} points`),
    ],
    targets: [["svgpath", 2]],
  };
}

function print({ expline, native }) {
  let result;
  const bytes = () => `${result.length} bytes`;
  const [parsed] = expline.parsePath(pathText);
  const ofSvgpath = svgpath(pathText);
  const ofPaper = new paper.Path({ pathData: pathText, insert: false });
  return {
    unit: "call",
    contestants: [
      row("expline, wasm, 3 decimals", () => (result = parsed.toPathD({ decimals: DECIMALS }).d), bytes),
      { name: "expline, native", measure: native.measure("expline:print"), units: 1, note: () => `${native.answer("expline:print")} bytes` },
      { name: "kurbo, native, all digits", measure: native.measure("kurbo:print"), units: 1, note: () => `${native.answer("kurbo:print")} bytes` },
      row("svgpath, 3 decimals", () => (result = ofSvgpath.toString()), bytes),
      row("paper, 3 decimals", () => (result = ofPaper.getPathData(null, DECIMALS)), bytes),
    ],
    targets: [["svgpath, 3 decimals", 1.4]],
  };
}

/** Titles and what makes the contestants. */
export const pathRows = [
  ["parse a path of 1000 cubics", parse],
  ["print a path of 1000 cubics", print],
];
