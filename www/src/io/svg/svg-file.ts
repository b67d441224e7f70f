/**
 * Reads an SVG document into path data and transforms. The browser's own parser reads it into a document that is never
 * attached to the page, so nothing in it is fetched, styled or run; only shape elements are looked at.
 */
import { lengthOf, type Warn } from "./lengths.ts";
import { overLimit, svgLimits, type SvgLimits, type SvgWarning } from "./limits.ts";
import { rootOf } from "./markup.ts";
import { identity, multiply, numbersOf, scale, translate, type Matrix } from "./matrix.ts";
import { pathDataOf, shapeNames } from "./shapes.ts";
import { mayHide, type Box } from "./style/clip.ts";
import { hiddenBySheets, isHidden } from "./style/hidden.ts";
import { ownTransformOf } from "./style/transform.ts";

/** One drawn shape: its path data, and the transform from its own units to the document's. */
export interface SvgShape {
  readonly d: string;
  readonly transform: Matrix;
}

export interface SvgFile {
  readonly shapes: readonly SvgShape[];
  readonly warnings: readonly SvgWarning[];
}

/** Elements whose shapes are drawn where they stand; every other element's children are not part of the picture. */
const groups: ReadonlySet<string> = new Set(["svg", "g", "a", "switch"]);

interface Reading {
  readonly limits: SvgLimits;
  readonly shapes: SvgShape[];
  readonly warnings: SvgWarning[];
  readonly warn: Warn;
  /** The groups that are being walked, by nesting or by `use`: a `use` of one of them is a cycle. */
  readonly entered: Set<Element>;
  readonly hidden: ReadonlySet<Element>;
  /** What is seen of the whole drawing, in its own units. */
  readonly picture: Box | null;
  expanded: number;
  commands: number;
}

/** @throws SvgFileError with `E_PARSE_SVG`, `E_LIMIT` or `E_RANGE`. */
export function readSvg(source: string, limits: SvgLimits = svgLimits): SvgFile {
  const root = rootOf(source, limits);
  const warnings: SvgWarning[] = [];
  const reading: Reading = {
    limits,
    shapes: [],
    warnings,
    warn: (code, element) => {
      if (warnings.length < 100) warnings.push({ code, element: element.localName });
    },
    entered: new Set(),
    hidden: hiddenBySheets(root),
    picture: pictureOf(root),
    expanded: 0,
    commands: 0,
  };
  walk(root, identity, 1, reading);
  return { shapes: reading.shapes, warnings };
}

function walk(element: Element, outer: Matrix, depth: number, reading: Reading): void {
  // Nested elements were counted before parsing; a chain of `use` elements nests further.
  if (depth > 4 * reading.limits.maxDepth) throw overLimit("maxDepth", reading.limits.maxDepth, depth);
  if (isHidden(element, reading.hidden)) return;
  const matrix = multiply(outer, ownTransform(element, reading.warn));
  if (mayHide(element, matrix, reading.picture)) reading.warn("W_CLIP", element);
  if (shapeNames.has(element.localName)) addShape(element, matrix, reading);
  else if (element.localName === "use") expand(element, matrix, depth, reading);
  else if (groups.has(element.localName)) walkChildren(element, matrix, depth, reading);
  else if (element.localName === "text") reading.warn("W_TEXT", element);
}

function walkChildren(element: Element, outer: Matrix, depth: number, reading: Reading): void {
  const matrix = element.localName === "svg" ? multiply(outer, viewport(element, depth === 1, reading.warn)) : outer;
  reading.entered.add(element);
  for (const child of element.children) walk(child, matrix, depth + 1, reading);
  reading.entered.delete(element);
}

function ownTransform(element: Element, warn: Warn): Matrix {
  const { matrix, problem } = ownTransformOf(element);
  if (problem !== null) warn(problem, element);
  return matrix;
}

function addShape(element: Element, transform: Matrix, reading: Reading): void {
  const d = pathDataOf(element, reading.warn);
  if (d === null) return;
  for (let i = 0; i < d.length; i += 1) {
    const letter = d.charCodeAt(i) | 0x20;
    // Every letter but the e of an exponent is a command.
    if (letter >= 0x61 && letter <= 0x7a && letter !== 0x65) reading.commands += 1;
  }
  const max = reading.limits.maxCommands;
  if (reading.commands > max) throw overLimit("maxCommands", max, reading.commands);
  reading.shapes.push({ d, transform });
}

