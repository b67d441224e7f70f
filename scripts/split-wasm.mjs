// The wasm sorted for compression: operations in one run of bytes, and what they work on in others, each with its like.
//
// In a wasm file numbers of locals, offsets and constants stand between the operations, and a compressor takes the one
// for the other. Apart they are an eighth smaller after gzip. What comes out has a head that says how it is put
// together again:
//
//   count of streams, count of rows
//   a stream: its length in three bytes, and how its items are cut: 0 as LEB128, a type as a local of that type, 251 as
//   doubles by number, 252 as the beginning of a function, 253 as its end, 254 as LEB128 to be multiplied by 2 to the
//   power of the byte before it, 255 by a first byte with the length, else so many bytes
//   a row: how many bytes and 16 times how many items, the bytes as they are, and the numbers of the streams of the
//   items
//   the streams; that of operations names the row of each
//
// A local is told by how many others of its type have been used since its last use, plus one; 0 is the next new one
// (number-locals.mjs). How long a function is follows from where it ends, and what its locals are from their uses. A
// double is told by its number in the order of first uses; 0 is the next new one, which is in the stream after that.
//
// Where there are more kinds of operations than rows, the rarest are items of the raw stream, as they are: of them,
// those without locals.
//
// The decoder (decoder.mjs) puts it together.

import { typesOf } from "./number-locals.mjs";
import { bodyOf, bytesOf, headOf, leb, numberOf, takenApart } from "./wasm-functions.mjs";

/**
 * How items are cut: as LEB128, as doubles by their numbers, at the two ends of a function, as LEB128 in units of the
 * alignment before, with their length before them.
 */
const LEB = 0;
const NUMBERED = 251;
const BEGIN = 252;
const END = 253;
const SCALED = 254;
const COUNTED = 255;
const LONGEST_ITEM = 253;
/** What the decoder has room for. */
const MOST_DOUBLES = 1800;

const I32 = 0x7f;
const I64 = 0x7e;
const F32 = 0x7d;
const F64 = 0x7c;
const V128 = 0x7b;

/**
 * The streams and how their items are cut. Gzip makes a code for sixteen thousand symbols at a time, so it matters what
 * lies beside what: this is the best of some thousand orders for the five files of the package, 1 % smaller than the
 * long before the short.
 */
const STREAMS = [
  ["offset of integer", SCALED],
  ["offset of vector", SCALED],
  ["offset", SCALED],
  ["offset of double", SCALED],
  ["shift to the left", LEB],
  ["shift to the right", LEB],
  ["set f32", F32],
  ["get f32", F32],
  ["get v128", V128],
  ["get f64", F64],
  ["get i32", I32],
  ["get i64", I64],
  ["lane", 1],
  ["set i64", I64],
  ["set v128", V128],
  ["branch", LEB],
  ["set f64", F64],
  ["set i32", I32],
  ["table", COUNTED],
  ["operations", 1],
  ["global", LEB],
  ["vector", 16],
  ["single", 4],
  ["function", BEGIN],
  ["end", END],
  ["double", NUMBERED],
  ["new double", 8],
  ["raw", COUNTED],
  ["long", LEB],
  ["integer", LEB],
  ["summand", LEB],
  ["call", LEB],
];
const NUMBERS = new Map(STREAMS.map(([name], number) => [name, number]));
const MODES = new Map(STREAMS);

/** The number of the stream that says which operation comes next; it is not the last one. */
export const OPERATIONS = NUMBERS.get("operations");

const TYPE_NAMES = new Map([[I32, "i32"], [F64, "f64"], [V128, "v128"], [I64, "i64"], [F32, "f32"]]);

/** Constants for different uses are of different sizes: what the operation after one says of it. */
const USES = new Map([[0x6a, "summand"], [0x6b, "summand"], [0x74, "shift to the left"], [0x75, "shift to the right"], [0x76, "shift to the right"]]);
/** As are offsets of what is 4 or 8 bytes long. */
const KINDS_OF_MEMORY = new Map([[0x28, "offset of integer"], [0x36, "offset of integer"], [0x2b, "offset of double"], [0x39, "offset of double"], [0xfd, "offset of vector"]]);

/**
 * What is a part of its operation: what says what kind of operation it is, and the numbers that stand with some
 * operations far more often than with others, so that a run of operations is found again with them.
 */
const PARTS = new Map([
  ["type", () => true],
  ["lane", () => true],
  ["branch", ([byte]) => byte === 0],
  ["integer", ([byte]) => byte === 0 || byte === 1 || byte === 0x7f],
  ["long", ([byte]) => byte === 0 || byte === 1],
  ["double", (bytes) => [0, 1].includes(new Float64Array(Uint8Array.from(bytes).buffer)[0])],
]);

function counted(bytes) {
  if (bytes.length > LONGEST_ITEM) throw new Error(`an item has ${bytes.length} bytes: too long for one byte of length`);
  return [bytes.length, ...bytes];
}

/** Bytes that are no operations, as they are. */
function raw(bytes) {
  const parts = Array.from({ length: Math.ceil(bytes.length / LONGEST_ITEM) }, (_, i) => bytes.slice(i * LONGEST_ITEM, (i + 1) * LONGEST_ITEM));
  return parts.map((part) => ({ code: [], items: [["raw", counted(part)]] }));
}

const BEGINNING = { code: [], items: [["function", []]] };

/** The locals of a function in use, of each type those used last first. */
class Recency {
  constructor(f) {
    this.types = typesOf(f);
    if (this.types.length > 255) throw new Error("a function has more locals than a byte can count");
    this.lists = new Map([...TYPE_NAMES.keys()].map((type) => [type, []]));
    f.parameters.forEach((type, local) => this.lists.get(type).unshift(local));
  }

