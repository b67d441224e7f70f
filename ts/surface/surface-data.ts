/** What a surface is made of, owned here; the kernel only ever holds a copy of it in one of its places. */
import { type Door, type Floats, Held } from "../core.js";
import { type SurfaceKernel, call, door, peek, result, write } from "./surface-engine.js";

/** What the class of surfaces is called. @internal */
export const NAME = "TensorSurface";

/** How many surfaces an instance keeps at once. */
const PLACES = 4;

/** One direction of a net. @internal */
export interface DirectionData {
  /** Two numbers for each root. */
  readonly roots: Floats;
  readonly count: number;
  readonly closed: boolean;
  /** 0 for points on the surface, k for control points on the grid 2⁻ᵏ. */
  readonly level: number;
}

/** Rows of a patch in one direction of its level's grid. */
export interface PatchWindow {
  /** The grid's: each level halves the step. */
  readonly level: number;
  /** The first row, in steps of that grid. */
  readonly first: number;
  /** How many rows. */
  readonly count: number;
}

/** Detail on a finer grid over a part of the net. @internal */
export interface PatchData {
  readonly u: PatchWindow;
  readonly v: PatchWindow;
  /** Three numbers for each of its points. */
  readonly displacements: Floats;
}

/** The arrays of one surface. @internal */
export class SurfaceData extends Held<SurfaceKernel> {
  /** Ends of the domain and parameters of the first point. */
  end: readonly [number, number] = [0, 0];
  first: readonly [number, number] = [0, 0];

  constructor(
    readonly net: Floats,
    readonly u: DirectionData,
    readonly v: DirectionData,
    readonly patches: readonly PatchData[],
  ) {
    super();
  }

  get door(): Door<SurfaceKernel> {
    return door;
  }

  get count(): number {
    return this.net.length / 3;
  }

  override get slots(): number {
    return PLACES;
  }

  protected send(op: string, slot: number): void {
    const numbers = this.numbers();
    const total = numbers.reduce((sum, array) => sum + array.length, 0);
    write(op, ...numbers);
    call(op, (kernel) => kernel.surface_load(slot, total), { net: this.net });
    this.describe();
  }

  /** Takes what the kernel left in the record about a surface. */
  describe(): void {
    this.end = [result(0), result(1)];
    this.first = [result(2), result(3)];
  }

  /** The surface as one run of numbers, in the kernel's order. */
  private numbers(): Float64Array[] {
    const { net, u, v, patches } = this;
    const header = (d: DirectionData): number[] => [d.count, d.closed ? 1 : 0, d.level, d.roots.length / 2];
    const arrays: Float64Array[] = [Float64Array.of(...header(u), ...header(v), patches.length), u.roots, v.roots, net];
    for (const patch of patches) {
      const window = (w: PatchWindow): number[] => [w.level, w.first, w.count];
      arrays.push(Float64Array.of(...window(patch.u), ...window(patch.v)), patch.displacements);
    }
    return arrays;
  }
}

/** The surface that the kernel has left in its output. @internal */
export function readSurface(count: number): SurfaceData {
  const numbers = peek(count);
  let at = 0;
  const take = (length: number): Floats => numbers.slice(at, (at += length)) as Floats;
  const [m = 0, closedU, levelU = 0, rootsU = 0, n = 0, closedV, levelV = 0, rootsV = 0, patchCount = 0] = take(9);
  const u = { count: m, closed: closedU === 1, level: levelU, roots: take(2 * rootsU) };
  const v = { count: n, closed: closedV === 1, level: levelV, roots: take(2 * rootsV) };
  const net = take(3 * m * n);
  const windowOf = (): PatchWindow => {
    const [level = 0, first = 0, rows = 0] = take(3);
    return { level, first, count: rows };
  };
  const patches = Array.from({ length: patchCount }, (): PatchData => {
    const windows = { u: windowOf(), v: windowOf() };
    return { ...windows, displacements: take(3 * windows.u.count * windows.v.count) };
  });
  const data = new SurfaceData(net, u, v, patches);
  data.describe();
  return data;
}
