import { statSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const wasm = fileURLToPath(new URL("../pkg/expline_bg.wasm", import.meta.url));

export default defineConfig({
  root: import.meta.dirname,
  base: "./",
  define: { __WASM_BYTES__: JSON.stringify(statSync(wasm).size) },
  // Assets are never inlined as data: URLs: the page's Content Security Policy has none for scripts and styles.
  build: { outDir: "dist", emptyOutDir: true, target: "es2022", assetsInlineLimit: 0, modulePreload: { polyfill: false }, chunkSizeWarningLimit: 600 },
});
