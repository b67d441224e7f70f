/** Calls into a living instance: numbers in, numbers out, failures as errors. */
import { type AnyKernel, type Engine, type Instance, core, instanceOf, retire } from "./engine.js";
import { ExplineError, degenerate, overLimit, range, tooFewPoints, wrong, wrongLength } from "./error.js";
import type { OwnFloats } from "./host.js";
import { textOf } from "./utf8.js";

/** What a caller handed in, for messages: one number, or a list of them. */
type Numbers = number | ArrayLike<number>;

/** The same, or several of them by their names. @internal */
export type Given = Numbers | { readonly [arg: string]: Numbers };

/** Numbers that nobody else holds. */
export type Floats = OwnFloats;

/** What the kernel's numbers of failure mean. */
const enum Failure {
  NotFinite = 1,
  OutOfRange,
  WrongLength,
  TooFewPoints,
  Degenerate,
  LimitExceeded,
  OutOfMemory,
  PathSyntax,
}

/**
 * Runs one function of an engine and returns how many numbers it left in the output.
 *
 * Whatever else comes out of it than an answer ends the instance. `given` is the array that an error's index points
 * into, or the number that stands alone and has none.
 * @internal
 */
export function callOf<K extends AnyKernel>(
  from: Engine<K>,
  op: string,
  body: (kernel: K, slot: number) => number,
  given?: Given,
  slot = 0,
): number {
  const instance = from.current ?? instanceOf(from, op);
  let count: number;
  try {
    count = body(instance.kernel, slot);
  } catch (cause) {
    throw retire(from, op, cause);
  }
  if (count < 0) throw failure(from, instance, op, given);
  return count;
}

/** Number i of the record of scalar results. */
function resultOf({ floats, record }: Instance<AnyKernel>, i: number): number {
  return floats[record + i] ?? 0;
}

/** The output as it lies in an instance: valid until the next call. */
function peekOf({ floats, record }: Instance<AnyKernel>, count: number): Float64Array {
  const start = (floats[record + 14] ?? 0) / 8;
  return floats.subarray(start, start + count);
}

/** Writes arrays one after the other to where an engine reads numbers. */
function writeTo<K extends AnyKernel>(to: Engine<K>, op: string, arrays: readonly Float64Array[]): void {
  let total = 0;
  for (const array of arrays) total += array.length;
  const instance = instanceOf(to, op);
  let place = room(to, instance, op, total);
  for (const array of arrays) {
    instance.floats.set(array, place);
    place += array.length;
  }
}

/** One engine as all that is worked on in it sees it. @internal */
export interface Door<K extends AnyKernel> {
  /** The living instance; where there is none, one is started for the operation. */
  instance(op?: string): Instance<K>;
  /**
   * Runs one function, on what lies in a slot if it is about one, and returns how many numbers it left in the output.
   */
  call(op: string, body: (kernel: K, slot: number) => number, given?: Given, slot?: number): number;
  /** Number i of the record of scalar results. */
  result(i: number): number;
  /** The output as it lies in the instance: valid until the next call. */
  peek(count: number): Float64Array;
  /** A copy of the output. */
  copy(count: number): Floats;
  /** Writes arrays one after the other to where the engine reads numbers. */
  write(op: string, ...arrays: Float64Array[]): void;
  /** Writes bytes to where the engine reads text, and returns how many they are. */
  writeBytes(op: string, bytes: Uint8Array | Uint8ClampedArray): number;
}

/** The door of an engine. @internal */
export function doorOf<K extends AnyKernel>(engine: Engine<K>): Door<K> {
  const instance = (op?: string): Instance<K> => engine.current ?? instanceOf(engine, op);
  return {
    instance,
    call: (op, body, given, slot) => callOf(engine, op, body, given, slot),
    result: (i) => resultOf(instance(), i),
    peek: (count) => peekOf(instance(), count),
    copy: (count) => peekOf(instance(), count).slice() as Floats,
    write: (op, ...arrays) => writeTo(engine, op, arrays),
    writeBytes: (op, bytes) => (textRoom(engine, op, bytes.length).set(bytes), bytes.length),
  };
}

