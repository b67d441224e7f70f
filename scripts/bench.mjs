// npm run bench: the package beside its peers, in one run on one curve, results checked against each other.

import { buildPackage } from "./package.mjs";
import { setUp } from "./setup.mjs";
import { at, door, run, show, step } from "./steps.mjs";

const PEERS = ["bench/peers", "src", "Cargo.toml", "Cargo.lock", "rust-toolchain.toml", ".cargo/config.toml"];
const PROGRAM = "target/release/expline-peers";
const WASM = "target/wasm32-unknown-unknown/release/expline_peers.wasm";
const KURBO = "build/bench/kurbo.wasm";

await door(async () => {
  await setUp();
  await buildPackage();
  await step("native peers", { inputs: PEERS, outputs: [PROGRAM] }, async () => {
    await run("cargo", ["build", "--locked", "--release", "-p", "expline-peers", "--bin", "expline-peers"]);
  });
  await step("kurbo in wasm", { inputs: PEERS, outputs: [KURBO] }, async () => {
    await run("cargo", ["build", "--locked", "--release", "-p", "expline-peers", "--lib", "--target", "wasm32-unknown-unknown"]);
    await run("mkdir", ["-p", at("build/bench")]);
    await run("node", [at("node_modules/binaryen/bin/wasm-opt"), "-O3", "--all-features", at(WASM), "-o", at(KURBO)]);
  });
  const parameters = [at("bench/run.mjs"), at(PROGRAM), at(KURBO), ...process.argv.slice(2)];
  await show("node", parameters, "the benchmark did not finish");
});
