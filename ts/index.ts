/**
 * The public interface of expline: each kind of work is an ES module; a bundler drops those of which nothing is used.
 */
export { default, ExplineError, HermiteCurve, HermiteGenerators, initSync, parsePath, version } from "./core.js";
export type {
  Bounds,
  Curve,
  Ellipse,
  EllipseOptions,
  ErrorCode,
  ErrorDetails,
  HermiteCurveJSON,
  HermiteCurveOptions,
  InitOptions,
  InitSyncOptions,
  MatrixLike,
  Nearest,
  PathOptions,
  PathWarning,
  PointsLike,
  Root,
  Space,
  SpacePointsLike,
} from "./core.js";
export { bendCurve, handlesOf, hitTest, jointOf, moveHandle, movePoint, tangentWeights } from "./edit.js";
export type { HandleSide, Hit, HitCurve, HitHandle, HitOptions, HitPoint, Joint } from "./edit.js";
export { SparseFitter, fitSparse, fitSparseAll, fitSparseAllAsync, fitSparseAsync, initFit, initFitSync } from "./fit.js";
export type { FitChange, FitProgress, FitStatus, FitStep, SparseFit, SparseFitAllOptions, SparseFitOptions, SparseFitStrength, SparseKnot } from "./fit.js";
export { fromJSON } from "./json.js";
export type { JSONWarning, ReadOptions } from "./json.js";
export {
  BSplineCurve,
  ExponentialBSpline,
  InterpolatingCurve,
  Interpolator,
  LocalCurve,
  initSpline,
  initSplineSync,
  roots,
} from "./spline.js";
export type {
  AnyPointsLike,
  BSplineCurveJSON,
  BSplineCurveOptions,
  InterpolatingCurveJSON,
  InterpolatingCurveOptions,
  LocalCurveJSON,
  LocalCurveOptions,
  Patch,
} from "./spline.js";
export { TensorSurface, initSurface, initSurfaceSync } from "./surface.js";
export type {
  Direction,
  DirectionJSON,
  MeshFileOptions,
  MeshRegion,
  PatchWindow,
  SurfaceMesh,
  SurfacePatch,
  TensorSurfaceJSON,
  TensorSurfaceOptions,
} from "./surface.js";
export { evenLight, fitProfile, initTrace, initTraceSync, looScore, metrics, quasiInterpolate, traceImage, traceImageAsync } from "./trace.js";
export type {
  ImageLike,
  ProfileFit,
  ProfileOptions,
  ProfileTube,
  QuasiInterpolantOptions,
  Trace,
  TraceLayer,
  TraceMetrics,
  TraceOptions,
  TraceProgress,
  TraceStage,
  TraceSvgOptions,
  TracedContour,
} from "./trace.js";
