import type { Warn } from "../lengths.ts";
import type { Declared } from "./declared.ts";
import { isPaint, opacityOf, type Paint } from "./paint.ts";

/** The flat colours that areas are filled and lines are drawn with, as the browser reads them. */

/** What an area is filled with. */
export interface Fill {
  /** As the file names it: areas of one name are of one ink, whatever colour that is. */
  readonly paint: string;
  /** `#rrggbb`, or `#rrggbbaa` where something shows through; null where only a page could tell. */
  readonly color: string | null;
  readonly rule: CanvasFillRule;
}

/** Red, green and blue up to 255, and how opaque. */
type Rgba = readonly [number, number, number, number];

export interface Painter {
  /** What is nothing to be seen is null. */
  fillOf(paint: Paint, element: Element): Fill | null;
  /** What is nothing to be seen is null; else its colour, which is null where only a page could tell. */
  strokeOf(paint: Paint, element: Element): { readonly color: string | null } | null;
}

/** Reads the fills and strokes of one document. */
export function painterOf(styles: (element: Element) => Declared, warn: Warn): Painter {
  const read = reader();
  const gradients = new Map<string, Rgba | null>();
  const gradient = (id: string, { ownerDocument }: Element): Rgba | null => {
    let mean = gradients.get(id);
    if (mean === undefined) gradients.set(id, (mean = meanOf(stopsOf(ownerDocument.getElementById(id), styles, read))));
    return mean;
  };
  const rgbaOf = (own: string, { color }: Paint, element: Element): Rgba | null => {
    const text = /^currentcolor$/iu.test(own) ? color : own;
    const [, id, instead = ""] = /^url\(\s*["']?#([^"')]+)["']?\s*\)\s*(.*)$/isu.exec(text) ?? [];
    if (id === undefined) return read(text);
    const mean = gradient(id, element);
    if (mean !== null) warn("W_GRADIENT", element);
    return mean ?? read(instead);
  };
  const seen = (part: "fill" | "stroke", paint: Paint, element: Element): { readonly color: string | null } | null => {
    const around = paint.opacity * opacityOf(paint[`${part}-opacity`]);
    if (!isPaint(paint[part]) || around === 0) return null;
    const found = rgbaOf(paint[part], paint, element);
    if (found !== null && found[3] === 0) return null;
    return { color: found === null ? null : hexOf(found, around) };
  };
  return {
    fillOf(paint, element) {
      const fill = seen("fill", paint, element);
      return fill === null ? null : { paint: fill.color ?? paint.fill, ...fill, rule: paint["fill-rule"] === "evenodd" ? "evenodd" : "nonzero" };
    },
    strokeOf: (paint, element) => seen("stroke", paint, element),
  };
}

/** Reads a colour as browsers do; null where it is none. */
function reader(): (text: string) => Rgba | null {
  const context = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d", { willReadFrequently: true });
  const known = new Map<string, Rgba | null>();
  const taken = (text: string, over: string): string => {
    if (context === null) return "";
    context.fillStyle = over;
    context.fillStyle = text;
    return String(context.fillStyle);
  };
  return (text) => {
    let found = known.get(text);
    if (found === undefined) {
      const normal = taken(text, "#000001");
      // What is no colour leaves the one before, whichever that is.
      const isColor = context !== null && normal === taken(text, "#000002");
      known.set(text, (found = isColor ? (numbersOf(normal) ?? drawnIn(context)) : null));
    }
    return found;
  };
}

/** Of a colour in another space than that of screens, which a canvas hands back as it is written: what comes of it. */
function drawnIn(context: CanvasRenderingContext2D): Rgba {
  context.clearRect(0, 0, 1, 1);
  context.fillRect(0, 0, 1, 1);
  const [red = 0, green = 0, blue = 0, opacity = 0] = context.getImageData(0, 0, 1, 1).data;
  return [red, green, blue, opacity / 255];
}

/** Of `#rrggbb`, or `rgba(…)` of numbers, as which a canvas hands colours back. */
function numbersOf(normal: string): Rgba | null {
  if (normal.startsWith("#")) return [...channelsOf(normal), 1];
  const [red, green, blue, opacity] = /^rgba\(([^)]*)\)$/u.exec(normal)?.[1]?.split(",").map(Number) ?? [];
  return red === undefined || green === undefined || blue === undefined || opacity === undefined ? null : [red, green, blue, opacity];
}

function channelsOf(hex: string): [number, number, number] {
  const channel = (at: number): number => Number.parseInt(hex.slice(at, at + 2), 16);
  return [channel(1), channel(3), channel(5)];
}

function hexOf([red, green, blue, own]: Rgba, around: number): string {
  const two = (value: number): string => Math.round(value).toString(16).padStart(2, "0");
  const opacity = two(255 * own * around);
  return `#${two(red)}${two(green)}${two(blue)}${opacity === "ff" ? "" : opacity}`;
}

interface Stop {
  readonly at: number;
  readonly color: Rgba;
}

const longestChain = 16;

/** A gradient's stops: its own, or those of the one that it refers to. */
function stopsOf(element: Element | null, styles: (element: Element) => Declared, read: (text: string) => Rgba | null): readonly Stop[] {
  let from = element;
  for (let i = 0; i < longestChain && from !== null && /^(?:linear|radial)Gradient$/u.test(from.localName); i += 1) {
    const stops = [...from.children].filter(({ localName }) => localName === "stop");
    if (stops.length > 0) return stops.map((stop) => stopOf(stop, styles(stop), read));
    const href = from.getAttribute("href") ?? from.getAttributeNS("http://www.w3.org/1999/xlink", "href") ?? "";
    from = href.startsWith("#") ? from.ownerDocument.getElementById(href.slice(1)) : null;
  }
  return [];
}

function stopOf(stop: Element, css: Declared, read: (text: string) => Rgba | null): Stop {
  const own = (name: string): string => css.get(name) ?? stop.getAttribute(name) ?? "";
  const [red, green, blue, opacity] = read(own("stop-color").trim()) ?? [0, 0, 0, 1];
  const offset = stop.getAttribute("offset") ?? "0";
  return { at: opacityOf(offset === "" ? "0" : offset), color: [red, green, blue, opacity * opacityOf(own("stop-opacity"))] };
}

/** The mean along a gradient, from its first end to its last; null without stops. */
function meanOf(stops: readonly Stop[]): Rgba | null {
  const last = stops.at(-1);
  if (last === undefined) return null;
  const sum: [number, number, number, number] = [0, 0, 0, 0];
  let [from, at] = [stops[0] ?? last, 0];
  for (const stop of [...stops, { ...last, at: 1 }]) {
    const to = Math.max(at, stop.at);
    addBetween(sum, from.color, stop.color, to - at);
    [from, at] = [stop, to];
  }
  const [red, green, blue, opacity] = sum;
  return opacity === 0 ? [0, 0, 0, 0] : [red / opacity, green / opacity, blue / opacity, opacity];
}

/**
 * Colour and opacity both change evenly from one to the other, and a colour counts as much as it is seen: the integral
 * of the product.
 */
function addBetween(sum: [number, number, number, number], [r0, g0, b0, a0]: Rgba, [r1, g1, b1, a1]: Rgba, width: number): void {
  const seen = (from: number, to: number): number => (width * (from * (2 * a0 + a1) + to * (a0 + 2 * a1))) / 6;
  sum[0] += seen(r0, r1);
  sum[1] += seen(g0, g1);
  sum[2] += seen(b0, b1);
  sum[3] += (width * (a0 + a1)) / 2;
}
