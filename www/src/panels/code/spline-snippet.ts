import { baseCount, type Contour, type CurveDocument } from "../../document/document.ts";
import { rootsOf } from "../../document/curve/roots.ts";
import { number, pairs } from "./literals.ts";

/** Contours without tangents in a program: through their points, refined, or refined in places. */

export function splineKind({ grid, places }: Contour): "InterpolatingCurve" | "BSplineCurve" | "LocalCurve" {
  if (places !== undefined) return "LocalCurve";
  return grid === undefined ? "InterpolatingCurve" : "BSplineCurve";
}

export function splineConstruction(curve: CurveDocument, contour: Contour): string {
  const { closed, grid, places } = contour;
  const lines = [
    `points: ${pairs(contour.points.slice(0, baseCount(contour)).map(({ x, y }) => [x, y] as const))},`,
    closed ? "" : "closed: false,",
    rootsOption(curve, contour),
    grid === undefined || places !== undefined ? "" : `step: ${number(grid.step)}, offset: ${number(grid.offset)},`,
    places === undefined ? "" : `patches: [\n${patches(contour).map((patch) => `    ${patch},`).join("\n")}\n  ],`,
  ];
  return `new ${splineKind(contour)}({\n${lines.filter((line) => line !== "").map((line) => `  ${line}`).join("\n")}\n})`;
}

/** Left out where the library would choose the same: those that keep an ellipse of so many points. */
function rootsOption(curve: CurveDocument, contour: Contour): string {
  const roots = rootsOf(curve, contour);
  const round = (2 * Math.PI) / contour.points.length;
  const ordinary = contour.closed && contour.grid === undefined && contour.places === undefined && roots.length === 3
    && roots.every(({ re, im }) => re === 0 && (im === 0 || Math.abs(Math.abs(im) - round) <= 1e-12 * round)) && roots.some(({ im }) => im !== 0);
  if (ordinary) return "";
  return `roots: [${roots.map(({ re, im }) => (im === 0 ? number(re) : `{ re: ${number(re)}, im: ${number(im)} }`)).join(", ")}],`;
}

function patches(contour: Contour): string[] {
  let from = baseCount(contour);
  return (contour.places ?? []).map(({ level, first, count }) => {
    const moved = contour.points.slice(from, from + count).flatMap(({ moved }) => [moved?.dx ?? 0, moved?.dy ?? 0]);
    from += count;
    return `{ level: ${level}, first: ${first}, displacements: [${moved.map(number).join(", ")}] }`;
  });
}
