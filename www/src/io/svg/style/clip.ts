import { inertStyle } from "../inert.ts";
import type { Size } from "../lengths.ts";
import type { Matrix } from "../matrix.ts";
import { pathDataOf } from "../shapes.ts";
import type { Box } from "./box.ts";
import { nothingDeclared, type Declared } from "./declared.ts";

/** Clips and masks are not applied: what they would hide comes along, and that is said. */

/** Whether a clip or a mask of the element may hide something of a picture; `matrix` leads to the picture's units. */
export function mayHide(element: Element, style: Declared, { matrix, around }: { matrix: Matrix; around: Size }, picture: Box | null): boolean {
  return ["clip-path", "mask"].some((property) => {
    const value = style.get(property) ?? element.getAttribute(property) ?? "none";
    if (value === "none" || value === "") return false;
    const id = /^url\(\s*["']?#([^"')]+)["']?\s*\)$/u.exec(value)?.[1];
    const hider = id === undefined ? undefined : element.ownerDocument.getElementById(id);
    // Browsers draw all of what refers to nothing.
    if (hider === null) return false;
    const shown = hider === undefined ? null : shownBy(hider, around);
    return shown === null || picture === null || !covers(shown, matrix, picture);
  });
}

const placing = ["transform", inertStyle, "class", "clip-path", "mask", "clipPathUnits", "maskContentUnits"];
const white = /^(?:#fff|#ffffff|white)$/iu;

/** The box that a clip or a mask leaves, where it is one and no more: editors clip whole drawings to their frames. */
function shownBy(hider: Element, around: Size): Box | null {
  const [only, ...others] = hider.children;
  if (only === undefined || others.length > 0) return null;
  // Of which kind a mask is, is the same for a white one.
  const kind = hider.localName === "mask" && /^\s*mask-type\s*:[^;]*;?\s*$/iu.test(hider.getAttribute(inertStyle) ?? "");
  if (placing.some((name) => only.hasAttribute(name) || (hider.hasAttribute(name) && !(kind && name === inertStyle)))) return null;
  if (hider.localName === "mask" && !white.test(only.getAttribute("fill") ?? "")) return null;
  return boxOf(pathDataOf(only, { css: nothingDeclared, around, warn: () => undefined }) ?? "");
}

const alternating = /^M[\d\s.,+-]+(?:H[\d\s.+-]+V[\d\s.+-]+H[\d\s.+-]+(?:V[\d\s.+-]+)?|V[\d\s.+-]+H[\d\s.+-]+V[\d\s.+-]+(?:H[\d\s.+-]+)?)Z$/u;

/** The rectangle that path data draw from one of its corners. */
function boxOf(d: string): Box | null {
  if (!alternating.test(d)) return null;
  const [start = "", ...sides] = d.slice(1, -1).split(/(?=[HV])/u);
  const [x = NaN, y = NaN] = start.trim().split(/[\s,]+/u).map(Number);
  const along = (letter: string): number[] => sides.filter((side) => side.startsWith(letter)).map((side) => Number(side.slice(1)));
  const [xs, ys] = [[x, ...along("H")], [y, ...along("V")]];
  const isBox = [xs, ys].every((values) => values.every(Number.isFinite) && (values.length === 2 || values[2] === values[0]));
  return isBox ? { left: Math.min(...xs), top: Math.min(...ys), right: Math.max(...xs), bottom: Math.max(...ys) } : null;
}

function covers(box: Box, [a, b, c, d, e, f]: Matrix, picture: Box): boolean {
  if (b !== 0 || c !== 0) return false;
  const [xs, ys] = [[a * box.left + e, a * box.right + e], [d * box.top + f, d * box.bottom + f]];
  // Frames are written with fewer digits than what is in them.
  const slack = 1e-6 * Math.max(picture.right - picture.left, picture.bottom - picture.top);
  return (
    Math.min(...xs) <= picture.left + slack && Math.max(...xs) >= picture.right - slack &&
    Math.min(...ys) <= picture.top + slack && Math.max(...ys) >= picture.bottom - slack
  );
}
