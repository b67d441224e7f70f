// npm start: sets up, builds the package, the demo and the documentation, and serves them until Ctrl-C.

import { buildDemo } from "./demo.mjs";
import { buildPackage } from "./package.mjs";
import { serve } from "./serve.mjs";
import { setUp } from "./setup.mjs";
import { SITE, buildSite } from "./site.mjs";
import { at, door } from "./steps.mjs";

await door(async () => {
  await setUp();
  await buildPackage();
  await buildDemo();
  await buildSite();
  const { url } = await serve(at("www", "dist"), { beside: { docs: at(SITE) }, ...(process.env.PORT ? { port: Number(process.env.PORT) } : {}) });
  console.log(`\nexpline is at ${url}, its documentation at ${url}docs/ (Ctrl-C stops it)`);
});
