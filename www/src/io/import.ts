/** What was pasted, dropped or typed: recognised by its first characters, read into contours or a whole state. */
import { artboardOf } from "../document/artboard.ts";
import { isLineWidth, type Line } from "../document/painted.ts";
import type { Space } from "../document/document.ts";
import { FileError, parseState } from "../document/file/file.ts";
import type { Imported } from "../document/imported.ts";
import { Problem } from "../document/problem.ts";
import { filled, type FilledShape } from "../kernel/paths/filling.ts";
import { boundsOfPath, importPath, importPoints, lengthOfPath, type Drawn } from "../kernel/paths/import.ts";
import { beginsAsList, beginsAsTable, mostPoints, readPoints } from "./points/points.ts";
import { SvgFileError, type SvgWarningCode } from "./svg/limits.ts";
import type { Stroke } from "./svg/style/line.ts";
import { readSvg, type SvgFile, type SvgShape } from "./svg/svg-file.ts";
import { inkOfFiles } from "./svg/svg-write.ts";

export type ImportKind = "svg" | "path" | "points" | "json";

/** Path data as a program has it: `d="…"`, `path("…")`, `new Path2D("…")`. */
const quoted = /["'`]\s*([mM]\s*[-+.\d][^"'`]*)(?:["'`]|$)/u;

/** The names of two columns above numbers, though they begin as path data does: `m1,m2`. */
const heading = /^[a-z]\d*\s*[,;\t]\s*["']?[a-z]\w*["']?[^\n]*\n\s*[-+.\d]/iu;

/** What a text seems to be, or null when it is nothing that can be drawn. */
export function kindOfText(text: string): ImportKind | null {
  const start = text.replace(/^[\uFEFF\s]+/u, "").slice(0, 2000);
  if (start.startsWith("<")) return "svg";
  if (beginsAsList(start)) return "points";
  if (start.startsWith("{") || start.startsWith("[")) return "json";
  if (quoted.test(start)) return "path";
  if (/^[-+.\d]/u.test(start)) return "points";
  if (/^[a-z]\s*[-+.\d]/iu.test(start) && !heading.test(start)) return "path";
  return beginsAsTable(start) ? "points" : /^m/iu.test(start) ? "path" : null;
}

/**
 * @throws Problem, also where nothing came of it; a JSON `null` or list is refused as the file it fails to be, not as
 *   unknown text.
 */
export function readImport(text: string, space: Space): Imported {
  const imported = readAs(text, space);
  if (imported.kind !== "json" && imported.contours.length === 0) throw imported.broken ?? new Problem("paste-unknown");
  return imported;
}

function readAs(text: string, space: Space): Imported {
  const kind = text.trim() === "null" ? "json" : kindOfText(text);
  switch (kind) {
    case "json":
      return readJson(text);
    case "svg":
      return readDrawing(text, space);
    case "path":
      return readPath((quoted.exec(text)?.[1] ?? text).trim(), space);
    case "points":
      return readRows(text, space);
    case null:
      throw new Problem("paste-unknown");
  }
}

function readJson(text: string): Imported {
  try {
    const { state, warnings } = parseState(text);
    const notes = warnings.length === 0 ? [] : [`Left out: ${warnings.map((warning) => warning.path).join(", ")} (not known here).`];
    return { kind: "json", state, notes };
  } catch (error) {
    if (!(error instanceof FileError)) throw error;
    if (error.code === "E_UNSUPPORTED") throw new Problem("json-version", { version: error.detail.version ?? 0 });
    const what = error.message.replace(/ \[E_[A-Z_]+\]$/u, "").replace(/^\$\.?/u, "").trim().replace(/^is /u, "it is ");
    throw new Problem(error.code === "E_LIMIT" ? "json-big" : "json-broken", { field: what, code: error.code });
  }
}

function readPath(d: string, space: Space): Imported {
  const { contours, broken } = importPath(d, space);
  if (contours.reduce((sum, { points }) => sum + points.length, 0) > mostPoints) throw new Problem("d-big");
  // Nobody who hands on path data says by which rule it is filled; where nothing is said, it is this one.
  return { kind: "path", notes: [], broken, ...filled([{ contours, rule: "nonzero", fill: "" }], space) };
}

function readDrawing(text: string, space: Space): Imported {
  const file = readFile(text);
  if (file.shapes.length === 0) throw new Problem("svg-nopath", insteadOfPaths(file));
  const shapes: FilledShape[] = [];
  const isColored = !file.shapes.every(isInk);
  let broken: Problem | null = null;
  let points = 0;
  for (const shape of file.shapes) {
    const part = importPath(shape.d, space, shape.transform, drawnAs(shape));
    broken ??= part.broken;
    shapes.push({ contours: part.contours, ...paintedAs(shape, isColored) });
    for (const contour of part.contours) points += contour.points.length;
    if (points > mostPoints) throw new Problem("svg-big", { field: "points", most: mostPoints });
  }
  const artboard = file.picture === null ? null : artboardOf(file.picture);
  return { kind: "svg", ...filled(shapes, space), ...(artboard === null ? {} : { artboard }), notes: notesOf(file), broken };
}

/** What a file has that outlines could be made of. */
function insteadOfPaths({ warnings }: SvgFile): { readonly field?: string } {
  const has = (wanted: SvgWarningCode): boolean => warnings.some(({ code }) => code === wanted);
  return has("W_TEXT") ? { field: "text" } : has("W_PICTURE") ? { field: "picture" } : {};
}

/** What is black, or our own ink of files, is ink and no colour. */
function isInk({ fill, stroke }: SvgShape): boolean {
  return [fill, stroke].every((part) => part === null || part.color === null || part.color === "#000000" || part.color === inkOfFiles);
}

function drawnAs({ fill, stroke }: SvgShape): Drawn {
  return stroke === null ? "areas" : fill === null ? "lines" : "either";
}

function paintedAs({ fill, stroke }: SvgShape, isColored: boolean): Omit<FilledShape, "contours"> {
  const line = stroke === null ? undefined : lineOf(stroke, isColored);
  const painted = line === undefined ? {} : { line };
  if (fill === null) return { rule: "nonzero", fill: null, ...painted };
  const { paint, rule, color } = fill;
  return { rule, fill: paint, ...painted, ...(isColored && color !== null ? { ink: color } : {}) };
}

/** Absent where nothing says how wide it is, or it is wider than any drawing. */
function lineOf({ color, width, ...ends }: Stroke, isColored: boolean): Line | undefined {
  if (width === undefined || !isLineWidth(width)) return undefined;
  return { width, ...ends, ...(isColored && color !== null ? { color } : {}) };
}

function readFile(text: string): SvgFile {
  try {
    return readSvg(text, boundsOfPath, lengthOfPath);
  } catch (error) {
    if (!(error instanceof SvgFileError)) throw error;
    if (error.code === "E_LIMIT") throw new Problem("svg-big", { field: error.detail.limit ?? "size", most: error.detail.max ?? 0, code: error.code });
    if (error.code === "E_RANGE") throw new Problem("svg-range", { code: error.code });
    if (error.detail.reason === "doctype") throw new Problem("svg-entities", { code: error.code });
    const { line, column } = error.detail;
    throw new Problem("svg-broken", { code: error.code, ...(line === undefined ? {} : { line, column: column ?? 1 }) });
  }
}

const notesByCode: Readonly<Record<SvgWarningCode, string>> = {
  W_CYCLE: "a reference to itself was left out",
  W_BAD_TRANSFORM: "a transform that could not be read was ignored",
  W_BAD_VIEWBOX: "the viewBox could not be used",
  W_BAD_LENGTH: "a shape without a valid size was left out",
  W_UNIT: "a length in page-relative units was ignored",
  W_ODD_POINTS: "an unpaired last coordinate was dropped",
  W_GRADIENT: "a gradient became its average colour",
  W_DASHES: "a dashed line became solid",
  W_STYLE: "a style sheet was only partly applied",
  W_STYLE_TRANSFORM: "a CSS transform in 3D, or in percent of an unknown size, was ignored",
  W_TEXT: "text was left out; convert it to outlines to include it",
  W_PICTURE: "a picture was left out; use Trace for pictures",
  W_CLIP: "clips and masks were ignored, so hidden parts show",
  W_NO_TARGET: "a reference to something outside the file was left out",
};

function notesOf(file: SvgFile): string[] {
  const codes = new Set(file.warnings.map((warning) => warning.code));
  return [...codes].map((code) => notesByCode[code]);
}

function readRows(text: string, space: Space): Imported {
  const { strokes, notes } = readPoints(text);
  return { kind: "points", contours: strokes.map(({ points, closed }) => importPoints(points, closed, space)), notes, broken: null };
}
