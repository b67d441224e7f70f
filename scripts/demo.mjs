// The demo: a Vite build of www/ that imports the built package by its public name.

import { at, run, step } from "./steps.mjs";

/** Builds www/ into www/dist. */
export async function buildDemo() {
  const inputs = ["www/index.html", "www/src", "www/public", "www/vite.config.ts", "pkg", "package-lock.json"];
  await step("demo", { inputs, outputs: ["www/dist/index.html"] }, async () => {
    await run("node", [at("node_modules/vite/bin/vite.js"), "build", "www", "--config", "www/vite.config.ts", "--logLevel", "warn"]);
  });
}
