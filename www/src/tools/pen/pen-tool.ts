import { replaceContour, reverseContour, type Command } from "../../document/curve/commands.ts";
import { noOffset, nothingSelected, type Contour, type ControlPoint, type CurveDocument, type Offset, type PointRef } from "../../document/document.ts";
import { opposite } from "../../document/curve/offset.ts";
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

function corner(place: PagePoint): ControlPoint {
  return { x: place.x, y: place.y, kind: "cusp", in: noOffset, out: noOffset };
}

function withOut(point: ControlPoint, out: Offset): ControlPoint {
  return { ...point, kind: "symmetric", out, in: opposite(out) };
}

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

  /** The contour with its next point, as a document change. */
  function addPoint(place: PagePoint): { command: Command; ref: PointRef } {
    const contour = current();
    const { curve } = editor.state.value;
    if (contour === undefined || drawing === null) {
      const index = curve.contours.length;
      const fresh: Contour = { family: "hermite", closed: false, points: [corner(place)], support: 1 };
      const ref = { contour: index, index: 0 };
      return {
        ref,
        command: { name: "Start path", apply: (document) => ({ ...document, contours: [...document.contours, fresh] }), select: { points: [ref], handle: null } },
      };
    }
    const grown = { ...contour, points: [...contour.points, corner(place)], ...grownArrays(contour) };
    const at = drawing;
    const ref = { contour: at, index: contour.points.length };
    return { ref, command: { name: "Add point", apply: (document) => replaceContour(document, at, grown), select: { points: [ref], handle: null } } };
  }

  function grownArrays(contour: Contour): Partial<Contour> {
    return {
      ...(contour.omega === undefined ? {} : { omega: [...contour.omega, contour.omega.at(-1) ?? 0] }),
      ...(contour.lengths === undefined ? {} : { lengths: [...contour.lengths, 1] }),
    };
  }

  function closed(contour: Contour, document: CurveDocument): Contour {
    // Closing must not change what the rubber band showed: an open contour's automatic frequency is 0.
    const omega = contour.omega ?? (document.omega === "auto" ? contour.points.slice(1).map(() => 0) : undefined);
    return {
      ...contour,
      closed: true,
      ...(omega === undefined ? {} : { omega: [...omega, omega.at(-1) ?? 0] }),
      ...(contour.lengths === undefined ? {} : { lengths: [...contour.lengths, 1] }),
    };
  }

  function pull(ref: PointRef, point: ControlPoint, sample: PointerSample): ControlPoint {
    let offset = { dx: sample.page.x - point.x, dy: sample.page.y - point.y };
    if (sample.modifiers.shift) offset = turnedBySteps(offset);
    // Alt bends only what comes next: the side already drawn stays.
    return sample.modifiers.alt && ref.index > 0 ? { ...point, kind: "cusp", out: offset } : withOut(point, offset);
  }

  function rubber(sample: PointerSample): void {
    const contour = current();
    const last = contour?.points.at(-1);
    if (contour === undefined || last === undefined) return editor.patch({ sketch: nothingSketched, hover: { kind: "empty" }, cursor: "crosshair" });
    const closing = closes(sample);
    const first = contour.points[0];
    const next = closing && first !== undefined ? first : corner(placed(sample));
    const omega = contour.omega === undefined ? {} : { omega: [contour.omega.at(-1) ?? 0] };
    const preview: Contour = { family: "hermite", closed: false, points: [last, next], ...omega };
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
      const closing = closes(sample);
      const place = placed(sample);
      editor.begin(closing ? "Close path" : contour === undefined ? "Start path" : "Add point");
      if (closing && contour !== undefined && drawing !== null) {
        const at = drawing;
        press = { start: sample, ref: { contour: at, index: 0 }, closing };
        editor.preview({
          name: "Close path",
          apply: (document) => replaceContour(document, at, closed(contour, document)),
          select: { points: [press.ref], handle: null },
        });
        return;
      }
      const { command, ref } = addPoint(place);
      drawing = ref.contour;
      press = { start: sample, ref, closing };
      editor.preview(command);
      editor.patch({ sketch: nothingSketched });
    },
    drag(sample) {
      if (press === null || distanceBetween(sample.screen, press.start.screen) < dragThreshold[sample.kind]) return;
      const { ref } = press;
      editor.dispatch({
        name: "Pull handles",
        apply: (document) => {
          const contour = document.contours[ref.contour];
          if (contour === undefined) return document;
          return replaceContour(document, ref.contour, {
            ...contour,
            points: contour.points.map((point, i) => (i === ref.index ? pull(ref, point, sample) : point)),
          });
        },
      });
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
