// A wasm taken apart into its functions, down to operations and what they work on, and put together again.

/** What follows the code of an operation, by how it is cut: LEB128, one byte, or so many. */
const WIDTHS = { type: 1, lane: 1, single: 4, double: 8, vector: 16 };

const MEMORY = ["align", "offset"];

/** The kinds of what follows an operation, by its numbers: those of version 2 of the format that compilers write. */
function operandsOf(code, sub) {
  if (code >= 0x02 && code <= 0x04) return ["type"];
  if (code === 0x0c || code === 0x0d) return ["branch"];
  if (code === 0x0e) return ["table"];
  if (code === 0x10) return ["call"];
  if (code === 0x11) return ["call", "call"];
  if (code === 0x1c) throw new Error("select with types: not expected from this compiler");
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

  list(item) {
    return Array.from({ length: this.number() }, item);
  }

  /** What an operation works on. */
  operand(kind) {
    const width = WIDTHS[kind];
    if (width !== undefined) return this.take(width);
    const start = this.at;
    const count = this.number();
    if (kind === "table") for (let i = 0; i <= count; i++) this.number();
    return this.since(start);
  }
}

/** A number as LEB128. */
export function leb(number) {
  return number < 128 ? [number] : [(number & 127) | 128, ...leb(Math.floor(number / 128))];
}

/** The number that is written so. */
export const numberOf = (bytes) => new Reader(Uint8Array.from(bytes)).number();

/**
 * One function: the types of its parameters, of its locals as [count, type], and operations as { code, operands: [kind,
 * bytes] }.
 */
function functionOf(reader, parameters) {
  const end = reader.number() + reader.at;
  const locals = reader.list(() => [reader.number(), reader.take(1)[0]]);
  const operations = [];
  while (reader.at < end) {
    const start = reader.at;
    const [first] = reader.take(1);
    const sub = first >= 0xfc ? reader.number() : 0;
    const code = reader.since(start);
    const kinds = operandsOf(first, sub);
    if (kinds === undefined) throw new Error(`operation ${first} ${sub} is not known`);
    operations.push({ code, operands: kinds.map((kind) => [kind, reader.operand(kind)]) });
  }
  return { parameters, locals, operations };
}

/** A wasm up to its functions, the functions, and what comes after them. */
export function takenApart(wasm) {
  const reader = new Reader(wasm);
  const signatures = signaturesOf(reader);
  const before = reader.since(0);
  reader.number();
  reader.number();
  const functions = signatures.map((parameters) => functionOf(reader, parameters));
  return { before, functions, after: [...wasm.subarray(reader.at)] };
}

/** The types of each function's parameters; the reader stands before the length of the functions' section then. */
function signaturesOf(reader) {
  let types = [];
  let signatures = [];
  reader.take(8);
  for (;;) {
    const [section] = reader.take(1);
    if (section === 10) return signatures;
    const end = reader.number() + reader.at;
    if (section === 1) types = reader.list(() => parametersOf(reader));
    if (section === 3) signatures = reader.list(() => types[reader.number()]);
    reader.at = end;
  }
}

function parametersOf(reader) {
  reader.take(1);
  const parameters = reader.list(() => reader.take(1)[0]);
  reader.list(() => reader.take(1));
  return parameters;
}

/** The bytes of an operation. */
export const bytesOf = ({ code, operands }) => [...code, ...operands.flatMap(([, bytes]) => bytes)];

/** The bytes of a function, without how many they are. */
export function bodyOf({ locals, operations }) {
  const groups = locals.flatMap(([count, type]) => [...leb(count), type]);
  return [...leb(locals.length), ...groups, ...operations.flatMap(bytesOf)];
}

/**
 * What stands between what comes before the functions and the first of them: how many bytes they are, and how many
 * functions.
 */
export function headOf(bodies) {
  const count = leb(bodies.length);
  const length = bodies.reduce((sum, body) => sum + leb(body.length).length + body.length, count.length);
  return [...leb(length), ...count];
}

/** The wasm of these functions. */
export function putTogether({ before, functions, after }) {
  const bodies = functions.map(bodyOf);
  const parts = [before, headOf(bodies), ...bodies.flatMap((body) => [leb(body.length), body]), after];
  return Uint8Array.from(parts.flat());
}
