import { partsOf } from "../../document/curve/parts.ts";
import type { Contour, CurveDocument } from "../../document/document.ts";
import { bendsOf, teethOf } from "../../kernel/curve/overlays/comb.ts";
import { documentBounds, type Bounds } from "../../kernel/curve/samples.ts";
import { stepOf } from "../outlines.ts";
import { inPage, overlap, sightOf, type Scene } from "../scene.ts";

const mostTeeth = 1024;
/** Teeth of a segment of a contour that has more of them in all. */
const fewest = 4;

/** Teeth at right angles to the curve on its convex side, as long as the curvature is great. */
export function drawComb(scene: Scene): void {
  const { state, palette } = scene;
  if (!state.settings.overlays.comb || state.originalOnly) return;
  const context = inPage(scene);
  const { zoom } = state.view;
  context.strokeStyle = context.fillStyle = palette.handle;
  const half = halfExtent(scene);
  const scale = state.settings.combScale * combScale(scene.origin, half);
  const sight = sightOf(scene);
  for (const contour of state.curve.contours) {
    const segments = Math.max(1, contour.closed ? contour.points.length : contour.points.length - 1);
    const perSegment = Math.max(fewest, Math.min(48, Math.floor(mostTeeth / segments)));
    for (const part of partsOf(state.curve, contour)) {
      const { teeth, isArea, envelope, box } = combPaths(scene, part, perSegment, half, scale);
      if (!overlap(box, sight)) continue;
      context.globalAlpha = isArea ? 0.3 : 0.55;
      context.lineWidth = 1 / zoom;
      if (isArea) context.fill(teeth);
      else context.stroke(teeth);
      context.globalAlpha = 1;
      context.lineWidth = 1.25 / zoom;
      context.stroke(envelope);
    }
  }
}

interface CombPaths {
  readonly scale: number;
  readonly stride: number;
  readonly teeth: Path2D;
  /** Of very many segments, teeth that cannot be told apart are the area on which they stand. */
  readonly isArea: boolean;
  readonly envelope: Path2D;
  /** Around the teeth. */
  readonly box: Bounds;
}

/** An immutable contour's comb only changes with the scale, and with how many of its teeth can be told apart. */
const combs = new WeakMap<Contour, CombPaths>();

/** Half the larger side of the drawing: all contours' combs have one scale. */
function halfExtent({ state }: Scene): number {
  const box = documentBounds(state.curve);
  return box === null ? 0 : Math.max(box.maxX - box.minX, box.maxY - box.minY) / 2;
}

const scales = new WeakMap<CurveDocument, number>();
/** Contours that tell how curved a drawing is. */
const mostLookedAt = 64;

/**
 * Tooth per curvature at which nine teeth of ten are at most three tenths of the drawing's half: on a circle, of its
 * radius. Of the drawing as it was when a drag began, so that the scale stands still while it lasts.
 */
function combScale(document: CurveDocument, half: number): number {
  const known = scales.get(document);
  if (known !== undefined) return known;
  const bends = document.contours.slice(0, mostLookedAt).flatMap((contour) => bendsOf(document, contour))
    .flatMap((some) => Array.from(some)).filter((bend) => bend < Infinity).sort((a, b) => a - b);
  const scale = (0.3 * half) / Math.max(1 / half, bends[Math.floor(0.9 * bends.length)] ?? 0);
  scales.set(document, scale);
  return scale;
}

/** Every how many-th tooth is drawn, a power of two, so that neighbours are a pixel or more apart on average. */
function strideOf({ state }: Scene, part: Contour, perSegment: number): number {
  const apart = (stepOf(part) * state.view.zoom) / perSegment;
  return apart >= 1 ? 1 : 2 ** Math.ceil(-Math.log2(Math.max(apart, 1e-6)));
}

function combPaths(scene: Scene, part: Contour, perSegment: number, half: number, scale: number): CombPaths {
  const stride = strideOf(scene, part, perSegment);
  const known = combs.get(part);
  if (known !== undefined && known.scale === scale && known.stride === stride) return known;
  const isArea = stride > 1 && perSegment === fewest;
  const [teeth, envelope] = [new Path2D(), new Path2D()];
  const feet: number[] = [];
  let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity];
  const all = teethOf(scene.state.curve, part, perSegment);
  // Near a cusp the curvature has no bound; a tooth of a good third of the drawing says enough.
  const longest = 0.75 * half;
  for (let i = 0; i < (all?.curvature.length ?? 0); i += stride) {
    const [x = 0, y = 0, across = 0, down = 0] = [all?.feet[2 * i], all?.feet[2 * i + 1], all?.across[2 * i], all?.across[2 * i + 1]];
    const tooth = Math.max(-longest, Math.min(longest, (all?.curvature[i] ?? 0) * scale));
    const [tipX, tipY] = [x + across * tooth, y + down * tooth];
    if (!Number.isFinite((all?.curvature[i] ?? 0) * scale + tipX + tipY)) continue;
    if (isArea) feet.push(x, y);
    else teeth.moveTo(x, y);
    teeth.lineTo(tipX, tipY);
    // Curvature may jump from one segment to the next: the envelope says so by breaking off, where that can be seen.
    if (i === 0 || (stride === 1 && i % perSegment === 0)) envelope.moveTo(tipX, tipY);
    else envelope.lineTo(tipX, tipY);
    [minX, minY, maxX, maxY] = [Math.min(minX, x, tipX), Math.min(minY, y, tipY), Math.max(maxX, x, tipX), Math.max(maxY, y, tipY)];
  }
  for (let i = feet.length - 2; i >= 0; i -= 2) teeth.lineTo(feet[i] ?? 0, feet[i + 1] ?? 0);
  const fresh = { scale, stride, isArea, teeth, envelope, box: { minX, minY, maxX, maxY } };
  combs.set(part, fresh);
  return fresh;
}
