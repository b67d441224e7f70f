/** The ES module of Hermite curves and path data: the public names, and what the other modules need of it. */
export { default, initSync, version } from "./engine.js";
export type { InitOptions, InitSyncOptions } from "./engine.js";
export { ExplineError } from "./error.js";
export type { ErrorCode, ErrorDetails } from "./error.js";
export type { PointsLike, SpacePointsLike } from "./arguments.js";
export type { Space } from "./curve-data.js";
export type { Bounds, Curve, Ellipse, Nearest, PathOptions } from "./curve.js";
export { HermiteCurve } from "./hermite-curve.js";
export type { EllipseOptions, HermiteCurveJSON, HermiteCurveOptions } from "./hermite-curve.js";
export { HermiteGenerators } from "./hermite-generators.js";
export type { Root } from "./root-lists.js";
export { parsePath } from "./svg.js";
export type { PathWarning } from "./svg.js";

/** @internal */
export { begin, beginSync, instanceOf } from "./engine.js";
/** @internal */
export type { AnyKernel, CurveKernel, Engine, Instance } from "./engine.js";
/** @internal */
export {
  LARGEST,
  MAX_EVALUATIONS,
  MAX_OUTPUT,
  coordinate,
  count,
  exactly,
  finite,
  flag,
  integer,
  isBytes,
  isFloat64Array,
  lengthOfArray,
  numbers,
  options,
  points,
  tolerance,
  within,
  word,
} from "./arguments.js";
/** @internal */
export { Held, curvesIn } from "./curve-data.js";
/** @internal */
export type { CurveData } from "./curve-data.js";
/** @internal */
export { dataOf, pathsOf } from "./curve.js";
export { MeasuredCurve } from "./curve.js";
/** @internal */
export { overLimit, shown, tooFewPoints, wrong, wrongLength } from "./error.js";
/** @internal */
export { checked, curveOf } from "./hermite-curve.js";
/** @internal */
export { MAX_ROOTS, rootList, rootNumbers } from "./root-lists.js";
/** @internal */
export { callOf, doorOf, peekOf, resultOf, writeBytesTo, writeTo } from "./kernel.js";
/** @internal */
export type { Door, Floats } from "./kernel.js";
/** @internal */
export { decoded } from "./decode.js";
