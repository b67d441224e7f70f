import type { Box } from "../../artboard.ts";
import type { Contour, ControlPoint, CurveDocument, Offset } from "../../document.ts";

/** Contours that fill a box: which way round they run, and where they begin, does not depend on how it was drawn. */

/**
 * The ellipse that touches the sides of a box: exact, from four points in the middle of the sides. Two would do, but a
 * point of four is where the sides of the box are, and moving it leaves the opposite half as it was.
 */
export function ellipseIn({ space, omega }: Pick<CurveDocument, "space" | "omega">, { minX, minY, maxX, maxY }: Box): Contour {
  const [x, y] = [(minX + maxX) / 2, (minY + maxY) / 2];
  const [dx, dy] = [((maxX - minX) * Math.PI) / 12, ((maxY - minY) * Math.PI) / 12];
  const points = [smooth(maxX, y, 0, dy), smooth(x, maxY, -dx, 0), smooth(minX, y, 0, -dy), smooth(x, minY, dx, 0)];
  // Where a closed contour of four has these already, they stay those of the drawing, as a sample's are.
  const own = space === "trigonometric" && omega === "auto" ? {} : { omega: points.map(() => Math.PI / 2) };
  return { family: "hermite", closed: true, points, support: 1, ...own, ...(space === "trigonometric" ? {} : { space: "trigonometric" }) };
}

function smooth(x: number, y: number, dx: number, dy: number): ControlPoint {
  return { x, y, kind: "symmetric", in: { dx: 0 - dx, dy: 0 - dy }, out: { dx, dy } };
}

/** Four lines, as a file's `H` and `V` are. */
export function rectangleIn({ minX, minY, maxX, maxY }: Box): Contour {
  const [dx, dy] = [(maxX - minX) / 3, (maxY - minY) / 3];
  const right = { dx, dy: 0 };
  const left = { dx: -dx, dy: 0 };
  const down = { dx: 0, dy };
  const up = { dx: 0, dy: -dy };
  const points = [corner(minX, minY, down, right), corner(maxX, minY, left, down), corner(maxX, maxY, up, left), corner(minX, maxY, right, up)];
  return { family: "hermite", closed: true, points, support: 1, omega: [0, 0, 0, 0] };
}

function corner(x: number, y: number, arriving: Offset, leaving: Offset): ControlPoint {
  return { x, y, kind: "cusp", in: arriving, out: leaving };
}
