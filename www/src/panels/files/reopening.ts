import type { Mode } from "../../document/document.ts";
import type { PageIo } from "../page-io.ts";
import type { Shell } from "../shell.ts";
import { openState, report } from "./report.ts";

/**
 * What comes back from outside the page: a link's drawing, or what this browser has kept. First it is read, and what
 * that gives puts it on the stage, so that nothing can happen there between.
 */

/** With `fresh` a page begins with it; else it is a step that can be taken back, as what was there may be work. */
export async function linked(shell: Shell, hash: string, fresh: boolean): Promise<() => void> {
  try {
    const state = await shell.io.readShareHash(hash);
    return () => {
      if (openState(shell, state, fresh)) shell.io.rememberTab(hash);
    };
  } catch (error) {
    return () => report(shell, error);
  }
}

/** The newest work, that of this tab before all other; in the mode that the address names. */
export async function kept(shell: Shell, own: string | null, mode: Mode | null): Promise<(() => void) | undefined> {
  const last = await shell.io.newestKept(own);
  return last === null ? undefined : () => restore(shell, last, mode);
}

function restore(shell: Shell, { state, damaged }: NonNullable<Awaited<ReturnType<PageIo["newestKept"]>>>, mode: Mode | null): void {
  const { editor, io, toasts } = shell;
  const fresh = editor.getState();
  if (!openState(shell, { ...state, mode: mode ?? state.mode }, true)) return;
  toasts.say("Your last session was restored.", { label: "Start fresh", run: () => openState(shell, fresh, true) });
  if (damaged === undefined) return;
  const save = (): void => {
    io.download("damaged.txt", new Blob([damaged.text], { type: "text/plain" }));
    void damaged.forget();
  };
  toasts.say("The latest copy of your work was damaged, so the one before it is open.", { label: "Download damaged copy", lasting: true, run: save });
}
