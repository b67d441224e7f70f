import type { Contour } from "../document.ts";
import { traceDefaults, traceLimits, workSizes, type CornerChoice, type KeptTrace, type TraceDocument, type TraceSettings } from "../trace/trace.ts";
import { asArray, asBoolean, asNumber, asSampleId, asWhole, field, oneOf, optional, wrong, type Found } from "./check.ts";

/** A trace as a file has it: the sample or the outlines, how they were found, and what was decided by hand. */

const mostSide = 65_536;
const mostCorners = 10_000;

/** What a file leaves out is as it is on a fresh page; a picture that was not kept is not missed. */
export function readTrace(found: Found, readContours: (found: Found) => Contour[]): TraceDocument {
  const settings = optional(found, "settings", readSettings) ?? traceDefaults;
  const corners = optional(found, "corners", (list) => asArray(list, readCorner, mostCorners, "maxPoints")) ?? [];
  const anyway = optional(found, "anyway", asBoolean) === true ? { anyway: true } : {};
  const sample = optional(found, "sample", asSampleId);
  if (sample !== undefined) return { sample, settings, corners, ...anyway };
  const kept = optional(found, "kept", (outlines) => readKept(outlines, readContours));
  return { settings, corners, ...anyway, ...(kept === undefined ? {} : { kept }) };
}

function readSettings(found: Found): TraceSettings {
  const part = <T>(name: string, read: (value: Found) => T): T | undefined => optional(found, name, read);
  const orAuto = (most: number) => (value: Found): number | "auto" => (value.value === "auto" ? "auto" : asNumber(value, 0, most));
  const all = {
    detail: part("detail", (value) => asNumber(value, 0, traceLimits.detail)),
    corner: part("corner", (value) => asNumber(value, 0, traceLimits.corner)),
    speckle: part("speckle", (value) => asNumber(value, 0, traceLimits.speckle)),
    mode: part("mode", (value) => oneOf(value, ["brightness", "edges", "lines"])),
    threshold: part("threshold", orAuto(traceLimits.threshold)),
    blur: part("blur", orAuto(traceLimits.blur)),
    invert: part("invert", asBoolean),
    colors: part("colors", readColors),
    size: part("size", readSize),
  };
  return { ...traceDefaults, ...Object.fromEntries(Object.entries(all).filter(([, value]) => value !== undefined)) };
}

function readColors(found: Found): number {
  const colors = asWhole(found, 0, traceLimits.colors);
  if (colors === 1) throw wrong(found, "0, or at least 2 colours");
  return colors;
}

function readSize(found: Found): TraceSettings["size"] {
  const size = workSizes.find((each) => each === found.value);
  if (size === undefined) throw wrong(found, `one of ${workSizes.join(", ")}`);
  return size;
}

function readCorner(found: Found): CornerChoice {
  return { x: asNumber(field(found, "x")), y: asNumber(field(found, "y")), kind: oneOf(field(found, "kind"), ["smooth", "cusp"]) };
}

function readKept(found: Found, readContours: (found: Found) => Contour[]): KeptTrace {
  const name = field(found, "name");
  if (typeof name.value !== "string" || name.value.length > 100) throw wrong(name, "a short name");
  return {
    name: name.value.replace(/[\p{Cc}\p{Cf}\p{Zl}\p{Zp}]/gu, "\uFFFD"),
    width: asWhole(field(found, "width"), 1, mostSide),
    height: asWhole(field(found, "height"), 1, mostSide),
    contours: readContours(field(found, "contours")),
  };
}
