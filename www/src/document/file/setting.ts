import { settingOf, type Artboard, type Setting } from "../artboard.ts";
import { asNumber, field, oneOf, optional, type Found } from "./check.ts";

/** What a drawing is besides its contours, as a file has it. */

const fillings = ["nonzero", "none"] as const;

export function readSetting(found: Found): Setting {
  const [filling, artboard] = [optional(found, "filling", (each) => oneOf(each, fillings)), optional(found, "artboard", readArtboard)];
  return settingOf({ ...(filling === undefined ? {} : { filling }), ...(artboard === undefined ? {} : { artboard }) });
}

function readArtboard(found: Found): Artboard {
  const side = (name: "width" | "height"): number => asNumber(field(found, name), 1e-6, 2e9);
  return { x: asNumber(field(found, "x")), y: asNumber(field(found, "y")), width: side("width"), height: side("height") };
}
