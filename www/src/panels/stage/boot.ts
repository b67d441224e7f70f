import type { Engine } from "../../editor/editor.ts";
import { h } from "../controls/dom.ts";
import type { Shell } from "../shell.ts";

const patienceMs = 300;

/** Says over the stage what is waited for, once that takes a while; null: nothing is. */
export type Wait = (text: string | null) => void;

/**
 * What the stage says while the engine starts or something else is waited for, and when it cannot. The rest of the page
 * works either way.
 */
export function mountBoot({ editor, regions, until }: Shell): Wait {
  const slot = h("div", { class: "boot" });
  regions.stage.append(slot);
  let slow: ReturnType<typeof setTimeout> | undefined;
  const wait: Wait = (text) => {
    clearTimeout(slow);
    if (text === null) return slot.replaceChildren();
    const say = (): void => slot.replaceChildren(h("p", { class: "boot-note", role: "status" }, text));
    // What is waited for next is said at once where something is said already.
    if (slot.firstChild === null) slow = setTimeout(say, patienceMs);
    else say();
  };
  const show = (engine: Engine): void => {
    regions.stage.dataset["engine"] = engine.status;
    wait(engine.status === "booting" ? "Loading the spline engine…" : null);
    if (engine.status === "failed") void import("./boot-failure.ts").then(({ failure }) => slot.replaceChildren(failure(engine)));
  };
  editor.state.subscribe((state, before) => state.engine !== before.engine && show(state.engine), { until });
  until.addEventListener("abort", () => clearTimeout(slow), { once: true });
  show(editor.state.value.engine);
  return wait;
}
