/** The ES module of curves: the public names, and what the module for fitting needs of it. */
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
export { fromJSON } from "./json.js";
export type { JSONWarning, ReadOptions } from "./json.js";
export { TensorSurface } from "./surface.js";
export type {
  Direction,
  MeshRegion,
  SurfaceMesh,
  SurfacePatch,
  TensorSurfaceOptions,
} from "./surface.js";
export type { MeshFileOptions } from "./mesh-files.js";
export type { PatchWindow } from "./surface-data.js";
export type { DirectionJSON, TensorSurfaceJSON } from "./surface-json.js";
export { parsePath } from "./svg.js";
export type { PathWarning } from "./svg.js";

/** @internal */
export { begin, beginSync, instanceOf } from "./engine.js";
/** @internal */
export type { AnyKernel, Engine } from "./engine.js";
/** @internal */
export { count, finite, flag, integer, numbers, options, points, word } from "./arguments.js";
/** @internal */
export { curvesIn } from "./curve-data.js";
/** @internal */
export { overLimit, tooFewPoints, wrong, wrongLength } from "./error.js";
/** @internal */
export { curveOf } from "./hermite-curve.js";
/** @internal */
export { callOf, peekOf, resultOf, writeTo } from "./kernel.js";
/** @internal */
export { decoded } from "./decode.js";
