/** What a curve is made of, owned here; the kernel only ever holds a copy of it in one of its slots. */
import { type CurveKernel, SLOTS } from "./engine.js";
import { type Door, type Floats, call, copy, door, peek, result, write } from "./kernel.js";

/** The space that a segment lies in. */
export type Space = "trigonometric" | "hyperbolic" | "polynomial";

/** The spaces in the kernel's order. */
export const SPACES: readonly Space[] = ["trigonometric", "hyperbolic", "polynomial"];

/** Points of all resident curves together, above which the kernel forgets the others first. */
const MOST_RESIDENT = 1_500_000;

/** Every state of every curve has a number of its own. */
let lastId = 0;
let clock = 0;

/** What one curve of any kind is made of. An edit gives it a new number, so that the kernel's copy no longer counts. */
export abstract class Held {
  id = 0;
  slot = 0;
  /** First and last parameter of the domain. */
  start = 0;
  end = 0;
  /** Fields that a file had and this version does not know: own properties, kept for the next file. */
  extra: Readonly<Record<string, unknown>> | undefined;

  constructor(
    readonly points: Floats,
    readonly closed: boolean,
    readonly dimension: 2 | 3,
  ) {
    this.touch();
  }

  /** The engine that such curves are worked on in. @internal */
  abstract get door(): Door<CurveKernel>;

  /** The highest derivative that can be asked for. */
  abstract get orders(): number;

  /** The curve with points and tangents that a path is made of, how far it is from this one, and what that leaves of the tolerance. */
  abstract outline(op: string, tolerance: number): { data: CurveData; near: number; rest: number };

  /** The curve as one with points and tangents, if it is one. */
  abstract exactly(op: string, tolerance: number): CurveData | undefined;

  /** Writes the arrays and has the kernel make and keep the curve. */
  protected abstract send(op: string, slot: number): void;

  /** To be called after every change of the arrays. */
  touch(): void {
    lastId += 1;
    this.id = lastId;
  }

  /** How many points there are. */
  get count(): number {
    return this.points.length / this.dimension;
  }

  /** The slot that holds this curve in the living instance, loaded now if need be. */
  resident(op: string): number {
    const { ids, used } = this.door.instance(op);
    clock += 1;
    if (ids[this.slot] !== this.id) this.load(op);
    used[this.slot] = clock;
    return this.slot;
  }

  /** Has the kernel check the curve and keep it. */
  load(op: string): void {
    const { count, door } = this;
    const instance = door.instance(op);
    if (instance.points + count > MOST_RESIDENT && instance.points > 0) {
      door.call(op, (kernel) => (kernel.forget(), 0));
      instance.ids.fill(0);
      instance.points = 0;
      instance.capacity = 0;
    }
    const slot = oldest(instance.used, instance.ids);
    this.send(op, slot);
    this.slot = slot;
    instance.ids[slot] = this.id;
    instance.points += count;
  }
}

/** The arrays of one Hermite curve. */
export class CurveData extends Held {
  constructor(
    points: Floats,
    readonly tangents: Floats,
    /** Empty where arriving and leaving are the same. */
    public tangentsIn: Floats,
    /** One, or one per segment; empty until the kernel has said what the default is. */
    public omega: Floats,
    /** Empty where all are 1. */
    readonly lengths: Floats,
    readonly space: Space,
    closed: boolean,
  ) {
    super(points, closed, 2);
  }

  /** @internal */
  get door(): Door<CurveKernel> {
    return door;
  }

  get orders(): number {
    return 2;
  }

  outline(_: string, rest: number): { data: CurveData; near: number; rest: number } {
    return { data: this, near: 0, rest };
  }

  exactly(): CurveData {
    return this;
  }

  /** How many segments there are. */
  get segments(): number {
    return this.count - (this.closed ? 0 : 1);
  }

  protected send(op: string, slot: number): void {
    const { points, tangents, tangentsIn, omega, lengths } = this;
    write(op, points, tangents, tangentsIn, omega, lengths);
    const space = SPACES.indexOf(this.space);
    const arrays = [tangentsIn.length / 2, omega.length, lengths.length] as const;
    const given = lengths.length < 2 ? { lengths: 0, omega: omega.length === 1 ? 0 : omega } : undefined;
    const omegas = call(op, (kernel) => kernel.load(slot, this.count, ...arrays, space, this.closed ? 1 : 0), given);
    this.omega = copy(omegas);
    this.end = result(0);
  }

  /** Gives the arriving tangents an array of their own. */
  separate(): void {
    if (this.tangentsIn.length === 0) this.tangentsIn = this.tangents.slice();
  }
}

function oldest(used: readonly number[], ids: readonly number[]): number {
  let best = 0;
  for (let slot = 0; slot < SLOTS; slot += 1) {
    if (ids[slot] === 0) return slot;
    if ((used[slot] ?? 0) < (used[best] ?? 0)) best = slot;
  }
  return best;
}

/** The curves that the kernel has left in its output, one after the other. */
export function readCurves(count: number): CurveData[] {
  return curvesIn(peek(count));
}

/** Curves as an engine describes them, one after the other. */
export function curvesIn(numbers: Float64Array): CurveData[] {
  const count = numbers.length;
  const curves: CurveData[] = [];
  let at = 0;
  const take = (length: number): Floats => numbers.slice(at, (at += length)) as Floats;
  while (at < count) {
    const [points = 0, closed, space = 0, arriving = 0, omega = 0, lengths = 0, end = 0] = take(7);
    const data = new CurveData(
      take(2 * points),
      take(2 * points),
      take(2 * arriving),
      take(omega),
      take(lengths),
      SPACES[space] ?? "trigonometric",
      closed === 1,
    );
    data.end = end;
    curves.push(data);
  }
  return curves;
}
