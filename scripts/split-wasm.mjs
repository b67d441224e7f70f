// The wasm sorted for compression: operations in one run of bytes, and what they work on in others, each with its like.
//
// In a wasm file numbers of locals, offsets and constants stand between the operations, and a compressor takes the one for the other.
// Apart they are an eighth smaller after gzip. What comes out has a head that says how it is put together again:
//
//   count of streams, count of rows
//   a stream: its length in three bytes, and how its items are cut: 0 as LEB128, 254 as LEB128 to be multiplied by 2 to the power of the
//   byte before it, 255 by a first byte with the length, else so many bytes
//   a row: how many bytes and 16 times how many items, the bytes as they are, and the numbers of the streams of the items
//   the streams, the first of which names the row of each operation
//
// Where there are more kinds of operations than rows, the rarest are items of the raw stream, as they are.
//
// DECODER, in inline-wasm.mjs, puts it together.

/** Items that are LEB128, such in units of the alignment before them, and items with their length before them. */
const LEB = 0;
const SCALED = 254;
const COUNTED = 255;
const LONGEST_ITEM = 253;

/** The streams and how their items are cut; operations come first, what is long before what is short. */
const STREAMS = [
  ["operations", 1],
  ["local", LEB],
  ["offset", SCALED],
  ["align", LEB],
  ["double", 8],
  ["integer", LEB],
  ["raw", COUNTED],
  ["vector", 16],
  ["call", LEB],
  ["type", 1],
  ["long", LEB],
  ["branch", LEB],
  ["locals", COUNTED],
  ["size", LEB],
  ["global", LEB],
  ["lane", 1],
  ["table", COUNTED],
  ["single", 4],
];

const MEMORY = ["align", "offset"];

/** The streams of what follows an operation, by its numbers: those of version 2 of the format that compilers write. */
function operandsOf(code, sub) {
  if (code >= 0x02 && code <= 0x04) return ["type"];
  if (code === 0x0c || code === 0x0d) return ["branch"];
  if (code === 0x0e) return ["table"];
  if (code === 0x10) return ["call"];
  if (code === 0x11) return ["call", "call"];
  if (code === 0x1c) return ["locals"];
  if (code >= 0x20 && code <= 0x22) return ["local"];
  if (code === 0x23 || code === 0x24) return ["global"];
  if (code >= 0x28 && code <= 0x3e) return MEMORY;
  if (code === 0x3f || code === 0x40) return ["lane"];
  if (code === 0x41) return ["integer"];
  if (code === 0x42) return ["long"];
  if (code === 0x43) return ["single"];
  if (code === 0x44) return ["double"];
  if (code === 0xfc) return sub <= 7 ? [] : sub === 10 ? ["lane", "lane"] : sub === 11 ? ["lane"] : undefined;
  if (code === 0xfd) {
    if (sub <= 11 || sub === 92 || sub === 93) return MEMORY;
    if (sub === 12 || sub === 13) return ["vector"];
    if (sub >= 21 && sub <= 34) return ["lane"];
    return sub >= 84 && sub <= 91 ? [...MEMORY, "lane"] : [];
  }
  return code < 0xc5 ? [] : undefined;
}

/** Reads a file from its start. */
class Reader {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }

  number() {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      const byte = this.bytes[this.at++];
      value += (byte & 127) * 2 ** shift;
      if (byte < 128) return value;
    }
  }

  take(count) {
    this.at += count;
    return [...this.bytes.subarray(this.at - count, this.at)];
  }

  /** What was read since then. */
  since(start) {
    return [...this.bytes.subarray(start, this.at)];
  }

  /** One item of a stream, with its length before it where that is how it is cut. */
  item(stream) {
    const start = this.at;
    const numbers = { table: 1, locals: 1 }[stream];
    if (numbers === undefined) {
      const mode = STREAMS.find(([name]) => name === stream)[1];
      if (mode !== LEB && mode !== SCALED) return this.take(mode);
      this.number();
      return this.since(start);
    }
    const count = this.number();
    if (stream === "locals") throw new Error("select with types: not expected from this compiler");
    for (let i = 0; i <= count; i++) this.number();
    return counted(this.since(start));
  }
}

/** A number as LEB128. */
function leb(number) {
  return number < 128 ? [number] : [(number & 127) | 128, ...leb(Math.floor(number / 128))];
}

function counted(bytes) {
  if (bytes.length > LONGEST_ITEM) throw new Error(`an item has ${bytes.length} bytes: too long for one byte of length`);
  return [bytes.length, ...bytes];
}

