import { surfaceTitle } from "../../document/surface/surface-samples.ts";
import { isChosen, noNetPoints, sameNetPoint, type NetRef, type SurfaceDocument, type SurfaceMoment } from "../../document/surface/surface.ts";
import { atLevels, netSize, resizedSurface, largestDistance } from "../../kernel/surface/surface-net.ts";
import { extentOf, netPoints, type ShownPoint } from "../../kernel/surface/surface-mesh.ts";
import { madeSurface, openedSurface, refinedHere, surfaceSample, withNetPoints } from "../../kernel/surface/surface.ts";
import { printed, refuse } from "../curve/edits.ts";
import type { Editor } from "../editor.ts";
import { add, fittingDistance, frameOf, turnedBy, type Orbit, type Vector } from "./orbit.ts";
import { startOrbit, type DragAxis, type SolidState } from "./solid.ts";

/** The edits of the surface that its tool, keys and panel share. */

const mostSurfaceLevel = 3;
const leastNet = 3;
const mostNet = 32;

export function patchSolid(editor: Editor, change: Partial<SolidState>): void {
  editor.patch({ solid: { ...editor.state.value.solid, ...change } });
}

/**
 * The sample that the document only names is opened, and what no library could draw gives way to it: no entry in the
 * history.
 */
export function ensureSurface(editor: Editor): void {
  const { surface, solid } = editor.state.value;
  if (surface.net.length > 0 && isDrawable(editor, surface)) {
    if (solid.full === 0) patchSolid(editor, { full: extentOf(surface).radius });
    return;
  }
  if (surfaceTitle(surface.sample) === "") editor.notify({ kind: "toast", text: `There is no sample called ${surface.sample}.` });
  editor.surfaceEdits.settle({ surface: openedSurface({ ...surface, net: [] }), chosen: noNetPoints });
  fitSurface(editor, true);
}

function isDrawable(editor: Editor, surface: SurfaceDocument): boolean {
  try {
    madeSurface(surface);
    return true;
  } catch (error) {
    editor.notify({
      kind: "error",
      id: "json-broken",
      text: `The surface could not be opened, so its sample is shown: ${error instanceof Error ? error.message : String(error)}`,
    });
    return false;
  }
}

export function openSurfaceSample(editor: Editor, id: string): boolean {
  const surface = surfaceSample(id);
  if (surface === null) return false;
  if (surface === editor.state.value.surface) return true;
  editor.surfaceEdits.dispatch("Open sample", () => ({ surface, chosen: noNetPoints }));
  fitSurface(editor, true);
  return true;
}

/** The whole surface in view; `fresh` also turns it to where one looks from first. */
export function fitSurface(editor: Editor, fresh = false): void {
  const { surface, stage, solid } = editor.state.value;
  const extent = extentOf(surface);
  const turn = fresh ? startOrbit : solid.orbit;
  patchSolid(editor, { orbit: { ...turn, target: extent.center, distance: fittingDistance(extent, stage) }, full: extent.radius });
}

export function lookFrom(editor: Editor, turn: { readonly yaw: number; readonly pitch: number }): void {
  patchSolid(editor, { orbit: { ...editor.state.value.solid.orbit, ...turn } });
}

/** Without a hand on the stage: by degrees, as a drag to the right and down would. */
export function turnView(editor: Editor, right: number, down: number): void {
  const orbit = turnedBy(editor.state.value.solid.orbit, (right * Math.PI) / 180, (down * Math.PI) / 180);
  patchSolid(editor, { orbit });
  editor.notify({ kind: "announce", text: describeOrbit(orbit) });
}

/** "Seen from 120 degrees around, 30 degrees above". */
function describeOrbit({ yaw, pitch }: Orbit): string {
  const [around, height] = [yaw, pitch].map((angle) => Math.round((angle * 180) / Math.PI)) as [number, number];
  return `Seen from ${(around + 360) % 360} degrees around, ${Math.abs(height)} degrees ${height < 0 ? "below" : "above"}`;
}

export function shownPoint(surface: SurfaceDocument, ref: NetRef): ShownPoint | undefined {
  return netPoints(surface).find((point) => sameNetPoint(point.ref, ref));
}

