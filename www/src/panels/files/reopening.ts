import type { Mode } from "../../document/document.ts";
import type { Shell } from "../shell.ts";
import { openState, report } from "./report.ts";

/** What comes back from outside the page: a link's drawing, or what this browser has kept. */

export async function openLink(shell: Shell, hash: string): Promise<void> {
  try {
    if (openState(shell, await shell.io.readShareHash(hash), true)) shell.io.rememberTab(hash);
  } catch (error) {
    report(shell, error);
  }
}

/** The newest work, that of this tab before all other; in the mode that the address names. */
export async function restore(shell: Shell, own: string | null, mode: Mode | null): Promise<void> {
  const { editor, io, toasts } = shell;
  const last = await io.newestKept(own);
  if (last === null) return;
  const fresh = editor.getState();
  if (!openState(shell, { ...last.state, mode: mode ?? last.state.mode }, true)) return;
  toasts.say("Your last session was restored.", { label: "Start fresh", run: () => openState(shell, fresh, true) });
  const { damaged } = last;
  if (damaged === undefined) return;
  const save = (): void => {
    io.download("damaged.txt", new Blob([damaged.text], { type: "text/plain" }));
    void damaged.forget();
  };
  toasts.say("The latest copy of your work was damaged, so the one before it is open.", { label: "Download damaged copy", lasting: true, run: save });
}
