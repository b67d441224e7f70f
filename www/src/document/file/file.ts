/**
 * The file format: what the page saves, shares, keeps over a reload and takes back. Reading checks every field and
 * copies only what it knows, so that nothing else in a file can reach the page; writing is the plain JSON of the state.
 */
import {
  baseCount, modes, segmentCount, stateVersion,
  type Contour, type ControlPoint, type CurveDocument, type DemoState, type FinePlace, type Grid, type Offset, type Order,
} from "../document.ts";
import { readFit } from "./fit.ts";
import { readOrbit, readRoots, readSurface } from "./surface.ts";
import { readTrace } from "./trace.ts";
import { drawable, readView } from "./view.ts";
import { emptyFit } from "../fit/fit.ts";
import { othersOf } from "./others.ts";
import { emptySurface } from "../surface/surface.ts";
import { emptyTrace } from "../trace/trace.ts";
import { asArray, asBoolean, asNumber, asObject, asSampleId, asWhole, defined, field, oneOf, optional, type Found } from "./check.ts";
import { FileError } from "./error.ts";
import { readPaint } from "./paint.ts";
import { readSetting } from "./setting.ts";
import { checkJson } from "./scan.ts";

export { FileError, type FileErrorCode } from "./error.ts";
export { writeState } from "./write.ts";

const fileVersion = stateVersion;

const limits = { maxBytes: 64 * 1024 * 1024, maxDepth: 64, maxPoints: 100_000, maxContours: 100_000 };

const spaces = ["trigonometric", "hyperbolic", "polynomial"] as const;
const kinds = ["symmetric", "smooth", "cusp"] as const;
const families = ["hermite", "interpolating"] as const;

export interface ReadFile {
  readonly state: DemoState;
  /** `W_UNKNOWN_FIELD` with the paths of fields that this version does not know and carries along. */
  readonly warnings: readonly { readonly code: "W_UNKNOWN_FIELD"; readonly path: string }[];
}

/** @throws FileError, and leaves nothing half read. */
export function parseState(source: string): ReadFile {
  if (source.length > limits.maxBytes) throw new FileError("E_LIMIT", "$", "is larger than 64 MiB", { limit: "maxBytes" });
  const text = source.replace(/^\uFEFF/u, "");
  checkJson(text, limits.maxDepth);
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    throw new FileError("E_PARSE_JSON", "$", "is not JSON");
  }
  return { state: readState(value), warnings: unknownFields(value) };
}

/** A checked copy of a state that came from outside. */
export function readState(value: unknown): DemoState {
  const root: Found = { value, path: "$" };
  const version = asWhole(field(root, "version"), 1, Number.MAX_SAFE_INTEGER);
  if (version > fileVersion) {
    throw new FileError("E_UNSUPPORTED", "$.version", `is ${version}; this page reads up to ${fileVersion}`, { version });
  }
  const state: DemoState = {
    ...strangers(root),
    format: oneOf(field(root, "format"), ["expline-demo"]),
    version: fileVersion,
    mode: optional(root, "mode", (found) => oneOf(found, modes)) ?? "curve",
    view: optional(root, "view", readView) ?? { zoom: 1, x: 400, y: 300 },
    curve: readCurve(field(root, "curve")),
    fit: optional(root, "fit", readFit) ?? emptyFit,
    trace: optional(root, "trace", (found) => readTrace(found, readContours)) ?? emptyTrace,
    surface: optional(root, "surface", readSurface) ?? emptySurface,
    ...defined({ orbit: optional(root, "orbit", readOrbit) }),
  };
  return { ...state, view: drawable(state) };
}

/** Copies of somebody else's fields, as far as JSON can hold them. */
function strangers(root: Found): Record<string, unknown> {
  return Object.fromEntries(Object.entries(othersOf(asObject(root))).flatMap(([key, value]) => {
    try {
      const text = JSON.stringify(value) as string | undefined;
      return text === undefined ? [] : [[key, JSON.parse(text) as unknown]];
    } catch {
      // It holds itself: no file can.
      return [];
    }
  }));
}

function unknownFields(value: unknown): ReadFile["warnings"] {
  return Object.keys(othersOf(asObject({ value, path: "$" })))
    .slice(0, 20)
    .map((key) => ({ code: "W_UNKNOWN_FIELD", path: `$.${key.slice(0, 40)}` }));
}

