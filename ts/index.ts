/** The public interface of expline. */
export { default, initSync, version } from "./engine.js";
export type { InitOptions } from "./engine.js";
export { ExplineError } from "./error.js";
export type { ErrorCode, ErrorDetails } from "./error.js";
export type { PointsLike } from "./arguments.js";
export type { Space } from "./curve-data.js";
export type { Bounds, Curve, Ellipse, Nearest, PathOptions } from "./curve.js";
export { HermiteCurve } from "./hermite-curve.js";
export type { EllipseOptions, HermiteCurveOptions } from "./hermite-curve.js";
export { HermiteGenerators } from "./hermite-generators.js";
export { fromJSON } from "./json.js";
export type { HermiteCurveJSON, JSONWarning } from "./json.js";
export { parsePath } from "./svg.js";
export type { PathWarning } from "./svg.js";
