import type { Engine } from "../editor/editor.ts";
import { h } from "./dom.ts";
import type { Shell } from "./shell.ts";

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
    else if (engine.status === "failed") slot.replaceChildren(failure(engine));
    else slot.remove();
  };
  editor.state.subscribe((state, before) => state.engine !== before.engine && show(state.engine), { until });
  show(editor.state.value.engine);
}

function loading(progress: number | null): HTMLElement {
  const percent = progress === null ? "" : ` ${Math.round(100 * progress)} %`;
  return h("p", { class: "boot-note", role: "status" }, `Loading the spline engine…${percent}`);
}

function failure({ reason, detail }: Extract<Engine, { status: "failed" }>): HTMLElement {
  const retry = h("button", { class: "button primary", type: "button", click: () => window.location.reload() }, h("span", {}, "Try again"));
  const shared = { class: "boot-error", testid: "boot-error", role: "alert", "data-reason": reason };
  switch (reason) {
    case "blocked":
      return h("div", shared,
        h("h2", {}, "The spline engine was blocked"),
        h("p", {}, "This page's Content Security Policy does not allow WebAssembly. Add ", h("code", {}, "'wasm-unsafe-eval'"), " to ", h("code", {}, "script-src"), ", then load the page again."),
        h("p", {}, h("a", { href: "https://developer.mozilla.org/docs/Web/HTTP/Reference/Headers/Content-Security-Policy/script-src#unsafe_webassembly_execution" }, "What this setting does")),
        retry);
    case "unsupported":
      return h("div", shared,
        h("h2", {}, "This browser cannot run the spline engine"),
        h("p", {}, `E_INIT, reason: unsupported. ${detail} WebAssembly with SIMD is needed: Chrome 91, Firefox 89, Safari 16.4 or later.`),
        retry);
    case "failed":
      return h("div", shared, h("h2", {}, "The spline engine did not start"), h("p", {}, detail), h("p", {}, "Chrome 123, Firefox 128 and Safari 17.5 or later run this page."), retry);
  }
}
