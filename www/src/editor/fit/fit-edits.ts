import {
  emptied, fitDefaults, fitLimits, isJoined, strokesOf, withPoint, withStrokes, withoutDisc, type FitClosing, type FitDocument, type FitModel, type FitTarget,
  type Pair,
} from "../../document/fit/fit.ts";
import { fitSample, samplePoints, type FitSample } from "../../document/fit/fit-samples.ts";
import type { KnotType, ShownKnot } from "../../kernel/fit/knots.ts";
import { fitted as fittedView } from "../pointer/camera.ts";
import type { Editor } from "../editor.ts";
import type { FitTool, FitView } from "./fit-state.ts";

/** Everything that changes what is fitted and how: each is one entry of Fit's history. */

export function setFitView(editor: Editor, change: Partial<FitView>): void {
  editor.patch({ fitView: { ...editor.state.value.fitView, ...change } });
}

/** The rail shows the same tool; panning is the rail's own. */
export function chooseFitTool(editor: Editor, tool: FitTool): void {
  setFitView(editor, { tool, brush: null, stroke: [] });
  editor.patch({ tool: tool === "draw" ? "draw" : tool === "points" ? "pen" : "select", hint: "" });
}

function change(editor: Editor, name: string, next: (fit: FitDocument) => FitDocument, run?: string): void {
  editor.fitEdits.dispatch(name, ({ fit }) => ({ fit: next(fit) }), run);
}

/** In a gesture (a slider that is dragged) everything is one step; outside, quick changes of one kind join. */
function adjust(editor: Editor, name: string, next: (fit: FitDocument) => FitDocument, run: string): void {
  if (editor.fitEdits.inGesture) editor.fitEdits.preview(({ fit }) => ({ fit: next(fit) }));
  else change(editor, name, next, run);
}

const clamped = (value: number, most: number): number => Math.min(most, Math.max(0, value));

/** Moving the slider is asking for what it says: a target no longer drives it. */
export function setSmoothing(editor: Editor, smoothing: number): void {
  adjust(editor, "Smoothing", (fit) => ({ ...fit, smoothing: clamped(smoothing, fitLimits.smoothing), target: "off" }), "smoothing");
}

/** The slider shows where a target has brought it; that is no step of its own. */
export function showSmoothing(editor: Editor, smoothing: number): void {
  const { fit } = editor.state.value;
  const next = Math.round(2 * clamped(smoothing, fitLimits.smoothing)) / 2;
  if (next !== fit.smoothing) editor.fitEdits.amend(({ fit: now }) => ({ fit: { ...now, smoothing: next } }));
}

export function setMix(editor: Editor, mix: number): void {
  adjust(editor, "Mix", (fit) => ({ ...fit, mix: clamped(mix, fitLimits.mix) }), "mix");
}

export function setModel(editor: Editor, model: FitModel): void {
  change(editor, "Model", (fit) => ({ ...fit, model }));
}

export function setCorners(editor: Editor, corners: boolean): void {
  change(editor, "Keep corners", (fit) => ({ ...fit, corners }));
}

export function setClosing(editor: Editor, closing: FitClosing): void {
  change(editor, "Closed", (fit) => ({ ...fit, closing }));
}

/** Which way y points: the numbers stay what they are. */
export function setUp(editor: Editor, up: boolean): void {
  change(editor, "Y axis", ({ up: _before, ...fit }) => (up ? { ...fit, up } : fit));
  showData(editor);
}

export function setTarget(editor: Editor, target: FitTarget): void {
  change(editor, "Target", (fit) => ({ ...fit, target }));
}

export function setTargetValue(editor: Editor, value: number): void {
  change(editor, "Target", (fit) => (fit.target === "knots" ? { ...fit, targetKnots: Math.floor(value) } : { ...fit, targetError: value }), "target");
}

/** A sample's points with other noise. */
export function setNoise(editor: Editor, noise: number, seed: number): void {
  const sample = fitSample(editor.state.value.fit.sample ?? "");
  if (sample === undefined) return;
  adjust(editor, "Noise", (fit) => ({ ...fit, noise, seed, ...samplePoints(sample, noise, seed) }), "noise");
}

export function opened(sample: FitSample): FitDocument {
  const { settings, id } = sample;
  return { ...settings, sample: id, ...samplePoints(sample, settings.noise, settings.seed) };
}

