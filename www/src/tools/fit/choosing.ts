import type { Editor } from "../../editor/editor.ts";
import { setFitView } from "../../editor/fit/fit-edits.ts";
import { knotAt } from "../../editor/fit/knot-hit.ts";
import type { PointerSample } from "../../editor/tool.ts";

/**
 * A click on a knot chooses it, with Shift beside others; beside all knots it chooses none. Says whether there was one.
 */
export function choose(editor: Editor, { screen, kind, modifiers }: PointerSample): boolean {
  const knot = knotAt(editor.state.value, screen, kind);
  const { chosen } = editor.state.value.fitView;
  if (knot === null) setFitView(editor, { chosen: [] });
  else if (!modifiers.shift) setFitView(editor, { chosen: [knot] });
  else setFitView(editor, { chosen: chosen.includes(knot) ? chosen.filter((each) => each !== knot) : [...chosen, knot] });
  return knot !== null;
}
