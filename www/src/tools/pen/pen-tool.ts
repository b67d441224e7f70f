import { replaceContour, type Command } from "../../document/curve/commands.ts";
import { reverseContour } from "../../document/curve/whole/commands.ts";
import { pullHandles, startName } from "../../document/curve/drawing/points.ts";
import { pointAt, type Offset, type PointRef } from "../../document/document.ts";
import { mostPoints, refuse } from "../../editor/curve/edits.ts";
import type { Editor } from "../../editor/editor.ts";
import { turnedBySteps } from "../../editor/pointer/snapping.ts";
import { nothingSketched } from "../../editor/sketch.ts";
import { distanceBetween, dragThreshold, type PointerSample, type Tool } from "../../editor/tool.ts";
import { Following } from "./following.ts";
import { endAt, firstPoint, joinedTo, nextPoint, rubberOf, type Drawn, type PathEnd, type Placement } from "./placing.ts";

/**
 * The pen: a click is a corner, a drag a point with handles, a click on the first point closes. The rubber band is the
 * segment itself, evaluated by the engine, and not a likeness of it.
 */
export function createPenTool(editor: Editor): Tool {
  return new Pen(editor);
}

/** A finger has no rubber band that would show it. */
const onTheWay = "Tap for a corner, drag for a smooth point. The first point closes, a double tap finishes.";

interface Press extends Pick<Placement, "ref" | "closing"> {
  readonly start: PointerSample;
}

class Pen implements Tool {
  readonly #editor: Editor;
  readonly #following = new Following();
  #drawing: number | null = null;
  #press: Press | null = null;

  constructor(editor: Editor) {
    this.#editor = editor;
    editor.state.subscribe(({ curve }, { curve: before }) => {
      if (curve === before) return;
      const was = this.#drawing;
      this.#drawing = this.#following.find(was, before.contours, curve.contours);
      if (this.#drawing === null) this.#quiet();
      else if (was === null && editor.state.value.touch) editor.patch({ hint: onTheWay });
    });
  }

  hover(sample: PointerSample): void {
    const { state } = this.#editor;
    const drawn = this.#drawn();
    const end = endAt(state.value, sample, drawn);
    const rubber = drawn === null ? null : rubberOf(state.value, drawn.contour, sample, end);
    const sketch = { ...nothingSketched, rubber, joint: end?.point ?? null };
    this.#editor.patch({ sketch, hover: { kind: "empty" }, cursor: rubber?.closing === true || end !== null ? "pointer" : "crosshair" });
  }

  press(sample: PointerSample): void {
    const drawn = this.#drawn();
    if (drawn === null) return this.#begin(sample);
    if (sample.clicks === 2) return void this.finish();
    const { value: state } = this.#editor.state;
    const end = endAt(state, sample, drawn);
    const join = end === null ? null : joinedTo(state, drawn, end);
    if (join !== null) return this.#join(join);
    if (drawn.contour.points.length >= mostPoints) return refuse(this.#editor, `A contour can have at most ${mostPoints} points.`);
    this.#place(sample, nextPoint(state, drawn, sample));
  }

  /** The end of another contour ends what is drawn. */
  #join(command: Command): void {
    this.#leave();
    this.#editor.dispatch(command);
    this.#editor.patch({ sketch: nothingSketched });
  }

  drag(sample: PointerSample): void {
    if (this.#press === null || distanceBetween(sample.screen, this.#press.start.screen) < dragThreshold[sample.kind]) return;
    const { ref } = this.#press;
    this.#editor.patch({ hint: sample.kind === "touch" ? "Drag to shape the handles." : "Drag to shape the handles; Shift for 15° steps, Alt for the next side only." });
    // Alt bends only what comes next: the side already drawn stays.
    this.#editor.dispatch(pullHandles(ref, this.#pulled(ref, sample), sample.modifiers.alt && ref.index > 0));
  }

  release(sample: PointerSample): void {
    if (this.#press === null) return;
    const { closing } = this.#press;
    this.#press = null;
    this.#editor.patch({ hint: sample.kind === "touch" && !closing ? onTheWay : "" });
    this.#editor.commit();
    if (closing) {
      this.#leave();
      this.#editor.patch({ sketch: nothingSketched });
    } else if (sample.kind !== "touch") this.hover(sample);
  }

  cancel(): boolean {
    if (this.#press === null) return this.finish();
    this.#press = null;
    this.#editor.patch({ hint: "" });
    this.#editor.bail();
    if (this.#drawn() === null) this.#leave();
    return true;
  }

  finish(): boolean {
    const drawn = this.#drawn();
    const began = this.#drawing !== null;
    this.#leave();
    this.#press = null;
    this.#editor.patch({ sketch: nothingSketched });
    if (drawn !== null && drawn.contour.points.length < 2) this.#drop(drawn);
    return began;
  }

  /** A single point is no path: it goes, and so does its entry, unless something else was done since. */
  #drop({ at }: Drawn): void {
    if (this.#editor.state.value.undoName === startName) this.#editor.undo();
    else this.#editor.dispatch({ name: "Drop point", apply: (curve) => replaceContour(curve, at) });
  }

  #quiet(): void {
    if (this.#editor.state.value.hint === onTheWay) this.#editor.patch({ hint: "" });
  }

  #leave(): void {
    this.#quiet();
    this.#drawing = null;
    this.#following.forget();
  }

  /** Undone, cleared or closed behind the pen's back, it is drawn no more. */
  #drawn(): Drawn | null {
    const at = this.#drawing;
    const contour = at === null ? undefined : this.#editor.state.value.curve.contours[at];
    return at === null || contour?.closed !== false ? null : { at, contour };
  }

  #begin(sample: PointerSample): void {
    const { state } = this.#editor;
    this.#leave();
    const end = endAt(state.value, sample, null);
    if (end === null) this.#place(sample, firstPoint(state.value, sample));
    else this.#goOn(sample, end);
  }

  #place(start: PointerSample, { command, ref, closing }: Placement): void {
    this.#editor.begin(command.name);
    this.#drawing = ref.contour;
    this.#press = { start, ref, closing };
    this.#editor.preview(command);
    if (!closing) this.#editor.patch({ sketch: nothingSketched });
  }

  #goOn(start: PointerSample, { contour, first }: PathEnd): void {
    this.#editor.begin("Continue path");
    const last = (this.#editor.state.value.curve.contours[contour]?.points.length ?? 1) - 1;
    const ref = { contour, index: last };
    const select = { points: [ref], handle: null };
    // A contour goes on at its end: taken up at its beginning, it is turned round first.
    if (first) this.#editor.preview({ ...reverseContour(contour), select });
    else this.#editor.patch({ selection: select });
    this.#drawing = contour;
    this.#press = { start, ref, closing: false };
    this.#editor.patch({ sketch: nothingSketched });
  }

  /** The leaving handle that ends under the pointer. */
  #pulled(ref: PointRef, { page, modifiers }: PointerSample): Offset {
    const point = pointAt(this.#editor.state.value.curve, ref) ?? page;
    const offset = { dx: page.x - point.x, dy: page.y - point.y };
    return modifiers.shift ? turnedBySteps(offset) : offset;
  }
}
