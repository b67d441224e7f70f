import { Problem } from "../../document/problem.ts";
import { isCoordinate, strokesOf, type Pair, type Strokes } from "./stroke.ts";

/** Points as programs have them: lists of JavaScript, Python or NumPy, JSON with names, one list or several. */

/** What begins so is no file of ours, which begins with the name of its format. */
const listed = /^(?:(?:np\.)?array\()?\s*[[(]\s*(?:[[({]|[-+.\d])|^\{\s*["']?(?:points|data|coordinates|strokes|x)["']?\s*:\s*\[/iu;

/** GeoJSON, whose type may stand after its name or its box. */
const mapped = /^\{[^]*?"type"\s*:\s*"(?:Feature|FeatureCollection|GeometryCollection|(?:Multi)?(?:Point|LineString|Polygon))"/u;

export const beginsAsList = (text: string): boolean => listed.test(text) || mapped.test(text);

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
  // What is JSON may have words in it, which are none of ours. Places one below the other are a list without brackets.
  for (const written of [(): string => text, () => asJson(text), () => `[${asJson(text)}]`]) {
    try {
      return JSON.parse(written());
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

/** Where GeoJSON has its places. */
const placesOfMaps: ReadonlySet<string> = new Set(["features", "geometry", "geometries", "coordinates"]);

function listsInObject(value: object): readonly Places[] {
  const { x, y, type, coordinates } = value as { readonly x?: unknown; readonly y?: unknown; readonly type?: unknown; readonly coordinates?: unknown };
  if (Array.isArray(x) && Array.isArray(y)) return [zipped(x, y)];
  if (type === "Point") return [[pairOf(coordinates)]];
  const entries = Object.entries(value);
  const onMap = entries.filter(([name]) => placesOfMaps.has(name));
  // Beside them stand boxes, and numbers that are known of a place.
  return (onMap.length > 0 ? onMap : entries).flatMap(([, entry]) => listsIn(entry));
}

/** The lists of places in a value, however deep. */
function listsIn(value: unknown): readonly Places[] {
  if (typeof value !== "object" || value === null) return [];
  if (!Array.isArray(value)) return listsInObject(value);
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
  const given = found.map((places) => places.filter((pair) => pair !== null)).filter((list) => list.length > 0);
  if (given.length === 0) throw new Problem("points-rows", { line: 1 });
  // A place on a map is none of its lines; where there are only places, they are one.
  const lines = mapped.test(text) ? given.filter((list) => list.length > 1) : [];
  const lists = lines.length > 0 ? lines : given;
  lists.flat().forEach(([x, y], i) => {
    if (!isCoordinate(x) || !isCoordinate(y)) throw new Problem("points-rows", { line: i + 1 });
  });
  return strokesOf(lists, [
    ...leftOut(found.flat().length - given.flat().length, "place without two numbers", "places without two numbers"),
    ...leftOut(given.length - lists.length, "place on no line", "places on no line"),
  ]);
}

function leftOut(count: number, one: string, many: string): readonly string[] {
  return count === 0 ? [] : [count === 1 ? `one ${one} was left out` : `${count} ${many} were left out`];
}