/** The chosen points moved by one step, from where they were in `start`. */
export function moved(start: SurfaceMoment, points: readonly NetRef[], step: Vector): SurfaceMoment {
  const places = points.flatMap((ref) => {
    const point = shownPoint(start.surface, ref);
    if (point === undefined) return [];
    const [x, y, z] = add(point.at, step);
    return [{ ...ref, x, y, z }];
  });
  return places.length === 0 ? start : { surface: withNetPoints(start.surface, places), chosen: points };
}

/** A change that the library refuses leaves everything as it was, and says so. */
function tryChange(editor: Editor, name: string, change: (now: SurfaceMoment) => SurfaceMoment, run?: string): void {
  try {
    editor.surfaceEdits.dispatch(name, change, run);
  } catch (error) {
    editor.notify({ kind: "error", id: "number", text: `${name} was refused: ${error instanceof Error ? error.message : String(error)}` });
  }
}

/** The direction of an axis: of the world, of the surface at a point, or of the screen. */
export function axisVector(axis: DragAxis, point: ShownPoint): Vector | null {
  switch (axis) {
    case "x":
      return [1, 0, 0];
    case "y":
      return [0, 1, 0];
    case "z":
      return [0, 0, 1];
    case "normal":
      return point.normal;
    case "view":
      return null;
  }
}

/** A hundredth of the surface, in round numbers. */
export function nudgeUnit(surface: SurfaceDocument): number {
  return 10 ** Math.round(Math.log10(extentOf(surface).radius / 100));
}

/** Steps of the screen, or along the axis that drags are held to; a quick run is one entry. */
export function nudgeNet(editor: Editor, right: number, up: number): void {
  const { surface, chosen, solid } = editor.state.value;
  const point = chosen[0] === undefined ? undefined : shownPoint(surface, chosen[0]);
  if (point === undefined) return;
  const unit = nudgeUnit(surface);
  const axis = axisVector(solid.axis, point);
  const frame = frameOf(solid.orbit);
  const step = axis === null ? add(add([0, 0, 0], frame.right, right * unit), frame.up, up * unit) : add([0, 0, 0], axis, (right + up) * unit);
  tryChange(editor, "Nudge", (now) => moved(now, chosen, step), `nudge ${JSON.stringify(chosen)}`);
}

export function placeNet(editor: Editor, axis: 0 | 1 | 2, value: number): void {
  const { surface, chosen } = editor.state.value;
  const [ref] = chosen;
  const point = ref === undefined ? undefined : shownPoint(surface, ref);
  if (ref === undefined || point === undefined || chosen.length !== 1) return;
  const place: [number, number, number] = [...point.at];
  place[axis] = value;
  const [x, y, z] = place;
  tryChange(editor, "Place point", (now) => ({ surface: withNetPoints(now.surface, [{ ...ref, x, y, z }]), chosen }), `type ${"xyz"[axis] ?? ""}`);
}

/** Finer or coarser control points of the same surface; what would change it is said first and made on asking again. */
export function setSurfaceLevels(editor: Editor, levelU: number, levelV: number): void {
  const { surface } = editor.state.value;
  const clamp = (level: number): number => Math.max(0, Math.min(mostSurfaceLevel, Math.round(level)));
  const [u, v] = [clamp(levelU), clamp(levelV)];
  if (u === surface.levelU && v === surface.levelV) return void proposed.delete(editor);
  const result = atLevels(surface, u, v);
  if (result.moved > unnoticed * extentOf(surface).radius && !isProposed(editor, surface, u, v)) {
    proposed.set(editor, { surface, u, v });
    editor.notify({ kind: "toast", text: `Level ${u} × ${v} would move the surface by up to ${printed(result.moved)}.`, actionId: "surface-apply-level" });
    return;
  }
  proposed.delete(editor);
  tryChange(editor, `Level ${u} × ${v}`, () => ({ surface: result.document, chosen: noNetPoints }), "surface-level");
}

/** Moves below this, relative to the surface, are rounding. */
const unnoticed = 1e-9;

interface Proposed {
  readonly surface: SurfaceDocument;
  readonly u: number;
  readonly v: number;
}

const proposed = new WeakMap<Editor, Proposed>();

