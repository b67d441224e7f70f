/** `expline fit`: points in, the curve with the fewest knots out. */
import { type SparseFit, type SparseFitOptions, fitSparse } from "expline";

import { Failure, INPUT, USAGE, statusOf } from "./failure.ts";
import { keepInputs, sourceName, writeText } from "./files.ts";
import { type Flag, type Given, describeFlags, numberOf, oneOrTwo, readFlags } from "./flags.ts";
import { largest } from "./largest.ts";
import { type Stroke, readPoints, readText } from "./points.ts";

const FLAGS: Readonly<Record<string, Flag>> = {
  tolerance: { value: "D", about: "the fewest knots whose curve is within D of every point" },
  smoothing: { value: "S", about: "0 … 1 instead: the same for any size of picture" },
  lambda: { value: "L", about: "the weight of the papers instead: L1,L2 for two degrees, as is the default, or L with --degree 3" },
  degree: { value: "N", about: "1 to 5, or two with a comma: 1,3 is the default. Without --smoothing and --lambda the higher counts" },
  closed: { about: "the last point is joined to the first; otherwise only where the last row repeats the first" },
  open: { about: "the curve ends at its last point, whatever the rows say" },
  "no-corners": { about: "sharp corners may be rounded; without --smoothing and --lambda" },
  "no-finish": { about: "with --smoothing or --lambda: the optimum as it is, with nothing joined, moved or dropped" },
  decimals: { value: "N", about: "digits after the point in the output; by default as many as the tolerance needs" },
  format: { value: "F", about: "svg, path (the d attribute) or json; by default what the output's name says, else svg" },
  output: { value: "FILE", short: "o", about: "where the result goes; by default standard output" },
  help: { short: "h", about: "this text" },
};

const FIT_HELP = `Usage: expline fit POINTS [options]

POINTS is a file with rows of x and y, or - for standard input. An empty row begins another contour.
Without --tolerance, --smoothing or --lambda the noise of the points is estimated and taken out.

${describeFlags(FLAGS)}
`;

type Format = "svg" | "path" | "json";

/** Runs the command; what is returned goes to standard output. */
export function fit(words: readonly string[]): string {
  const given = readFlags(words, FLAGS);
  if (given.values.has("help")) return FIT_HELP;
  const [file, ...more] = given.operands;
  if (file === undefined) throw new Failure(USAGE, "fit needs a file with points, or - for standard input");
  if (more.length > 0) throw new Failure(USAGE, `fit takes one file; ${more.length + 1} are given`);
  const options = optionsOf(given);
  const format = formatOf(given);
  const decimals = numberOf(given, "decimals");
  if (decimals !== undefined && !(Number.isInteger(decimals) && decimals >= 0 && decimals <= 17)) {
    throw new Failure(USAGE, `--decimals is ${decimals}; expected an integer in [0, 17]`);
  }
  const output = given.values.get("output");
  keepInputs([file], output === "-" ? [] : [output]);
  const strokes = readPoints(readText(file), file);
  if (strokes.length === 0) throw new Failure(INPUT, `${sourceName(file)}: there are no points`);
  const fits = strokes.map((stroke) => {
    const joined = given.values.has("open") ? false : stroke.closed || given.values.has("closed");
    return one(stroke, file, { ...options, closed: joined });
  });
  const text = written(fits, format, decimals, numberOf(given, "tolerance"));
  if (output === undefined || output === "-") return text;
  writeText(output, text);
  return `${output}: ${summary(strokes.reduce((sum, { points }) => sum + points.length / 2, 0), fits)}\n`;
}

/** The fit of one contour; what is wrong with its points is said with the row that it begins in. */
function one({ points, row }: Stroke, file: string, options: SparseFitOptions): SparseFit {
  try {
    return fitSparse(points, options);
  } catch (error) {
    if (statusOf(error) !== INPUT || !(error instanceof Error)) throw error;
    throw new Failure(INPUT, `${sourceName(file)}:${row}: the contour that begins here: ${error.message}`);
  }
}

