import type { EditorState } from "../../editor/editor.ts";
import type { FitFailure } from "../../editor/fit/fit-state.ts";
import { mountBusy } from "../mode/busy.ts";
import { engineFailure, mountNotice } from "../mode/notice.ts";
import type { Shell } from "../shell.ts";

/** Over the stage: how far a fit has come that takes its time, or that the engine gave none, with a way on. */
export function mountFitProgress(shell: Shell): void {
  const { editor, until } = shell;
  const busy = mountBusy(shell, { label: "Fitting", about: "Stop and keep the previous curve.", testid: "fit-cancel", stop: () => editor.actions.run("fit-cancel") });
  const say = mountNotice(shell);
  let said: FitFailure | null = null;

  const show = ({ mode, fitProgress: progress, fitRun: { since, failure } }: EditorState): void => {
    busy.show(mode !== "fit" || since === null ? null : { since, value: progress, text: `Fitting · ${Math.round(100 * progress)} %` });
    const shown = mode === "fit" && since === null && failure?.id === "engine" ? failure : null;
    if (shown === said) return;
    said = shown;
    say(shown === null ? null : engineFailure(shown.details.code, "Your points are safe; the engine was restarted.", () => editor.actions.run("fit-again")));
  };
  editor.state.subscribe((state, before) => {
    if (state.fitRun !== before.fitRun || state.fitProgress !== before.fitProgress || state.mode !== before.mode) show(state);
  }, { until });
  show(editor.state.value);
}
