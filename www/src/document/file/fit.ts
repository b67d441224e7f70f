import { readSetting } from "./setting.ts";
import { emptyFit, fitDefaults, fitLimits, owned, strokesOf, type FitDocument, type Pair } from "../fit/fit.ts";
import { asArray, asBoolean, asNumber, asSampleId, asWhole, field, oneOf, optional, type Found } from "./check.ts";
import { FileError } from "./error.ts";
import { readPaint } from "./paint.ts";

/** Points to be fitted and how, as a file has them. */

const mostPoints = 100_000;

function readPair(found: Found): Pair {
  const [x, y, ...rest] = asArray(found, (value) => asNumber(value), 2, "pair");
  if (x === undefined || y === undefined || rest.length > 0) throw new FileError("E_SCHEMA", found.path, "is not a pair of numbers");
  return [x, y];
}

/** Version 1 had no strokes, no corners, no target; what a file leaves out is as it is on a fresh page. */
export function readFit(found: Found): FitDocument {
  const data = asArray(field(found, "data"), readPair, mostPoints, "maxPoints");
  const sample = optional(found, "sample", asSampleId);
  if (data.length === 0 && sample === undefined) return { ...owned(emptyFit), ...settings(found) };
  const starts = optional(found, "starts", (list) => asArray(list, (start) => asWhole(start, 1, mostPoints), mostPoints, "maxPoints")) ?? [];
  const rising = starts.every((start, i) => start > (starts[i - 1] ?? 0) && start < data.length);
  if (!rising) throw new FileError("E_SCHEMA", `${found.path}.starts`, "is not rising, or beyond the data");
  const up = optional(found, "up", asBoolean);
  const paints = optional(found, "paints", (list) => asArray(list, readPaint, mostPoints, "maxPoints"));
  if (paints !== undefined && paints.length !== strokesOf({ data, starts }).length) throw new FileError("E_SCHEMA", `${found.path}.paints`, "has not one paint for each stroke");
  return { ...fitDefaults, ...settings(found), data, starts, ...(up === true ? { up } : {}), ...(paints === undefined ? {} : { paints }), ...readSetting(found), ...(sample === undefined ? {} : { sample }) };
}

function settings(found: Found): Partial<FitDocument> {
  const number = (name: string, least: number, most: number): number | undefined => optional(found, name, (value) => asNumber(value, least, most));
  const all = {
    model: oneOf(field(found, "model"), ["linear", "cubic", "hybrid"]),
    smoothing: asNumber(field(found, "smoothing"), 0, fitLimits.smoothing),
    mix: asNumber(field(found, "mix"), 0, fitLimits.mix),
    corners: optional(found, "corners", asBoolean),
    closing: optional(found, "closing", (value) => oneOf(value, ["auto", "open", "closed"])),
    target: optional(found, "target", (value) => oneOf(value, ["off", "knots", "error"])),
    targetKnots: optional(found, "targetKnots", (value) => asWhole(value, 1, fitLimits.knots)),
    targetError: number("targetError", 0, fitLimits.error),
    noise: number("noise", 0, fitLimits.noise),
    seed: optional(found, "seed", (value) => asWhole(value, 0, fitLimits.seed)),
  };
  return Object.fromEntries(Object.entries(all).filter(([, value]) => value !== undefined));
}
