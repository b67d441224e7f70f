import { Problem } from "../../document/problem.ts";
import { numberIn, type Row } from "./cells.ts";

/** Which columns of a table are x and y. */
export interface Columns {
  /** Null where a row's number is its x. */
  readonly x: number | null;
  readonly y: number;
  readonly notes: readonly string[];
}

/** A heading without its unit: `X [mm]` is x. */
const named = (heading: readonly string[], name: RegExp): number => heading.findIndex((cell) => name.test(cell.replace(/[[(/_].*$/u, "").trim()));

/** What stands above numbers of rows; nothing, as a rule. */
const numbering = /^(?:|#|nr\.?|no\.?|num|number|[ikn]|id|idx|index|row|line|point|pt)$/iu;

export function columnsOf(heading: readonly string[], rows: readonly Row[]): Columns {
  const count = rows.reduce((most, { cells }) => Math.max(most, cells.length), 0);
  // A column of words, such as names or dates, says nothing; one with a number among words is to be complained about.
  const numeric = Array.from({ length: count }, (_, i) => i).filter((i) => rows.some(({ cells }) => !Number.isNaN(numberIn(cells[i]))));
  const [first, second, third] = numeric;
  if (first === undefined) throw new Problem("points-rows", { line: rows[0]?.line ?? 1 });
  const [x, y] = [named(heading, /^(?:x|lon|lng|longitude)$/iu), named(heading, /^(?:y|lat|latitude)$/iu)];
  if (numeric.includes(x) && numeric.includes(y)) return { x, y, notes: [] };
  if (second === undefined) return { x: null, y: first, notes: [`only column ${first + 1} has numbers, so each row's number is its x`] };
  if (third === undefined) return { x: first, y: second, notes: [] };
  const [px, py] = numbering.test(heading[first] ?? "") && countsRows(rows, first) ? [second, third] : [first, second];
  return { x: px, y: py, notes: [`of ${count} columns, ${px + 1} and ${py + 1} were read as x and y`] };
}

/** A column of 0, 1, 2, …, or from 1 on, that numbers the rows. */
function countsRows(rows: readonly Row[], column: number): boolean {
  const start = numberIn(rows[0]?.cells[column]);
  return (start === 0 || start === 1) && rows.length > 2 && rows.every(({ cells }, i) => numberIn(cells[column]) === start + i);
}