/** The engine of Hermite curves. @internal */
export const door = /* @__PURE__ */ doorOf(core);
/** @internal */
export const { call, copy, peek, result, write, writeBytes } = door;

/** Text in the core's memory. */
export function textAt(address: number, bytes: number): string {
  return textIn(door.instance(), address, bytes);
}

function textIn({ kernel }: Instance<AnyKernel>, address: number, bytes: number): string {
  return textOf(new Uint8Array(kernel.memory.buffer, address, bytes));
}

/** Text that the kernel left, of so many bytes. */
export function outputText(bytes: number): string {
  return textAt(result(15), bytes);
}

/** An input of more numbers than this is given back before a larger one is made: the two would not lie side by side. */
const KEPT = 1 << 17;

function room<K extends AnyKernel>(to: Engine<K>, instance: Instance<K>, op: string, count: number): number {
  if (count > instance.capacity) {
    const capacity = Math.max(count, 1024);
    let address: number;
    try {
      if (instance.capacity > KEPT) instance.kernel.input_address(0);
      address = instance.kernel.input_address(capacity) >>> 0;
    } catch (cause) {
      throw retire(to, op, cause);
    }
    instance.capacity = address === 0 ? 0 : capacity;
    if (address === 0) throw outOfMemory(op, 8 * capacity);
    instance.input = address / 8;
  }
  return instance.input;
}

/** Where an engine reads so many bytes of text. */
function textRoom<K extends AnyKernel>(to: Engine<K>, op: string, bytes: number): Uint8Array {
  const { kernel } = instanceOf(to, op);
  let address: number;
  try {
    address = kernel.text_address(bytes) >>> 0;
  } catch (cause) {
    throw retire(to, op, cause);
  }
  if (address === 0) throw outOfMemory(op, bytes);
  return new Uint8Array(kernel.memory.buffer, address, bytes);
}

function outOfMemory(op: string, bytes: number): ExplineError {
  return new ExplineError("E_MEMORY", op, `there is no memory for ${bytes} bytes`, { actual: bytes });
}

/** The error that the kernel's record describes. */
function failure<K extends AnyKernel>(from: Engine<K>, instance: Instance<K>, op: string, given: Given | undefined): ExplineError {
  const at = instance.record;
  const [kind = 0, place = -1, value = 0, least = 0, most = 0, a = 0, aLength = 0, w = 0, wLength = 0, patch = 0] =
    instance.floats.slice(at, at + 10);
  const arg = (patch > 0 ? `patches[${patch - 1}].` : "") + textIn(instance, a, aLength);
  const words = textIn(instance, w, wLength);
  const numbers = (given as { readonly [arg: string]: Numbers } | undefined)?.[arg] ?? (given as Numbers | undefined);
  const index = place < 0 || typeof numbers === "number" ? undefined : place;
  const bad = typeof numbers === "object" ? numbers[place] : numbers;
  switch (kind as Failure) {
    case Failure.NotFinite:
      return wrong("E_NOT_FINITE", op, arg, bad, "a finite number", index);
    case Failure.OutOfRange:
      return wrong("E_RANGE", op, arg, value, range(least, most), index);
    case Failure.WrongLength:
      return wrongLength(op, arg, value, String(least));
    case Failure.TooFewPoints:
      return tooFewPoints(op, arg, value, least);
    case Failure.Degenerate:
      return degenerate(op, arg, words, index, bad);
    case Failure.LimitExceeded:
      return overLimit(op, arg, words, most, value);
    case Failure.OutOfMemory:
      return outOfMemory(op, value);
    case Failure.PathSyntax:
      return new ExplineError("E_PARSE_SVG", op, `${arg} makes no sense at offset ${place}; expected ${words}`, {
        arg,
        argument: arg,
        index,
        bound: words,
      });
    default:
      return retire(from, op, undefined);
  }
}
