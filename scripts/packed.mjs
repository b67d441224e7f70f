// The package as a user gets it: packed, then installed into build/consumer, a project of its own.

import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { KINDS, OVER } from "./kinds.mjs";
import { StepError, at, run, step } from "./steps.mjs";

const CONSUMER = "build/consumer";
/** What the tarball must hold besides package.json, README.md and the declarations. */
const EXPECTED = [
  ...["expline.js", "slim.js", "node.js", "node.cjs", "node-commonjs.cjs", "cli.js", "types/index.d.ts", "types-cjs/index.d.ts", ...OVER.flatMap((name) => [`${name}.js`, `slim-${name}.js`])].map((file) => `pkg/${file}`),
  ...KINDS.flatMap(({ name, file }) => [`pkg/${name}.js`, `pkg/slim-${name}.js`, `pkg/${file}_bg.wasm`]),
  ...["LICENSE-MIT", "LICENSE-APACHE", "THIRD_PARTY_LICENSES"],
];

/** Packs the package and installs the tarball with npm. */
export async function installPacked() {
  const inputs = ["pkg", "package.json", "README.md", "CHANGELOG.md", "LICENSE-MIT", "LICENSE-APACHE", "THIRD_PARTY_LICENSES"];
  await step("packed package", { inputs, outputs: [`${CONSUMER}/node_modules/expline/package.json`] }, async () => {
    rmSync(at(CONSUMER), { recursive: true, force: true });
    mkdirSync(at(CONSUMER), { recursive: true });
    await run("npm", ["pack", "--ignore-scripts", "--pack-destination", at(CONSUMER)]);
    const tarball = readdirSync(at(CONSUMER)).find((file) => file.endsWith(".tgz"));
    writeFileSync(at(CONSUMER, "package.json"), `${JSON.stringify({ name: "consumer", private: true, type: "module" })}\n`);
    await run("npm", ["install", "--offline", "--ignore-scripts", "--no-audit", "--no-fund", `./${tarball}`], { cwd: at(CONSUMER) });
    const installed = at(CONSUMER, "node_modules", "expline");
    const missing = EXPECTED.filter((file) => !existsSync(join(installed, file)));
    if (missing.length > 0) throw new StepError(`the tarball lacks ${missing.join(", ")}`);
    const { dependencies } = JSON.parse(readFileSync(join(installed, "package.json"), "utf8"));
    if (dependencies) throw new StepError("the package has runtime dependencies");
  });
}
