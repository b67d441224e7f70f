import { cornerGripAt } from "../../../editor/curve/corners/grips.ts";
import { rounding } from "../../../editor/curve/on-demand.ts";
import type { Editor, Target } from "../../../editor/editor.ts";
import { reachOf } from "../../../editor/pointer/hit-test.ts";
import { nothingSketched } from "../../../editor/sketch.ts";
import type { Drag, PointerSample } from "../../../editor/tool.ts";
import { curveDrag } from "../curve-drag.ts";

/** Rounding the chosen corners by the grip of one. */

export function cornerUnder(editor: Editor, { screen, kind }: PointerSample): Target | null {
  // What rounds is on its way when a grip is under the pointer first.
  if (cornerGripAt(editor.state.value, screen, reachOf[kind]) === null) return null;
  void rounding.load().catch(() => undefined);
  return { kind: "grip", grip: "corner", cursor: "grab", hint: "Drag to round the selected corners. Type their radius under Selected." };
}

/** The radius follows the pointer along the middle between both sides, in whole steps where snapping is on. */
export function dragCorner(editor: Editor, start: PointerSample): Drag | null {
  const state = editor.state.value;
  const grip = cornerGripAt(state, start.screen, reachOf[start.kind]);
  if (grip === null) return null;
  const { unit } = grip;
  const radiusAt = ({ page, modifiers }: PointerSample): number => {
    const along = (page.x - start.page.x) * grip.inwards.dx + (page.y - start.page.y) * grip.inwards.dy;
    const free = Math.max(0, grip.radius + along * grip.sine);
    return editor.state.value.settings.snap && !modifiers.mod ? unit * Math.round(free / unit) : free;
  };
  let [isOver, isShown] = [false, false];
  editor.begin("Round corners");
  const drag = curveDrag(editor, (sample) => rounding(editor, ({ roundingOf }) => {
    if (isOver) return;
    isShown = true;
    const { command, says } = roundingOf(state, radiusAt(sample));
    editor.preview(command, {
      drag: { dx: sample.page.x - start.page.x, dy: sample.page.y - start.page.y, snapped: null, says },
      sketch: nothingSketched,
    });
  }));
  return {
    update: drag.update,
    finish(sample) {
      isOver = true;
      drag.finish(sample);
      // What rounds may come after a quick finger has gone.
      if (!isShown) rounding(editor, ({ roundCorners }) => roundCorners(editor, radiusAt(sample)));
    },
    cancel() {
      isOver = true;
      drag.cancel();
    },
  };
}
