import type { FitOutcome } from "../../kernel/fit/outcome.ts";
import { drawGrid } from "../layers/grid.ts";
import { inScreen, type Scene } from "../scene.ts";
import type { Painter } from "../stage.ts";
import { drawCurve, drawData, drawFitComb, drawHand, drawHeat, drawParts, drawResiduals } from "./fit-layers.ts";
import { KnotLayer } from "./knot-layer.ts";

/** Fit's picture, from the paper up. `again` asks for another picture after this one. */
export function createFitPainter(again: () => void, now: () => number): Painter {
  const knots = new KnotLayer(again, now);
  return {
    paint(scene) {
      const { outcome } = scene.state.fitRun;
      const { compare } = scene.state.fitView;
      drawGrid(scene);
      if (outcome === null) knots.forget();
      if (outcome === null || scene.state.originalOnly) drawData(scene, 1);
      else if (compare === "split") drawSplit(scene, outcome, knots);
      else drawOver(scene, outcome, knots);
      drawHand(scene);
    },
  };
}

/** The fit over its data. */
function drawOver(scene: Scene, outcome: FitOutcome, knots: KnotLayer): void {
  const { overlays, compare } = scene.state.fitView;
  if (overlays.data) drawData(scene, compare === "onion" ? 1 : 0.9);
  drawResult(scene, outcome, knots);
}

/** Left of the line the data, right of it the fit. */
function drawSplit(scene: Scene, outcome: FitOutcome, knots: KnotLayer): void {
  const { stage, fitView } = scene.state;
  const at = stage.width * fitView.split;
  drawWithin(scene, 0, at, () => drawData(scene, 1));
  drawWithin(scene, at, stage.width, () => drawResult(scene, outcome, knots));
  drawDivider(scene, at);
}

function drawWithin(scene: Scene, left: number, right: number, draw: () => void): void {
  const context = inScreen(scene);
  context.save();
  context.beginPath();
  context.rect(left, 0, right - left, scene.state.stage.height);
  context.clip();
  draw();
  context.restore();
}

function drawDivider(scene: Scene, at: number): void {
  const context = inScreen(scene);
  context.strokeStyle = scene.palette.line;
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(at, 0);
  context.lineTo(at, scene.state.stage.height);
  context.stroke();
}

function drawResult(scene: Scene, outcome: FitOutcome, knots: KnotLayer): void {
  const { overlays } = scene.state.fitView;
  if (overlays.heat) drawHeat(scene, outcome);
  if (overlays.parts) drawParts(scene, outcome);
  if (overlays.comb) drawFitComb(scene, outcome);
  if (overlays.residual) drawResiduals(scene, outcome);
  drawCurve(scene, outcome);
  if (overlays.knots) knots.draw(scene, outcome);
}
