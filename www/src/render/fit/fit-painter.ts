import type { FitOutcome } from "../../kernel/fit/outcome.ts";
import type { ShownKnot } from "../../kernel/fit/knots.ts";
import { drawGrid } from "../layers/grid.ts";
import { inScreen, onScreen, type Scene } from "../scene.ts";
import type { Painter } from "../stage.ts";
import { drawCurve, drawData, drawFitComb, drawHand, drawHeat, drawParts, drawResiduals } from "./fit-layers.ts";
import { drawKnotMark } from "./knot-marks.ts";

/** Fit's picture, from the paper up. Knots that vanish fade out. */

const fadeMs = 150;
/** Knots of two fits that are nearer than this, in document units by the zoom, are one that moved. */
const movedPixels = 9;
const mostMarks = 2000;

interface Fading {
  readonly knots: readonly ShownKnot[];
  readonly since: number;
}

/** `again` asks for another picture after this one. */
export function createFitPainter(again: () => void, now: () => number): Painter {
  let shown: FitOutcome | null = null;
  let fading: Fading | null = null;
  const calm = matchMedia("(prefers-reduced-motion: reduce)");

  /** What was there and is no more. */
  function vanished(next: FitOutcome, zoom: number): ShownKnot[] {
    if (shown === null || shown.knots.length > mostMarks) return [];
    const reach = movedPixels / zoom;
    return shown.knots.filter((old) => !next.knots.some((knot) => Math.hypot(knot.x - old.x, knot.y - old.y) <= reach));
  }

  function drawKnots(scene: Scene, outcome: FitOutcome): void {
    const { state, palette, focused } = scene;
    if (outcome !== shown) {
      fading = calm.matches ? null : { knots: vanished(outcome, state.view.zoom), since: now() };
      shown = outcome;
    }
    const context = inScreen(scene);
    if (fading !== null) {
      const left = 1 - (now() - fading.since) / fadeMs;
      if (left > 0) {
        context.globalAlpha = left;
        for (const knot of fading.knots) drawKnotMark(context, onScreen(scene, knot), knot.type, { over: false, chosen: false, focused: false }, palette);
        context.globalAlpha = 1;
        if (fading.knots.length > 0) again();
      } else {
        fading = null;
      }
    }
    const { chosen, over } = state.fitView;
    const focus = focused && state.keyboard ? chosen.at(-1) : undefined;
    outcome.knots.slice(0, mostMarks).forEach((knot, i) => {
      drawKnotMark(context, onScreen(scene, knot), knot.type, { over: over === i, chosen: chosen.includes(i), focused: focus === i }, palette);
    });
  }

  function drawResult(scene: Scene, outcome: FitOutcome): void {
    const { overlays } = scene.state.fitView;
    if (overlays.heat) drawHeat(scene, outcome);
    if (overlays.parts) drawParts(scene, outcome);
    if (overlays.comb) drawFitComb(scene, outcome);
    if (overlays.residual) drawResiduals(scene, outcome);
    drawCurve(scene, outcome);
    if (overlays.knots) drawKnots(scene, outcome);
  }

  /** Left of the line the data, right of it the fit. */
  function drawSplit(scene: Scene, outcome: FitOutcome): void {
    const { state, palette } = scene;
    const at = state.stage.width * state.fitView.split;
    const context = inScreen(scene);
    context.save();
    context.beginPath();
    context.rect(0, 0, at, state.stage.height);
    context.clip();
    drawData(scene, 1);
    context.restore();
    inScreen(scene);
    context.save();
    context.beginPath();
    context.rect(at, 0, state.stage.width - at, state.stage.height);
    context.clip();
    drawResult(scene, outcome);
    context.restore();
    inScreen(scene);
    context.strokeStyle = palette.line;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(at, 0);
    context.lineTo(at, state.stage.height);
    context.stroke();
  }

  return {
    paint(scene) {
      const { fitRun, fitView, originalOnly } = scene.state;
      const { outcome } = fitRun;
      drawGrid(scene);
      if (outcome === null) shown = null;
      if (fitView.compare === "split" && outcome !== null && !originalOnly) {
        drawSplit(scene, outcome);
      } else {
        const alone = outcome === null || originalOnly;
        if (fitView.overlays.data || alone) drawData(scene, alone || fitView.compare === "onion" ? 1 : 0.75);
        if (outcome !== null && !originalOnly) drawResult(scene, outcome);
      }
      drawHand(scene);
    },
  };
}
