import { placeShape, shapeOf, type ShapeId } from "../../editor/curve/adding/shapes.ts";
import type { Editor } from "../../editor/editor.ts";
import type { Tool } from "../../editor/tool.ts";
import { pressOrDrag } from "../press-or-drag.ts";
import { dragShape, snapTo } from "./dragging-shape.ts";
import { keepHint } from "./shape-hint.ts";

/** Draws ellipses and rectangles: a drag from corner to corner, or a click for a circle or a square around it. */
export function createShapeTool(editor: Editor): Tool {
  keepHint(editor);
  const gestures = pressOrDrag<ShapeId>({
    hit: () => shapeOf(editor.state.value) ?? "ellipse",
    begin: (start, shape) => dragShape(editor, start, shape),
    click(shape, sample) {
      const { curve } = editor.state.value;
      // The second click of two would put another over the first.
      if (sample.clicks === 1) placeShape(editor, shape, snapTo(editor.state.value, curve, sample).value);
    },
  });
  return {
    ...gestures,
    hover() {
      if (editor.state.value.cursor !== "crosshair") editor.patch({ cursor: "crosshair", hover: { kind: "empty" } });
    },
    finish: () => false,
  };
}
