import type { EditorState } from "../../editor/editor.ts";
import { mountBusy } from "../mode/busy.ts";
import type { Shell } from "../shell.ts";

/** Over the stage: how far a fit has come that takes its time. */
export function mountFitProgress(shell: Shell): void {
  const { editor, until } = shell;
  const busy = mountBusy(shell, { label: "Fitting", about: "Stop and keep the previous curve.", testid: "fit-cancel", stop: () => editor.actions.run("fit-cancel") });
  const show = ({ mode, fitProgress: progress, fitRun: { since } }: EditorState): void => {
    busy.show(mode !== "fit" || since === null ? null : { since, value: progress, text: `Fitting · ${Math.round(100 * progress)} %` });
  };
  editor.state.subscribe((state, before) => {
    if (state.fitRun !== before.fitRun || state.fitProgress !== before.fitProgress || state.mode !== before.mode) show(state);
  }, { until });
  show(editor.state.value);
}