function isProposed(editor: Editor, surface: SurfaceDocument, u: number, v: number): boolean {
  const asked = proposed.get(editor);
  return asked !== undefined && asked.surface === surface && asked.u === u && asked.v === v;
}

export function applyProposedLevel(editor: Editor): void {
  const asked = proposed.get(editor);
  if (asked !== undefined) setSurfaceLevels(editor, asked.u, asked.v);
}

export function setNetSize(editor: Editor, which: "u" | "v", size: number): void {
  const { surface } = editor.state.value;
  const now = netSize(surface);
  const wanted = Math.max(leastNet, Math.min(mostNet, Math.round(size)));
  const [u, v] = which === "u" ? [wanted, now[1]] : [now[0], wanted];
  if (u === now[0] && v === now[1]) return;
  let before = surface;
  tryChange(editor, "Net size", ({ surface: old }) => {
    before = old;
    return { surface: resizedSurface(old, u, v), chosen: noNetPoints };
  }, `surface-net-${which}`);
  const after = editor.state.value.surface;
  if (after === before) return;
  const change = largestDistance(before, after);
  if (change > 1e-9 * extentOf(after).radius) editor.notify({ kind: "toast", text: `${u} × ${v} points: the surface moved by up to ${printed(change)}.` });
}

/** More control points around the chosen one, none elsewhere; the surface stays where it is. */
export function refineHere(editor: Editor): void {
  const { surface, chosen } = editor.state.value;
  const [ref] = chosen;
  const point = ref === undefined ? undefined : shownPoint(surface, ref);
  if (ref === undefined || point === undefined) return refuse(editor, "Select a control point first: refining happens around it.");
  const before = surface.details?.length ?? 0;
  tryChange(editor, "Refine here", (now) => ({ surface: refinedHere(now.surface, point), chosen: now.chosen }));
  const details = editor.state.value.surface.details ?? [];
  const added = details[before];
  if (added !== undefined) editor.notify({ kind: "toast", text: `Added ${added.u.count * added.v.count} finer points. The surface did not move.` });
}

export function chooseNet(editor: Editor, chosen: readonly NetRef[], keyboard = false): void {
  editor.patch({ chosen, keyboard, hint: "" });
}

export function toggleChosen(editor: Editor, ref: NetRef): void {
  const { chosen } = editor.state.value;
  chooseNet(editor, isChosen(chosen, ref) ? chosen.filter((other) => !sameNetPoint(other, ref)) : [...chosen, ref]);
}

/** Steps from point to point, in the order of the net. */
export function stepNet(editor: Editor, step: 1 | -1, extend: boolean): void {
  const { surface, chosen } = editor.state.value;
  const all = netPoints(surface);
  const last = chosen.at(-1);
  const at = last === undefined ? (step === 1 ? -1 : 0) : all.findIndex((point) => sameNetPoint(point.ref, last));
  const next = all[(at + step + all.length) % all.length];
  if (next === undefined) return;
  chooseNet(editor, extend ? [...chosen.filter((ref) => !sameNetPoint(ref, next.ref)), next.ref] : [next.ref], true);
  editor.notify({ kind: "announce", text: describeNet(next) });
}

export function chooseAllNet(editor: Editor): void {
  chooseNet(editor, netPoints(editor.state.value.surface).map(({ ref }) => ref));
}

/** "Control point 3, 2, on the surface, x 0.7, y 0, z 0.7". */
export function describeNet(point: ShownPoint): string {
  const { ref, at, on } = point;
  const name = ref.detail === undefined ? `Control point ${ref.u + 1}, ${ref.v + 1}` : `Finer point ${ref.u + 1}, ${ref.v + 1} of refined area ${ref.detail + 1}`;
  const short = (value: number): string => String(Math.round(value * 1000) / 1000 + 0);
  const where = on ? "on the surface" : "near the surface";
  return `${name}, ${where}, x ${short(at[0])}, y ${short(at[1])}, z ${short(at[2])}`;
}

/** Whether the surface turns away from the eye at a point. */
export function facesAway(orbit: Orbit, point: ShownPoint): boolean {
  const { eye } = frameOf(orbit);
  const [x, y, z] = point.at;
  return (eye[0] - x) * point.normal[0] + (eye[1] - y) * point.normal[1] + (eye[2] - z) * point.normal[2] < 0;
}
