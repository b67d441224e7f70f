/** What a surface is made of, owned here; the kernel only ever holds a copy of it in one of its places. */
import type { Floats } from "../core/kernel.js";
import { call, engine, peek, result, write } from "./surface-engine.js";

/** How many surfaces an instance keeps at once. */
const PLACES = 4;
/** Points of all resident surfaces together, above which the kernel forgets the others first. */
const MOST_RESIDENT = 1_500_000;

/** One direction of a net. */
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

/** Detail on a finer grid over a part of the net. */
export interface PatchData {
  readonly u: PatchWindow;
  readonly v: PatchWindow;
  /** Three numbers for each of its points. */
  readonly displacements: Floats;
}

/** Which surfaces lie in an instance, and when each was last used. */
interface Places {
  readonly ids: number[];
  readonly used: number[];
  points: number;
}

const placesOf = new WeakMap<object, Places>();

/** Every state of every surface has a number of its own. */
let lastId = 0;
let clock = 0;

/** The arrays of one surface. An edit gives it a new number, so that the kernel's copy no longer counts. */
export class SurfaceData {
  id = 0;
  place = 0;
  /** Ends of the domain and parameters of the first point. */
  end: readonly [number, number] = [0, 0];
  first: readonly [number, number] = [0, 0];
  /** Fields that a file had and this version does not know. */
  extra: Readonly<Record<string, unknown>> | undefined;

  constructor(
    readonly net: Floats,
    readonly u: DirectionData,
    readonly v: DirectionData,
    readonly patches: readonly PatchData[],
  ) {
    this.touch();
  }

  /** To be called after every change of the arrays. */
  touch(): void {
    lastId += 1;
    this.id = lastId;
  }

  /** To be called where the kernel's copy was changed in the same way. */
  touchBoth(): void {
    const places = placesOf.get(engine());
    const same = places?.ids[this.place] === this.id;
    this.touch();
    if (same && places !== undefined) places.ids[this.place] = this.id;
  }

  /** The place that holds this surface in the living instance, loaded now if need be. */
  resident(op: string): number {
    const places = placesOf.get(engine(op));
    if (places === undefined || places.ids[this.place] !== this.id) this.load(op);
    const now = placesOf.get(engine());
    clock += 1;
    if (now !== undefined) now.used[this.place] = clock;
    return this.place;
  }

  /** Has the kernel check the surface and keep it. */
  load(op: string): void {
    const count = this.net.length / 3;
    let places = placesOf.get(engine(op));
    if (places === undefined || places.points + count > MOST_RESIDENT) {
      if (places !== undefined) call(op, (kernel) => kernel.surface_forget());
      places = { ids: new Array<number>(PLACES).fill(0), used: new Array<number>(PLACES).fill(0), points: 0 };
      placesOf.set(engine(), places);
    }
    const { ids, used } = places;
    let place = 0;
    for (let i = 1; i < PLACES; i += 1) if ((used[i] ?? 0) < (used[place] ?? 0)) place = i;
    const numbers = this.numbers();
    let total = 0;
    for (const array of numbers) total += array.length;
    write(op, ...numbers);
    call(op, (kernel) => kernel.surface_load(place, total), this.net);
    this.describe();
    this.place = place;
    ids[place] = this.id;
    places.points += count;
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

/** The surface that the kernel has left in its output. */
export function readSurface(count: number): SurfaceData {
  const numbers = peek(count);
  let at = 0;
  const take = (length: number): Floats => numbers.slice(at, (at += length)) as Floats;
  const [m = 0, closedU, levelU = 0, rootsU = 0, n = 0, closedV, levelV = 0, rootsV = 0, patchCount = 0] = take(9);
  const u = { count: m, closed: closedU === 1, level: levelU, roots: take(2 * rootsU) };
  const v = { count: n, closed: closedV === 1, level: levelV, roots: take(2 * rootsV) };
  const net = take(3 * m * n);
  const patches: PatchData[] = [];
  for (let k = 0; k < patchCount; k += 1) {
    const [lu = 0, fu = 0, cu = 0, lv = 0, fv = 0, cv = 0] = take(6);
    const windows = { u: { level: lu, first: fu, count: cu }, v: { level: lv, first: fv, count: cv } };
    patches.push({ ...windows, displacements: take(3 * cu * cv) });
  }
  const data = new SurfaceData(net, u, v, patches);
  data.describe();
  return data;
}
