import type { FitOutcome } from "./outcome.ts";

/** An outcome with everything that is drawn of it moved by one step. What its errors are is as it was. */
export function asMoved(outcome: FitOutcome, dx: number, dy: number): FitOutcome {
  const by = [1, 0, 0, 1, dx, dy] as const;
  const strokes = outcome.strokes.map((stroke) => ({
    ...stroke,
    curve: stroke.curve.transform(by),
    points: stroke.points.map((value, i) => value + (i % 2 === 0 ? dx : dy)),
  }));
  return { ...outcome, strokes, knots: outcome.knots.map((knot) => ({ ...knot, x: knot.x + dx, y: knot.y + dy })) };
}
