import type { Engine } from "../../editor/editor.ts";
import { h } from "../controls/dom.ts";
import type { Shell } from "../shell.ts";

const patienceMs = 300;

/** What the stage says while the engine starts, and when it cannot. The rest of the page works either way. */
export function mountBoot({ editor, regions, until }: Shell): void {
  const slot = h("div", { class: "boot" });
  regions.stage.append(slot);
  let slow: ReturnType<typeof setTimeout> | null = null;
  const show = (engine: Engine): void => {
    if (slow !== null) clearTimeout(slow);
    slow = null;
    regions.stage.dataset["engine"] = engine.status;
    if (engine.status === "booting") slow = setTimeout(() => slot.replaceChildren(loading(engine.progress)), patienceMs);
    else if (engine.status === "failed") void import("./boot-failure.ts").then(({ failure }) => slot.replaceChildren(failure(engine)));
    else slot.remove();
  };
  editor.state.subscribe((state, before) => state.engine !== before.engine && show(state.engine), { until });
  show(editor.state.value.engine);
}

function loading(progress: number | null): HTMLElement {
  const percent = progress === null ? "" : ` ${Math.round(100 * progress)} %`;
  return h("p", { class: "boot-note", role: "status" }, `Loading the spline engine…${percent}`);
}
