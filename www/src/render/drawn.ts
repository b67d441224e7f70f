import type { EditorState } from "../editor/editor.ts";

/**
 * What no painter looks at: a picture of thousands of points is not drawn again for a percent of progress, or an arrow
 * that becomes a hand.
 */
const undrawn: ReadonlySet<string> = new Set<keyof EditorState>(["traceProgress", "fitProgress", "cursor"]);

/** Whether the stage has to be drawn again. */
export function drawnDiffers(state: EditorState, before: EditorState): boolean {
  return (Object.keys(state) as (keyof EditorState)[]).some((key) => state[key] !== before[key] && !undrawn.has(key));
}