function expand(use: Element, outer: Matrix, depth: number, reading: Reading): void {
  const href = use.getAttribute("href") ?? use.getAttributeNS("http://www.w3.org/1999/xlink", "href") ?? "";
  // Only what stands in the same file: an outside reference is never followed.
  const target = href.startsWith("#") ? use.ownerDocument.getElementById(href.slice(1)) : null;
  if (target === null) {
    reading.warn("W_NO_TARGET", use);
    return;
  }
  reading.entered.add(use);
  if (reading.entered.has(target)) {
    reading.warn("W_CYCLE", use);
    reading.entered.delete(use);
    return;
  }
  reading.expanded += 1;
  const max = reading.limits.maxUseExpansion;
  if (reading.expanded > max) throw overLimit("maxUseExpansion", max, reading.expanded);
  const x = lengthOf(use, "x", 0, reading.warn) ?? 0;
  const y = lengthOf(use, "y", 0, reading.warn) ?? 0;
  const matrix = multiply(outer, translate(x, y));
  // A symbol is a group that only a use draws.
  if (target.localName === "symbol") walkChildren(target, matrix, depth + 1, reading);
  else walk(target, matrix, depth + 1, reading);
  reading.entered.delete(use);
}

/** From the units inside an `svg` element to those around it: its place, size and viewBox. */
function viewport(element: Element, isRoot: boolean, warn: Warn): Matrix {
  const width = lengthOf(element, "width", null, warn);
  const height = lengthOf(element, "height", null, warn);
  const text = element.getAttribute("viewBox");
  const [left = 0, top = 0, boxWidth = 0, boxHeight = 0] = numbersOf(text ?? "") ?? [];
  // The whole picture's corner stays where its own coordinates say: what was exported from here comes back in place.
  const place = isRoot ? translate(left, top) : translate(lengthOf(element, "x", 0, warn) ?? 0, lengthOf(element, "y", 0, warn) ?? 0);
  if (text === null) return place;
  if (!(boxWidth > 0 && boxHeight > 0)) {
    warn("W_BAD_VIEWBOX", element);
    return isRoot ? identity : place;
  }
  // A size that is not given follows from the other by the box's proportions, or is the box's own.
  const toWidth = width ?? (height === null ? boxWidth : (height * boxWidth) / boxHeight);
  const toHeight = height ?? (width === null ? boxHeight : (width * boxHeight) / boxWidth);
  if (!(toWidth > 0 && toHeight > 0)) return isRoot ? identity : place;
  const fitted = fit(element.getAttribute("preserveAspectRatio") ?? "", toWidth, toHeight, boxWidth, boxHeight);
  return multiply(multiply(place, fitted), translate(-left, -top));
}

/** The box of the whole picture; none where its size is not its own. */
function pictureOf(root: Element): Box | null {
  const silent: Warn = () => undefined;
  const [left, top, boxWidth, boxHeight] = numbersOf(root.getAttribute("viewBox") ?? "") ?? [];
  const [width, height] = [lengthOf(root, "width", null, silent), lengthOf(root, "height", null, silent)];
  if (left === undefined || top === undefined || boxWidth === undefined || boxHeight === undefined) {
    return width === null || height === null ? null : { left: 0, top: 0, right: width, bottom: height };
  }
  const [a, , , d, e, f] = viewport(root, true, silent);
  return { left: a * left + e, top: d * top + f, right: a * (left + boxWidth) + e, bottom: d * (top + boxHeight) + f };
}

function fit(rule: string, width: number, height: number, boxWidth: number, boxHeight: number): Matrix {
  const stretch: readonly [number, number] = [width / boxWidth, height / boxHeight];
  if (/\bnone\b/u.test(rule)) return scale(...stretch);
  const factor = /\bslice\b/u.test(rule) ? Math.max(...stretch) : Math.min(...stretch);
  const share = (part: string): number => (part === "Min" ? 0 : part === "Max" ? 1 : 0.5);
  const align = /x(Min|Mid|Max)Y(Min|Mid|Max)/u.exec(rule);
  const dx = (width - boxWidth * factor) * share(align?.[1] ?? "Mid");
  const dy = (height - boxHeight * factor) * share(align?.[2] ?? "Mid");
  return multiply(translate(dx, dy), scale(factor, factor));
}
