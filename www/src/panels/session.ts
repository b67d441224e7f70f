import { errorText } from "./errors.ts";
import { h } from "./dom.ts";
import { icon } from "./icons.ts";
import { openState, report } from "./report.ts";
import type { Shell } from "./shell.ts";

/**
 * What the page opens with beside a route: a shared link, or the last session of this browser. Resolves when it is on
 * the stage, so that "ready" means ready.
 */
export async function openSession(shell: Shell, address: string): Promise<void> {
  window.addEventListener("hashchange", () => void openLink(shell, window.location.hash), { signal: shell.until });
  if (isPlainAddress(address)) await restore(shell);
  else await openLink(shell, address);
  startKeeping(shell);
}

function isPlainAddress(hash: string): boolean {
  return hash === "" || hash === "#" || hash === "#/" || hash === "#/curve";
}

async function openLink(shell: Shell, hash: string): Promise<void> {
  if (!shell.io.isShareLink(hash)) return;
  try {
    openState(shell, await shell.io.readShareHash(hash), true);
  } catch (error) {
    report(shell, error);
  }
}

async function restore(shell: Shell): Promise<void> {
  const { editor, io, toasts } = shell;
  const last = await io.newestKept();
  if (last === null) return;
  const fresh = editor.getState();
  if (!openState(shell, last.state, true)) return;
  toasts.say("Restored your last session.", { label: "Start fresh", run: () => openState(shell, fresh, true) });
  const { damaged } = last;
  if (damaged === undefined) return;
  const save = (): void => {
    io.download("damaged.txt", new Blob([damaged.text], { type: "text/plain" }));
    void damaged.forget();
  };
  toasts.say("The newest copy of your work was damaged; the one before it is open.", { label: "Download the damaged copy", run: save });
}

function startKeeping(shell: Shell): void {
  const { editor, io, regions, until } = shell;
  const warning = h("button", { class: "metric not-kept", type: "button", testid: "error", "data-error": "storage", title: errorText("storage"), click: () => editor.actions.run("save-json") }, icon("warn"), "Not kept: download JSON");
  const keeping = io.createAutosave({
    read: () => editor.getState(),
    busy: () => editor.inGesture,
    failing: (failed) => (failed ? regions.status.append(warning) : warning.remove()),
    until,
  });
  // A drag changes the curve first and the history when it ends; only what the history knows is worth keeping.
  let seen = [editor.state.value.curve, editor.state.value.surface, editor.state.value.fit, editor.state.value.trace, editor.state.value.traceRun.outcome] as const;
  editor.state.subscribe((state) => {
    const now = [state.curve, state.surface, state.fit, state.trace, state.traceRun.outcome] as const;
    if (now.every((part, i) => part === seen[i]) || !(state.canUndo || state.canRedo)) return;
    seen = now;
    keeping.touch();
  }, { until });
}
