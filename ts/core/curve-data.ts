/** What a curve is made of. */
import type { CurveKernel, Kernel } from "./engine.js";
import { Held } from "./held.js";
import { type Door, type Floats, call, copy, door, result, write } from "./kernel.js";

/** The space that a segment lies in. */
export type Space = "trigonometric" | "hyperbolic" | "polynomial";

/** The spaces in the kernel's order. */
export const SPACES: readonly Space[] = ["trigonometric", "hyperbolic", "polynomial"];

/** What one curve of any kind is made of. @internal */
export abstract class HeldCurve<K extends CurveKernel = CurveKernel> extends Held<K> {
  /** First and last parameter of the domain. */
  start = 0;
  end = 0;

  constructor(
    readonly points: Floats,
    readonly closed: boolean,
    readonly dimension: 2 | 3,
  ) {
    super();
  }

  /** How many points there are. */
  get count(): number {
    return this.points.length / this.dimension;
  }

  /** The highest derivative that can be asked for. */
  abstract get orders(): number;

  /**
   * The curve with points and tangents that a path is made of, how far it is from this one, and what that leaves of the
   * tolerance.
   */
  abstract outline(op: string, tolerance: number): { data: CurveData; near: number; rest: number };

  /** The curve as one with points and tangents, if it is one. */
  abstract exactly(op: string): CurveData | undefined;
}

/** The arrays of one Hermite curve. @internal */
export class CurveData extends HeldCurve<Kernel> {
  constructor(
    points: Floats,
    readonly tangents: Floats,
    /** Empty where arriving and leaving are the same. */
    public tangentsIn: Floats,
    /** One, or one per segment; empty until the kernel has said what the default is. */
    public omega: Floats,
    /** Empty where all are 1. */
    public lengths: Floats,
    readonly space: Space,
    closed: boolean,
  ) {
    super(points, closed, 2);
  }

  /** @internal */
  get door(): Door<Kernel> {
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
    // One number stands for all and has no index, unless lengths say of which segment more is wrong.
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

/** Curves as an engine describes them, one after the other. @internal */
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
