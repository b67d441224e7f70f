import type { Editor } from "../../editor/editor.ts";
import { shifted, turned } from "../../editor/surface/orbit.ts";
import { patchSolid } from "../../editor/surface/surface-edits.ts";
import type { Drag, PointerSample } from "../../editor/tool.ts";
import { rest } from "./resting.ts";

/** Turning the view; Shift moves it sideways. */
export function look(editor: Editor, start: PointerSample): Drag {
  const before = editor.state.value.solid.orbit;
  let at = start.screen;
  return {
    update({ screen, modifiers }) {
      const [dx, dy] = [screen.x - at.x, screen.y - at.y];
      at = screen;
      const { solid, stage } = editor.state.value;
      const orbit = modifiers.shift ? shifted(solid.orbit, stage, dx, dy) : turned(solid.orbit, dx, dy);
      patchSolid(editor, { orbit, turning: true });
      editor.patch({ cursor: "grabbing" });
    },
    finish: () => rest(editor),
    cancel() {
      patchSolid(editor, { orbit: before });
      rest(editor);
    },
  };
}
