// The command line of the packed package: what it writes, what it says, and its status.

import assert from "node:assert/strict";
import { mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { before, test } from "node:test";
import { join } from "node:path";

import { encode as encodePng } from "fast-png";
import { encode as encodeJpeg } from "jpeg-js";

import { PIXELS, PNG, SQUARE, SQUARE_PATH, expline, folder } from "./command-line.ts";

before(() => {
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, "square.csv"), `x,y\n${SQUARE}\n0,0\n`);
  writeFileSync(join(folder, "square.png"), PNG);
  writeFileSync(join(folder, "square.jpg"), encodeJpeg({ width: 40, height: 32, data: PIXELS }, 95).data);
  writeFileSync(join(folder, "broken.png"), PNG.subarray(0, 60));
});

test("a PNG becomes an SVG of its size, and one line says what came of it", () => {
  const { status, out, error } = expline(["trace", "square.png", "-o", "square.svg"]);
  assert.deepEqual([status, error], [0, ""]);
  assert.match(out, /^square\.svg: 40 × 32 pixels, 1 contour, 4 points, largest distance [\d.e-]+\n$/);
  const svg = readFileSync(join(folder, "square.svg"), "utf8");
  assert.match(svg, /^<svg xmlns="http:\/\/www\.w3\.org\/2000\/svg" viewBox="0 0 40 32"><path d="M[^"]+"\/><\/svg>\n$/);
  assert.match(svg, SQUARE_PATH);
});