function readCurve(found: Found): CurveDocument {
  return {
    space: oneOf(field(found, "space"), spaces),
    omega: readOmega(field(found, "omega")),
    level: optional(found, "level", (level) => asWhole(level, 0, 24)) ?? 0,
    contours: readContours(field(found, "contours")),
    ...defined({ sample: optional(found, "sample", asSampleId) }),
    ...readSetting(found),
  };
}

function readContours(found: Found): Contour[] {
  const left = { points: limits.maxPoints };
  return asArray(found, (contour) => readContour(contour, left), limits.maxContours, "maxContours");
}

function readOmega(found: Found): number | "auto" {
  return found.value === "auto" ? "auto" : asNumber(found, 0, 1e4);
}

function readContour(found: Found, left: { points: number }): Contour {
  const points = asArray(field(found, "points"), readPoint, left.points, "maxPoints");
  left.points -= points.length;
  const space = optional(found, "space", (each) => oneOf(each, spaces));
  const contour: Contour = {
    family: optional(found, "family", (each) => oneOf(each, families)) ?? "hermite",
    closed: asBoolean(field(found, "closed")),
    points,
    ...defined({
      space,
      ...readPaint(found),
      support: optional(found, "support", (each) => asWhole(each, 1, 64)),
      omega: optional(found, "omega", (each) => asArray(each, (value) => asNumber(value, 0, 1e4), limits.maxPoints, "maxPoints")),
      lengths: optional(found, "lengths", (each) => asArray(each, (value) => asNumber(value, 1e-9, 1e9), limits.maxPoints, "maxPoints")),
      order: optional(found, "order", readOrder),
      roots: optional(found, "roots", readRoots),
      grid: optional(found, "grid", readGrid),
      places: optional(found, "places", (each) => asArray(each, readPlace, 64, "maxPlaces")),
    }),
  };
  checkFamily(contour, found.path);
  if (points.length === 0) throw new FileError("E_SCHEMA", `${found.path}.points`, "is empty");
  for (const name of ["omega", "lengths"] as const) {
    const values = contour[name];
    if (values !== undefined && values.length !== segmentCount(contour)) {
      throw new FileError("E_SCHEMA", `${found.path}.${name}`, `has not one number for each of ${segmentCount(contour)} segments`);
    }
  }
  return contour;
}

function readOrder(found: Found): Order {
  const order = asWhole(found, 3, 5);
  return order === 3 ? 3 : order === 4 ? 4 : 5;
}

function readPlace(found: Found): FinePlace {
  return {
    level: asWhole(field(found, "level"), 1, 12),
    first: asWhole(field(found, "first"), 0, limits.maxPoints),
    count: asWhole(field(found, "count"), 1, limits.maxPoints),
  };
}

function readGrid(found: Found): Grid {
  return {
    step: asNumber(field(found, "step"), 1e-9, 1),
    offset: asNumber(field(found, "offset"), -1e6, 1e6),
    count: asWhole(field(found, "count"), 2, limits.maxPoints),
  };
}

/** Roots and grid are an interpolating contour's; a segment's own frequency or length is a Hermite one's. */
function checkFamily(contour: Contour, path: string): void {
  const strange = contour.family === "hermite" ? (["order", "roots", "grid", "places"] as const) : (["omega", "lengths"] as const);
  for (const name of strange) {
    if (contour[name] !== undefined) throw new FileError("E_SCHEMA", `${path}.${name}`, `is nothing that a contour of the family ${contour.family} has`);
  }
  if (contour.places !== undefined && (contour.grid !== undefined || baseCount(contour) < 2)) {
    throw new FileError("E_SCHEMA", `${path}.places`, "leaves no points on the curve");
  }
  if (contour.grid !== undefined && contour.roots === undefined) throw new FileError("E_SCHEMA", `${path}.roots`, "is missing");
}

function readOffset(found: Found): Offset {
  return { dx: asNumber(field(found, "dx")), dy: asNumber(field(found, "dy")) };
}

function readPoint(found: Found): ControlPoint {
  return {
    x: asNumber(field(found, "x")),
    y: asNumber(field(found, "y")),
    kind: oneOf(field(found, "kind"), kinds),
    in: readOffset(field(found, "in")),
    out: readOffset(field(found, "out")),
    ...defined({ level: optional(found, "level", (level) => asWhole(level, 0, 24)), moved: optional(found, "moved", readOffset) }),
  };
}
