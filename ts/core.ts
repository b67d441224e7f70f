/** The ES module of curves: the public names, and what the modules for surfaces, for fitting, for tracing and for plain data need of it. */
export { default, initSync, version } from "./engine.js";
export type { InitOptions } from "./engine.js";
export { ExplineError } from "./error.js";
export type { ErrorCode, ErrorDetails } from "./error.js";
export type { PointsLike, SpacePointsLike } from "./arguments.js";
export type { Space } from "./curve-data.js";
export type { Bounds, Curve, Ellipse, Nearest, PathOptions } from "./curve.js";
export { HermiteCurve } from "./hermite-curve.js";
export type { EllipseOptions, HermiteCurveJSON, HermiteCurveOptions } from "./hermite-curve.js";
export { InterpolatingCurve } from "./interpolating-curve.js";
export type { InterpolatingCurveJSON, InterpolatingCurveOptions } from "./interpolating-curve.js";
export { LocalCurve } from "./local-curve.js";
export type { LocalCurveJSON, LocalCurveOptions } from "./local-curve.js";
export type { Patch } from "./curve-data.js";
export { BSplineCurve } from "./b-spline-curve.js";
export type { BSplineCurveJSON, BSplineCurveOptions } from "./b-spline-curve.js";
export type { AnyPointsLike } from "./spline-curve.js";
export { HermiteGenerators } from "./hermite-generators.js";
export { ExponentialBSpline, Interpolator } from "./exponential-generators.js";
export { roots } from "./roots.js";
export type { Root } from "./roots.js";
export { parsePath } from "./svg.js";
export type { PathWarning } from "./svg.js";

/** @internal */
export { begin, beginSync, instanceOf } from "./engine.js";
/** @internal */
export type { AnyKernel, Engine, Instance } from "./engine.js";
/** @internal */
export {
  LARGEST,
  MAX_EVALUATIONS,
  MAX_OUTPUT,
  coordinate,
  count,
  finite,
  flag,
  integer,
  isBytes,
  isFloat64Array,
  lengthOfArray,
  numbers,
  options,
  points,
  within,
  word,
} from "./arguments.js";
/** @internal */
export { pathsOf } from "./curve.js";
/** @internal */
export { curvesIn } from "./curve-data.js";
/** @internal */
export { overLimit, shown, tooFewPoints, wrong, wrongLength } from "./error.js";
/** @internal */
export { checked, curveOf } from "./hermite-curve.js";
/** @internal */
export { checkedInterpolating, interpolatingOf } from "./interpolating-curve.js";
/** @internal */
export { checkedLocal, localOf } from "./local-curve.js";
/** @internal */
export { bSplineOf, checkedBSpline } from "./b-spline-curve.js";
/** @internal */
export { rootList, rootNumbers } from "./roots.js";
/** @internal */
export { callOf, peekOf, resultOf, writeBytesTo, writeTo } from "./kernel.js";
/** @internal */
export type { Floats } from "./kernel.js";
/** @internal */
export { decoded } from "./decode.js";
