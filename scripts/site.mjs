// The documentation site: docs/guide, the reference made of the declarations, and site/'s own code → static files.

import { at, step } from "./steps.mjs";

/** The folder of the finished site: files that any server can hand out, under any address. */
export const SITE = "build/site";
/** The reference as Markdown, as it comes out of the declarations. */
const REFERENCE = "build/reference";

/** Builds the site into build/site. */
export async function buildSite() {
  await step("reference", { inputs: ["pkg/types", "site/tsconfig.api.json", "scripts/site/reference.mjs", "package-lock.json"], outputs: [`${REFERENCE}/index.md`] }, async () => {
    const { writeReference } = await import("./site/reference.mjs");
    return writeReference(at(REFERENCE));
  });
  const sources = ["docs/guide", "site", "scripts/site", "scripts/site.mjs", "CHANGELOG.md", "README.md", "bench/recorded.json", "bench/tables.mjs", "www/src/styles/tokens.css", "www/public/favicon.svg"];
  await step("documentation", { inputs: [...sources, REFERENCE, "pkg", "package-lock.json"], outputs: [`${SITE}/index.html`] }, async () => {
    const { writeSite } = await import("./site/pages.mjs");
    return writeSite(at(SITE), at(REFERENCE));
  });
}
