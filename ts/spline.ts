/** The ES module of curves of any roots, and of the functions that they are made of. */
export { ExponentialBSpline, Interpolator } from "./spline/exponential-generators.js";
export { roots } from "./spline/roots.js";
export { InterpolatingCurve } from "./spline/interpolating-curve.js";
export type { InterpolatingCurveJSON, InterpolatingCurveOptions } from "./spline/interpolating-curve.js";
export { LocalCurve } from "./spline/local-curve.js";
export type { LocalCurveJSON, LocalCurveOptions } from "./spline/local-curve.js";
export type { Patch } from "./spline/spline-data.js";
export { BSplineCurve } from "./spline/b-spline-curve.js";
export type { BSplineCurveJSON, BSplineCurveOptions } from "./spline/b-spline-curve.js";
export type { AnyPointsLike } from "./spline/spline-curve.js";
export { initSpline, initSplineSync } from "./spline/spline-engine.js";

/** @internal */
export { checkedInterpolating, interpolatingOf } from "./spline/interpolating-curve.js";
/** @internal */
export { checkedLocal, localOf } from "./spline/local-curve.js";
/** @internal */
export { bSplineOf, checkedBSpline } from "./spline/b-spline-curve.js";
