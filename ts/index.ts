/** The public interface of expline: curves are one ES module, fitting another, which a bundler drops when nothing of it is used. */
export { default, ExplineError, HermiteCurve, HermiteGenerators, fromJSON, initSync, parsePath, version } from "./core.js";
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
  JSONWarning,
  Nearest,
  PathOptions,
  PathWarning,
  PointsLike,
  Space,
} from "./core.js";