  /** The stream of a use, and its item. */
  use(code, local) {
    const type = this.types[local];
    const list = this.lists.get(type);
    const place = list.indexOf(local);
    if (place >= 0) list.splice(place, 1);
    list.unshift(local);
    return [`${code === 0x20 ? "get" : "set"} ${TYPE_NAMES.get(type)}`, [place + 1]];
  }
}

/**
 * How memory is aligned goes with the operation nearly always: it is a part of it. Offsets are multiples of it nearly
 * always, and shorter in its units.
 */
function aligned({ code, operands: [[, [align]], [, offset], ...rest] }, plain) {
  const units = numberOf(offset) / 2 ** align;
  if (!Number.isInteger(units)) return { code: [], items: [["raw", counted(plain)]] };
  return { code: [...code, align], items: [[KINDS_OF_MEMORY.get(code[0]) ?? "offset", leb(units)], ...rest], plain };
}

/**
 * An operation with its items; `plain` where it may be raw as well: all but uses of locals and the ends of functions.
 */
function operation(each, next, recency) {
  const { code, operands } = each;
  const [kind] = operands[0] ?? [];
  if (kind === "local") return { code, items: [recency.use(code[0], numberOf(operands[0][1]))] };
  if (next === undefined) return { code, items: [["end", []]] };
  const plain = bytesOf(each);
  if (operands.length > 0 && operands.every(([stream, bytes]) => PARTS.get(stream)?.(bytes))) return { code: plain, items: [], plain };
  if (kind === "align") return aligned(each, plain);
  if (kind === "integer") return { code, items: [[USES.get(next.code[0]) ?? kind, operands[0][1]]], plain };
  const items = operands.map(([stream, bytes]) => [stream, MODES.get(stream) === COUNTED ? counted(bytes) : bytes]);
  return { code, items, plain };
}

function operationsOf(f) {
  const recency = new Recency(f);
  return [BEGINNING, ...f.operations.map((each, i) => operation(each, f.operations[i + 1], recency))];
}

/** All operations of a wasm, and what is no code, as { code, items: [stream, bytes], plain }. */
function operationsIn(wasm) {
  const { before, functions, after } = takenApart(wasm);
  return [...raw([...before, ...headOf(functions.map(bodyOf))]), ...functions.flatMap(operationsOf), ...raw(after)];
}

/** The doubles that have a number, in the order of their first uses. */
class Doubles {
  #numbers = new Map();
  #count = 0;

  /** An item of a stream; in place of a double its number, or 0 and the double itself. */
  items([stream, bytes]) {
    if (stream !== "double") return [[stream, bytes]];
    const number = this.#numbers.get(`${bytes}`);
    if (number !== undefined) return [[stream, [number]]];
    this.#count += 1;
    if (this.#count > MOST_DOUBLES) throw new Error(`there are more doubles than ${MOST_DOUBLES}, for which the decoder has room`);
    // A number is one byte.
    if (this.#count < 256) this.#numbers.set(`${bytes}`, this.#count);
    return [[stream, [0]], ["new double", bytes]];
  }
}

const RAW = " raw";
const keyOf = ({ code, items }) => `${code} ${items.map(([stream]) => stream)}`;

/**
 * The kinds of operations, as [key, operation]: what the other wasm has too where it has it, so that what is alike in
 * both looks alike, and the others by how frequent they are: low numbers are shorter in the text. Where there are more
 * than 256, the rarest are raw.
 */
function kindsOf(operations, others) {
  const uses = new Map();
  const kinds = new Map();
  for (const each of operations) {
    const key = keyOf(each);
    kinds.set(key, each);
    uses.set(key, (uses.get(key) ?? 0) + 1);
  }
  const ranked = [...kinds].sort(([a], [b]) => uses.get(b) - uses.get(a));
  const certain = ([, { plain }]) => plain === undefined;
  const kept = new Set([...ranked.filter(certain), ...ranked.filter((kind) => !certain(kind))].slice(0, 256).map(([key]) => key));
  const shared = others.map(([key]) => (kept.has(key) ? [key, kinds.get(key)] : undefined));
  const own = ranked.filter(([key]) => kept.has(key) && !others.some(([other]) => other === key));
  return [...shared.map((kind) => kind ?? own.shift()), ...own].filter((kind) => kind !== undefined);
}

/**
 * The wasm in streams, with the head that says how to put them together, and the kinds of operations that are told
 * apart; `others` are those of another wasm.
 */
export function splitWasm(wasm, others = []) {
  const all = operationsIn(wasm);
  const kinds = kindsOf(all, others);
  const rows = new Map(kinds.map(([key], row) => [key, row]));
  const streams = new Map(STREAMS.map(([name]) => [name, []]));
  const doubles = new Doubles();
  for (const each of all) {
    const row = rows.get(keyOf(each));
    streams.get("operations").push(row ?? rows.get(RAW));
    const items = row === undefined ? [["raw", counted(each.plain)]] : each.items;
    for (const [stream, item] of items.flatMap((each) => doubles.items(each))) streams.get(stream).push(...item);
  }
  const head = [STREAMS.length, kinds.length & 255];
  for (const [name, mode] of STREAMS) {
    const { length } = streams.get(name);
    head.push(length & 255, (length >> 8) & 255, length >> 16, mode);
  }
  for (const [, { code, items }] of kinds) head.push(code.length + 16 * items.length, ...code, ...items.map(([stream]) => NUMBERS.get(stream)));
  return { bytes: Uint8Array.from([...head, ...[...streams.values()].flat()]), kinds };
}
