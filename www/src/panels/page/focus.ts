import type { Frame } from "../../editor/frame.ts";

/**
 * Where the focus goes when what has it is taken away, hidden or switched off: to what is beside it, else to the stage.
 * Left to the browser it would be nowhere, and the next key would begin at the top of the page.
 */
export function keepFocus(frame: Frame, stage: HTMLElement, until: AbortSignal): void {
  let last = stage;
  document.addEventListener("focusin", ({ target }) => { last = target as HTMLElement; }, { signal: until });
  frame.add("paint", () => {
    const { activeElement: now, body } = document;
    if ((now !== last && now !== body) || (last.getClientRects().length > 0 && !last.matches(":disabled"))) return;
    last.parentElement?.querySelector<HTMLElement>(":enabled")?.focus();
    if (document.activeElement === now) stage.focus();
  });
  // Not everything that a key takes away asks for a frame.
  document.addEventListener("keyup", () => frame.request(), { signal: until });
}