/** Calls `row(bytes, items)` for every operation, and for what is not code; `bytes` are its own, `items` are [stream, bytes]. */
function eachOperation(wasm, row) {
  const reader = new Reader(wasm);
  const raw = (bytes) => {
    for (let i = 0; i < bytes.length; i += LONGEST_ITEM) row([], [["raw", counted(bytes.slice(i, i + LONGEST_ITEM))]]);
  };
  raw(reader.take(8));
  while (reader.at < wasm.length) {
    const start = reader.at;
    const [section] = reader.take(1);
    const length = reader.number();
    if (section !== 10) {
      reader.take(length);
      raw(reader.since(start));
      continue;
    }
    const functions = reader.number();
    raw(reader.since(start));
    for (let i = 0; i < functions; i++) eachOperationOfOne(reader, row);
  }
}

function eachOperationOfOne(reader, row) {
  const start = reader.at;
  const length = reader.number();
  const size = reader.since(start);
  const end = reader.at + length;
  const locals = reader.at;
  const groups = reader.number();
  for (let g = 0; g < groups; g++) {
    reader.number();
    reader.take(1);
  }
  row([], [["size", size], ["locals", counted(reader.since(locals))]]);
  while (reader.at < end) {
    const start = reader.at;
    const [code] = reader.take(1);
    const sub = code >= 0xfc ? reader.number() : 0;
    const bytes = reader.since(start);
    const operands = operandsOf(code, sub);
    if (operands === undefined) throw new Error(`operation ${code} ${sub} is not known`);
    const items = operands.map((stream) => [stream, reader.item(stream)]);
    if (operands[0] !== "align") row(bytes, items);
    else aligned(bytes, items, row);
  }
}

/**
 * How memory is aligned goes with the operation nearly always: it is a part of it. Offsets are multiples of it nearly always, and shorter
 * in its units.
 */
function aligned(bytes, [[, [align]], [stream, item], ...rest], row) {
  const offset = new Reader(item).number();
  const own = [...bytes, align];
  if (offset % 2 ** align !== 0) row([], whole(own, [[stream, item], ...rest]));
  else row(own, [[stream, leb(offset / 2 ** align), item], ...rest]);
}

const RAW = " raw";
const keyOf = (bytes, items) => `${bytes} ${items.map(([stream]) => stream)}`;

/** The operation as it was in the wasm, as one item; what is written otherwise in its stream has that as its third part. */
function whole(bytes, items) {
  const modes = new Map(STREAMS);
  return [["raw", counted([...bytes, ...items.flatMap(([stream, item, plain]) => plain ?? (modes.get(stream) === COUNTED ? item.slice(1) : item))])]];
}

/** The kinds of operations that get a row of their own: the most frequent, where there are too many for a byte. */
function kindsOf(wasm, most) {
  const uses = new Map();
  eachOperation(wasm, (bytes, items) => {
    const key = keyOf(bytes, items);
    uses.set(key, (uses.get(key) ?? 0) + 1);
  });
  const others = [...uses.keys()].filter((key) => key !== RAW).sort((a, b) => uses.get(b) - uses.get(a));
  return new Set([RAW, ...others.slice(0, most - 1)]);
}

/** The wasm in streams, with the head that says how to put them together; at `most` so many kinds of operations are told apart. */
export function splitWasm(wasm, most = 256) {
  const kinds = kindsOf(wasm, most);
  const streams = new Map(STREAMS.map(([name]) => [name, []]));
  const rows = new Map();
  const operations = [];
  eachOperation(wasm, (...operation) => {
    const [bytes, items] = kinds.has(keyOf(...operation)) ? operation : [[], whole(...operation)];
    const key = keyOf(bytes, items);
    let row = rows.get(key);
    if (row === undefined) rows.set(key, (row = { bytes, items: items.map(([stream]) => stream), count: 0 }));
    row.count += 1;
    operations.push(row);
    for (const [stream, item] of items) streams.get(stream).push(...item);
  });
  // Frequent ones get low numbers, which are shorter in the text.
  const sorted = [...rows.values()].sort((a, b) => b.count - a.count);
  sorted.forEach((row, number) => (row.number = number));
  streams.set("operations", operations.map((row) => row.number));
  const names = STREAMS.map(([name]) => name);
  const head = [STREAMS.length, sorted.length & 255];
  for (const [name, mode] of STREAMS) {
    const { length } = streams.get(name);
    head.push(length & 255, (length >> 8) & 255, length >> 16, mode);
  }
  for (const { bytes, items } of sorted) head.push(bytes.length + 16 * items.length, ...bytes, ...items.map((name) => names.indexOf(name)));
  return Uint8Array.from([...head, ...[...streams.values()].flat()]);
}