test("pictures through pipes, and JPEG as well as PNG", () => {
  const piped = expline(["trace", "-"], PNG);
  assert.equal(piped.status, 0, piped.error);
  assert.match(piped.out, SQUARE_PATH);
  const jpeg = expline(["trace", "square.jpg"]);
  assert.equal(jpeg.status, 0, jpeg.error);
  assert.match(jpeg.out, /viewBox="0 0 40 32"><path d="M/);
});

test("PNG of every depth and kind of colour gives the same outline", () => {
  const shades = Uint8Array.from({ length: 40 * 32 }, (_, i) => PIXELS[4 * i] ?? 0);
  const wide = Uint16Array.from(shades, (shade) => 257 * shade);
  const packed = Uint8Array.from({ length: 5 * 32 }, (_, i) => shades.subarray(8 * i, 8 * i + 8).reduce((byte, shade) => 2 * byte + (shade > 0 ? 1 : 0), 0));
  const colored = Uint8Array.from({ length: 3 * 40 * 32 }, (_, i) => shades[Math.floor(i / 3)] ?? 0);
  for (const picture of [
    { data: shades, channels: 1, depth: 8 },
    { data: wide, channels: 1, depth: 16 },
    { data: packed, channels: 1, depth: 1 },
    { data: packed, channels: 1, depth: 1, palette: [[0, 0, 0], [255, 255, 255]] },
    { data: colored, channels: 3, depth: 8 },
  ] as const) {
    const { palette, ...rest } = picture as typeof picture & { palette?: number[][] };
    const { status, out, error } = expline(["trace", "-"], encodePng({ width: 40, height: 32, ...rest, ...(palette === undefined ? {} : { palette }) }));
    assert.equal(status, 0, error);
    assert.match(out, SQUARE_PATH, `${picture.channels} channels of ${picture.depth} bits`);
  }
});

test("several pictures: each beside itself, or all in a folder", () => {
  mkdirSync(join(folder, "traced"), { recursive: true });
  const { status, out } = expline(["trace", "square.png", "square.jpg", "-o", "traced", "--format", "json"]);
  assert.equal(status, 0);
  assert.equal(out.split("\n").length, 3);
  const data = JSON.parse(readFileSync(join(folder, "traced", "square.json"), "utf8")) as { contours: { curve: { type: string } }[] };
  assert.equal(data.contours[0]?.curve.type, "HermiteCurve");
});

test("a folder that is not there is made, pictures of one name stay apart, and a bad one does not keep the others from it", () => {
  rmSync(join(folder, "fresh"), { recursive: true, force: true });
  const { status, out, error } = expline(["trace", "square.png", "broken.png", "square.jpg", "nowhere.png", "-o", "fresh"]);
  assert.equal(status, 1);
  assert.match(error, /^expline: broken\.png: this PNG cannot be read \([^\n]+\); nowhere\.png: there is no such file\n$/);
  assert.match(out, /^fresh\/square\.svg: 40 × 32 pixels, [^\n]+\nfresh\/square-2\.svg: 40 × 32 pixels, [^\n]+\n$/);
  assert.deepEqual(readdirSync(join(folder, "fresh")).sort(), ["square-2.svg", "square.svg"]);
  const single = expline(["trace", "square.png", "-o", "fresh", "--format", "json"]);
  assert.match(single.out, /^fresh\/square\.json: /, "one picture goes into a folder, too");
});

test("a picture that is refused is named", () => {
  const noise = encodePng({ width: 64, height: 64, channels: 1, data: Uint8Array.from({ length: 4096 }, (_, i) => (Math.imul(i + 1, 0x9e3779b1) >>> 24) & 255) });
  writeFileSync(join(folder, "noise.png"), noise);
  const { status, error } = expline(["trace", "noise.png", "--max-contours", "2", "--blur", "0"]);
  assert.equal(status, 1);
  assert.match(error, /^expline: noise\.png: traceImage: the image has \d+ contours, [^\n]+\n$/);
});

test("a heading may follow comments, and semicolons leave commas to the numbers", () => {
  const { status, out } = expline(["fit", "-", "--tolerance", "0.5", "--format", "path"], `# of a square\n\nx;y\n${SQUARE.replaceAll(",", ";")}`);
  assert.equal(status, 0);
  assert.equal(out, expline(["fit", "-", "--tolerance", "0.5", "--format", "path"], SQUARE).out);
});

test("a separator at the end of a row is no third number", () => {
  const { status, out } = expline(["fit", "-", "--tolerance", "0.5", "--format", "path"], SQUARE.replaceAll("\n", ",\n"));
  assert.equal(status, 0);
  assert.equal(out, expline(["fit", "-", "--tolerance", "0.5", "--format", "path"], SQUARE).out);
});

test("numbers in quotation marks, as spreadsheets and data frames write them, are numbers", () => {
  const quoted = `"x","y"\n${SQUARE.replace(/[^,\n]+/g, '"$&"')}`;
  const { status, out } = expline(["fit", "-", "--tolerance", "0.5", "--format", "path"], quoted);
  assert.equal(status, 0);
  assert.equal(out, expline(["fit", "-", "--tolerance", "0.5", "--format", "path"], SQUARE).out);
});

test("flat colours become layers", () => {
  const { status, out } = expline(["trace", "square.png", "--colors", "#fff,#000"]);
  assert.equal(status, 0);
  assert.match(out, /<path fill="#fff" d="M[^"]+"\/><path d="M[^"]+"\/><\/svg>/);
});

test("the data of a picture in colours say which colour each contour has", () => {
  const { status, out } = expline(["trace", "square.png", "--colors", "#fff,#000", "--format", "json"]);
  assert.equal(status, 0);
  const { layers, contours } = JSON.parse(out) as { layers: { color: string }[]; contours: { layer: number }[] };
  assert.deepEqual(contours.map(({ layer }) => layers[layer]?.color), ["#ffffff", "#000000"]);
});

test("points become an SVG within the tolerance, and one line says what came of it", () => {
  const { status, out, error } = expline(["fit", "square.csv", "--tolerance", "0.5", "-o", "out.svg"]);
  assert.deepEqual([status, error], [0, ""]);
  assert.match(out, /^out\.svg: 40 points, \d+ knots, largest distance [\d.e-]+\n$/);
  const svg = readFileSync(join(folder, "out.svg"), "utf8");
  assert.match(svg, /^<svg xmlns="http:\/\/www\.w3\.org\/2000\/svg" viewBox="[-\d. ]+"><path [^>]*d="M[^"]+"\/><\/svg>\n$/);
});

test("a fit by smoothing also says how near to the optimum it is proved to be", () => {
  const { out } = expline(["fit", "square.csv", "--smoothing", "0.3", "-o", "smooth.svg"]);
  assert.match(out, /^smooth\.svg: 40 points, \d+ knots, largest distance [\d.e-]+, certified gap \d+e-\d+\n$/);
});

test("standard input and output: the path alone, from points in rows", () => {
  const { status, out } = expline(["fit", "-", "--tolerance=0.5", "--format", "path"], SQUARE.replaceAll(",", " "));
  assert.equal(status, 0);
  assert.match(out, /^M[-\d.,\sA-Za-z]+\n$/);
});

test("JSON holds the curve to the last bit, with the knots and what is proved", () => {
  const { status, out } = expline(["fit", "square.csv", "--smoothing", "0.5", "--degree", "1", "--no-finish", "--format", "json"]);
  assert.equal(status, 0);
  const [fit] = JSON.parse(out) as { curve: { type: string; closed: boolean }; gap: number; status: string }[];
  assert.equal(fit?.curve.type, "HermiteCurve");
  assert.equal(fit?.curve.closed, true, "the last row repeats the first");
  assert.ok((fit?.gap ?? 1) <= 1e-6);
});

test("an empty row begins another contour", () => {
  const { status, out } = expline(["fit", "-", "--tolerance", "1", "--format", "path"], `${SQUARE}\n\n${SQUARE.split("\n").map((row) => row.replace(/^(\d+)/, "3$1")).join("\n")}`);
  assert.equal(status, 0);
  assert.equal(out.match(/M/g)?.length, 2);
});

test("UTF-16, as Windows PowerShell writes it, is read like UTF-8", () => {
  const text = `x,y\r\n${SQUARE.replaceAll("\n", "\r\n")}\r\n0,0\r\n`;
  const little = Buffer.from(`\ufeff${text}`, "utf16le");
  const wanted = expline(["fit", "-", "--tolerance", "0.5"], text);
  assert.equal(wanted.status, 0, wanted.error);
  for (const bytes of [little, Buffer.from(little).swap16()]) assert.deepEqual(expline(["fit", "-", "--tolerance", "0.5"], bytes), wanted);
});

test("contours that are more than one call takes arguments do not matter", () => {
  const rows = Array.from({ length: 130_000 }, (_, i) => `${i} 0\n${i} 1\n`).join("\n");
  const { status, out, error } = expline(["fit", "-", "--degree", "1", "--lambda", "1", "-o", "many.svg"], rows);
  assert.deepEqual([status, error], [0, ""]);
  assert.match(out, /^many\.svg: 260000 points, 0 knots, /);
  assert.match(readFileSync(join(folder, "many.svg"), "utf8").slice(0, 200), /viewBox="-[\d.]+ -[\d.]+ 131\d+ 1301"/);
});

test("help and version", () => {
  const [help, fit, version] = [expline(["--help"]), expline(["fit", "--help"]), expline(["--version"])];
  assert.match(help.out, /Usage: expline COMMAND/);
  assert.match(fit.out, /--tolerance D/);
  assert.match(version.out, /^\d+\.\d+\.\d+\n$/);
  assert.deepEqual([help.status, fit.status, version.status], [0, 0, 0]);
  assert.deepEqual(expline(["help", "fit"]), fit, "either order will do");
  assert.deepEqual(expline(["help"]), help);
});

for (const [what, parameters, status, words, input] of [
  ["no command", [], 2, /a command is missing/],
  ["a command that there is not", ["trance"], 2, /no command "trance"/],
  ["help on a command that there is not", ["help", "trance"], 2, /no command "trance"/],
  ["a name that is empty", ["fit", ""], 1, /"": there is no such file/],
  ["a result without a name", ["fit", "square.csv", "-o", ""], 1, /"": it cannot be written/],
  ["words in quotation marks", ["fit", "-"], 1, /standard input:2: "abc" is not a number/, '"1","2"\n"abc","3"\n'],
  ["no file", ["fit"], 2, /needs a file/],
  ["an option that there is not", ["fit", "square.csv", "--tolerence", "1"], 2, /no option --tolerence/],
  ["an option without its value", ["fit", "square.csv", "--tolerance"], 2, /--tolerance needs a value/],
  ["a tolerance that is a word", ["fit", "square.csv", "--tolerance", "small"], 2, /--tolerance is "small"; expected a number/],
  ["one weight for two degrees", ["fit", "square.csv", "--lambda", "1"], 2, /--lambda is one number for two degrees; expected L1,L2, or one number with --degree 3/],
  ["two weights for one degree", ["fit", "square.csv", "--lambda", "1,2", "--degree", "3"], 2, /--lambda is two numbers for one degree/],
  ["a negative tolerance", ["fit", "square.csv", "--tolerance", "-1"], 2, /tolerance is -1/],
  ["two strengths", ["fit", "square.csv", "--tolerance", "1", "--smoothing", "0.5"], 2, /only one can be given/],
  ["a file that is not there", ["fit", "nowhere.csv"], 1, /nowhere\.csv: there is no such file/],
  ["a folder", ["fit", "."], 1, /it is a folder/],
  ["a row that is no point", ["fit", "-"], 1, /standard input:2: "abc" is not a number/, "1,2\nabc,3\n"],
  ["numbers with a comma in them", ["fit", "-"], 1, /standard input:1: "1,5" is not a number/, "1,5;2,5\n3,5;4,5\n"],
  ["a single number in a row", ["fit", "-"], 1, /standard input:1: "7" is not two numbers/, "7\n"],
  ["three numbers in a row", ["fit", "-"], 1, /standard input:2: "1,2,3" is not two numbers/, "id,x,y\n1,2,3\n2,5,4\n"],
  ["a corner in other degrees", ["trace", "square.png", "--corner", "200"], 2, /--corner is 200; expected degrees in \[2\.87, 180\]/],
  ["no picture", ["trace"], 2, /needs a PNG or JPEG file/],
  ["a picture that is not there", ["trace", "nowhere.png"], 1, /nowhere\.png: there is no such file/],
  ["a picture that is none", ["trace", "square.csv"], 1, /neither a PNG nor a JPEG/],
  ["half a picture", ["trace", "broken.png"], 1, /broken\.png: this PNG cannot be read/],
  ["a tolerance of 0", ["trace", "square.png", "--tolerance", "0"], 2, /tolerance is 0/],
  ["colours out of range", ["trace", "square.png", "--colors", "1"], 2, /colors is 1; expected an integer in \[2, 64\]/],
  ["a source that there is not", ["trace", "square.png", "--source", "ink"], 2, /--source is "ink"; expected/],
  ["several pictures for one pipe", ["trace", "square.png", "square.jpg", "-o", "-"], 2, /cannot all go to standard output/],
  ["no points at all", ["fit", "-"], 1, /there are no points/, "x,y\n"],
  ["one point", ["fit", "-"], 1, /points has 1 point; expected at least/, "1,2\n"],
  ["a stray point", ["fit", "-"], 1, /standard input:5: the contour that begins here: fitSparse: points has 1 point; expected/, "0,0\n1,1\n3,5\n\n5,5\n"],
  ["colours by name", ["trace", "square.png", "--colors", "red,blue"], 2, /--colors is "red,blue"; expected a number, or colours like #ffffff,#cc0000/],
  ["colours of centre lines", ["trace", "square.png", "--source", "lines", "--colors", "3"], 2, /--source is for ink on paper; it cannot be given with --colors/],
  ["points that are all the same", ["fit", "-"], 1, /points has no unique answer/, "1,2\n1,2\n1,2\n"],
  ["a place that cannot be written", ["fit", "square.csv", "-o", "nowhere/out.svg"], 1, /nowhere\/out\.svg: it cannot be written \(there is no such folder\)/],
] as const) {
  test(`${what}: status ${status} and one clear line`, () => {
    const said = expline(parameters, input ?? "");
    assert.equal(said.status, status, said.error);
    assert.match(said.error, words);
    assert.match(said.error, /^expline: [^\n]+\n$/);
    assert.equal(said.out, "");
  });
}
