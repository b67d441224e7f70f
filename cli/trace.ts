/** `expline trace`: pictures in, their outlines out. */
import { basename, dirname, extname, join } from "node:path";

import { type Trace, type TraceOptions, traceImage } from "expline";

import { Failure, INPUT, USAGE, statusOf } from "./failure.ts";
import { isFile, isFolder, keepInputs, makeFolder, sourceName, writeText } from "./files.ts";
import { type Flag, type Given, describeFlags, numberOf, readFlags } from "./flags.ts";
import { largest } from "./largest.ts";
import { type Picture, readPicture } from "./picture.ts";

const FLAGS: Readonly<Record<string, Flag>> = {
  tolerance: { value: "D", about: "largest distance of a curve from its contour in pixels, before it is refined" },
  threshold: { value: "N", about: "shade between ink and paper, 0 … 255; by default found" },
  blur: { value: "S", about: "deviation in pixels of a blur before all else; by default as much as the noise needs" },
  invert: { about: "light ink on dark paper" },
  speckle: { value: "A", about: "leave out contours that enclose fewer square pixels" },
  corner: { value: "DEG", about: "the least turning of a corner in degrees, 2.87 … 180; 180 knows no corners, 28 is the default" },
  source: { value: "S", about: "what is followed: brightness, the default, edges, or lines, the middle of thin strokes" },
  model: { value: "M", about: "sparse, the default, or wqisa" },
  colors: { value: "N", about: "at most so many flat colours, or a list: #ffffff,#cc0000,#00aa00; without --source, --threshold and --invert" },
  "no-refine": { about: "contours are followed, but pixels are not asked again" },
  "max-contours": { value: "N", about: "more than this is refused as a photograph; by default 1500" },
  decimals: { value: "N", about: "digits after the point in the output; by default 2" },
  format: { value: "F", about: "svg or json; by default what the output's name says, else svg" },
  output: { value: "FILE", short: "o", about: "where the result goes; for several pictures a folder, which may be new and has no name like a.svg. By default standard output, or beside each picture" },
  help: { short: "h", about: "this text" },
};

const TRACE_HELP = `Usage: expline trace PICTURE... [options]

PICTURE is a PNG or JPEG file, or - for standard input.

${describeFlags(FLAGS)}
`;

type Format = "svg" | "json";

/** Degrees; the package has a twentieth, in radians. */
const LEAST_CORNER = 2.87;

/** Runs the command; what is returned goes to standard output. */
export function trace(words: readonly string[]): string {
  const given = readFlags(words, FLAGS);
  if (given.values.has("help")) return TRACE_HELP;
  const files = given.operands;
  if (files.length === 0) throw new Failure(USAGE, "trace needs a PNG or JPEG file, or - for standard input");
  if (files.filter((file) => file === "-").length > 1) throw new Failure(USAGE, "standard input can be read only once");
  const options = optionsOf(given);
  const format = formatOf(given);
  const decimals = numberOf(given, "decimals");
  if (decimals !== undefined && !(Number.isInteger(decimals) && decimals >= 0 && decimals <= 17)) {
    throw new Failure(USAGE, `--decimals is ${decimals}; expected an integer in [0, 17]`);
  }
  const outputs = targets(files, given, format);
  keepInputs(files, outputs);
  return each(files, outputs, (file, output) => one(file, output, options, format, decimals));
}

/** Of so many pictures one line says what is wrong with them. */
const MOST_NAMED = 8;

/** All pictures, one after the other: one that cannot be traced does not keep the others from it. */
function each(files: readonly string[], outputs: readonly (string | undefined)[], work: (file: string, output: string | undefined) => string): string {
  const [done, failed]: [string[], string[]] = [[], []];
  files.forEach((file, i) => {
    try {
      done.push(work(file, outputs[i]));
    } catch (error) {
      if (statusOf(error) !== INPUT || !(error instanceof Error)) throw error;
      failed.push(error instanceof Failure ? error.message : `${sourceName(file)}: ${error.message}`);
    }
  });
  if (failed.length === 0) return done.join("");
  const more = failed.splice(MOST_NAMED).length;
  throw new Failure(INPUT, failed.join("; ") + (more === 0 ? "" : `; nor could ${more} more`), done.join(""));
}

function one(file: string, output: string | undefined, options: TraceOptions, format: Format, decimals: number | undefined): string {
  const picture = readPicture(file);
  const traced = traceImage(picture, options);
  const text = format === "json" ? `${JSON.stringify(asData(traced), undefined, 1)}\n` : `${traced.toSvg({ decimals })}\n`;
  if (output === undefined) return text;
  writeText(output, text);
  return `${output}: ${summary(picture, traced)}\n`;
}

