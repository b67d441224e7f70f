// Calls that work, and what becomes of them when one value in them is replaced by something else.

import assert from "node:assert/strict";

import { ExplineError } from "expline";

/** A call that works: its name, what does it, and its arguments. */
export interface Valid {
  readonly name: string;
  readonly run: (this: unknown, ...values: never[]) => unknown;
  readonly values: readonly unknown[];
  /** What it is called on; where there is one, it must be after a refusal as it was before. */
  readonly make?: () => unknown;
}

/** An array whose buffer was handed to somebody else. */
function detached(): Float64Array {
  const array = new Float64Array(4);
  structuredClone(array.buffer, { transfer: [array.buffer] });
  return array;
}

/** Values of every kind that JavaScript has; fresh ones at each call, so that none is changed for the next. */
const strange = (): unknown[] => [
  ...[undefined, null, true, false, 7n, "", "x", "1", Symbol("s"), () => 1],
  ...[0, -0, 1, -1, 0.5, 2, 3, 1e5, 1e308, -1e308, 5e-324, NaN, Infinity, -Infinity, 2 ** 32, 2 ** 53],
  ...[{}, [], [[]], [null], [[1]], [[1, 2]], [{ x: 1, y: 2 }], [NaN], [1, 2, 3], ["a", "b"], new Array<number>(5), [0, 0, 1, 0, 1, 1]],
  ...[new Float64Array(0), Float64Array.of(NaN, 1), Float64Array.of(0, 0, 1, 1, 2, 0), new Float32Array(4), new Uint8Array(4), detached()],
  ...[new ArrayBuffer(8), new DataView(new ArrayBuffer(8)), new Date(0), new Map([[1, 2]]), new Error("e"), Object.create(null), globalThis],
  ...[{ length: 1e9 }, { re: 0, im: 1 }, { re: NaN, im: 0 }, { x: 1 }],
];

type Path = readonly (string | number)[];
type Tree = Record<string | number, unknown>;

/** Lists and plain objects; curves and the like are values of their own. */
function isTree(value: unknown): value is Tree {
  if (typeof value !== "object" || value === null) return false;
  const prototype: unknown = Object.getPrototypeOf(value);
  return Array.isArray(value) || prototype === Object.prototype || prototype === null;
}

/** Every place in a tree of arguments: of lists the first two, of options also a name that is not known. */
function* places(value: unknown, path: Path = []): Generator<Path> {
  if (path.length > 0) yield path;
  if (path.length > 3 || !isTree(value)) return;
  const list = Array.isArray(value);
  // Of the arguments themselves all; the numbers of a list are all alike.
  const names = list ? [...value.keys()].slice(0, path.length === 0 ? 9 : 2) : Object.keys(value);
  for (const name of names) yield* places(value[name], [...path, name]);
  if (!list) yield [...path, "nonsense"];
}

function copy(value: unknown): unknown {
  if (ArrayBuffer.isView(value)) return (value as Float64Array).slice();
  if (Array.isArray(value)) return value.map(copy);
  return isTree(value) ? Object.fromEntries(Object.entries(value).map(([name, item]) => [name, copy(item)])) : value;
}

function replaced(values: readonly unknown[], path: Path, by: unknown): unknown[] {
  const tree = copy(values) as unknown[];
  let at = tree as unknown as Tree;
  for (const name of path.slice(0, -1)) at = at[name] as Tree;
  at[path.at(-1) as string | number] = by;
  return tree;
}

/** Failures that lie in no argument. */
const ELSEWHERE = /^E_(?:INIT|DISPOSED|UNSUPPORTED|PARSE_SVG|PARSE_JSON|SCHEMA)$/;
const MESSAGE = /^[\w.]+: .{3,260} \[E_[A-Z_]+\]$/;

/** What is wrong with how a call failed, if anything. */
function complaint(error: unknown): string | undefined {
  if (!(error instanceof ExplineError)) return `threw ${String(error)}`;
  if (error.fatal || error.code === "E_INTERNAL") return `stopped the engine: ${error.message}`;
  if (!MESSAGE.test(error.message)) return `says ${error.message}`;
  if (!ELSEWHERE.test(error.code) && error.argument === undefined) return `names no argument: ${error.message}`;
  return undefined;
}

const named = (value: unknown): string => (isTree(value) ? Object.prototype.toString.call(value) : typeof value === "symbol" ? "a symbol" : String(value));

/**
 * Puts every strange value into every place of a call, one at a time: it works, or says clearly what is wrong and
 * changes nothing. Gives back how many calls that were.
 */
export async function tryEverything({ name, run, values, make = () => undefined }: Valid): Promise<number> {
  await run.apply(make(), copy(values) as never[]);
  const complaints: string[] = [];
  let tried = 0;
  for (const path of places(values)) {
    for (const value of strange()) {
      const subject = make();
      const before = JSON.stringify(subject);
      tried += 1;
      try {
        await run.apply(subject, replaced(values, path, value) as never[]);
      } catch (error) {
        const said = complaint(error) ?? (JSON.stringify(subject) === before ? undefined : "changed what it refused to change");
        if (said !== undefined) complaints.push(`${name}, ${path.join(".")} = ${named(value)}: ${said}`);
      }
    }
  }
  assert.deepEqual(complaints, []);
  return tried;
}
