/** Points from rows of text. */
import { Failure, INPUT } from "./failure.ts";
import { readBytes, sourceName } from "./files.ts";

/** The points of one contour, x and y in turn. */
export interface Stroke {
  readonly points: Float64Array;
  /** The row of the file that it begins in, counted from 1. */
  readonly row: number;
  /** The last row repeats the first: the contour is closed, and the repetition is gone. */
  readonly closed: boolean;
}

const LARGEST = 1e9;
/** A contour has half a million points at most. */
const MOST_MEGABYTES = 64;

/**
 * The text of a file, or of standard input for `-`: in UTF-8, or in UTF-16 where its first bytes say so, as what
 * Windows PowerShell writes with `>`.
 */
export function readText(file: string): string {
  const bytes = readBytes(file, MOST_MEGABYTES);
  const [first, second] = bytes;
  const encoding = first === 0xff && second === 0xfe ? "utf-16le" : first === 0xfe && second === 0xff ? "utf-16be" : "utf-8";
  return new TextDecoder(encoding).decode(bytes);
}

/**
 * Rows of x and y with a comma, a semicolon, a tab or blanks between them. A first row of words, after comments, is a
 * heading, `#` begins a comment, an empty row begins another contour.
 */
export function readPoints(text: string, file: string): Stroke[] {
  const strokes: { readonly numbers: number[]; readonly row: number }[] = [];
  let open = false;
  let heading = true;
  text.replace(/^\uFEFF/u, "").split(/\r\n|\n|\r/u).forEach((line, i) => {
    const row = line.replace(/#.*$/u, "").trim();
    if (row === "") {
      if (line.trim() === "") open = false;
      return;
    }
    // Between semicolons a comma belongs to a number as some countries write it; it is not read as two.
    const cells = row.split(row.includes(";") ? /\s*[;\t]\s*|\s+/u : /\s*[,\t]\s*|\s+/u).map(unquoted);
    const first = heading;
    heading = false;
    if (first && cells.every((cell) => !/\d/u.test(cell[0] ?? "") && (cell === "" || Number.isNaN(Number(cell))))) return;
    // Of three it is not known which are x and y: an index or a time may come before them.
    if (cells.length < 2 || cells.slice(2).some((cell) => cell !== "")) throw new Failure(INPUT, `${sourceName(file)}:${i + 1}: ${shown(row)} is not two numbers`);
    if (!open) strokes.push({ numbers: [], row: i + 1 });
    open = true;
    for (const cell of cells.slice(0, 2)) strokes.at(-1)?.numbers.push(coordinate(cell, `${sourceName(file)}:${i + 1}`));
  });
  return strokes.map(({ numbers, row }) => stroke(numbers, row));
}

/** A cell as it was before some program put it in quotation marks. */
const unquoted = (cell: string): string => /^"(.*)"$/u.exec(cell)?.[1]?.trim() ?? cell;

function coordinate(cell: string, place: string): number {
  const value = cell === "" ? Number.NaN : Number(cell);
  if (Number.isNaN(value)) throw new Failure(INPUT, `${place}: ${shown(cell)} is not a number`);
  if (!(Math.abs(value) <= LARGEST)) throw new Failure(INPUT, `${place}: ${shown(cell)} is out of range; expected |x| <= 1e9`);
  return value;
}

const shown = (text: string): string => JSON.stringify(text.length > 40 ? `${text.slice(0, 39)}…` : text);

function stroke(numbers: readonly number[], row: number): Stroke {
  const closed = numbers.length > 6 && numbers[0] === numbers.at(-2) && numbers[1] === numbers.at(-1);
  return { points: Float64Array.from(closed ? numbers.slice(0, -2) : numbers), row, closed };
}
