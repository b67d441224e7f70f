import type { DemoState } from "../../document/document.ts";

/** The text of a state in pieces of a few milliseconds at most, for whoever cannot wait for all of a large one. */
export function statePieces(state: DemoState): Iterable<string> {
  return piecesOf(state);
}

/** Numbers, texts, lists and objects that are written at a time. */
const most = 4000;

function* piecesOf(value: unknown): Generator<string, void> {
  if (weightOf(value, most) <= most) yield JSON.stringify(value);
  else if (Array.isArray(value)) yield* listPieces(value);
  else yield* objectPieces(value as object);
}

function* objectPieces(value: object): Generator<string, void> {
  let before = "{";
  for (const [name, each] of Object.entries(value)) {
    if (each === undefined) continue;
    yield `${before}${JSON.stringify(name)}:`;
    yield* piecesOf(each);
    before = ",";
  }
  yield before === "{" ? "{}" : "}";
}

function* listPieces(list: readonly unknown[]): Generator<string, void> {
  let [before, from, weight] = ["[", 0, 0];
  for (let i = 0; i <= list.length; i += 1) {
    const own = i < list.length ? weightOf(list[i], most) : Infinity;
    if ((weight += own) <= most) continue;
    // What comes before the one that is too much.
    if (from < i) {
      yield before + JSON.stringify(list.slice(from, i)).slice(1, -1);
      before = ",";
    }
    [from, weight] = [i, own];
    if (own <= most || i === list.length) continue;
    yield before;
    yield* piecesOf(list[i]);
    [before, from, weight] = [",", i + 1, 0];
  }
  yield before === "[" ? "[]" : "]";
}

/** How many values there are in a value, as far as that is no more than asked about. */
function weightOf(value: unknown, enough: number): number {
  if (typeof value !== "object" || value === null) return 1;
  let weight = 1;
  for (const each of Array.isArray(value) ? value : Object.values(value)) {
    weight += weightOf(each, enough - weight);
    if (weight > enough) break;
  }
  return weight;
}
