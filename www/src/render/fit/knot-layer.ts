import type { FitOutcome } from "../../kernel/fit/outcome.ts";
import type { ShownKnot } from "../../kernel/fit/knots.ts";
import { inScreen, onScreen, type Scene } from "../scene.ts";
import { drawKnotMark } from "./knot-marks.ts";

/** The knots of a fit as marks; those that the fit before had and this one has not fade out. */

const fadeMs = 150;
/** Knots of two fits that are nearer than this, in document units by the zoom, are one that moved. */
const movedPixels = 9;
const mostMarks = 2000;

interface Fading {
  readonly knots: readonly ShownKnot[];
  readonly since: number;
}

export class KnotLayer {
  readonly #again: () => void;
  readonly #now: () => number;
  readonly #calm = matchMedia("(prefers-reduced-motion: reduce)");
  #shown: FitOutcome | null = null;
  #fading: Fading | null = null;

  /** `again` asks for another picture after this one. */
  constructor(again: () => void, now: () => number) {
    this.#again = again;
    this.#now = now;
  }

  draw(scene: Scene, outcome: FitOutcome): void {
    if (outcome !== this.#shown) {
      this.#fading = this.#calm.matches ? null : { knots: vanished(this.#shown, outcome, scene.state.view.zoom), since: this.#now() };
      this.#shown = outcome;
    }
    if (this.#fading !== null) this.#drawFading(scene, this.#fading);
    drawKnots(scene, outcome);
  }

  /** Nothing fades out of what is drawn next. */
  forget(): void {
    this.#shown = null;
  }

  #drawFading(scene: Scene, { knots, since }: Fading): void {
    const left = 1 - (this.#now() - since) / fadeMs;
    if (left <= 0) {
      this.#fading = null;
      return;
    }
    const context = inScreen(scene);
    context.globalAlpha = left;
    for (const knot of knots) drawKnotMark(context, onScreen(scene, knot), knot.type, { over: false, chosen: false, focused: false }, scene.palette);
    context.globalAlpha = 1;
    if (knots.length > 0) this.#again();
  }
}

/** What was there and is no more. */
function vanished(before: FitOutcome | null, next: FitOutcome, zoom: number): readonly ShownKnot[] {
  if (before === null || before.knots.length > mostMarks) return [];
  const reach = movedPixels / zoom;
  return before.knots.filter((old) => !next.knots.some((knot) => Math.hypot(knot.x - old.x, knot.y - old.y) <= reach));
}

function drawKnots(scene: Scene, { knots }: FitOutcome): void {
  const { state, palette, focused } = scene;
  const context = inScreen(scene);
  const { chosen, over } = state.fitView;
  const focus = focused && state.keyboard ? chosen.at(-1) : undefined;
  knots.slice(0, mostMarks).forEach((knot, i) => {
    drawKnotMark(context, onScreen(scene, knot), knot.type, { over: over === i, chosen: chosen.includes(i), focused: focus === i }, palette);
  });
}
