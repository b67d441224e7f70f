/** The public interface of expline: curves, surfaces, fitting and tracing are an ES module each; a bundler drops those of which nothing is used. */
export {
  default,
  BSplineCurve,
  ExplineError,
  ExponentialBSpline,
  HermiteCurve,
  HermiteGenerators,
  InterpolatingCurve,
  Interpolator,
  LocalCurve,
  initSync,
  parsePath,
  roots,
  version,
} from "./core.js";
export type {
  AnyPointsLike,
  BSplineCurveJSON,
  BSplineCurveOptions,
  Bounds,
  Curve,
  Ellipse,
  EllipseOptions,
  ErrorCode,
  ErrorDetails,
  HermiteCurveJSON,
  HermiteCurveOptions,
  InitOptions,
  InterpolatingCurveJSON,
  InterpolatingCurveOptions,
  LocalCurveJSON,
  LocalCurveOptions,
  Nearest,
  Patch,
  PathOptions,
  PathWarning,
  PointsLike,
  Root,
  Space,
  SpacePointsLike,
} from "./core.js";
export { SparseFitter, fitSparse, fitSparseAsync, initFit, initFitSync } from "./fit.js";
export type { FitProgress, FitStatus, SparseFit, SparseFitOptions, SparseFitStrength, SparseKnot } from "./fit.js";
export { fromJSON } from "./json.js";
export type { JSONWarning, ReadOptions } from "./json.js";
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
export { initTrace, initTraceSync, traceImage, traceImageAsync } from "./trace.js";
export type {
  ImageLike,
  Trace,
  TraceMetrics,
  TraceOptions,
  TraceProgress,
  TraceStage,
  TraceSvgOptions,
  TracedContour,
} from "./trace.js";
