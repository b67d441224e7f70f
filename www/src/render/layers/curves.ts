import { locate } from "../../document/curve/contours.ts";
import { paintLayers } from "../../document/paint-layers.ts";
import { lineStyle, noInk, setDashes } from "../../document/painted.ts";
import { pointAt, segmentCount } from "../../document/document.ts";
import { affectedSegments } from "../../document/curve/roots.ts";
import { segmentPolygon } from "../../kernel/curve/samples.ts";
import { documentPaths } from "../outlines.ts";
import { inPage, pathOfPoints, type Scene } from "../scene.ts";
import { drawSheet } from "./sheet.ts";

/** The drawing itself on its sheet, and what of it a drag would change. */

export function drawArtboard(scene: Scene): void {
  const { artboard } = scene.state.curve;
  if (artboard !== undefined) drawSheet(scene, artboard);
}

/** Characters of a colour through which nothing shows. */
const solid = "#rrggbb".length;

export function drawFill(scene: Scene): void {
  const { state } = scene;
  const { filling = "evenodd" } = state.curve;
  if (!state.settings.overlays.fill || state.originalOnly) return;
  const context = inPage(scene);
  for (const { ink, line, drawing } of paintLayers(state.curve)) {
    const { all, closed } = documentPaths(scene, drawing);
    if (ink !== noInk && filling !== "none") paint(scene, context, ink, () => context.fill(closed, filling));
    if (line === undefined) continue;
    Object.assign(context, lineStyle(line));
    setDashes(context, line, state.view.zoom);
    // All at once, as in files: where two of them meet, no more of what is below is hidden.
    paint(scene, context, line.color, () => context.stroke(all));
    context.setLineDash([]);
  }
  Object.assign(context, { globalAlpha: 1, lineCap: "butt" });
}

function paint({ palette }: Scene, context: CanvasRenderingContext2D, color: string | undefined, draw: () => void): void {
  const inColor = (of: string, opacity: number): void => {
    Object.assign(context, { fillStyle: of, strokeStyle: of, globalAlpha: opacity });
    draw();
  };
  // What lies below is not seen, and lines and points are over any colour.
  if (color?.length === solid) inColor(palette.canvas, 1);
  inColor(color ?? palette.point, color === undefined ? 0.08 : 0.5);
}

const sidesPerSegment = 48;
const mostSpans = 24;

/** What a press would move, and what a drag is changing: the rest of the curve stays where it is. */
function spansToShow({ state }: Scene): { contour: number; segment: number }[] {
  const { curve, drag, hover, selection } = state;
  const spans = new Map<string, { contour: number; segment: number }>();
  const add = (contour: number, segment: number): void => {
    const shape = curve.contours[contour];
    if (shape === undefined) return;
    const segments = segmentCount(shape);
    const index = shape.closed ? (segment + segments) % segments : segment;
    if (index >= 0 && index < segments) spans.set(`${contour}:${index}`, { contour, segment: index });
  };
  if (drag !== null) {
    for (const ref of selection.points.slice(0, mostSpans / 2)) {
      const shape = curve.contours[ref.contour];
      if (shape?.family === "interpolating") {
        for (const segment of affectedSegments(curve, shape, ref.index)) add(ref.contour, segment);
        continue;
      }
      if (selection.handle?.side !== "out") add(ref.contour, ref.index - 1);
      if (selection.handle?.side !== "in") add(ref.contour, ref.index);
    }
    // A linked handle shapes both sides.
    if (selection.handle !== null && pointAt(curve, selection.handle)?.kind !== "cusp") {
      add(selection.handle.contour, selection.handle.index - 1);
      add(selection.handle.contour, selection.handle.index);
    }
  } else if (hover.kind === "curve" && state.tool === "select") {
    const shape = curve.contours[hover.contour];
    if (shape !== undefined) add(hover.contour, locate(shape, hover.t).segment);
  }
  return [...spans.values()];
}

export function drawSpans(scene: Scene): void {
  const { state, palette } = scene;
  if (state.originalOnly) return;
  const spans = spansToShow(scene);
  if (spans.length === 0) return;
  const context = inPage(scene);
  context.strokeStyle = palette.point;
  context.lineWidth = 7 / state.view.zoom;
  context.lineJoin = "round";
  context.globalAlpha = 0.22;
  for (const { contour, segment } of spans) {
    const shape = state.curve.contours[contour];
    if (shape !== undefined) context.stroke(pathOfPoints(segmentPolygon(state.curve, shape, segment, sidesPerSegment), false));
  }
  context.globalAlpha = 1;
}

export function drawCurves(scene: Scene): void {
  const { state, palette } = scene;
  if (state.originalOnly) return;
  const context = inPage(scene);
  context.strokeStyle = palette.curve;
  context.lineWidth = 2 / state.view.zoom;
  context.lineJoin = "round";
  for (const line of documentPaths(scene, state.curve).lines) context.stroke(line);
}
