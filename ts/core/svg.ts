/** SVG path data in. */
import { options as checkOptions, text } from "./arguments.js";
import { curvesIn } from "./curve-data.js";
import { ExplineError, wrong } from "./error.js";
import { type HermiteCurve, curveOf } from "./hermite-curve.js";
import { call, peek, result, textAt, writeBytes } from "./kernel.js";
import { utf8 } from "./utf8.js";

/** Path text that was read up to a place where it stops making sense. */
export interface PathWarning {
  /** The stable code. */
  code: "W_PATH_TRUNCATED";
  /** From this offset on nothing was used. */
  offset: number;
  /** Offset of the character that makes no sense. */
  index: number;
  /** What was expected there. */
  expected: string;
}

/** The longest path text, in characters. */
const MAX_PATH = 8 << 20;

/**
 * Every subpath of SVG path data that draws something as a curve, exactly: lines, cubics, raised quadratics, arcs of
 * ellipses. Segments of no extent are left out, and so is a subpath of nothing else: a dot that only a round line cap
 * would show.
 *
 * @param d - the text of a `d` attribute, at most 8 MiB with at most 100 000 subpaths. No text gives no curves.
 * @param options - with `onWarning` a text that breaks off after its first point gives what came before, and a warning.
 * @throws {ExplineError} E_PARSE_SVG with `index`, the offset of the first character that makes no sense, and
 *   `partial`, the curves before it; without `partial`, and in spite of `onWarning`, for what does not begin with a
 *   moveto to a point: that is no path. E_RANGE for numbers beyond ±1e9; E_LIMIT.
 */
export function parsePath(
  d: string,
  options?: { onWarning?: ((warning: PathWarning) => void) | undefined },
): HermiteCurve[] {
  const op = "parsePath";
  const { onWarning } = checkOptions(op, options, ["onWarning"]);
  if (onWarning !== undefined && typeof onWarning !== "function") {
    throw wrong("E_TYPE", op, "onWarning", onWarning, "a function");
  }
  const bytes = writeBytes(op, utf8(text(op, "d", d, "maxPathBytes", MAX_PATH)));
  const count = call(op, (kernel) => kernel.parse_path(bytes));
  const offset = result(0);
  const index = result(1);
  const expected = offset < 0 ? "" : textAt(result(2), result(3));
  const curves = curvesIn(peek(count)).map(curveOf);
  if (offset < 0) return curves;
  if (onWarning === undefined) throw brokenPath(op, index, expected, curves);
  (onWarning as (warning: PathWarning) => void)({ code: "W_PATH_TRUNCATED", offset, index, expected });
  return curves;
}

function brokenPath(op: string, index: number, expected: string, partial: HermiteCurve[]): ExplineError {
  const what = `d makes no sense at offset ${index}; expected ${expected}`;
  return new ExplineError("E_PARSE_SVG", op, what, { arg: "d", argument: "d", index, bound: expected, partial });
}
