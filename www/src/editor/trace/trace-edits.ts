import { traceSample, type TraceSample } from "../../document/trace/trace-samples.ts";
import { emptyTrace, isEmptyTrace, traceDefaults, withChoice, withPicture, type OwnPicture, type TraceDocument, type TraceSettings } from "../../document/trace/trace.ts";
import type { LeftOut } from "../../kernel/trace/job.ts";
import { pointCount, shownOutcome, type TraceOutcome } from "../../kernel/trace/outcome.ts";
import type { CurveDocument } from "../../document/document.ts";
import { fitted } from "../pointer/camera.ts";
import type { Editor, EditorState } from "../editor.ts";
import type { PointOfOutline, TraceView, TraceViewId } from "./trace-state.ts";

/** Everything that changes what is traced and how: each is one entry of Trace's history. */

export function setTraceView(editor: Editor, change: Partial<TraceView>): void {
  editor.patch({ traceView: { ...editor.state.value.traceView, ...change } });
}

/** Of outlines that came back without their picture there are two views. */
export function canView({ trace }: EditorState, view: TraceViewId): boolean {
  return trace.kept === undefined || view === "result" || view === "outline";
}

function change(editor: Editor, name: string, next: (trace: TraceDocument) => TraceDocument, run?: string): void {
  editor.traceEdits.dispatch(name, ({ trace }) => ({ trace: next(trace) }), run);
}

/** In a gesture (a slider that is dragged) everything is one step; outside, quick changes of one kind join. */
export function setTrace(editor: Editor, name: string, settings: Partial<TraceSettings>): void {
  const next = (trace: TraceDocument): TraceDocument => ({ ...trace, settings: { ...trace.settings, ...settings } });
  if (editor.traceEdits.inGesture) editor.traceEdits.preview(({ trace }) => ({ trace: next(trace) }));
  else change(editor, name, next, name);
}

/** What the present picture was opened with. */
export function ownSettings({ sample }: TraceDocument): TraceSettings {
  return { ...traceDefaults, ...traceSample(sample ?? "")?.settings };
}

export function openedSample({ id, settings }: TraceSample): TraceDocument {
  return { ...emptyTrace, sample: id, settings: { ...traceDefaults, ...settings } };
}

/** Opens a sample with its own good settings; false for a name that is none. */
export function openTraceSample(editor: Editor, id: string): boolean {
  const sample = traceSample(id);
  if (sample === undefined) return false;
  if (editor.state.value.mode !== "trace") editor.actions.run("mode-trace");
  change(editor, `Open ${sample.title}`, () => openedSample(sample));
  begun(editor);
  showBox(editor, sample);
  editor.patch({ hint: sample.note });
  return true;
}

/** A picture of somebody's own in place of what is there. Settings that were good for a sample are not for it. */
export function openPicture(editor: Editor, picture: OwnPicture): void {
  change(editor, `Open ${picture.name}`, (trace) => withPicture(trace.sample === undefined
    ? trace
    : { ...trace, settings: { ...traceDefaults, size: trace.settings.size } }, { picture }));
  showAnew(editor);
  showBox(editor, picture);
  editor.patch({ hint: "" });
}

function begun(editor: Editor): void {
  // "The previous picture is kept" is not true of the next one.
  editor.notify({ kind: "well" });
  showAnew(editor);
}

function showAnew(editor: Editor): void {
  setTraceView(editor, { chosen: null, over: null, view: "result" });
}

export function clearTrace(editor: Editor): void {
  change(editor, "Clear", (trace) => (isEmptyTrace(trace) ? trace : { ...emptyTrace, settings: { ...traceDefaults } }));
  begun(editor);
  editor.patch({ hint: "" });
}

/** How many flat colours are looked for unless somebody says otherwise. */
export const usualColors = 8;

/** Whether a picture in several flat colours is traced as ink on paper. */
export function losesColors({ trace: { settings }, traceRun: { picture } }: EditorState): boolean {
  return picture?.colored === true && settings.colors === 0 && settings.mode === "brightness";
}

