import { nothingSelected, type Contour } from "../../document/document.ts";
import type { Editor } from "../editor.ts";

/** Contours that another mode has made, as the drawing in Curve: a copy, seen from where one was, ready to be edited. */
export function openInCurve(editor: Editor, name: string, contours: readonly Contour[], says: (points: number) => string): void {
  const { view } = editor.state.value;
  editor.patch({ mode: "curve", tool: "select" });
  editor.dispatch({
    name,
    apply: ({ sample: _gone, ...curve }) => ({ ...curve, space: "trigonometric", omega: "auto", level: 0, contours }),
    select: nothingSelected,
  });
  editor.setOverlay("bezier", false);
  editor.patch({ view, hint: "" });
  editor.notify({ kind: "toast", text: says(contours.reduce((sum, { points }) => sum + points.length, 0)) });
}
