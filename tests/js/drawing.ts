// What a viewer draws from path data: a plain reader by the letter of SVG 2, which shares nothing with the package
// (numbers are JavaScript's own; arcs are in SVG's centre parametrisation, B.2.4).

export type Point = readonly [number, number];

/** One drawn segment: Bézier points (2, 3 or 4), or an arc. */
export type Piece =
  | { readonly kind: "bezier"; readonly points: readonly Point[] }
  | {
      readonly kind: "arc";
      readonly center: Point;
      readonly radii: Point;
      readonly rotation: number;
      readonly first: number;
      readonly sweep: number;
    };

export interface Contour {
  readonly pieces: Piece[];
  closed: boolean;
}

/** A chord this close to the diameter, by its square, is the diameter: rounding would move the centre by its root. */
const HALF_TURN = 1e-12;

const COUNTS: Readonly<Record<string, number>> = { M: 2, L: 2, H: 1, V: 1, C: 6, S: 4, Q: 4, T: 2, A: 7, Z: 0 };
const NUMBER = /[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?/y;

/** The point at x in [0, 1]. */
export function at(piece: Piece, x: number): Point {
  if (piece.kind === "arc") {
    const angle = piece.first + piece.sweep * x;
    const [u, v] = [piece.radii[0] * Math.cos(angle), piece.radii[1] * Math.sin(angle)];
    const [sin, cos] = [Math.sin(piece.rotation), Math.cos(piece.rotation)];
    return [piece.center[0] + u * cos - v * sin, piece.center[1] + u * sin + v * cos];
  }
  const z = 1 - x;
  const [a, b, c, d] = piece.points;
  if (!a || !b) return [NaN, NaN];
  if (!c) return [a[0] * z + b[0] * x, a[1] * z + b[1] * x];
  if (!d) {
    const [p, q, r] = [z * z, 2 * x * z, x * x];
    return [a[0] * p + b[0] * q + c[0] * r, a[1] * p + b[1] * q + c[1] * r];
  }
  const [p, q, r, s] = [z * z * z, 3 * x * z * z, 3 * x * x * z, x * x * x];
  return [a[0] * p + b[0] * q + c[0] * r + d[0] * s, a[1] * p + b[1] * q + c[1] * r + d[1] * s];
}

/** Whether all its points are one. */
export function isPoint(piece: Piece): boolean {
  const first = piece.kind === "bezier" ? piece.points[0] : undefined;
  return first !== undefined && piece.kind === "bezier" && piece.points.every((p) => p[0] === first[0] && p[1] === first[1]);
}

function line(from: Point, to: Point): Piece {
  return { kind: "bezier", points: [from, to] };
}

function arc(from: Point, to: Point, [rx, ry, degrees, large, positive]: readonly number[]): Piece {
  if (!rx || !ry || (from[0] === to[0] && from[1] === to[1])) return line(from, to);
  const rotation = ((degrees ?? 0) * Math.PI) / 180;
  const [sin, cos] = [Math.sin(rotation), Math.cos(rotation)];
  const [hx, hy] = [(from[0] - to[0]) / 2, (from[1] - to[1]) / 2];
  const [x, y] = [hx * cos + hy * sin, hy * cos - hx * sin];
  let [a, b] = [Math.abs(rx), Math.abs(ry)];
  const lambda = (x / a) ** 2 + (y / b) ** 2;
  let root = 0;
  if (lambda > 1) {
    a *= Math.sqrt(lambda);
    b *= Math.sqrt(lambda);
  } else if (lambda < 1 - HALF_TURN) {
    root = Math.sqrt((1 - lambda) / lambda);
  }
  if (large === positive) root = -root;
  const [cx, cy] = [(root * a * y) / b, (-root * b * x) / a];
  const first = Math.atan2((y - cy) / b, (x - cx) / a);
  let sweep = Math.atan2((-y - cy) / b, (-x - cx) / a) - first;
  if (positive && sweep < 0) sweep += 2 * Math.PI;
  if (!positive && sweep > 0) sweep -= 2 * Math.PI;
  const center: Point = [cx * cos - cy * sin + (from[0] + to[0]) / 2, cx * sin + cy * cos + (from[1] + to[1]) / 2];
  return { kind: "arc", center, radii: [a, b], rotation, first, sweep };
}

/** The contours of valid path data that draw something. */
export function drawing(d: string): Contour[] {
  const contours: Contour[] = [];
  let contour: Contour | undefined;
  let current: Point = [0, 0];
  let start: Point = current;
  let letter = "M";
  let cubic: Point | undefined;
  let quadratic: Point | undefined;
  let place = 0;
  const skip = (): void => {
    while (/[\s,]/.test(d[place] ?? "")) place += 1;
  };
  const number = (flag: boolean): number => {
    skip();
    if (flag) return Number(d[place++]);
    NUMBER.lastIndex = place;
    const found = NUMBER.exec(d);
    if (!found) throw new Error(`no number at ${place} of ${d}`);
    place = NUMBER.lastIndex;
    return Number(found[0]);
  };
  const mirrored = (control: Point | undefined): Point => (control ? [2 * current[0] - control[0], 2 * current[1] - control[1]] : current);
  for (skip(); place < d.length; skip()) {
    if (/[a-z]/i.test(d[place] ?? "")) letter = d[place++] ?? "";
    const command = letter.toUpperCase();
    const from = current;
    const base: Point = letter === command ? [0, 0] : from;
    const numbers = Array.from({ length: COUNTS[command] ?? NaN }, (_, k) => number(command === "A" && (k === 3 || k === 4)));
    const pairs: Point[] = [];
    const coordinates = command === "A" ? numbers.slice(5) : numbers;
    for (let k = 0; k + 1 < coordinates.length; k += 2) pairs.push([base[0] + (coordinates[k] ?? 0), base[1] + (coordinates[k + 1] ?? 0)]);
    const [one, two, three] = pairs;
    const end = pairs.at(-1);
    let piece: Piece | undefined;
    let nextCubic: Point | undefined;
    let nextQuadratic: Point | undefined;
    if (command === "Z") {
      if (contour) contour.closed = true;
      piece = contour && line(from, start);
      current = start;
    } else if (command === "H" || command === "V") {
      const value = numbers[0] ?? 0;
      current = command === "H" ? [base[0] + value, from[1]] : [from[0], base[1] + value];
      piece = line(from, current);
    } else if (end) {
      current = end;
      if (command === "L") piece = line(from, end);
      if (command === "A") piece = arc(from, end, numbers);
      if (command === "C" && one && two && three) {
        piece = { kind: "bezier", points: [from, one, two, three] };
        nextCubic = two;
      }
      if (command === "S" && one && two) {
        current = from;
        piece = { kind: "bezier", points: [from, mirrored(cubic), one, two] };
        current = end;
        nextCubic = one;
      }
      if (command === "Q" && one && two) {
        piece = { kind: "bezier", points: [from, one, two] };
        nextQuadratic = one;
      }
      if (command === "T") {
        current = from;
        nextQuadratic = mirrored(quadratic);
        piece = { kind: "bezier", points: [from, nextQuadratic, end] };
        current = end;
      }
    }
    [cubic, quadratic] = [nextCubic, nextQuadratic];
    if (command === "M") {
      start = current;
      contour = undefined;
      letter = letter === "m" ? "l" : "L";
    } else if (piece) {
      if (!contour) contours.push((contour = { pieces: [], closed: false }));
      if (!isPoint(piece)) contour.pieces.push(piece);
    }
    if (command === "Z") contour = undefined;
  }
  return contours.filter(({ pieces }) => pieces.length > 0);
}
