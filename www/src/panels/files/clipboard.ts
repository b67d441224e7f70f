import type { Contour, CurveDocument } from "../../document/document.ts";
import { duplicateContours } from "../../document/curve/whole/commands.ts";
import { addDrawing } from "../../editor/curve/adding/drawing.ts";
import type { Editor } from "../../editor/editor.ts";
import { toScreen } from "../../editor/pointer/camera.ts";

/** What an editor copied last, and as what text: pasted there, it is what it was, and not what SVG can say of it. */
const copies = new WeakMap<Editor, { readonly text: string; readonly drawing: CurveDocument }>();

/** Clipboards have line ends of their own. */
function plain(text: string): string {
  return text.replace(/\r\n?/gu, "\n").trim();
}

export function rememberCopy(editor: Editor, text: string, drawing: CurveDocument): void {
  copies.set(editor, { text: plain(text), drawing });
}

/** Pastes what was copied here, chosen: in its old place, or beside what is there already. False for any other text. */
export function pasteCopy(editor: Editor, text: string): boolean {
  const { mode, curve, view } = editor.state.value;
  const copied = copies.get(editor);
  if (copied === undefined || mode !== "curve" || copied.text !== plain(text)) return false;
  const { drawing } = copied;
  // Points mean a curve by the settings of their drawing.
  if (drawing.space !== curve.space || drawing.omega !== curve.omega || drawing.level !== curve.level) return false;
  const step = 16 / view.zoom;
  let by = 0;
  while (curve.contours.some((contour) => stands(contour, drawing.contours[0], by, step))) by += step;
  const contours = duplicateContours([...drawing.contours.keys()], by).copies(drawing);
  addDrawing(editor, "Paste", { ...drawing, contours }, "add");
  if (!contours.some((contour) => isSeen(editor, contour))) editor.actions.run("zoom-fit");
  return true;
}

/** Whether a contour is the other one moved by so much, or lies on it for the eye. */
function stands(contour: Contour, other: Contour | undefined, by: number, step: number): boolean {
  return other !== undefined && contour.points.length === other.points.length && other.points.every(({ x, y }, i) => {
    const point = contour.points[i];
    return point !== undefined && Math.hypot(point.x - x - by, point.y - y - by) < step / 8;
  });
}

function isSeen(editor: Editor, contour: Contour): boolean {
  const { view, stage } = editor.state.value;
  return contour.points.some((point) => {
    const { x, y } = toScreen(view, stage, point);
    return x >= 0 && y >= 0 && x <= stage.width && y <= stage.height;
  });
}
