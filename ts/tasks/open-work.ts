/** Work that an engine keeps open under a number, for as long as somebody here needs it. */
import { type AnyKernel, type Engine, callOf, instanceOf } from "../core.js";

/** How work is opened and closed in its engine. @internal */
export interface Kind<K extends AnyKernel> {
  readonly engine: Engine<K>;
  /** Gives the work of a number up. */
  readonly close: (kernel: K, number: number) => number;
}

/** Closes what was forgotten: the memory of an instance is not seen by the collector. */
const forgotten: FinalizationRegistry<() => void> | undefined =
  typeof FinalizationRegistry === "function" ? new FinalizationRegistry(closeQuietly) : undefined;

function closeQuietly(close: () => void): void {
  try {
    close();
  } catch {
    // Nobody has called, so nobody can catch: the instance is out of service, and the next call starts another.
  }
}

/** What closes a place. It must not know who is there, or he would never be forgotten. */
function closer<K extends AnyKernel>({ engine, close }: Kind<K>, instance: object, number: number): () => void {
  return () => {
    // A dead instance has taken its work along; a new one has other work under the same numbers.
    if (engine.current === instance) callOf(engine, "dispose", (kernel) => close(kernel, number));
  };
}

/**
 * One piece of work: opened at once, and again in the next instance when its own has died.
 * @internal
 */
export class OpenWork<K extends AnyKernel> {
  readonly #kind: Kind<K>;
  readonly #open: (op: string) => number;
  readonly #key = {};
  #place: { readonly instance: object; readonly number: number; readonly close: () => void } | undefined;

  /** `open` has the engine open the work, and returns its number. */
  constructor(op: string, kind: Kind<K>, open: (op: string) => number) {
    this.#kind = kind;
    this.#open = open;
    this.number(op);
  }

  /**
   * The number in the living instance. Where that is a new one, the work is opened again, and `again` has a call of its
   * own.
   */
  number(op: string, again?: (number: number) => void): number {
    const place = this.#place;
    const instance = instanceOf(this.#kind.engine, op);
    if (place?.instance === instance) return place.number;
    if (place !== undefined) forgotten?.unregister(this.#key);
    const number = this.#open(op);
    const close = closer(this.#kind, instance, number);
    this.#place = { instance, number, close };
    forgotten?.register(this, close, this.#key);
    if (place !== undefined) again?.(number);
    return number;
  }

  /** Gives the memory back; a second call does nothing. */
  close(): void {
    const place = this.#place;
    if (place === undefined) return;
    this.#place = undefined;
    forgotten?.unregister(this.#key);
    place.close();
  }
}
