import type { Engine } from "../../editor/editor.ts";
import { h } from "../controls/dom.ts";

/** Why the engine did not start, and what helps. */
export function failure({ reason, detail }: Extract<Engine, { status: "failed" }>): HTMLElement {
  const retry = h("button", { class: "button primary", type: "button", click: () => window.location.reload() }, h("span", {}, "Try again"));
  const shared = { class: "boot-error", testid: "boot-error", role: "alert", "data-reason": reason };
  switch (reason) {
    case "blocked":
      return h("div", shared,
        h("h2", {}, "The spline engine was blocked"),
        h("p", {},
          "This page's Content Security Policy does not allow WebAssembly. Add ",
          h("code", {}, "'wasm-unsafe-eval'"),
          " to ",
          h("code", {}, "script-src"),
          ", then load the page again.",
        ),
        h("p", {}, h("a", { href: "https://developer.mozilla.org/docs/Web/HTTP/Reference/Headers/Content-Security-Policy/script-src#unsafe_webassembly_execution" },
          "About this setting",
        )),
        retry);
    case "unsupported":
      return h("div", shared,
        h("h2", {}, "This browser cannot run the spline engine"),
        h("p", {}, `E_INIT, reason: unsupported. ${detail} WebAssembly with SIMD is needed: Chrome 91, Firefox 89, Safari 16.4 or later.`),
        retry);
    case "failed":
      return h("div", shared,
        h("h2", {}, "The spline engine did not start"),
        h("p", {}, detail),
        h("p", {}, "Chrome 123, Firefox 128 and Safari 17.5 or later run this page."),
        retry,
      );
  }
}
