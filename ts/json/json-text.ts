/** What JSON.parse does not refuse, although it should: brackets without end, and two values under one name. */
import { ExplineError } from "../core.js";

const QUOTE = 0x22;

/** One bracket that is open. */
interface Open {
  /** The names in an object so far. */
  readonly names: Set<string> | undefined;
  /** The last name, or the place in an array. */
  at: string | number;
}

/** Refuses text with too many brackets inside one another, or with an object that has a name twice. */
export function scan(op: string, text: string, maxDepth: number): void {
  const open: Open[] = [];
  for (let i = 0; i < text.length; i += 1) {
    const code = text.charCodeAt(i);
    const inner = open[open.length - 1];
    if (code === QUOTE) {
      const end = closing(text, i);
      if (inner?.names !== undefined && followedByColon(text, end)) enter(op, inner, unescaped(text.slice(i, end + 1)), open);
      i = end;
    } else if (code === 0x2c /* , */) {
      if (inner !== undefined && typeof inner.at === "number") inner.at += 1;
    } else if (code === 0x7b /* { */ || code === 0x5b /* [ */) {
      if (open.length >= maxDepth) {
        const what = `json has more than ${maxDepth} brackets inside one another at offset ${i}`;
        const details = { arg: "json", argument: "json", index: i, limit: "maxDepth", max: maxDepth };
        throw new ExplineError("E_LIMIT", op, what, details);
      }
      open.push(code === 0x7b ? { names: new Set(), at: "" } : { names: undefined, at: 0 });
    } else if (code === 0x7d /* } */ || code === 0x5d /* ] */) {
      open.pop();
    }
  }
}

/** Where the string ends that starts at i, or the end of the text. */
function closing(text: string, i: number): number {
  for (let end = text.indexOf('"', i + 1); end >= 0; end = text.indexOf('"', end + 1)) {
    let slashes = 0;
    while (text[end - 1 - slashes] === "\\") slashes += 1;
    if (slashes % 2 === 0) return end;
  }
  return text.length;
}

function followedByColon(text: string, end: number): boolean {
  let i = end + 1;
  while (" \t\n\r".includes(text[i] ?? "x")) i += 1;
  return text[i] === ":";
}

function unescaped(literal: string): string {
  try {
    return JSON.parse(literal) as string;
  } catch {
    return literal;
  }
}

function enter(op: string, inner: Open, name: string, open: readonly Open[]): void {
  inner.at = name;
  if (inner.names?.has(name) !== true) {
    inner.names?.add(name);
    return;
  }
  const path = open.reduce((sum, { at }) => sum + (typeof at === "number" ? `[${at}]` : `.${at}`), "$").slice(0, 120);
  const details = { arg: "json", argument: path, path, reason: "duplicate-key" };
  throw new ExplineError("E_SCHEMA", op, `${path} is there twice`, details);
}
