/** What is asked of a surface at many places at once. */
import { type Floats, finite, oneOr, parameters, wrongLength } from "../core.js";
import { type SurfaceData } from "./surface-data.js";
import { type SurfaceKernel, copy } from "./surface-engine.js";

/** The two halves of what the kernel left. @internal */
export function halves(values: Float64Array): { gaussian: Float64Array; mean: Float64Array } {
  return { gaussian: values.slice(0, values.length / 2), mean: values.slice(values.length / 2) };
}

/** Answers at pairs of parameters. @internal */
export function pairwise(
  data: SurfaceData,
  op: string,
  u: unknown,
  v: unknown,
  body: (kernel: SurfaceKernel, slot: number, count: number) => number,
): Floats {
  const list = (arg: string, value: unknown): Floats => {
    const given = parameters(op, arg, value);
    given.forEach((number, i) => finite(op, arg, number, typeof value === "number" ? undefined : i));
    return given;
  };
  const [first, second] = [list("u", u), list("v", v)];
  if (second.length !== first.length) throw wrongLength(op, "v", second.length, String(first.length));
  const given = { u: oneOr(u, first), v: oneOr(v, second) };
  return copy(data.ask(op, (kernel, slot) => body(kernel, slot, first.length), given, [first, second]));
}
