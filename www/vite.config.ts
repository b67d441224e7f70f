import { statSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const wasm = fileURLToPath(new URL("../pkg/expline_bg.wasm", import.meta.url));

/** The names of all files that the page is made of, for visits without a network. */
const parts = {
  name: "parts",
  generateBundle: {
    order: "post" as const,
    handler(this: { emitFile(file: { type: "asset"; fileName: string; source: string }): void }, _: unknown, bundle: object) {
      this.emitFile({ type: "asset", fileName: "parts.json", source: JSON.stringify(Object.keys(bundle).filter((name) => name.startsWith("assets/"))) });
    },
  },
};

/**
 * What the page and most of what it loads later have in common is one file: as a dozen small ones it would compress
 * worse, by 3 kB of the 80 that a first visit may take.
 */
const common = /\/www\/src\/(?:document\/(?:document|problem|unit|curve\/(?:contours|offset|roots|commands))|kernel\/(?:unit|curve\/(?:curve-cache|samples)|paths\/paths)|editor\/pointer\/camera|panels\/controls\/dom)\.ts$/u;

/** The first page names eighty files, and hashes do not compress: seven letters of them are as short as they may be. */
const names = { entryFileNames: "assets/[name]-[hash:7].js", chunkFileNames: "assets/[name]-[hash:7].js", assetFileNames: "assets/[name]-[hash:7][extname]" };

/** What the page began with need not be looked for before what comes later. */
const resolveDependencies = (_: string, files: string[]): string[] => files.filter((file) => !/\/(?:common|index)-[^/]*\.js$/u.test(file));

export default defineConfig({
  root: import.meta.dirname,
  base: "./",
  plugins: [parts],
  define: { __WASM_BYTES__: JSON.stringify(statSync(wasm).size) },
  // Assets are never inlined as data: URLs: the page's Content Security Policy has none for scripts and styles.
  build: {
    outDir: "dist", emptyOutDir: true, target: "es2022", assetsInlineLimit: 0, modulePreload: { polyfill: false, resolveDependencies }, chunkSizeWarningLimit: 600,
    rolldownOptions: { output: { ...names, codeSplitting: { groups: [{ name: "common", test: common }] } } },
  },
});
