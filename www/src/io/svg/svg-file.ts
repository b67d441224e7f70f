/**
 * Reads an SVG document into path data and transforms. The browser's own parser reads it into a document that is never
 * attached to the page, so nothing in it is fetched, styled or run; only shape elements are looked at.
 */
import { lengthOf, unknownSize, type Measures, type Size, type Warn } from "./lengths.ts";
import { overLimit, svgLimits, type SvgLimits, type SvgWarning } from "./limits.ts";
import { rootOf } from "./markup.ts";
import { identity, multiply, translate, type Matrix } from "./matrix.ts";
import { pathDataOf, shapeNames } from "./shapes.ts";
import { enclosing, type Box } from "./style/box.ts";
import { mayHide } from "./style/clip.ts";
import { painterOf, type Fill, type Painter } from "./style/color.ts";
import type { Declared } from "./style/declared.ts";
import { strokeOf, type Stroke } from "./style/line.ts";
import { initialPaint, paintOf, unknownPaint, type Paint } from "./style/paint.ts";
import { isHidden, isVisible, stylesOf, type Styles } from "./style/styles.ts";
import { ownTransformOf } from "./style/transform.ts";
import { innerViewport, nothingWanted, pictureOf, rootViewport, wantedBy, type Viewport, type Wanted } from "./viewport.ts";

/** One drawn shape: its path data, the transform from its own units to the document's, and how it is painted. */
export interface SvgShape {
  readonly d: string;
  readonly transform: Matrix;
  /** What its area is filled with; null where nothing is. */
  readonly fill: Fill | null;
  /** The line along its outline; null where there is none. */
  readonly stroke: Stroke | null;
}

export interface SvgFile {
  readonly shapes: readonly SvgShape[];
  /** What is seen of the whole drawing, in its own units; null where no size is given. */
  readonly picture: Box | null;
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
  readonly styles: Styles;
  readonly painter: Painter;
  /** What is seen of the whole drawing, in its own units. */
  readonly picture: Box | null;
  readonly boundsOf: BoundsOf;
  readonly alongOf: AlongOf;
  expanded: number;
  commands: number;
}

/** What an element takes from where it stands, or from the `use` that draws it. */
interface Place {
  /** From the units here to the document's. */
  readonly matrix: Matrix;
  /** The viewport around, in the units here. */
  readonly around: Size;
  readonly visible: boolean;
  readonly paint: Paint;
  readonly depth: number;
}

/** The box around what path data draw; null where it is nothing, or not known. */
export type BoundsOf = (d: string) => Box | null;

/** How long the outlines are that path data draw; null where that is not known. */
export type AlongOf = (d: string) => number | null;

/** @throws SvgFileError with `E_PARSE_SVG`, `E_LIMIT` or `E_RANGE`. */
export function readSvg(source: string, boundsOf: BoundsOf = () => null, alongOf: AlongOf = () => null, limits: SvgLimits = svgLimits): SvgFile {
  const { root, isWhole } = rootOf(source, limits);
  const warnings: SvgWarning[] = [];
  const warn: Warn = (code, element) => {
    if (warnings.length < 100) warnings.push({ code, element: element.localName });
  };
  const styles = stylesOf(root, warn);
  const reading: Reading = {
    limits,
    shapes: [],
    warnings,
    warn,
    entered: new Set(),
    styles,
    painter: painterOf(styles, warn),
    picture: pictureOf(root),
    boundsOf,
    alongOf,
    expanded: 0,
    commands: 0,
  };
  walk(root, { matrix: identity, around: unknownSize, visible: true, paint: isWhole ? initialPaint : unknownPaint, depth: 1 }, reading);
  return { shapes: seenOf(reading.shapes), picture: reading.picture, warnings };
}

/**
 * The frame that icons have around them is neither filled nor stroked. Where all are so, a page's style was to paint
 * them.
 */
function seenOf(shapes: readonly SvgShape[]): readonly SvgShape[] {
  const seen = shapes.filter(({ fill, stroke }) => fill !== null || stroke !== null);
  return seen.length === 0 ? shapes : seen;
}

/** `byUse` is the size that a `use` gives to what it draws; null where the element stands itself. */
function walk(element: Element, outer: Place, reading: Reading, byUse: Wanted | null = null): void {
  // Nested elements were counted before parsing; a chain of `use` elements nests further.
  if (outer.depth > 4 * reading.limits.maxDepth) throw overLimit("maxDepth", reading.limits.maxDepth, outer.depth);
  const css = reading.styles(element);
  if (isHidden(element, css)) return;
  const fill = (): Box | null => boxOfShapes(element, css, outer, reading, byUse);
  const { matrix, problem } = ownTransformOf(element, css, { view: outer.around, fill });
  if (problem !== null) reading.warn(problem, element);
  const place = { ...outer, matrix: multiply(outer.matrix, matrix), visible: isVisible(element, css, outer.visible), paint: paintOf(element, css, outer.paint) };
  draw(element, css, place, reading, byUse);
}

