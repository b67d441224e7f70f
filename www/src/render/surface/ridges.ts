import { add, projector, type Vector } from "../../editor/surface/orbit.ts";
import { facesAway } from "../../editor/surface/surface-edits.ts";
import { extentOf } from "../../kernel/surface/surface-mesh.ts";
import { ridgesOf, type Ridge } from "../../kernel/surface/surface-weights.ts";
import { inScreen, type Scene } from "../scene.ts";

/**
 * The generators of a control point, standing on the surface along the two lines through it: as high as it acts
 * strongly.
 */

/** A weight of 1, as a part of the surface's radius. */
const high = 0.35;
/** Less is no weight but the rounding of one. */
const least = 1e-7;

export function drawRidges(scene: Scene): void {
  const { surface, solid, chosen } = scene.state;
  if (!solid.weights || surface.net.length === 0) return;
  const [along, across] = ridgesOf(surface, chosen.at(-1) ?? { u: 0, v: 0 });
  if (along !== undefined) drawRidge(scene, along, scene.palette.linear);
  if (across !== undefined) drawRidge(scene, across, scene.palette.cubic);
}

function drawRidge(scene: Scene, { places, normals, weights }: Ridge, colour: string): void {
  const { solid, stage, surface } = scene.state;
  const project = projector(solid.orbit, stage);
  const scale = high * extentOf(surface).radius;
  const at = (list: Float64Array, i: number): Vector => [list[3 * i] ?? 0, list[3 * i + 1] ?? 0, list[3 * i + 2] ?? 0];
  const context = inScreen(scene);
  // What stands on the far side is fainter, as the net is.
  const [near, far] = [{ area: new Path2D(), line: new Path2D() }, { area: new Path2D(), line: new Path2D() }];
  const standing = Array.from(weights, (weight, i) => {
    const [foot, normal] = [at(places, i), at(normals, i)];
    const away = facesAway(solid.orbit, { at: foot, normal, ref: { u: 0, v: 0 }, parameter: [0, 0], on: true });
    return { weight, away, foot: project(foot), tip: project(add(foot, normal, scale * weight)) };
  });
  for (const [i, one] of standing.entries()) {
    const next = standing[i + 1];
    if (next === undefined || (Math.abs(one.weight) < least && Math.abs(next.weight) < least)) continue;
    if ([one.foot, one.tip, next.foot, next.tip].some(({ depth }) => depth <= 0)) continue;
    const { area, line } = one.away ? far : near;
    area.moveTo(one.foot.x, one.foot.y);
    for (const corner of [one.tip, next.tip, next.foot]) area.lineTo(corner.x, corner.y);
    area.closePath();
    line.moveTo(one.tip.x, one.tip.y);
    line.lineTo(next.tip.x, next.tip.y);
  }
  context.fillStyle = context.strokeStyle = colour;
  context.lineWidth = 2;
  context.lineCap = "round";
  for (const [{ area, line }, strength] of [[far, 0.4], [near, 1]] as const) {
    context.globalAlpha = 0.28 * strength;
    context.fill(area);
    context.globalAlpha = strength;
    context.stroke(line);
  }
  context.globalAlpha = 1;
  context.lineCap = "butt";
}
