/** Colours and lines, of contours and of what they are made of. */

/** How a contour is painted: its area, then its line over it. */
export interface Painted {
  /**
   * The colour of its area: `#rrggbb`, or `#rrggbbaa` where something shows through. `none`: it is a line, which has no
   * area even where it is closed. Absent: the colour of the page, and of files.
   */
  readonly ink?: string;
  /** Absent: an area has none, and what has no area a thin one, however near one looks. */
  readonly line?: Line;
}

export interface Line {
  /** Document units. */
  readonly width: number;
  /** As of `ink`. */
  readonly color?: string;
  /** How it ends; absent: cut off square at its last point. */
  readonly cap?: "round" | "square";
  /** How it turns at corners; absent: in a point. */
  readonly join?: "round" | "bevel";
  /** Lengths of dashes and of the gaps between them, in turn, as of SVG's `stroke-dasharray`; absent: solid. */
  readonly dashes?: readonly number[];
  /** How far into its dashes it begins; absent: 0. */
  readonly dashOffset?: number;
}

/** Wider lines than any drawing is, and such that nobody sees, are none. */
export function isLineWidth(width: number): boolean {
  return width >= 1e-9 && width <= 1e9;
}

/** Of contours that are lines, whatever closes them. */
export const noInk = "none";

/** As a canvas has it: a point at a corner is cut off where SVG cuts it. */
export function lineStyle({ width, cap, join }: Line): Pick<CanvasRenderingContext2D, "lineWidth" | "lineCap" | "lineJoin" | "miterLimit"> {
  return { lineWidth: width, lineCap: cap ?? "butt", lineJoin: join ?? "miter", miterLimit: 4 };
}

/** Dashes that repeat within this many pixels cannot be told apart, and would be millions. */
const leastPeriod = 0.5;

/** Solid where `scale` pixels a unit show none. */
export function setDashes(context: CanvasRenderingContext2D, { dashes = [], dashOffset = 0 }: Line, scale: number): void {
  const period = dashes.reduce((sum, each) => sum + each, 0);
  context.setLineDash(period * scale < leastPeriod ? [] : [...dashes]);
  context.lineDashOffset = dashOffset;
}

/** How far a line reaches beyond the outline that it runs along, corners up to a right angle and its ends included. */
export function reachOf({ width, cap, join }: Line): number {
  return (width / 2) * (cap === "square" || join === undefined ? Math.SQRT2 : 1);
}

/** The paint of what may have more than that. */
export function paintOf({ ink, line }: { readonly [K in keyof Painted]: Painted[K] | undefined }): Painted {
  return { ...(ink === undefined ? {} : { ink }), ...(line === undefined ? {} : { line }) };
}

export function isPainted({ ink, line }: Painted): boolean {
  return ink !== undefined || line !== undefined;
}

export function isAlike(a: Painted, b: Painted): boolean {
  const [one, other] = [a.line, b.line];
  return a.ink === b.ink && (one === other || (["width", "color", "cap", "join", "dashes", "dashOffset"] as const).every((part) => String(one?.[part]) === String(other?.[part])));
}

/** What is painted alike and follows each other, together. */
export function runsOf<T extends Painted>(all: readonly T[]): readonly (readonly T[])[] {
  const runs: T[][] = [];
  all.forEach((each, i) => {
    const before = all[i - 1];
    if (before !== undefined && isAlike(before, each)) runs.at(-1)?.push(each);
    else runs.push([each]);
  });
  return runs;
}
