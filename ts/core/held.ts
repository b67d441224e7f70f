/** Arrays that are owned here, of which the kernel only ever holds a copy in one of its slots. */
import { type CurveKernel, SLOTS } from "./engine.js";
import type { Door, Given } from "./kernel.js";

/** Points of all residents together, above which the kernel forgets the others first. */
const MOST_RESIDENT = 1_500_000;

/** Every state of everything has a number of its own. */
let lastId = 0;
let clock = 0;

/** What every wasm can do that holds something in slots. @internal */
export type HoldingKernel = Pick<CurveKernel, "memory" | "record_address" | "input_address" | "text_address" | "kernel_version" | "forget">;

/**
 * What one curve or surface is made of. An edit gives it a new number, so that the kernel's copy no longer counts.
 * @internal
 */
export abstract class Held<K extends HoldingKernel = HoldingKernel> {
  id = 0;
  slot = 0;
  /** Fields that a file had and this version does not know: own properties, kept for the next file. */
  extra: Readonly<Record<string, unknown>> | undefined;

  constructor() {
    this.touch();
  }

  /** The engine that it is worked on in. */
  abstract get door(): Door<K>;

  /** How many points there are. */
  abstract get count(): number;

  /** How many of its kind an instance holds at once. */
  get slots(): number {
    return SLOTS;
  }

  /** Writes the arrays and has the kernel check, make and keep it. */
  protected abstract send(op: string, slot: number): void;

  /** To be called after every change of the arrays. */
  touch(): void {
    lastId += 1;
    this.id = lastId;
  }

  /** To be called where the kernel's copy was changed in the same way. */
  touchBoth(): void {
    const { ids } = this.door.instance();
    const same = ids[this.slot] === this.id;
    this.touch();
    if (same) ids[this.slot] = this.id;
  }

  /** The slot that holds it in the living instance, loaded now if need be. */
  resident(op: string): number {
    const { ids, used } = this.door.instance(op);
    clock += 1;
    if (ids[this.slot] !== this.id) this.load(op);
    used[this.slot] = clock;
    return this.slot;
  }

  /** Has the kernel check it and keep it. */
  load(op: string): void {
    const { count, door } = this;
    const instance = door.instance(op);
    if (instance.points + count > MOST_RESIDENT && instance.points > 0) {
      door.call(op, (kernel) => (kernel.forget(), 0));
      instance.ids.fill(0);
      instance.points = 0;
      instance.capacity = 0;
    }
    const slot = oldest(instance.used, instance.ids, this.slots);
    this.send(op, slot);
    this.slot = slot;
    instance.ids[slot] = this.id;
    instance.points += count;
  }

  /** Runs a function of the kernel on it, which reads `input`, and returns how many numbers that left in the output. */
  ask(op: string, body: (kernel: K, slot: number) => number, given?: Given, input?: readonly Float64Array[]): number {
    const slot = this.resident(op);
    if (input !== undefined) this.door.write(op, ...input);
    return this.door.call(op, body, given, slot);
  }
}

function oldest(used: readonly number[], ids: readonly number[], slots: number): number {
  let best = 0;
  for (let slot = 0; slot < slots; slot += 1) {
    if (ids[slot] === 0) return slot;
    if ((used[slot] ?? 0) < (used[best] ?? 0)) best = slot;
  }
  return best;
}
