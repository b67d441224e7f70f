import type { CurveDocument } from "../../document/document.ts";
import { contourPathD } from "../../kernel/paths/paths.ts";
import { documentBounds } from "../../kernel/curve/samples.ts";
import { svg } from "../controls/dom.ts";

/** A real render of a drawing, as large as its frame: the curve, and its points when there are few. */
export function thumbnail(curve: CurveDocument): SVGSVGElement {
  const box = documentBounds(curve) ?? { minX: 0, minY: 0, maxX: 1, maxY: 1 };
  const [width, height] = [box.maxX - box.minX, box.maxY - box.minY];
  // Thumbnails are 3 : 2; the drawing keeps a margin of a tenth on its longer side.
  const scale = Math.max(width / 3, height / 2) * 1.2;
  const [frameX, frameY] = [3 * scale, 2 * scale];
  const viewBox = [box.minX + width / 2 - frameX / 2, box.minY + height / 2 - frameY / 2, frameX, frameY].map((value) => value.toFixed(2)).join(" ");
  const path = (closed: boolean): string =>
    curve.contours.filter((contour) => contour.closed === closed).map((contour) => contourPathD(curve, contour, { tolerance: scale / 500, decimals: 2 }).d).join("");
  const dot = scale / 24;
  const points = curve.contours.flatMap((contour) => contour.points);
  const marks = points.length > 20 ? [] : points.map(({ x, y }) => svg("circle", { cx: x.toFixed(2), cy: y.toFixed(2), r: dot.toFixed(2) }));
  return svg(
    "svg",
    { class: "thumbnail", viewBox, "aria-hidden": "true" },
    svg("path", { class: "thumbnail-curve", d: path(true) }),
    svg("path", { class: "thumbnail-curve thumbnail-open", d: path(false) }),
    svg("g", { class: "thumbnail-points" }, ...marks),
  );
}
