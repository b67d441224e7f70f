// npm run docs: sets up, builds the package and the documentation site, and says where it lies.

import { buildPackage } from "./package.mjs";
import { setUp } from "./setup.mjs";
import { SITE, buildSite } from "./site.mjs";
import { door } from "./steps.mjs";

await door(async () => {
  await setUp();
  await buildPackage();
  await buildSite();
  console.log(`\nthe documentation is in ${SITE}; npm start serves it beside the demo`);
});
