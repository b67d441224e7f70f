import type { Size } from "../lengths.ts";
import { identity, multiply, parseTransform, translate, type Matrix } from "../matrix.ts";
import type { Box } from "./box.ts";
import type { Declared } from "./declared.ts";

/** What CSS says of where an element is. The browser reads the values; what moves it in space is not applied. */

const percentages = /[a-z\d]*\(|[),]|[-+]?[\d.]+(?:e[-+]?\d+)?%/giu;

/** A list of functions with the percentages of its steps as lengths: of the width, and of the height. */
function inLengths(functions: string, { width, height }: Size): string {
  let [depth, isAcross] = [0, true];
  return functions.replace(percentages, (part) => {
    if (part.endsWith("%")) return `${(Number(part.slice(0, -1)) * (isAcross ? width : height)) / 100}px`;
    if (part.endsWith("(")) {
      depth += 1;
      if (depth === 1) isAcross = !/^translateY/iu.test(part);
    } else if (part === ")") depth -= 1;
    else if (depth === 1) isAcross = !isAcross;
    return part;
  });
}

/**
 * A list of transform functions as CSS writes them; null when it needs a box that is not known or a third dimension.
 */
function listed(functions: string, size: () => Size): Matrix | null {
  try {
    const { a, b, c, d, e, f, m13, m14, m23, m24, m31, m32, m33, m34, m43, m44 } = new DOMMatrix(functions.includes("%") ? inLengths(functions, size()) : functions);
    const isFlat = m33 === 1 && m44 === 1 && [m13, m14, m23, m24, m31, m32, m34, m43].every((entry) => entry === 0);
    // Sines and cosines of right angles are whole.
    const whole = (value: number): number => (Math.abs(value) < 1e-15 ? 0 : value);
    return isFlat ? [whole(a), whole(b), whole(c), whole(d), whole(e), whole(f)] : null;
  } catch {
    return null;
  }
}

/** A property of its own, such as `rotate: 45deg`, as the function of its name. */
function alone(name: string, value: string | undefined, size: () => Size): Matrix | null {
  return value === undefined || value === "none" ? identity : listed(`${name}(${value.split(/\s+(?![^(]*\))/u).join(",")})`, size);
}

const distance = /^([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)(px|%)?$/iu;
const shares: ReadonlyMap<string, number> = new Map([["left", 0], ["top", 0], ["center", 0.5], ["right", 1], ["bottom", 1]]);

/** A place in a box by words, lengths or percentages of its sides; null where it is none. */
function placeIn(text: string, { left, top, right, bottom }: Box): readonly [x: number, y: number] | null {
  const words = text.trim().toLowerCase().split(/\s+/u);
  const [first = "", second = "center", depth = "0"] = words;
  const isTurned = /^(?:top|bottom)$/u.test(first) || /^(?:left|right)$/u.test(second);
  const along = (word: string, from: number, size: number): number => {
    const share = shares.get(word);
    const [, value = "NaN", unit] = distance.exec(word) ?? [];
    return from + (share !== undefined ? share * size : unit === "%" ? (Number(value) * size) / 100 : Number(value));
  };
  const x = along(isTurned ? second : first, left, right - left);
  const y = along(isTurned ? first : second, top, bottom - top);
  return Number.isFinite(x) && Number.isFinite(y) && /^0(?:px)?$/u.test(depth) ? [x, y] : null;
}

/** The matrix about the place that stays; null when that depends on a box that is not known. */
function about(origin: string, box: () => Box | null, matrix: Matrix): Matrix | null {
  const [a, b, c, d] = matrix;
  if (a === 1 && b === 0 && c === 0 && d === 1) return matrix;
  const known = box();
  const place = known === null ? null : placeIn(origin, known);
  return place === null ? null : multiply(multiply(translate(...place), matrix), translate(-place[0], -place[1]));
}

/** What percentages and words of an element's transform refer to, in its own units. */
export interface Boxes {
  /** The viewport around. */
  readonly view: Size;
  /** Around the element's shapes, without their lines; null where that is not known. */
  readonly fill: () => Box | null;
}

function boxNamed(name: string, { view, fill }: Boxes): Box | null {
  if (name === "view-box") return { left: 0, top: 0, right: view.width, bottom: view.height };
  return name === "fill-box" || name === "content-box" ? fill() : null;
}

export interface OwnTransform {
  readonly matrix: Matrix;
  readonly problem: "W_BAD_TRANSFORM" | "W_STYLE_TRANSFORM" | null;
}

/** An element's own transform: what CSS says comes before its attribute. What cannot be applied is left out. */
export function ownTransformOf(element: Element, style: Declared, boxes: Boxes): OwnTransform {
  const attribute = element.getAttribute("transform");
  const css = style.get("transform");
  let known: Box | null | undefined;
  const box = (): Box | null => (known === undefined ? (known = boxNamed(style.get("transform-box") ?? "view-box", boxes)) : known);
  const size = (): Size => {
    const { left, top, right, bottom } = box() ?? { left: NaN, top: NaN, right: NaN, bottom: NaN };
    return { width: right - left, height: bottom - top };
  };
  const list = css === undefined ? parseTransform(attribute ?? "") : css === "none" ? identity : listed(css, size);
  const parts = [...["translate", "rotate", "scale"].map((name) => alone(name, style.get(name), size)), list];
  const matrix = parts.some((part) => part === null) ? null : parts.reduce<Matrix>((all, part) => (part === null ? all : multiply(all, part)), identity);
  const whole = matrix === null ? null : about(style.get("transform-origin") ?? element.getAttribute("transform-origin") ?? "0 0", box, matrix);
  if (whole !== null) return { matrix: whole, problem: null };
  const byAttribute = css === undefined && list === null;
  return { matrix: css === undefined ? (list ?? identity) : identity, problem: byAttribute ? "W_BAD_TRANSFORM" : "W_STYLE_TRANSFORM" };
}
