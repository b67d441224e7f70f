import { writeState } from "../../document/file/write.ts";
import type { Autosave, AutosaveOptions } from "./autosave.ts";
import { seal } from "./seal.ts";
import { keepAtOnce, rememberTab } from "./store.ts";

/**
 * Keeping begins with the first change; until then there is nothing to keep. Who leaves while what keeps drawings is on
 * its way, or did not come, has the last one kept all the same.
 */
export function createAutosave(options: AutosaveOptions): Autosave {
  const { busy, until } = options;
  const session = Math.random().toString(36).slice(2, 10).padEnd(8, "0");
  let keeping: Promise<Autosave> | null = null;
  let there = false;
  let missing = false;
  const begun = (): Promise<Autosave> => (keeping ??= import("./autosave.ts").then((loaded) => {
    there = true;
    return loaded.createAutosave(session, options);
  }));
  const tell = (is: boolean): void => {
    if (is !== missing) options.failing(is);
    missing = is;
  };
  const leave = ({ type }: Event): void => {
    if (there || keeping === null && !missing) return;
    if (busy()) {
      // Who only looks at another tab goes on with it.
      if (type !== "pagehide") return;
      options.abandon();
    }
    rememberTab(session);
    keepAtOnce(seal({ session, generation: 0, time: Date.now(), json: writeState(options.read()) }));
  };
  document.addEventListener("visibilitychange", (event) => document.hidden && leave(event), { signal: until });
  window.addEventListener("pagehide", leave, { signal: until });
  return {
    touch: () => void begun().then((autosave) => {
      tell(false);
      autosave.touch();
    }, () => {
      // The next change tries again.
      keeping = null;
      tell(true);
    }),
  };
}