function optionsOf(given: Given): SparseFitOptions {
  const [tolerance, smoothing] = [numberOf(given, "tolerance"), numberOf(given, "smoothing")];
  const [lambda, degree] = [oneOrTwo(given, "lambda"), oneOrTwo(given, "degree")];
  const asked = [tolerance, smoothing, lambda].filter((strength) => strength !== undefined);
  if (asked.length > 1) throw new Failure(USAGE, "of --tolerance, --smoothing and --lambda only one can be given");
  const pair = degree === undefined || Array.isArray(degree);
  if (lambda !== undefined && pair !== Array.isArray(lambda)) {
    throw new Failure(USAGE, pair ? "--lambda is one number for two degrees; expected L1,L2, or one number with --degree 3" : "--lambda is two numbers for one degree; expected one");
  }
  if (given.values.has("open") && given.values.has("closed")) throw new Failure(USAGE, "--open and --closed exclude each other");
  return {
    tolerance,
    smoothing,
    lambda,
    degree,
    corners: !given.values.has("no-corners"),
    finish: given.values.has("no-finish") ? "none" : "full",
  };
}

function formatOf({ values }: Given): Format {
  const asked = values.get("format") ?? /\.(json|txt)$/iu.exec(values.get("output") ?? "")?.[1]?.toLowerCase() ?? "svg";
  const format = asked === "txt" ? "path" : asked;
  if (format !== "svg" && format !== "path" && format !== "json") {
    throw new Failure(USAGE, `--format is ${JSON.stringify(asked.slice(0, 40))}; expected svg, path or json`);
  }
  return format;
}

function written(fits: readonly SparseFit[], format: Format, decimals: number | undefined, tolerance: number | undefined): string {
  if (format === "json") return `${JSON.stringify(fits.map(asData), undefined, 1)}\n`;
  const extent = boxOf(fits);
  const size = Math.max(extent.width, extent.height);
  // A tenth of what was asked for, so that writing it down does not use the tolerance up.
  const within = tolerance === undefined || tolerance === 0 ? size / 1e4 : tolerance / 10;
  const d = fits.map(({ curve }) => curve.toPathD({ tolerance: within || 1e-9, decimals }).d).join("");
  if (format === "path") return `${d}\n`;
  const stroke = Number((size / 200 || 1).toPrecision(2));
  const box = [extent.x - stroke, extent.y - stroke, extent.width + 2 * stroke, extent.height + 2 * stroke];
  const view = box.map((value) => Number(value.toPrecision(6))).join(" ");
  const path = `<path fill="none" stroke="#000" stroke-width="${stroke}" stroke-linejoin="round" d="${d}"/>`;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${view}">${path}</svg>\n`;
}

function asData({ curve, knots, objective, gap, qfe, maxError, lambda, smoothing, sigma, status, iterations }: SparseFit): object {
  return { curve: curve.toJSON(), knots, objective, gap, qfe, maxError, lambda, smoothing, sigma, status, iterations };
}

function boxOf(fits: readonly SparseFit[]): { x: number; y: number; width: number; height: number } {
  const boxes = fits.map(({ curve }) => curve.bounds());
  const [x, y] = [-largest(boxes.map(({ minX }) => -minX)), -largest(boxes.map(({ minY }) => -minY))];
  return { x, y, width: largest(boxes.map(({ maxX }) => maxX)) - x, height: largest(boxes.map(({ maxY }) => maxY)) - y };
}

function summary(points: number, fits: readonly SparseFit[]): string {
  const knots = fits.reduce((sum, fit) => sum + fit.knots.length, 0);
  const error = largest(fits.map(({ maxError }) => maxError));
  // Where no λ was involved there is no optimum that a gap would speak of: the distance is what is proved.
  const gaps = fits.filter(({ lambda }) => lambda.length > 0).map(({ gap }) => gap);
  const certified = gaps.length > 0 ? `, certified gap ${largest(gaps).toExponential(0)}` : "";
  return `${points} points, ${knots} knots, largest distance ${Number(error.toPrecision(3))}${certified}`;
}