/** An element in its own place. */
function draw(element: Element, css: Declared, place: Place, reading: Reading, byUse: Wanted | null): void {
  const kind = element.localName;
  if (!place.visible && (shapeNames.has(kind) || kind === "text" || kind === "image")) return;
  if (mayHide(element, css, place, reading.picture)) reading.warn("W_CLIP", element);
  if (shapeNames.has(kind)) addShape(element, { css, around: place.around, warn: reading.warn }, place, reading);
  else if (kind === "use") expand(element, css, place, reading);
  // A symbol is a group that only a use draws.
  else if (groups.has(kind) || (kind === "symbol" && byUse !== null)) walkChildren(element, place, reading, byUse ?? nothingWanted);
  else if (kind === "text") reading.warn("W_TEXT", element);
  else if (kind === "image") reading.warn("W_PICTURE", element);
}

/** The box around an element's shapes in its own units; they are read once more, which counts against the limits. */
function boxOfShapes(element: Element, css: Declared, outer: Place, reading: Reading, byUse: Wanted | null): Box | null {
  const inner: Reading = { ...reading, shapes: [], warn: () => undefined };
  const { x, y } = element.localName === "use" ? placeOfUse(element, { css, around: outer.around, warn: inner.warn }) : { x: 0, y: 0 };
  // Browsers take the box of what a use draws before it is placed.
  draw(element, css, { ...outer, matrix: translate(-x, -y), visible: true }, inner, byUse);
  reading.expanded = inner.expanded;
  reading.commands = inner.commands;
  const boxes = inner.shapes.map(({ d, transform }) => [reading.boundsOf(d), transform] as const);
  return boxes.reduce<Box | null>((all, [box, transform]) => (box === null ? all : enclosing(all, box, transform)), null);
}

function walkChildren(element: Element, outer: Place, reading: Reading, byUse: Wanted): void {
  const inside = viewportOf(element, outer, reading.warn, byUse);
  if (inside === null) return;
  const place = { ...outer, matrix: multiply(outer.matrix, inside.matrix), around: inside.size, depth: outer.depth + 1 };
  reading.entered.add(element);
  for (const child of element.children) walk(child, place, reading);
  reading.entered.delete(element);
}

function viewportOf(element: Element, { around, depth }: Place, warn: Warn, byUse: Wanted): Viewport | null {
  if (element.localName !== "svg" && element.localName !== "symbol") return { matrix: identity, size: around };
  return depth === 1 ? rootViewport(element, warn) : innerViewport(element, around, byUse, warn);
}

function addShape(element: Element, measures: Measures, { matrix, paint }: Place, reading: Reading): void {
  const d = pathDataOf(element, measures);
  if (d === null) return;
  for (let i = 0; i < d.length; i += 1) {
    const letter = d.charCodeAt(i) | 0x20;
    // Every letter but the e of an exponent is a command.
    if (letter >= 0x61 && letter <= 0x7a && letter !== 0x65) reading.commands += 1;
  }
  const max = reading.limits.maxCommands;
  if (reading.commands > max) throw overLimit("maxCommands", max, reading.commands);
  const { painter, shapes } = reading;
  const along = (): number | null => reading.alongOf(d);
  shapes.push({ d, transform: matrix, fill: painter.fillOf(paint, element), stroke: strokeOf(paint, element, measures, { matrix, along }, painter) });
}

function expand(use: Element, css: Declared, outer: Place, reading: Reading): void {
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
  const { around, depth } = outer;
  const measures = { css, around, warn: reading.warn };
  const { x, y } = placeOfUse(use, measures);
  const matrix = multiply(outer.matrix, translate(x, y));
  const sizes = target.localName === "svg" || target.localName === "symbol";
  walk(target, { ...outer, matrix, depth: depth + 1 }, reading, sizes ? wantedBy(use, around, reading.warn) : nothingWanted);
  reading.entered.delete(use);
}

function placeOfUse(use: Element, measures: Measures): { x: number; y: number } {
  return { x: lengthOf(use, "x", 0, measures) ?? 0, y: lengthOf(use, "y", 0, measures) ?? 0 };
}
