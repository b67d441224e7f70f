import { Problem } from "../../document/problem.ts";
import { isCoordinate, strokesOf, type Pair, type Strokes } from "./stroke.ts";

/** Points as programs have them: lists of JavaScript, Python or NumPy, JSON with names, one list or several. */

/** What begins so is no file of ours, which begins with the name of its format. */
const listed = /^(?:(?:np\.)?array\()?\s*[[(]\s*(?:[[({]|[-+.\d])|^\{\s*["']?(?:points|data|coordinates|strokes|x)["']?\s*:\s*\[|^\{\s*["']?type["']?\s*:\s*["'](?:LineString|MultiLineString|Polygon|MultiPoint)["']/iu;

export const beginsAsList = (text: string): boolean => listed.test(text);

/**
 * As JSON would have it: brackets of one kind, commas between, names in quotation marks, `null` for what is no number.
 */
function asJson(text: string): string {
  return text.trim().replace(/[;,\s]+$/u, "")
    .replace(/\b(?:np\.)?array\b|\bdtype\s*=\s*[\w.]+/gu, "").replace(/\(/gu, "[").replace(/\)/gu, "]")
    .replace(/\u2212/gu, "-").replaceAll("'", "\"").replace(/\b(?:NaN|nan|None)\b/gu, "null")
    .replace(/([{,]\s*)([a-z_]\w*)\s*:/giu, "$1\"$2\":")
    .replace(/([\d.\]}])\s+(?=[-+.\d[{])/gu, "$1,").replace(/\](?=\[)|\}(?=\{)/gu, "$&,").replace(/,\s*(?=[\]}])/gu, "")
    // Numbers of programs that JSON does not know: `1.`, `.5`, `+2`.
    .replace(/(\d)\.(?!\d)/gu, "$1").replace(/(^|[^\d])\.(?=\d)/gu, "$10.").replace(/([[,:]\s*)\+/gu, "$1");
}

function parsed(text: string): unknown {
  const json = asJson(text);
  // Places one below the other are a list without its brackets.
  for (const list of [json, `[${json}]`]) {
    try {
      return JSON.parse(list);
    } catch {
      continue;
    }
  }
  throw new Problem("points-list");
}

const isNumber = (value: unknown): value is number => typeof value === "number";

/** A place: two numbers, after which others may stand, or an object with an x and a y. */
function pairOf(value: unknown): Pair | null {
  if (Array.isArray(value)) return value.length >= 2 && value.length <= 4 && value.every(isNumber) ? [value[0] ?? 0, value[1] ?? 0] : null;
  if (typeof value !== "object" || value === null) return null;
  const byName = new Map(Object.entries(value).map(([name, entry]) => [name.toLowerCase(), entry as unknown]));
  const [x, y] = [byName.get("x"), byName.get("y")];
  return isNumber(x) && isNumber(y) ? [x, y] : null;
}

/** Null where a place has no two numbers. */
type Places = readonly (Pair | null)[];

/** The lists of places in a value, however deep. */
function listsIn(value: unknown): readonly Places[] {
  if (typeof value !== "object" || value === null) return [];
  if (!Array.isArray(value)) {
    const columns = value as { readonly x?: unknown; readonly y?: unknown };
    if (Array.isArray(columns.x) && Array.isArray(columns.y)) return [zipped(columns.x, columns.y)];
    return Object.values(value).flatMap(listsIn);
  }
  const all: readonly unknown[] = value;
  if (all.length >= 4 && all.length % 2 === 0 && all.every(isNumber)) return [Array.from({ length: all.length / 2 }, (_, i): Pair => [all[2 * i] as number, all[2 * i + 1] as number])];
  const pairs = all.map(pairOf);
  if (pairs.every((pair) => pair === null)) return all.flatMap(listsIn);
  const lengthOf = (each: unknown): number => (Array.isArray(each) ? each.length : 0);
  const odd = all.findIndex((each) => lengthOf(each) !== lengthOf(all[0]));
  if (odd >= 0) throw new Problem("points-rows", { line: odd + 1 });
  return [pairs];
}

function zipped(x: readonly unknown[], y: readonly unknown[]): Places {
  return x.map((each, i) => pairOf([each, y[i]]));
}

/** @throws Problem where that is no list of places. */
export function readList(text: string): Strokes {
  const found = listsIn(parsed(text));
  const lists = found.map((places) => places.filter((pair) => pair !== null)).filter((list) => list.length > 0);
  if (lists.length === 0) throw new Problem("points-rows", { line: 1 });
  lists.flat().forEach(([x, y], i) => {
    if (!isCoordinate(x) || !isCoordinate(y)) throw new Problem("points-rows", { line: i + 1 });
  });
  const gaps = found.flat().length - lists.flat().length;
  return strokesOf(lists, gaps === 0 ? [] : [gaps === 1 ? "one place without two numbers was left out" : `${gaps} places without two numbers were left out`]);
}
