/** What a curve on a grid is made of. */
import { type CurveData, type Door, type Floats, HeldCurve, LARGEST, curvesIn } from "../core.js";
import { type SplineKernel, door } from "./spline-engine.js";

/** The one curve with points and tangents that the engine has left in its output. */
function hermiteData(count: number): CurveData {
  return curvesIn(door.peek(count))[0] as CurveData;
}

/** The kinds of curves on a grid, in the kernel's numbers. */
export const enum SplineKind {
  Interpolating = 1,
  BSpline,
  Local,
}

/** Control points of a finer grid over a part of a curve, by how far they are displaced. */
export interface Patch {
  /** Its grid is 2^−level. */
  readonly level: number;
  /** Number of its first control point on that grid. */
  readonly first: number;
  /** All coordinates of each in turn. */
  readonly displacements: Float64Array;
}

/** The arrays of one curve on a grid. @internal */
export class SplineData extends HeldCurve<SplineKernel> {
  constructor(
    readonly kind: SplineKind,
    points: Floats,
    dimension: 2 | 3,
    closed: boolean,
    /** Two numbers each; empty until the kernel has said what the default is. */
    public roots: Floats,
    readonly step = 1,
    readonly offset = 0,
    public patches: readonly Patch[] = [],
  ) {
    super(points, closed, dimension);
    // Until a file or the kernel has said what they are.
    this.start = this.end = NaN;
  }

  /** What a curve on the same grid is made of. */
  over(points: Floats, patches: readonly Patch[]): SplineData {
    const { kind, dimension, closed, roots, step, offset, start, end } = this;
    return Object.assign(new SplineData(kind, points, dimension, closed, roots, step, offset, patches), { start, end });
  }

  get door(): Door<SplineKernel> {
    return door;
  }

  outline(op: string, tolerance: number): { data: CurveData; near: number; rest: number } {
    const data = hermiteData(this.ask(op, (kernel, slot) => kernel.outline(slot, tolerance)));
    return { data, near: door.result(0), rest: door.result(1) };
  }

  exactly(op: string): CurveData | undefined {
    if (this.dimension === 3) return undefined;
    // Where it is not exact it is not wanted: the widest tolerance takes the least work.
    const data = hermiteData(this.ask(op, (kernel, slot) => kernel.to_hermite(slot, LARGEST)));
    return door.result(0) === 0 ? data : undefined;
  }

  get orders(): number {
    return Math.max(this.roots.length / 2 - 1, 2);
  }

  protected send(op: string, slot: number): void {
    const { kind, points, dimension, roots, step, offset, start, end, patches } = this;
    const arrays = patches.map(({ level, first, displacements }) => {
      return [Float64Array.of(level, first, displacements.length / dimension), displacements];
    });
    door.write(op, points, roots, ...arrays.flat());
    const counts = [points.length, dimension, this.closed ? 1 : 0, roots.length / 2, patches.length] as const;
    const given = door.call(op, (kernel) => kernel.load_spline(slot, kind, ...counts, step, offset, start, end), { points });
    this.roots = door.copy(given);
    this.start = door.result(0);
    this.end = door.result(1);
  }
}

/** The curve on a grid that the kernel has left in its output. @internal */
export function readSpline(count: number): SplineData {
  const numbers = door.peek(count);
  let at = 10;
  const take = (length: number): Floats => numbers.slice(at, (at += length)) as Floats;
  const [kind = 0, length = 0, axes, closed, roots = 0, patches = 0, step, offset, start = 0, end = 0] = numbers;
  const dimension = axes === 3 ? 3 : 2;
  const data = new SplineData(kind as SplineKind, take(length), dimension, closed === 1, take(2 * roots), step, offset);
  data.patches = Array.from({ length: patches }, () => {
    const [level = 0, first = 0, points = 0] = take(3);
    return { level, first, displacements: take(dimension * points) };
  });
  data.start = start;
  data.end = end;
  return data;
}

