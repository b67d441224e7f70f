import type { Editor, Grip, Target } from "../../../editor/editor.ts";
import type { Drag, PointerSample } from "../../../editor/tool.ts";
import { cornerUnder, dragCorner } from "./dragging-corner.ts";
import { dragFrame, gripUnder as frameUnder } from "./dragging-frame.ts";

/** The grips of what is chosen: those of its corners, and those of the frame around whole contours. */

export function gripUnder(editor: Editor, sample: PointerSample): Target | null {
  return cornerUnder(editor, sample) ?? frameUnder(editor, sample);
}

export function dragGrip(editor: Editor, start: PointerSample, grip: Grip): Drag | null {
  return grip === "corner" ? dragCorner(editor, start) : dragFrame(editor, start, grip);
}