/** A photograph is traced if that is what somebody wants. */
export function traceAnyway(editor: Editor): void {
  change(editor, "Trace anyway", (trace) => ({ ...trace, anyway: true }));
}

/** What was too small to be kept and may be missed, until a speckle is asked for that keeps it. */
export function leftOutOf({ trace, traceRun }: EditorState): LeftOut | null {
  const left = traceRun.outcome?.leftOut;
  return left !== undefined && trace.settings.speckle > left.keeping ? left : null;
}

export function keepSmall(editor: Editor): void {
  const left = leftOutOf(editor.state.value);
  if (left !== null) setTrace(editor, "Speckle", { speckle: left.keeping });
}

/** What is on the stage, with what was decided about its corners, and the numbers that are true of it. */
export function shownOf({ trace, traceRun }: EditorState): TraceOutcome | null {
  return traceRun.outcome === null ? null : shownOutcome(traceRun.outcome, trace.corners);
}

/** The outlines of that. */
export function drawingOf(state: EditorState): CurveDocument | null {
  return shownOf(state)?.drawing ?? null;
}

/** A corner becomes smooth, a smooth point a corner; the same once more takes it back. */
export function toggleCorner(editor: Editor, { contour, index }: PointOfOutline): void {
  const point = drawingOf(editor.state.value)?.contours[contour]?.points[index];
  if (point === undefined) return;
  const kind = point.kind === "cusp" ? "smooth" as const : "cusp" as const;
  change(editor, kind === "cusp" ? "Make corner" : "Smooth corner", (trace) => ({ ...trace, corners: withChoice(trace.corners, { x: point.x, y: point.y, kind }) }));
  editor.notify({ kind: "announce", text: kind === "cusp" ? "The point is now a corner" : "The corner is now smooth" });
}

/** The next or previous point of the outlines by keys. */
export function stepPoint(editor: Editor, by: number, corners: boolean): void {
  const drawing = drawingOf(editor.state.value);
  if (drawing === null) return;
  const all = drawing.contours.flatMap(({ points }, contour) => points.flatMap(({ kind }, index) => (!corners || kind === "cusp" ? [{ contour, index }] : [])));
  if (all.length === 0) return;
  const { chosen } = editor.state.value.traceView;
  const at = all.findIndex((each) => each.contour === chosen?.contour && each.index === chosen.index);
  const next = all[at === -1 ? (by > 0 ? 0 : all.length - 1) : (at + by + all.length) % all.length];
  if (next !== undefined) choosePoint(editor, next);
}

export function choosePoint(editor: Editor, chosen: PointOfOutline): void {
  setTraceView(editor, { chosen });
  editor.patch({ keyboard: true });
  editor.notify({ kind: "announce", text: describePoint(editor.state.value, chosen) });
}

/** "Point 3 of 12, corner, x 240, y 120". */
export function describePoint(state: EditorState, { contour, index }: PointOfOutline): string {
  const drawing = drawingOf(state);
  const point = drawing?.contours[contour]?.points[index];
  if (drawing === null || point === undefined) return "";
  const before = drawing.contours.slice(0, contour).reduce((sum, { points }) => sum + points.length, 0);
  return `Point ${before + index + 1} of ${pointCount(drawing)}, ${point.kind === "cusp" ? "corner" : "smooth"}, x ${point.x.toFixed(1)}, y ${point.y.toFixed(1)}`;
}

/** The size of what is on the stage, in pixels of the picture. */
export function sizeOf({ trace }: EditorState): { readonly width: number; readonly height: number } | null {
  return trace.picture ?? trace.kept ?? traceSample(trace.sample ?? "") ?? null;
}

/**
 * An icon of 16 pixels is shown as large as a drawing of its outlines would be; a picture of four is not all over the
 * stage.
 */
const mostZoom = 40;

/** The whole picture in view, with room around. */
export function showBox(editor: Editor, { width, height }: { readonly width: number; readonly height: number }): void {
  const { stage } = editor.state.value;
  editor.patch({ view: fitted({ minX: 0, minY: 0, maxX: width, maxY: height }, stage, mostZoom, 0.06) });
}