/** Opens a sample with its own good settings; false for a name that is none. */
export function openFitSample(editor: Editor, id: string): boolean {
  const sample = fitSample(id);
  if (sample === undefined) return false;
  if (editor.state.value.mode !== "fit") editor.actions.run("mode-fit");
  change(editor, `Open ${sample.title}`, () => opened(sample));
  setFitView(editor, { chosen: [] });
  showData(editor, sampleZoom);
  editor.patch({ hint: sample.note });
  return true;
}

/** Samples are as large as the stage, but not blown up. */
export const sampleZoom = 1.5;

/** All data in view, with room around. */
export function showData(editor: Editor, most?: number): void {
  const { fit, stage } = editor.state.value;
  const box = boxOf(fit.data);
  if (box === null) return editor.patch({ view: { zoom: 1, x: 400, y: 300 } });
  editor.patch({ view: fittedView(box, stage, most) });
}

export function boxOf(data: readonly Pair[]): { minX: number; minY: number; maxX: number; maxY: number } | null {
  if (data.length === 0) return null;
  const box = { minX: Infinity, minY: Infinity, maxX: -Infinity, maxY: -Infinity };
  for (const [x, y] of data) {
    box.minX = Math.min(box.minX, x);
    box.minY = Math.min(box.minY, y);
    box.maxX = Math.max(box.maxX, x);
    box.maxY = Math.max(box.maxY, y);
  }
  return box;
}

/**
 * A sample as it was opened gives way to what is drawn or brought in, and its settings to the usual ones, but for those
 * that somebody has set; what was worked on is added to.
 */
export function base(fit: FitDocument): FitDocument {
  if (fit.sample === undefined) return fit;
  const set: Partial<FitDocument> = fitSample(fit.sample)?.settings ?? {};
  const mine = Object.entries(emptied(fit)).filter(([name, value]) => set[name as keyof FitDocument] !== value);
  return { ...fitDefaults, data: [], ...Object.fromEntries(mine), starts: [], closing: "auto" };
}

export function addStroke(editor: Editor, stroke: readonly Pair[]): void {
  change(editor, "Draw", (fit) => withStrokes(base(fit), [{ places: stroke }]));
}

/** A point at the end of the last stroke, or the first of a new one. */
export function addPoint(editor: Editor, point: Pair, begins: boolean): void {
  change(editor, "Add point", (fit) => (begins ? withStrokes(base(fit), [{ places: [point] }]) : withPoint(fit, point)));
}

export function eraseAt(editor: Editor, x: number, y: number, radius: number): void {
  editor.fitEdits.preview(() => ({ fit: withoutDisc(editor.state.value.fit, x, y, radius) }));
}

export function clearFit(editor: Editor): void {
  change(editor, "Clear", (fit) => (fit.data.length === 0 ? fit : emptied(base(fit))));
  setFitView(editor, { chosen: [] });
}

/** "One closed stroke of 300 points". */
export function describeData(fit: FitDocument): string {
  const strokes = strokesOf(fit);
  const closed = strokes.filter((stroke) => isJoined(fit, stroke)).length;
  if (strokes.length === 0) return "No points yet";
  const kind = strokes.length === 1 ? (closed === 1 ? "One closed stroke" : "One open stroke") : `${strokes.length} strokes, ${closed} closed`;
  return `${kind}, ${fit.data.length} points`;
}

const typeNames = { linear: "corner", cubic: "smooth knot", coincident: "corner and smooth knot" } as const;

/** "Knot 3 of 14, corner, x 240, y 120". */
export function describeKnot({ type, x, y }: ShownKnot, i: number, count: number): string {
  return `Knot ${i + 1} of ${count}, ${typeNames[type]}, x ${Math.round(x)}, y ${Math.round(y)}`;
}

/** The next or previous knot by keys. */
export function stepKnot(editor: Editor, by: number): void {
  const { fitRun, fitView } = editor.state.value;
  const count = fitRun.outcome?.knots.length ?? 0;
  if (count === 0) return;
  const last = fitView.chosen.at(-1);
  const next = last === undefined ? (by > 0 ? 0 : count - 1) : (last + by + count) % count;
  setFitView(editor, { chosen: [next] });
  editor.patch({ keyboard: true });
  const knot = fitRun.outcome?.knots[next];
  if (knot !== undefined) editor.notify({ kind: "announce", text: describeKnot(knot, next, count) });
}

/** Chooses every knot of a kind. */
export function chooseKnots(editor: Editor, type: KnotType): void {
  const knots = editor.state.value.fitRun.outcome?.knots ?? [];
  setFitView(editor, { chosen: knots.flatMap((knot, i) => (knot.type === type ? [i] : [])) });
}
