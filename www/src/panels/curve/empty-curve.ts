import type { EditorState } from "../../editor/editor.ts";
import { whileLoading } from "../../editor/loading.ts";
import type { Shell } from "../shell.ts";

function isEmpty(state: EditorState): boolean {
  return state.mode === "curve" && state.engine.status === "ready" && state.curve.contours.length === 0 && (state.tool === "select" || state.tool === "hand");
}

/** An empty drawing: the pen, or three samples to start from. Presses beside the buttons go through to the stage. */
export function mountEmptyCurve({ editor, regions, until }: Shell): void {
  let card: HTMLElement | null = null;
  const offer = async (): Promise<void> => {
    // While the page starts, the drawing is empty for a moment: nothing is loaded for that.
    await Promise.resolve();
    if (!isEmpty(editor.state.value)) return;
    const { emptyCard } = await import("./empty-card.ts");
    if (card !== null || !isEmpty(editor.state.value)) return;
    card = emptyCard(editor);
    regions.stage.append(card);
  };
  const update = (state: EditorState): void => {
    if (!isEmpty(state)) {
      card?.remove();
      card = null;
    } else if (card === null) void whileLoading(editor, offer());
  };
  editor.state.subscribe(update, { now: true, until });
}
