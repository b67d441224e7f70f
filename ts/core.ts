/** The ES module of Hermite curves and path data: the public names, and what the other modules need of it. */
export { default, initSync, version } from "./core/engine.js";
export type { InitOptions, InitSyncOptions } from "./core/engine.js";
export type { OwnBytes, Signal } from "./core/host.js";
export { ExplineError } from "./core/error.js";
export type { ErrorCode, ErrorDetails } from "./core/error.js";
export type { MatrixLike, PointsLike, SpacePointsLike } from "./core/arguments.js";
export type { Space } from "./core/curve-data.js";
export type { Bounds, Curve, Ellipse, Nearest, PathOptions } from "./core/contract.js";
export { HermiteCurve } from "./core/hermite-curve.js";
export type { EllipseOptions, HermiteCurveOptions } from "./core/hermite-arguments.js";
export type { HermiteCurveJSON } from "./core/hermite-json.js";
export { HermiteGenerators } from "./core/hermite-generators.js";
export type { Root } from "./core/root-lists.js";
export { parsePath } from "./core/svg.js";
export type { PathWarning } from "./core/svg.js";

/** @internal */
export { begin, beginSync, instanceOf } from "./core/engine.js";
/** @internal */
export type { AnyKernel, CurveKernel, Engine, Instance } from "./core/engine.js";
/** @internal */
export { affine } from "./core/affine.js";
/** @internal */
export {
  LARGEST,
  MAX_EVALUATIONS,
  MAX_OUTPUT,
  MAX_POINTS,
  coordinate,
  coordinates,
  count,
  exactly,
  finite,
  flag,
  inRange,
  integer,
  isFloat64Array,
  lengthOfArray,
  numbers,
  oneOr,
  options,
  parameters,
  patchNumber,
  points,
  tolerance,
  word,
} from "./core/arguments.js";
/** @internal */
export { HeldCurve, curvesIn } from "./core/curve-data.js";
/** @internal */
export { Held } from "./core/held.js";
/** @internal */
export type { CurveData } from "./core/curve-data.js";
/** @internal */
export { dataOf, pathsOf } from "./core/curve.js";
export { MeasuredCurve } from "./core/curve.js";
/** @internal */
export { overLimit, shown, tagOf, tooFewPoints, wrong, wrongLength } from "./core/error.js";
/** @internal */
export { checked } from "./core/hermite-arguments.js";
/** @internal */
export { curveIn, curveOf } from "./core/hermite-curve.js";
/** @internal */
export { MAX_ROOTS, rootList, rootNumbers } from "./core/root-lists.js";
/** @internal */
export { callOf, doorOf } from "./core/kernel.js";
/** @internal */
export type { Door, Floats } from "./core/kernel.js";
/** @internal */
export { besideCore } from "../build/bindings/wasm-bytes.js";
