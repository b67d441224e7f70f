/** Points as tables and programs have them. */
import { Problem } from "../document/problem.ts";

export const mostPoints = 100_000;

/** Words above numbers: the names of the columns. */
export const heading = /^["']?[a-z]\w*["']?(?:\s*[,;\t]\s*["']?[a-z]\w*["']?)+\s*\n\s*[-+.\d]/iu;

/** Points as a program has them: `[[1, 2], [3, 4]]`, `[{ x: 1, y: 2 }, …]`. */
export const listed = /^\[\s*(?:\[\s*[-+.\d]|\{\s*["']?x["']?\s*:)/u;

/** Every point of a list on a line of its own, however many lines a program has put it on. */
function rowsOfList(text: string): string {
  let end = text.length;
  while (end > 0 && " \n\r\t,;]}".includes(text[end - 1] ?? "-")) end -= 1;
  return text.slice(0, end).replace(/\s+/gu, " ").replace(/[\]}]\s*(?:,\s*)?[[{]/gu, "\n").replace(/["']?\b[xy]["']?\s*:|[[\]{}]/gu, "");
}

/** The numbers of a row; beside a semicolon or a tab a comma is that of a decimal fraction. A place with nothing in it is no number. */
function numbersOf(row: string): number[] {
  const parts = /[;\t]/u.test(row) ? row.replaceAll(",", ".").split(/\s*[;\t]\s*/u) : row.split(/\s*,\s*|\s+/u);
  return parts.map((part) => (part === "" ? NaN : Number(part)));
}

/** Rows of two numbers, with a comma, semicolon, tab or blanks between them; a first row of words is a heading. */
export function readPoints(text: string): { readonly points: readonly (readonly [number, number])[]; readonly closed: boolean } {
  const rows = (listed.test(text.trim()) ? rowsOfList(text) : text).split(/\r?\n/u);
  const points: [number, number][] = [];
  rows.forEach((row, i) => {
    if (row.trim() === "" || (points.length === 0 && heading.test(`${row.trim()}\n0`))) return;
    const [x, y, ...rest] = numbersOf(row.trim());
    if (x === undefined || y === undefined || rest.length > 0 || !(Math.abs(x) <= 1e9 && Math.abs(y) <= 1e9)) throw new Problem("points-rows", { line: i + 1 });
    const last = points.at(-1);
    if (last === undefined || last[0] !== x || last[1] !== y) points.push([x, y]);
    if (points.length > mostPoints) throw new Problem("points-big", { most: mostPoints });
  });
  const [first, last] = [points[0], points.at(-1)];
  // A last row that repeats the first closes the curve.
  const closed = points.length > 3 && first !== undefined && last !== undefined && first[0] === last[0] && first[1] === last[1];
  if (closed) points.pop();
  if (points.length < 2) throw new Problem("points-few", { count: points.length });
  return { points, closed };
}
