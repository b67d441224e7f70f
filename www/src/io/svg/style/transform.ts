import { identity, multiply, parseTransform, translate, type Matrix } from "../matrix.ts";
import type { Declared } from "./styles.ts";

/** What CSS says of where an element is. The browser reads the values; percentages and 3D are not applied. */

/** A list of transform functions as CSS writes them; null when it needs a box or a third dimension. */
function listed(functions: string): Matrix | null {
  try {
    const { a, b, c, d, e, f, is2D } = new DOMMatrix(functions);
    // Sines and cosines of right angles are whole.
    const whole = (value: number): number => (Math.abs(value) < 1e-15 ? 0 : value);
    return is2D ? [whole(a), whole(b), whole(c), whole(d), whole(e), whole(f)] : null;
  } catch {
    return null;
  }
}

/** A property of its own, such as `rotate: 45deg`, as the function of its name. */
function alone(name: string, value: string | undefined): Matrix | null {
  return value === undefined || value === "none" ? identity : listed(`${name}(${value.split(/\s+/u).join(",")})`);
}

const place = /^([+-]?[\d.]+(?:e[+-]?\d+)?)(?:px)?\s+([+-]?[\d.]+(?:e[+-]?\d+)?)(?:px)?$/iu;

/** The matrix about the place that stays; null when that depends on a box. */
function about(origin: string | null | undefined, box: string, matrix: Matrix): Matrix | null {
  const [a, b, c, d] = matrix;
  if (a === 1 && b === 0 && c === 0 && d === 1) return matrix;
  if (box !== "view-box") return null;
  if (origin == null) return matrix;
  const [, x = "", y = ""] = place.exec(origin.trim()) ?? [];
  if (x === "" || y === "") return null;
  return multiply(multiply(translate(Number(x), Number(y)), matrix), translate(-Number(x), -Number(y)));
}

export interface OwnTransform {
  readonly matrix: Matrix;
  readonly problem: "W_BAD_TRANSFORM" | "W_STYLE_TRANSFORM" | null;
}

/** An element's own transform: what CSS says comes before its attribute. What cannot be applied is left out. */
export function ownTransformOf(element: Element, style: Declared): OwnTransform {
  const attribute = element.getAttribute("transform");
  const css = style.get("transform");
  const list = css === undefined ? parseTransform(attribute ?? "") : css === "none" ? identity : listed(css);
  const parts = [...["translate", "rotate", "scale"].map((name) => alone(name, style.get(name))), list];
  const matrix = parts.some((part) => part === null) ? null : parts.reduce<Matrix>((all, part) => (part === null ? all : multiply(all, part)), identity);
  const whole = matrix === null ? null : about(style.get("transform-origin") ?? element.getAttribute("transform-origin"), style.get("transform-box") ?? "view-box", matrix);
  if (whole !== null) return { matrix: whole, problem: null };
  const byAttribute = css === undefined && list === null;
  return { matrix: css === undefined ? (list ?? identity) : identity, problem: byAttribute ? "W_BAD_TRANSFORM" : "W_STYLE_TRANSFORM" };
}
