import { addContours, cleared } from "../../document/curve/commands.ts";
import { filledTogether, type FilledDrawing } from "../../kernel/paths/filling.ts";
import type { Editor } from "../editor.ts";

/**
 * Adds contours to the drawing, or puts them in its place. What comes to others is chosen, ready to be moved from where it
 * lies over them; an import that is alone is looked at first.
 */
export function addDrawing(editor: Editor, name: string, drawing: FilledDrawing, how: "add" | "replace"): void {
  const isChosen = name === "Paste" || (how === "add" && editor.state.value.curve.contours.length > 0);
  editor.dispatch({
    ...addContours(name, drawing.contours, isChosen),
    apply(curve) {
      const before = how === "add" ? curve : cleared(curve);
      const { filling: _old, ...rest } = before;
      return { ...rest, ...filledTogether(before, drawing) };
    },
  });
}
