import type { ContractParts } from "./contract.ts";
import type { Mode } from "./document/document.ts";
import type { Editor } from "./editor/editor.ts";
import { askedFor, sayMissing } from "./editor/loading.ts";
import type { Frame } from "./editor/frame.ts";
import type { Panels } from "./panels/mount.ts";
import type { Wait } from "./panels/stage/boot.ts";
import type { Stage } from "./render/stage.ts";

/** What a mode is put together with when it is first opened. */
export interface ModeParts {
  readonly editor: Editor;
  readonly frame: Frame;
  readonly stage: Stage;
  readonly surface: HTMLElement;
  /** Where buttons for what is on the stage are put. */
  readonly proxies: HTMLElement;
  readonly panels: Panels;
  readonly contract: ContractParts;
  readonly until: AbortSignal;
}

/** Modes that are loaded when they are first opened: the page of somebody who never does is not the heavier for it. */
export interface ModeLoader {
  /** Resolves when every mode that was asked for is there. */
  settled(): Promise<void>;
}

export function loadModes(editor: Editor, loaders: Partial<Record<Mode, () => Promise<void>>>, wait: Wait, until: AbortSignal): ModeLoader {
  const asked = new Map<Mode, Promise<void>>();
  const coming = new Set<Mode>();
  const sayComing = (): void => wait(coming.has(editor.state.value.mode) ? "Loading…" : null);
  const ask = (mode: Mode): void => {
    const load = loaders[mode];
    if (load === undefined || asked.has(mode) || editor.state.value.engine.status !== "ready") return;
    coming.add(mode);
    const sayThere = askedFor(editor);
    asked.set(mode, load().then(() => {
      // What is shown of the mode as soon as it is there is looked up again.
      editor.patch({ hint: "" });
      sayThere();
    }).catch((error: unknown) => {
      // The next visit tries again: a connection may have been lost for a moment.
      asked.delete(mode);
      sayMissing(editor, "This mode", error);
    }).finally(() => {
      coming.delete(mode);
      sayComing();
    }));
  };
  editor.state.subscribe(({ mode, engine }, before) => {
    if (mode === before.mode && engine === before.engine) return;
    ask(mode);
    sayComing();
  }, { until });
  ask(editor.state.value.mode);
  sayComing();
  return {
    async settled() {
      await Promise.all(asked.values());
    },
  };
}
