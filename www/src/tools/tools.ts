import type { Editor, ToolId } from "../editor/editor.ts";
import { lazyTool } from "../editor/loading.ts";
import type { Tool } from "../editor/tool.ts";
import { createHandTool } from "./hand/hand-tool.ts";
import { createSelectTool } from "./select/select-tool.ts";

/** The pen of a page that many visit without ever drawing with it. */
function latePen(editor: Editor): Tool {
  return lazyTool(editor, ({ tool }) => tool === "pen", async () => (await import("./pen/pen-tool.ts")).createPenTool(editor));
}

/** Drawing by hand brings the fit with it. */
function lateDraw(editor: Editor, until: AbortSignal): Tool {
  return lazyTool(editor, ({ tool, mode }) => tool === "draw" && mode === "curve", async () => {
    const [{ createDrawTool }, { createFreehand, connectFit }] = await Promise.all([import("./draw/draw-tool.ts"), import("../editor/fit/freehand.ts")]);
    return createDrawTool(editor, createFreehand(editor, connectFit(until)));
  });
}

/** Ellipses and rectangles are drawn in one way. */
function lateShape(editor: Editor): Tool {
  return lazyTool(editor, ({ tool }) => tool === "ellipse" || tool === "rectangle", async () => (await import("./shape/shape-tool.ts")).createShapeTool(editor));
}

/** Every tool of the rail. Another tool coming up ends what the last one had begun. */
export function createTools(editor: Editor, until: AbortSignal, pen: Tool = latePen(editor), draw: Tool = lateDraw(editor, until)): Readonly<Record<ToolId, Tool>> {
  const shape = lateShape(editor);
  const tools = { select: createSelectTool(editor), pen, draw, ellipse: shape, rectangle: shape, hand: createHandTool(editor) };
  editor.state.subscribe((state, before) => {
    if (state.tool === before.tool && state.mode === before.mode) return;
    tools[before.tool].finish();
  });
  return tools;
}
