import type { Pair } from "../../document/fit/fit.ts";
import type { Editor } from "../../editor/editor.ts";
import type { Freehand } from "../../editor/fit/freehand.ts";
import { distanceBetween, dragThreshold, type PointerSample, type Tool } from "../../editor/tool.ts";

/** Draws by hand: while the button is down a line, afterwards a curve. */

/** A hand does not mean two places nearer than this, in CSS pixels. */
const leastStep = 0.75;

export function createDrawTool(editor: Editor, freehand: Freehand): Tool {
  let press: { readonly start: PointerSample; readonly stroke: Pair[]; drawing: boolean } | null = null;

  function show(stroke: readonly Pair[]): void {
    editor.patch({ sketch: { ...editor.state.value.sketch, stroke } });
  }

  return {
    hover() {
      if (editor.state.value.cursor !== "crosshair") editor.patch({ cursor: "crosshair", hover: { kind: "empty" } });
    },
    press(sample) {
      press = { start: sample, stroke: [[sample.page.x, sample.page.y]], drawing: false };
    },
    drag(sample) {
      if (press === null) return;
      if (!press.drawing && distanceBetween(press.start.screen, sample.screen) < dragThreshold[sample.kind]) return;
      press.drawing = true;
      const least = leastStep / editor.state.value.view.zoom;
      for (const { x, y } of sample.trail ?? [sample.page]) {
        const last = press.stroke.at(-1);
        if (last === undefined || Math.hypot(x - last[0], y - last[1]) >= least) press.stroke.push([x, y]);
      }
      show([...press.stroke]);
    },
    release() {
      const done = press;
      press = null;
      if (done?.drawing === true) freehand.add(done.stroke);
    },
    cancel() {
      const had = press !== null;
      press = null;
      if (had) show([]);
      return had;
    },
    finish: () => false,
  };
}