/** Where the result of each picture goes; undefined for standard output. */
function targets(files: readonly string[], { values }: Given, format: Format): (string | undefined)[] {
  const asked = values.get("output");
  const several = files.length > 1;
  if (several && asked === "-") throw new Failure(USAGE, "several pictures cannot all go to standard output");
  if (!several && (asked === undefined || asked === "-" || !isFolder(asked))) return [asked === "-" ? undefined : asked];
  if (asked !== undefined) asFolder(asked, files.length);
  const taken = new Set<string>();
  return files.map((file) => {
    const name = file === "-" ? "picture" : basename(file, extname(file));
    const folder = asked ?? (file === "-" ? "." : dirname(file));
    // Pictures of the same name do not take each other's place.
    let path = join(folder, `${name}.${format}`);
    for (let k = 2; taken.has(path); k += 1) path = join(folder, `${name}-${k}.${format}`);
    taken.add(path);
    return path;
  });
}

/**
 * A folder for the results of several pictures; a name that is a file's is a mistake, and one picture would take the
 * other's place.
 */
function asFolder(path: string, count: number): void {
  if (!isFolder(path) && (isFile(path) || /\.(?:svg|json)$/iu.test(path))) {
    throw new Failure(USAGE, `${path}: the results of ${count} pictures need a folder, and this is a file or is called like one`);
  }
  makeFolder(path);
}

function optionsOf(given: Given): TraceOptions {
  const { values } = given;
  const colors = values.get("colors");
  if (colors !== undefined) checkColors(colors, values);
  return {
    tolerance: numberOf(given, "tolerance"),
    threshold: numberOf(given, "threshold"),
    blur: numberOf(given, "blur"),
    speckle: numberOf(given, "speckle"),
    corner: cornerOf(numberOf(given, "corner")),
    maxContours: numberOf(given, "max-contours"),
    colors: colors?.startsWith("#") === true ? colors.split(/\s*,\s*/u) : numberOf(given, "colors"),
    source: oneOf(values, "source", ["brightness", "edges", "lines"]),
    model: oneOf(values, "model", ["sparse", "wqisa"]),
    invert: values.has("invert"),
    refine: !values.has("no-refine"),
  };
}

/** In radians; checked as it is given, in degrees: the package would speak of radians. */
function cornerOf(degrees: number | undefined): number | undefined {
  if (degrees === undefined) return undefined;
  if (degrees >= LEAST_CORNER && degrees <= 180) return degrees * (Math.PI / 180);
  throw new Failure(USAGE, `--corner is ${degrees}; expected degrees in [${LEAST_CORNER}, 180]`);
}

/** Each colour is a layer of its own: what tells ink from paper has no say there. */
function checkColors(colors: string, values: Given["values"]): void {
  const idle = ["source", "threshold", "invert"].find((name) => values.has(name) && values.get(name) !== "brightness");
  if (idle !== undefined) throw new Failure(USAGE, `--${idle} is for ink on paper; it cannot be given with --colors`);
  if (colors.startsWith("#") || Number.isFinite(Number(colors.trim() || Number.NaN))) return;
  throw new Failure(USAGE, `--colors is ${JSON.stringify(colors.slice(0, 40))}; expected a number, or colours like #ffffff,#cc0000`);
}

function oneOf<W extends string>(values: Given["values"], name: string, words: readonly W[]): W | undefined {
  const value = values.get(name);
  const found = words.find((word) => word === value);
  if (value === undefined || found !== undefined) return found;
  throw new Failure(USAGE, `--${name} is ${JSON.stringify(value.slice(0, 40))}; expected ${words.join(", ")}`);
}

function formatOf({ values }: Given): Format {
  const asked = values.get("format") ?? /\.(json)$/iu.exec(values.get("output") ?? "")?.[1]?.toLowerCase() ?? "svg";
  if (asked !== "svg" && asked !== "json") throw new Failure(USAGE, `--format is ${JSON.stringify(asked.slice(0, 40))}; expected svg or json`);
  return asked;
}

function asData({ width, height, layers, contours }: Trace): object {
  return { width, height, layers, contours: contours.map(({ curve, ...rest }) => ({ curve: curve.toJSON(), ...rest })) };
}

function summary({ width, height }: Picture, { contours }: Trace): string {
  const points = contours.reduce((sum, { curve }) => sum + curve.points.length / 2, 0);
  const farthest = Math.max(0, largest(contours.map(({ metrics }) => metrics.max)));
  const found = `${contours.length} ${contours.length === 1 ? "contour" : "contours"}, ${points} points`;
  return `${width} × ${height} pixels, ${found}, largest distance ${Number(farthest.toPrecision(3))}`;
}
