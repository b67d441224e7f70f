import { addContours } from "../../document/curve/whole/commands.ts";
import { differentPoints, isJoined, type Pair } from "../../document/fit/fit.ts";
import { contourOfFit } from "../../kernel/fit/as-contour.ts";
import { createFitClient, isTooFew, type FitClient, type FitHandlers } from "../../kernel/fit/fit-client.ts";
import type { FitSubject } from "../../kernel/fit/job.ts";
import { fitWorkers } from "../../kernel/fit/start-worker.ts";
import type { Editor } from "../editor.ts";
import { betweenGestures } from "../history/gestures.ts";

/** Strokes drawn by hand in Curve: each becomes the contour with the fewest knots within a pixel or two of it. */

/** CSS pixels that the curve may be away from the hand: about as far as a hand trembles. */
const tremble = 1.5;
/** What turns by less is no corner but a hand that went on: radians. */
const leastCorner = 0.5;

export interface Freehand {
  /** A stroke that was drawn; its contour is added when it is there. */
  add(stroke: readonly Pair[]): void;
}

/** Fits in a worker of its own, that starts with the first stroke. */
export function connectFit(until: AbortSignal): (handlers: FitHandlers) => FitClient {
  return (handlers) => createFitClient(fitWorkers(until), handlers);
}

export function createFreehand(editor: Editor, connect: (handlers: FitHandlers) => FitClient): Freehand {
  /** Strokes wait for each other: none is dropped for a later one. */
  const waiting: { readonly subject: FitSubject; readonly tolerance: number; readonly line: readonly Pair[] }[] = [];

  const client = connect({
    progress: () => undefined,
    fitted(fits) {
      const contours = fits.map(({ curve }) => contourOfFit(curve));
      const count = contours.reduce((sum, { points }) => sum + points.length, 0);
      betweenGestures(editor, () => {
        const { select, ...adding } = addContours("Draw", contours, true);
        // What was drawn last is what the panel and the keys work on, unless the hand has gone on to something else.
        editor.dispatch(editor.state.value.tool === "draw" && select !== undefined ? { ...adding, select } : adding);
        editor.notify({ kind: "announce", text: `Stroke converted to a curve with ${count} points` });
        next();
      });
    },
    failed(code) {
      if (isTooFew(code)) refuse("That stroke was too short for a curve. Try a longer one.");
      else editor.notify({ kind: "error", id: "engine", text: `The stroke could not become a curve (${code === "" ? "unknown" : code}). Check the connection, then draw it again.` });
      next();
    },
    stopped: () => undefined,
    chart: () => undefined,
    restarted: () => undefined,
  });

  function refuse(text: string): void {
    editor.patch({ hint: text });
    editor.notify({ kind: "announce", text });
  }

  /** The line has become a curve, or nothing; another that is being drawn meanwhile stays. */
  function shown(line: readonly Pair[]): void {
    const { sketch } = editor.state.value;
    if (sketch.stroke === line) editor.patch({ sketch: { ...sketch, stroke: [] } });
  }

  function next(): void {
    const done = waiting.shift();
    if (done !== undefined) shown(done.line);
    start();
  }

  function start(): void {
    const [first] = waiting;
    if (first === undefined) return;
    client.fit(first.subject, { by: "error", tolerance: first.tolerance }, false);
    const done = client.idle();
    editor.loading.add(done);
    void done.then(() => editor.loading.delete(done));
  }

  return {
    add(data) {
      const stroke = { from: 0, to: data.length };
      const line = editor.state.value.sketch.stroke;
      if (differentPoints({ data }, stroke, 4) < 4) {
        shown(line);
        return refuse("Press and drag to draw.");
      }
      const strokes = [{ points: Float64Array.from(data.flat()), closed: isJoined({ data, closing: "auto" }, stroke) }];
      waiting.push({ subject: { strokes, degree: [1, 3], mix: 0.5, corners: leastCorner }, tolerance: tremble / editor.state.value.view.zoom, line });
      if (waiting.length === 1) start();
    },
  };
}
