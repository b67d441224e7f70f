/** The ES module of curves of any roots, and of the functions that they are made of. */
export { ExponentialBSpline, Interpolator } from "./exponential-generators.js";
export { roots } from "./roots.js";
export { InterpolatingCurve } from "./interpolating-curve.js";
export type { InterpolatingCurveJSON, InterpolatingCurveOptions } from "./interpolating-curve.js";
export { LocalCurve } from "./local-curve.js";
export type { LocalCurveJSON, LocalCurveOptions } from "./local-curve.js";
export type { Patch } from "./spline-data.js";
export { BSplineCurve } from "./b-spline-curve.js";
export type { BSplineCurveJSON, BSplineCurveOptions } from "./b-spline-curve.js";
export type { AnyPointsLike } from "./spline-curve.js";
export { initSpline, initSplineSync } from "./spline-engine.js";

/** @internal */
export { checkedInterpolating, interpolatingOf } from "./interpolating-curve.js";
/** @internal */
export { checkedLocal, localOf } from "./local-curve.js";
/** @internal */
export { bSplineOf, checkedBSpline } from "./b-spline-curve.js";
