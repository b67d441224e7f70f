import { reverseContour, type Command } from "../../document/curve/commands.ts";
import { closeDrawn, cornerAt, growContour, pullHandles, startContour } from "../../document/curve/drawing.ts";
import { nothingSelected, type Contour, type ControlPoint, type Offset, type PointRef } from "../../document/document.ts";
import { toScreen, type PagePoint } from "../../editor/pointer/camera.ts";
import { nothingSketched } from "../../editor/sketch.ts";
import { mostPoints, refuse } from "../../editor/curve/edits.ts";
import type { Editor } from "../../editor/editor.ts";
import { constrained, snapPlace, turnedBySteps } from "../../editor/pointer/snapping.ts";
import { distanceBetween, dragThreshold, type PointerSample, type Tool } from "../../editor/tool.ts";

/**
 * The pen: a click is a corner, a drag a point with handles, a click on the first point closes. The rubber band is the
 * segment itself, evaluated by the engine, and not a likeness of it.
 */

const closeReach = 10;

export function createPenTool(editor: Editor): Tool {
  /** The contour that the pen is drawing; it is always the last point that goes on. */
  let drawing: number | null = null;
  let press: { start: PointerSample; ref: PointRef; closing: boolean } | null = null;

  function current(): Contour | undefined {
    const contour = drawing === null ? undefined : editor.state.value.curve.contours[drawing];
    // Undone, cleared or closed behind the pen's back: it starts anew.
    return contour?.closed === false ? contour : undefined;
  }

  function closes(sample: PointerSample): boolean {
    const contour = current();
    return contour !== undefined && contour.points.length >= 2 && isAt(contour.points[0], sample);
  }

  function isAt(point: ControlPoint | undefined, sample: PointerSample): boolean {
    const { view, stage } = editor.state.value;
    return point !== undefined && distanceBetween(toScreen(view, stage, point), sample.screen) <= closeReach * (sample.kind === "touch" ? 2 : 1);
  }

  /** The open contour with an end under the pointer: the pen goes on from there. */
  function endAt(sample: PointerSample): { contour: number; first: boolean } | null {
    for (const [contour, { closed: isClosed, points, family }] of editor.state.value.curve.contours.entries()) {
      if (isClosed || family === "interpolating") continue;
      if (isAt(points.at(-1), sample)) return { contour, first: false };
      if (isAt(points[0], sample)) return { contour, first: true };
    }
    return null;
  }

  function goOn(sample: PointerSample, end: { contour: number; first: boolean }): void {
    const at = end.contour;
    editor.begin("Continue path");
    const last = (editor.state.value.curve.contours[at]?.points.length ?? 1) - 1;
    const ref = { contour: at, index: last };
    const select = { points: [ref], handle: null };
    // A contour goes on at its end: taken up at its beginning, it is turned round first.
    if (end.first) editor.preview({ ...reverseContour(at), select });
    else editor.patch({ selection: select });
    drawing = at;
    press = { start: sample, ref, closing: false };
    editor.patch({ sketch: nothingSketched });
  }

  function placed(sample: PointerSample): PagePoint {
    const { curve, settings, view } = editor.state.value;
    const last = current()?.points.at(-1);
    if (sample.modifiers.shift && last !== undefined) {
      const step = constrained(sample.page.x - last.x, sample.page.y - last.y);
      return { x: last.x + step.dx, y: last.y + step.dy };
    }
    if (!settings.snap || sample.modifiers.mod) return sample.page;
    return snapPlace(curve, nothingSelected, sample.page, view.zoom, settings.overlays.grid ? settings.gridStep : null).value;
  }

  /** The place of the next point: a command, and which point it is about. */
  function next(sample: PointerSample): { command: Command; ref: PointRef; closing: boolean } {
    const contour = current();
    const { curve } = editor.state.value;
    if (contour === undefined || drawing === null) {
      return { command: startContour(curve, placed(sample)), ref: { contour: curve.contours.length, index: 0 }, closing: false };
    }
    if (closes(sample)) return { command: closeDrawn(drawing, contour), ref: { contour: drawing, index: 0 }, closing: true };
    return { command: growContour(drawing, contour, placed(sample)), ref: { contour: drawing, index: contour.points.length }, closing: false };
  }

  /** The leaving handle that ends under the pointer. */
  function pulled(ref: PointRef, sample: PointerSample): Offset {
    const point = editor.state.value.curve.contours[ref.contour]?.points[ref.index] ?? sample.page;
    const offset = { dx: sample.page.x - point.x, dy: sample.page.y - point.y };
    return sample.modifiers.shift ? turnedBySteps(offset) : offset;
  }

  function rubber(sample: PointerSample): void {
    const contour = current();
    const last = contour?.points.at(-1);
    if (contour === undefined || last === undefined) return editor.patch({ sketch: nothingSketched, hover: { kind: "empty" }, cursor: "crosshair" });
    const closing = closes(sample);
    const first = contour.points[0];
    const to = closing && first !== undefined ? first : cornerAt(placed(sample));
    const omega = contour.omega === undefined ? {} : { omega: [contour.omega.at(-1) ?? 0] };
    const preview: Contour = { family: "hermite", closed: false, points: [last, to], ...omega };
    editor.patch({ sketch: { ...nothingSketched, rubber: { contour: preview, closing } }, hover: { kind: "empty" }, cursor: closing ? "pointer" : "crosshair" });
  }

  function stop(): boolean {
    const contour = current();
    const at = drawing;
    const began = drawing !== null;
    drawing = null;
    press = null;
    editor.patch({ sketch: nothingSketched });
    // A single point is no path: it goes, and so does its entry.
    if (contour !== undefined && at !== null && contour.points.length < 2) editor.undo();
    return began;
  }

  return {
    hover: rubber,
    press(sample) {
      const contour = current();
      if (contour === undefined) drawing = null;
      if (sample.clicks === 2 && contour !== undefined) return void stop();
      if (contour !== undefined && contour.points.length >= mostPoints) return refuse(editor, `A contour holds at most ${mostPoints} points here.`);
      const end = contour === undefined ? endAt(sample) : null;
      if (end !== null) return goOn(sample, end);
      const { command, ref, closing } = next(sample);
      editor.begin(command.name);
      drawing = ref.contour;
      press = { start: sample, ref, closing };
      editor.preview(command);
      if (!closing) editor.patch({ sketch: nothingSketched });
    },
    drag(sample) {
      if (press === null || distanceBetween(sample.screen, press.start.screen) < dragThreshold[sample.kind]) return;
      const { ref } = press;
      // Alt bends only what comes next: the side already drawn stays.
      editor.dispatch(pullHandles(ref, pulled(ref, sample), sample.modifiers.alt && ref.index > 0));
    },
    release(sample) {
      if (press === null) return;
      const { closing } = press;
      press = null;
      editor.commit();
      if (closing) {
        drawing = null;
        editor.patch({ sketch: nothingSketched });
      } else if (sample.kind !== "touch") rubber(sample);
    },
    cancel() {
      if (press !== null) {
        press = null;
        editor.bail();
        if (current() === undefined) drawing = null;
        return true;
      }
      return stop();
    },
    finish: stop,
  };
}
