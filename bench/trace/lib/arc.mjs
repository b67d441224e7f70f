// Elliptical arcs of path data as cubics so short that nothing measured here can tell them from the arc.

/** The most an arc turns in one cubic: off by 7e-8 of its radius. */
const PIECE = Math.PI / 8;

/** The cubics [x0, y0, …] of an arc; a line where a radius is 0. */
export function arcPieces(x, y, [rx, ry, rotation, large, sweep, toX, toY]) {
  let [a, b] = [Math.abs(rx), Math.abs(ry)];
  if (a === 0 || b === 0) return [[x, y, toX, toY]];
  const angle = (rotation * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  // Half the chord in the ellipse's own directions.
  const [hx, hy] = [(cos * (x - toX) + sin * (y - toY)) / 2, (cos * (y - toY) - sin * (x - toX)) / 2];
  const stretch = Math.hypot(hx / a, hy / b);
  if (stretch === 0) return [];
  if (stretch > 1) [a, b] = [a * stretch, b * stretch];
  const far = Math.sqrt(Math.max(0, 1 / Math.min(1, stretch) ** 2 - 1)) * (large === sweep ? -1 : 1);
  // On the unit circle: half the chord, and the centre beside it.
  const [ux, uy] = [hx / a, hy / b];
  const [cx, cy] = [far * uy, -far * ux];
  const start = Math.atan2(uy - cy, ux - cx);
  let turn = Math.atan2(-uy - cy, -ux - cx) - start;
  if (sweep && turn < 0) turn += 2 * Math.PI;
  if (!sweep && turn > 0) turn -= 2 * Math.PI;
  const count = Math.max(1, Math.ceil(Math.abs(turn) / PIECE - 1e-9));
  const step = turn / count;
  const handle = (4 / 3) * Math.tan(step / 4);
  const place = (px, py) => [
    cos * a * (cx + px) - sin * b * (cy + py) + (x + toX) / 2,
    sin * a * (cx + px) + cos * b * (cy + py) + (y + toY) / 2,
  ];
  const pieces = [];
  let from = [x, y];
  for (let i = 0; i < count; i++) {
    const [s, e] = [start + i * step, start + (i + 1) * step];
    const to = i === count - 1 ? [toX, toY] : place(Math.cos(e), Math.sin(e));
    pieces.push([
      ...from,
      ...place(Math.cos(s) - handle * Math.sin(s), Math.sin(s) + handle * Math.cos(s)),
      ...place(Math.cos(e) + handle * Math.sin(e), Math.sin(e) - handle * Math.cos(e)),
      ...to,
    ]);
    from = to;
  }
  return pieces;
}
