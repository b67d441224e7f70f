import { paintOf, type Line, type Painted } from "../painted.ts";
import { asArray, asNumber, defined, field, oneOf, optional, wrong, type Found } from "./check.ts";

/** How a contour is painted, or a stroke that one is made of, as a file has it. */
export function readPaint(found: Found): Painted {
  return paintOf({ ink: optional(found, "ink", asInk), line: optional(found, "line", readLine) });
}

const caps = ["round", "square"] as const;
const joins = ["round", "bevel"] as const;
const color = /^#[0-9a-f]{6}(?:[0-9a-f]{2})?$/u;

function asInk(found: Found): string {
  if (typeof found.value !== "string" || !(color.test(found.value) || found.value === "none")) throw wrong(found, 'a colour like #1b5e50, or "none"');
  return found.value;
}

function asColor(found: Found): string {
  if (typeof found.value !== "string" || !color.test(found.value)) throw wrong(found, "a colour like #1b5e50");
  return found.value;
}

const mostDashes = 256;

function asDashes(found: Found): readonly number[] {
  const dashes = asArray(found, (each) => asNumber(each, 0), mostDashes, "dashes");
  if (!dashes.some((each) => each > 0)) throw wrong(found, "lengths of dashes and gaps");
  return dashes;
}

function readLine(found: Found): Line {
  const look = {
    color: optional(found, "color", asColor),
    cap: optional(found, "cap", (value) => oneOf(value, caps)),
    join: optional(found, "join", (value) => oneOf(value, joins)),
    dashes: optional(found, "dashes", asDashes),
    dashOffset: optional(found, "dashOffset", asNumber),
  };
  return { width: asNumber(field(found, "width"), 1e-9), ...defined(look) };
}
