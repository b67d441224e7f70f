/** What an engine describes, part by part. */
import { type HermiteCurve, curveIn } from "../core.js";

/**
 * Numbers in sections, each with its length in front, from the first to the last: all lie in the engine, until its next
 * call.
 * @internal
 */
export class Sections {
  #at = 0;

  constructor(readonly numbers: Float64Array) {}

  /** Whether there is another one. */
  get more(): boolean {
    return this.#at < this.numbers.length;
  }

  /** The next one. */
  next(): Float64Array {
    const start = this.#at + 1;
    this.#at = start + (this.numbers[this.#at] ?? 0);
    return this.numbers.subarray(start, this.#at);
  }

  /** The next one as records of so many numbers. */
  records<R>(size: number, read: (record: Float64Array) => R): R[] {
    const numbers = this.next();
    return Array.from({ length: numbers.length / size }, (_, i) => read(numbers.subarray(size * i, size * i + size)));
  }

  /** The next one as places of the plane. */
  places(): [number, number][] {
    return this.records(2, ([x = 0, y = 0]) => [x, y]);
  }

  /** The next one as a curve. */
  curve(): HermiteCurve {
    return curveIn(this.next());
  }
}
