// One start in a fresh process: milliseconds for the import, and for the first answer after it. Usage: node
// bench/start.mjs LIBRARY

/** What each library is asked first: a point of a curve. */
const FIRST = {
  expline: ({ HermiteCurve }) => HermiteCurve.ellipse({ center: [0, 0], radii: [1, 1], count: 2 }).evaluate(0.5),
  "bezier-js": ({ Bezier }) => new Bezier(0, 0, 1, 0, 1, 1, 0, 1).get(0.5),
  paper: ({ default: paper }) => new paper.Path("M0 0C1 0 1 1 0 1").getPointAt(0.5),
  "curve-interpolator": ({ CurveInterpolator }) => new CurveInterpolator([[0, 0], [1, 0], [1, 1]]).getPointAt(0.5),
};

const [, , name] = process.argv;
// paper's entry for Node draws: its core does not.
const file = name === "paper" ? "paper/dist/paper-core.js" : name;
const started = performance.now();
const library = await import(file);
const imported = performance.now();
if (name === "paper") library.default.setup(new library.default.Size(1, 1));
FIRST[name](library);
console.log(`${imported - started} ${performance.now() - imported}`);
