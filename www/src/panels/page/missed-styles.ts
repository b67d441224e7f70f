import type { Editor } from "../../editor/editor.ts";

/**
 * Who imports a part of the page asks for its program again, but never again for a style sheet: those that did not come
 * are asked for once others do.
 */
export function retryStyles({ notices }: Editor, until: AbortSignal): void {
  let missed: HTMLLinkElement[] = [];
  document.addEventListener("error", ({ target }) => {
    if (target instanceof HTMLLinkElement && target.rel === "stylesheet") missed.push(target);
  }, { capture: true, signal: until });
  notices.subscribe((notice) => {
    if (notice?.kind !== "well") return;
    const again = missed;
    missed = [];
    for (const link of again) link.replaceWith(link.cloneNode());
  }, { until });
}
