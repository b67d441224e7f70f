// The tracers, each as `trace(picture) → { svg, ms }`: milliseconds from pixels in memory to the text of the drawing.

import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { createInterface } from "node:readline";

const require = createRequire(import.meta.url);

/** A browser's picture, as the peers expect it. */
class ImageData {
  constructor({ width, height, pixels }) {
    this.width = width;
    this.height = height;
    this.data = new Uint8ClampedArray(4 * width * height).fill(255);
    for (let i = 0; i < pixels.length; i++) this.data.fill(pixels[i], 4 * i, 4 * i + 3);
  }
}

/** The result and the least time of some runs; the picture is made anew for each, outside the time. */
async function least(times, prepare, run) {
  let best = { ms: Infinity, svg: "" };
  for (let i = 0; i < times; i++) {
    const input = prepare();
    const start = performance.now();
    const svg = await run(input);
    const ms = performance.now() - start;
    if (ms < best.ms) best = { ms, svg };
  }
  return best;
}

/**
 * potrace compiled to wasm; dark and light only, all else as it comes. Its build for browsers finds in Node what it
 * takes for CommonJS.
 */
async function potrace() {
  Object.assign(globalThis, { require, __dirname: "", ImageData });
  const { init, potrace: run } = await import("esm-potrace-wasm");
  await init();
  delete globalThis.require;
  delete globalThis.__dirname;
  return (picture, times) => least(times, () => new ImageData(picture), (image) => run(image, { extractcolors: false, posterizelevel: 2 }));
}

/** vtracer's binary mode compiled to wasm, with its own defaults. */
async function vtracer() {
  globalThis.ImageData = ImageData;
  const folder = new URL("./", import.meta.resolve("vectortracer"));
  const glue = await import(new URL("vectortracer_bg.js", folder).href);
  const { instance } = await WebAssembly.instantiate(readFileSync(new URL("vectortracer_bg.wasm", folder)), { "./vectortracer_bg.js": glue });
  glue.__wbg_set_wasm(instance.exports);
  instance.exports.__wbindgen_start();
  const run = (image) => {
    const converter = new glue.BinaryImageConverter(image, { debug: false }, { invert: false, scale: 1 });
    converter.init();
    while (!converter.tick());
    const svg = converter.getResult();
    converter.free();
    return svg;
  };
  return (picture, times) => least(times, () => new ImageData(picture), run);
}

/**
 * imagetracerjs with white and black as its palette, in this order so that ink lies on top, and no strokes on top of
 * the outlines.
 */
async function imagetracer() {
  const tracer = require("imagetracerjs");
  const pal = [255, 0].map((v) => ({ r: v, g: v, b: v, a: 255 }));
  return (picture, times) => least(times, () => new ImageData(picture), (image) => tracer.imagedataToSVG(image, { pal, strokewidth: 0 }));
}

/** expline as its package offers it: wasm. */
async function wasm(refine) {
  const { traceImage } = await import("expline");
  return (picture, times) => least(times, () => ({ ...new ImageData(picture) }), (image) => traceImage(image, { refine }).toSvg());
}

const framed = ({ width, height }, d, paint) => `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}"><path ${paint}d="${d}"/></svg>`;

/** expline natively: a program that is asked line by line. */
function native(program) {
  const child = spawn(program, [], { stdio: ["pipe", "pipe", "inherit"] });
  const lines = createInterface({ input: child.stdout })[Symbol.asyncIterator]();
  const ask = (what, refined, paint) => async (picture, times) => {
    const shades = Buffer.from(picture.pixels).toString("hex");
    child.stdin.write(`${what} ${picture.width} ${picture.height} ${refined} ${times} ${shades}\n`);
    const { value, done } = await lines.next();
    if (done) throw new Error("the native program ended");
    if (value.startsWith("! ")) throw new Error(value.slice(2));
    const [, ns, ...d] = value.split(" ");
    return { ms: Number(ns) / 1e6, svg: framed(picture, d.join(" "), paint) };
  };
  return {
    trace: (refined) => ask("outlines", refined, ""),
    lines: ask("lines", true, 'fill="none" stroke="#000" '),
    close: () => child.stdin.end(),
  };
}

/**
 * By name, ours first: those whose drawings are scored, and all whose time is taken; `centreLines` is ours. `close`
 * ends the native program.
 */
export async function tracers(program) {
  const own = native(program);
  const scored = [
    ["expline, wasm", await wasm(true)],
    ["potrace (esm-potrace-wasm 0.5.1)", await potrace()],
    ["vtracer (vectortracer 0.1.2)", await vtracer()],
    ["imagetracerjs 1.2.6", await imagetracer()],
  ];
  const timed = [
    scored[0],
    ["expline, wasm, not refined", await wasm(false)],
    ["expline, native", own.trace(true)],
    ["expline, native, not refined", own.trace(false)],
    ...scored.slice(1),
  ];
  return { scored, timed, centreLines: own.lines, close: own.close };
}
