import { Problem } from "../../document/problem.ts";
import { cellsOf, isAbsent, numberIn, type Row } from "./cells.ts";
import { columnsOf } from "./columns.ts";
import { sortedRows } from "./order.ts";
import { isCoordinate, strokesOf, type Pair, type Strokes } from "./stroke.ts";

/** Points as tables have them: a row for each, with headings, remarks, other columns and gaps. */

const isRemark = (line: string): boolean => /^(?:#|%|\/\/)/u.test(line);

/** Pairs in one line, as SVG has them: `0,0 10,5 20,0`, or numbers alone. */
function rowsOfLine(line: string): Row[] | null {
  const pairs = line.split(/\s+/u);
  if (pairs.length > 1 && pairs.every((pair) => /^[^,]*\d,[^,]+$/u.test(pair))) return pairs.map((pair) => ({ line: 1, cells: pair.split(","), begins: false }));
  const numbers = cellsOf(line);
  if (numbers.length < 4 || numbers.length % 2 > 0 || numbers.some((cell) => Number.isNaN(numberIn(cell)))) return null;
  return Array.from({ length: numbers.length / 2 }, (_, i) => ({ line: 1, cells: numbers.slice(2 * i, 2 * i + 2), begins: false }));
}

/** Rows that are given in lines of several pairs each are given in one line that was broken. */
function brokenLines(lines: readonly string[]): Row[] | null {
  const said = lines.filter((line) => line !== "");
  if (said.length === 1) return rowsOfLine(said[0] ?? "");
  // Two in a line may be fractions with commas; three are none.
  const areLists = said.every((line) => /^[^\s,;]+,[^\s,;]+(?: +[^\s,;]+,[^\s,;]+)*$/u.test(line)) && said.some((line) => line.split(" ").length > 2);
  return areLists ? rowsOfLine(said.join(" ")) : null;
}

interface Table {
  /** The cells above the first row of numbers; empty where there is no heading. */
  readonly heading: readonly string[];
  readonly rows: readonly Row[];
}

function tableOf(text: string): Table {
  const lines = text.split(/\r\n|\n|\r/u).map((line) => (isRemark(line.trim()) ? null : line.replace(/^\uFEFF/u, "").replace(/^ +|(?<! ) +$/gu, "")));
  const rows: Row[] = brokenLines(lines.filter((line) => line !== null)) ?? [];
  let heading: readonly string[] = [];
  let begins = false;
  if (rows.length === 0) lines.forEach((line, i) => {
    if (line === null) return;
    if (line.trim() === "") return void (begins = rows.length > 0);
    const cells = cellsOf(line);
    // Words above the numbers are a heading; the lowest of them names the columns.
    if (rows.length === 0 && !hasNumbers(cells)) return void (heading = cells);
    rows.push({ line: i + 1, cells, begins });
    begins = false;
  });
  return { heading, rows };
}

function hasNumbers(cells: readonly string[]): boolean {
  return cells.some((cell) => !Number.isNaN(numberIn(cell)));
}

/**
 * Whether this begins as a table does: below any heading, one row and another, with as many cells and numbers at the
 * same places.
 */
export function beginsAsTable(text: string): boolean {
  const { rows: [one, other] } = tableOf(text);
  if (one === undefined || other === undefined || one.cells.length < 2 || one.cells.length !== other.cells.length) return false;
  return one.cells.every((cell, i) => isAbsent(cell) || isAbsent(other.cells[i]) || Number.isNaN(numberIn(cell)) === Number.isNaN(numberIn(other.cells[i])));
}

/** @throws Problem where a row has words instead of numbers, and where most have nothing. */
export function readTable(text: string): Strokes {
  const { heading, rows } = tableOf(text);
  const { x, y, notes } = columnsOf(heading, rows);
  const lists: Pair[][] = [[]];
  let [left, firstLeft] = [0, 1];
  rows.forEach(({ line, cells, begins }, i) => {
    if (begins && lists.at(-1)?.length !== 0) lists.push([]);
    const both = [x === null ? String(i + 1) : cells[x], cells[y]];
    if (both.some(isAbsent)) {
      if (left === 0) firstLeft = line;
      left += 1;
      return;
    }
    const [px, py] = both.map(numberIn);
    if (px === undefined || py === undefined || !isCoordinate(px) || !isCoordinate(py)) throw new Problem("points-rows", { line });
    lists.at(-1)?.push([px, py]);
  });
  const kept = rows.length - left;
  if (left > kept || (left > 0 && kept < 2)) throw new Problem("points-rows", { line: firstLeft });
  const gaps = left === 0 ? [] : [left === 1 ? `line ${firstLeft} has no two numbers and was left out` : `${left} lines without two numbers were left out`];
  const given = lists.filter((list) => list.length > 0);
  const sorted = given.length === 1 ? sortedRows(given.flat()) : null;
  const order = sorted === null ? [] : ["the rows were in no order and have been sorted by x"];
  return strokesOf(sorted === null ? given : [sorted], [...notes, ...gaps, ...order]);
}
