import { svg } from "./dom.ts";

/** 16 × 16 line drawings, 1.5 wide, on the half-pixel grid. */
const drawings = {
  brand: "M1.5 11.5C3 5 13 5 14.5 11.5M2 4.5h12",
  select: "M3.5 2.5l8.5 5.2-3.9.9-1.9 3.6z",
  pen: "M8 2l3.6 5.6L8 14 4.4 7.6zM8 2v5.6M8 8.6v-1M5.5 14h5",
  draw: "M2 11.5c1.6-4.6 3-7 4.4-6.6 2 .6-1.6 6.2.4 6.8 1.6.4 2.2-3 3.6-2.7 1 .2.6 1.9 1.9 1.9.7 0 1.2-.3 1.7-.8",
  ellipse: "M8 3.5c8 0 8 9 0 9s-8-9 0-9",
  rectangle: "M2.5 4h11v8h-11z",
  hand: "M5.2 8.5V4.2a1 1 0 0 1 2 0V3a1 1 0 0 1 2 0v1.2a1 1 0 0 1 2 0v1.6a1 1 0 0 1 2 0v4c0 2.4-1.6 4-4 4-2 0-3-.8-4-2.4l-2-3.2c-.5-1 .7-1.8 1.4-1zM7.2 4.2v3.3M9.2 4.2v3.3M11.2 5.8v1.7",
  undo: "M6 3L3 6l3 3M3 6h6.5a3.5 3.5 0 0 1 0 7H6.5",
  redo: "M10 3l3 3-3 3M13 6H6.5a3.5 3.5 0 0 0 0 7h3",
  menu: "M2.6 8a.4.4 0 1 1 .8 0 .4.4 0 0 1-.8 0M7.6 8a.4.4 0 1 1 .8 0 .4.4 0 0 1-.8 0M12.6 8a.4.4 0 1 1 .8 0 .4.4 0 0 1-.8 0",
  panel: "M2.5 3.5h11v9h-11zM9.5 3.5v9",
  close: "M4 4l8 8M12 4l-8 8",
  chevron: "M6 4l4 4-4 4",
  down: "M4 6l4 4 4-4",
  up: "M4 10l4-4 4 4",
  left: "M10 4L6 8l4 4",
  right: "M6 4l4 4-4 4",
  plus: "M8 3.5v9M3.5 8h9",
  minus: "M3.5 8h9",
  copy: "M6 6h7v7.5H6zM10 6V2.5H3V10h3",
  help: "M5.8 6.2a2.2 2.2 0 1 1 3.2 2c-.7.4-1 .8-1 1.6M8 12.5v.01",
  theme: "M8 2.5a5.5 5.5 0 1 0 0 11zM8 2.5a5.5 5.5 0 0 1 0 11",
  sun: "M8 5.2a2.8 2.8 0 1 1 0 5.6 2.8 2.8 0 0 1 0-5.6zM8 1.5v1M8 13.5v1M1.5 8h1M13.5 8h1M3.4 3.4l.7.7M11.9 11.9l.7.7M12.6 3.4l-.7.7M4.1 11.9l-.7.7",
  moon: "M13 9.6A5.5 5.5 0 0 1 6.4 3a5.5 5.5 0 1 0 6.6 6.6z",
  warn: "M8 2.5l6 10.5H2zM8 6.5v3M8 11.2v.01",
} as const;

export type IconName = keyof typeof drawings;

export function icon(name: IconName): SVGSVGElement {
  return svg("svg", { class: "icon", viewBox: "0 0 16 16", "aria-hidden": "true" }, svg("path", { d: drawings[name] }));
}

/** The markers of the stage as legend glyphs: shape as well as colour tells the kind. */
const glyphs = {
  point: "M8 3.5a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9z",
  cusp: "M8 2.5L13.5 8 8 13.5 2.5 8z",
  linear: "M3.5 3.5h9v9h-9z",
  cubic: "M8 4a4 4 0 1 1 0 8 4 4 0 0 1 0-8z",
  coincident: "M2 2h12v12H2zM8 5.5a2.5 2.5 0 1 0 0 5 2.5 2.5 0 0 0 0-5z",
  handle: "M8 4a4 4 0 1 1 0 8 4 4 0 0 1 0-8z",
  vertex: "M8 2.5L13.5 8 8 13.5 2.5 8z",
} as const;

export type GlyphName = keyof typeof glyphs;

export function glyph(name: GlyphName): SVGSVGElement {
  return svg("svg", { class: `glyph glyph-${name}`, viewBox: "0 0 16 16", "aria-hidden": "true" }, svg("path", { d: glyphs[name] }));
}
