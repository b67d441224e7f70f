import type { Editor, ToolId } from "../editor/editor.ts";
import type { Tool } from "../editor/tool.ts";
import { createDrawTool } from "./draw/draw-tool.ts";
import { createHandTool } from "./hand/hand-tool.ts";
import { createPenTool } from "./pen/pen-tool.ts";
import { createSelectTool } from "./select/select-tool.ts";

/** Every tool of the rail. Another tool coming up ends what the last one had begun. */
export function createTools(editor: Editor): Readonly<Record<ToolId, Tool>> {
  const tools = { select: createSelectTool(editor), pen: createPenTool(editor), draw: createDrawTool(editor), hand: createHandTool(editor) };
  editor.state.subscribe((state, before) => {
    if (state.tool === before.tool && state.mode === before.mode) return;
    tools[before.tool].finish();
  });
  return tools;
}
