// The README's tables of times, made from one run of the bench that was kept (`npm run bench -- --record`).

/** A time as a person reads it: two digits, three where the first is a one. */
export function time(ns) {
  for (const [unit, size] of [["ns", 1], ["µs", 1e3], ["ms", 1e6], ["s", 1e9]]) {
    const value = ns / size;
    if (value < 999.5 || unit === "s") return `${value < 10 ? Number(value.toPrecision(2)) : Math.round(value)} ${unit}`;
  }
  return "";
}

const factor = (ratio) => `${ratio < 10 ? Number(ratio.toPrecision(2)) : Math.round(ratio)}×`;

/** What a contestant took, how many times as long as ours, and what is to be said of its result. */
function cell(results, name, remark) {
  const [{ least: ours }] = results;
  const found = results.find((result) => result.name === name);
  if (found === undefined) return "";
  const times = found === results[0] ? `**${time(ours)}**` : `${time(found.least)} (${factor(found.least / ours)})`;
  const said = remark?.exec(found.note)?.[0];
  return said === undefined ? times : `${times}, ${said}`;
}

/** Columns of the first table, and the contestants that they may show. */
const COLUMNS = [
  ["expline", ["expline, wasm", "expline, wasm, 3 decimals"]],
  ["kurbo, wasm", ["kurbo, wasm"]],
  ["kurbo, native", ["kurbo, native", "kurbo, native, all digits"]],
  ["bezier-js", ["bezier-js"]],
  ["paper", ["paper", "paper, 3 decimals"]],
  ["hand-written JS", ["hand-written JS, table"]],
];

/** Rows of the first table: title in the bench, what is said in the README, and what of a contestant's note. */
const ROWS = [
  ["evaluate 1 000 000 points", "a point (1,000,000 into one array)"],
  ["evaluate 16 × 64 points, the call included", "a point (1024 of them, the call included)"],
  ["point and tangent, 1 000 000", "a point with its tangent"],
  ["bounds", "bounds"],
  ["length, 1e-9 asked for", "length within 1e-9"],
  ["nearest point, 10 000 queries", "nearest point", /^[1-9]\d* of \d+ missed/],
  ["polyline within 0.1", "polyline within 0.1", /^\d+ points/],
  ["polyline within 0.001", "polyline within 0.001", /^\d+ points/],
  ["parse a path of 1000 cubics", "parse a path of 1000 cubics"],
  ["print a path of 1000 cubics", "print it with 3 decimals"],
];

/** Rows of the second table: ours in the bench, and what stands beside it. */
const BESIDE = [
  ["a fresh Node process", "start in a fresh process: import and first point"],
  ["1000 points evenly by arc length", "a point (1000 of them, evenly by length)", /off [\d.e+-]+/],
  ["polyline within 0.1 of an exponential curve (ω = π/2)", "a polyline within 0.1 of an exponential curve", /^\d+ points/],
  ["cubics within 1e-3 of an exponential curve (ω = π/2)", "an exponential curve as cubics within 1e-3", /^\d+ cubics/],
  ["interpolating curve, points one by one", "a point of an interpolating curve"],
  ["surface mesh with normals", "a vertex of a surface mesh with its normal", /no normals/],
  ["one point of 16 × 16 moved, 64 800 triangles", "one point of a 16 × 16 net dragged: its part of 64,800 triangles"],
  ["sparse fit, degree 1, 500 points", "sparse fit to a gap of 1e-6, degree 1, 500 points", /^\d+ knots/],
  ["sparse fit, degree 3, 500 points", "the same, degree 3", /^\d+ knots/],
  ["sparse fit, degree 3, 2700 points", "degree 3, 2,700 points", /^\d+ knots/],
  ["sparse fit, degree 3, 100000 points", "degree 3, 100,000 points", /^\d+ knots/],
  ["noisy points, 1000 of them, on 14 cubics", "1,000 noisy points, no noise level given", /^\d+ (?:segments|lines)/],
];

const line = (cells) => `| ${cells.join(" | ")} |`;

function first(rows) {
  const body = ROWS.flatMap(([title, said, remark]) => {
    const row = rows.find((r) => r.title === title);
    if (row === undefined) return [];
    const cells = COLUMNS.map(([, names]) => cell(row.results, names.find((name) => row.results.some((r) => r.name === name)), remark));
    return [line([said, ...cells])];
  });
  return [line(["", ...COLUMNS.map(([title]) => title)]), line(["---", ...COLUMNS.map(() => "---")]), ...body];
}

/** A contestant as the README calls it. */
function plainly(name) {
  if (name.includes("λ × 1.05")) return "a slider's step of λ by 5 %, to 1e-3";
  return name.replace(/^expline, (?!wasm|native)/, "");
}

function second(rows) {
  const body = BESIDE.flatMap(([title, said, remark]) => {
    // A title may go on with what belongs to the run: numbers of places, limits.
    const row = rows.find((r) => r.title === title || r.title.startsWith(`${title},`) || r.title.startsWith(`${title}:`));
    if (row === undefined) return [];
    const [ours, ...others] = row.results;
    const beside = others.map(({ name }) => `${plainly(name)}: ${cell(row.results, name, remark)}`);
    return [line([said, cell(row.results, ours.name, remark), beside.join("; ")])];
  });
  return [line(["", "expline", "for comparison"]), line(["---", "---", "---"]), ...body];
}

/** The tables and what they say about the run. */
export function tables({ machine, cores, node, rounds, rows }) {
  return [
    `One run of \`npm run bench\` (${machine}, ${cores} cores, Node ${node}; the contestants take turns for ${rounds} rounds, and the least time of each counts) on a closed curve of 16 cubics`,
    "in a box of 512. The answers are checked against each other. Each cell is a time and, in brackets, how many times as long as expline it takes: below 1× the other is faster. expline always runs in",
    "wasm, the call included.",
    "",
    ...first(rows),
    "",
    ...second(rows),
  ].join("\n");
}

const [START, END] = ["<!-- times: npm run bench -- --record -->", "<!-- end of times -->"];

/** A text with the tables between its two marks; undefined where there are no marks. */
export function inserted(text, recorded) {
  const [start, end] = [text.indexOf(START), text.indexOf(END)];
  if (start < 0 || end < start) return undefined;
  return `${text.slice(0, start + START.length)}\n${tables(recorded)}\n${text.slice(end)}`;
}
