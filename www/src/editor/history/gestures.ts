import type { Editor } from "../editor.ts";

/**
 * Does something that nobody's hand does, as what comes from a worker: where a gesture is open, as soon as it is over,
 * as its next move would undo it.
 */
export function betweenGestures(editor: Editor, work: () => void): void {
  if (!editor.inGesture) return work();
  const over = new AbortController();
  editor.state.subscribe(() => {
    if (editor.inGesture) return;
    over.abort();
    work();
  }, { until: over.signal });
}
