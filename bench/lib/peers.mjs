// The contestants' forms of the curve: kurbo in wasm, kurbo and expline natively, paper, bezier-js, curve-interpolator.

import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";

import { Bezier } from "bezier-js";
import { CurveInterpolator } from "curve-interpolator";
import paper from "paper/dist/paper-core.js";

import { EXPONENTIAL_OMEGA, SEGMENTS, cubics, pathText, points, queries, tangents } from "./curve.mjs";

/** kurbo as bare wasm exports, compiled like expline: simd128, fat LTO, opt-level 3, then wasm-opt -O3. */
export function kurboWasm(file) {
  const { exports } = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(file)), {});
  const at = exports.input(cubics.length);
  new Float64Array(exports.memory.buffer, at, cubics.length).set(cubics);
  exports.load();
  const bytes = new TextEncoder().encode(pathText);
  const text = (content) => new Uint8Array(exports.memory.buffer, exports.text(content.length), content.length).set(content);
  text(bytes);
  const numbers = (count) => new Float64Array(exports.memory.buffer, exports.out(), count);
  return { ...exports, numbers, setText: (d) => text(new TextEncoder().encode(d)) };
}

/** The native program, asked line by line. */
export class Native {
  #child;
  #lines;
  #answers = new Map();

  constructor(program) {
    this.#child = spawn(program, [], { stdio: ["pipe", "pipe", "inherit"] });
    this.#lines = createInterface({ input: this.#child.stdout })[Symbol.asyncIterator]();
    this.#say("cubics", cubics);
    this.#hermite("hermite", 0);
    this.#hermite("exponential", EXPONENTIAL_OMEGA);
    this.#say("queries", queries);
    this.#say("text", [pathText]);
  }

  #say(command, values) {
    this.#child.stdin.write(`${command} ${[...values].join(" ")}\n`);
  }

  /** The curves that expline's rows are about. */
  #hermite(command, omega) {
    const numbers = [omega];
    for (let i = 0; i < points.length; i += 2) numbers.push(points[i], points[i + 1], tangents[i], tangents[i + 1]);
    this.#say(command, numbers);
  }

  /**
   * The sparse fit that the solvers' rows are about: how many splines, degree, λ and places of each, then the points.
   */
  sparse(numbers) {
    this.#say("sparse", numbers);
  }

  /** A row's measure: milliseconds for so many runs; the result is kept for `answer`. */
  measure(name) {
    return async (times) => {
      this.#say("run", [name, times]);
      const { value, done } = await this.#lines.next();
      if (done) throw new Error(`the native program ended at ${name}`);
      const [nanoseconds, answer] = value.split(" ").map(Number);
      this.#answers.set(name, answer);
      return nanoseconds / 1e6;
    };
  }

  answer(name) {
    return this.#answers.get(name);
  }

  close() {
    this.#child.stdin.end();
  }
}

/** bezier-js: one object per segment. */
export const beziers = Array.from({ length: SEGMENTS }, (_, i) => new Bezier(...cubics.subarray(8 * i, 8 * i + 8)));

/** paper: one closed path. */
export function paperPath() {
  paper.setup(new paper.Size(512, 512));
  const handle = (i) => new paper.Point(tangents[2 * i] / 3, tangents[2 * i + 1] / 3);
  const segment = (_, i) => new paper.Segment(new paper.Point(points[2 * i], points[2 * i + 1]), handle(i).negate(), handle(i));
  return new paper.Path({ segments: Array.from({ length: SEGMENTS }, segment), closed: true, insert: false });
}

export { paper };

/** curve-interpolator: tension 0 and alpha 0 is the uniform Catmull–Rom curve. */
export function interpolator() {
  const pairs = Array.from({ length: SEGMENTS }, (_, i) => [points[2 * i], points[2 * i + 1]]);
  return new CurveInterpolator(pairs, { tension: 0, alpha: 0, closed: true });
}
