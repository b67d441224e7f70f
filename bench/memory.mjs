// How much memory wasm takes for one sparse fit. Usage: node bench/memory.mjs POINTS PLACES; prints bytes before and
// after, of the engine that fits.

const { Instance } = WebAssembly;
const memories = [];

/** Remembers the memory of each engine that the package makes. */
WebAssembly.Instance = class extends Instance {
  constructor(...parameters) {
    super(...parameters);
    if (this.exports.memory) memories.push(this.exports.memory);
  }
};

const { fitSparse } = await import("expline");
const { outline } = await import("./lib/outlines.mjs");
const [count, gridSize] = process.argv.slice(2).map(Number);
const fit = (points, size, places) => {
  const detail = Math.min(size / 60, 1200);
  const parameters = Float64Array.from({ length: size }, (_, i) => i);
  const lambda = 400 * (detail / (2 * Math.PI)) ** 4;
  return fitSparse(points, { degree: 3, finish: "none", period: size, gridSize: places, lambda, parameters });
};
const bytes = () => Math.max(...memories.map((memory) => memory.buffer.byteLength));
fit(outline(100), 100, 100);
const before = bytes();
fit(outline(count), count, gridSize);
console.log(`${before} ${bytes()}`);
