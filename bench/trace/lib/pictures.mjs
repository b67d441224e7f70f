// The pictures with known outlines that were drawn once and kept.

import { readFileSync } from "node:fs";

import { readPng } from "./png.mjs";
import { twoShades } from "./unseen.mjs";

const at = (name) => new URL(`../pictures/${name}`, import.meta.url);

const json = (name) => JSON.parse(readFileSync(at(name), "utf8"));

/** The size in pixels that a condition's name says. */
export const sizeOf = (condition) => Number(condition.slice(1));

/**
 * Logos, glyphs and analytic shapes: their outlines in the unit square, and how to get their picture in a condition;
 * those of two shades are drawn here.
 */
export function kept() {
  const { conditions, shapes } = json("outlines.json");
  const read = (shape, condition) => readPng(readFileSync(at(`outlines/${shape.id}_${condition}.png`)));
  const picture = (shape, condition) => (condition.startsWith("b") ? twoShades(shape, sizeOf(condition)) : read(shape, condition));
  return { conditions: [...conditions, "b64", "b256", "b1024"], shapes, picture };
}

/** Icons of strokes with their true centre lines, in pixels. */
export function strokes() {
  const { size, shapes } = json("strokes.json");
  return { conditions: ["thick", "thin"], size, shapes, picture: (shape, condition) => readPng(readFileSync(at(`strokes/${shape.id}_${condition}.png`))) };
}
