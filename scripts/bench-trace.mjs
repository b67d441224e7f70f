// npm run bench:trace: tracers side by side on pictures whose outlines are known;
// `npm run bench:trace -- "outlines, c256"` prints one part.

import { buildPackage } from "./package.mjs";
import { setUp } from "./setup.mjs";
import { at, door, run, show, step } from "./steps.mjs";

const SOURCES = ["bench/peers", "src", "Cargo.toml", "Cargo.lock", "rust-toolchain.toml", ".cargo/config.toml"];
const PROGRAM = "target/release/expline-trace";

await door(async () => {
  await setUp();
  await buildPackage();
  await step("native tracer", { inputs: SOURCES, outputs: [PROGRAM] }, async () => {
    await run("cargo", ["build", "--locked", "--release", "-p", "expline-peers", "--bin", "expline-trace"]);
  });
  const parameters = [at("bench/trace/run.mjs"), at(PROGRAM), ...process.argv.slice(2)];
  await show("node", parameters, "the benchmark did not finish");
});
