import type { Setting } from "../../../document/artboard.ts";
import { cleared } from "../../../document/curve/commands.ts";
import { addContours } from "../../../document/curve/whole/commands.ts";
import { filledTogether, type FilledDrawing } from "../../../kernel/paths/filling.ts";
import type { Editor } from "../../editor.ts";

/**
 * Adds contours to the drawing, or puts them in its place. What comes to others is chosen, ready to be moved from where
 * it lies over them; an import that is alone is looked at first, and brings its artboard.
 */
export function addDrawing(editor: Editor, name: string, drawing: FilledDrawing & Setting, how: "add" | "replace"): void {
  const isChosen = name === "Paste" || (how === "add" && editor.state.value.curve.contours.length > 0);
  editor.dispatch({
    ...addContours(name, drawing.contours, isChosen),
    apply(curve) {
      const before = how === "add" ? curve : cleared(curve);
      const { filling: _old, artboard: own, ...rest } = before;
      const artboard = before.contours.length === 0 ? drawing.artboard : own;
      return { ...rest, ...filledTogether(before, drawing), ...(artboard === undefined ? {} : { artboard }) };
    },
  });
}
