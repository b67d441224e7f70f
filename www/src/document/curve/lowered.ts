import { lengthOf, segmentCount, type Contour } from "../document.ts";
import { kindOf, scaled } from "./offset.ts";

/**
 * Takes away the points that refining made above `level`; each handle grows with its segment. The shape stays if none
 * of them was edited.
 */
export function loweredContour(contour: Contour, level: number): Contour {
  const kept = contour.points.map((point, index) => ({ point, index })).filter(({ point }) => (point.level ?? 0) <= level);
  if (kept.length === contour.points.length || kept.length < 2) return contour;
  const segments = segmentCount(contour);
  const spans = kept.map(({ index }, k) => {
    const next = kept[k + 1]?.index ?? (contour.closed ? (kept[0]?.index ?? 0) + contour.points.length : index);
    let length = 0;
    let angle = 0;
    for (let s = index; s < next; s += 1) {
      length += lengthOf(contour, s % segments);
      angle += (contour.omega?.[s % segments] ?? 0) * lengthOf(contour, s % segments);
    }
    return { length, omega: length === 0 ? 0 : angle / length, first: lengthOf(contour, index % segments), last: lengthOf(contour, (next + segments - 1) % segments) };
  });
  const points = kept.map(({ point }, k) => {
    const leaving = spans[k];
    const arriving = spans[(k + spans.length - 1) % spans.length];
    const growth = {
      out: leaving === undefined || leaving.length === 0 ? null : leaving.length / leaving.first,
      in: arriving === undefined || arriving.length === 0 ? null : arriving.length / arriving.last,
    };
    // The free side of an open end grows with the side that has a segment.
    const out = scaled(point.out, growth.out ?? growth.in ?? 1);
    const into = scaled(point.in, growth.in ?? growth.out ?? 1);
    const lowered = { ...point, in: into, out };
    return { ...lowered, kind: point.kind === "cusp" ? point.kind : kindOf(lowered) };
  });
  const used = contour.closed ? spans : spans.slice(0, -1);
  const { omega, lengths: _lengths, ...rest } = contour;
  return {
    ...rest,
    points,
    ...(omega === undefined ? {} : { omega: used.map((span) => span.omega) }),
    ...(used.every((span) => span.length === 1) ? {} : { lengths: used.map((span) => span.length) }),
  };
}
