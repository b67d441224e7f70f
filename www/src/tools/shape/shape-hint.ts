import { shapeOf, type ShapeId } from "../../editor/curve/adding/shapes.ts";
import type { Editor } from "../../editor/editor.ts";

/** What the hint line says while a shape is drawn, and before. */

/** What Shift makes of each. */
const regular: Readonly<Record<ShapeId, string>> = { ellipse: "circle", rectangle: "square" };

function standing(shape: ShapeId, touch: boolean): string {
  const one = regular[shape];
  return touch
    ? `Drag from corner to corner, or tap for a ${one}. Two fingers move the view.`
    : `Drag from corner to corner; Shift for a ${one}, Alt from the centre. Click or press Enter for a ${one}.`;
}

/** Keys are told to those who have some. */
export function whileDrawing(shape: ShapeId, touch: boolean, says: readonly (string | null)[]): string {
  const keys = touch ? null : `Shift for a ${regular[shape]}, Alt from the centre, Space to move it`;
  return [...says, keys].filter((part) => part !== null).join("  ·  ");
}

/** While the tool is up, the line says what a press would do wherever there is nothing more particular to say. */
export function keepHint(editor: Editor): void {
  editor.state.subscribe((state, before) => {
    const { hint, drag, touch } = editor.state.value;
    const shape = shapeOf(editor.state.value);
    if (shape === null || drag !== null) return;
    // What was said of a drawing is over when that changes again.
    if (hint === "" || state.curve !== before.curve) editor.patch({ hint: standing(shape, touch) });
  }, { now: true });
}
