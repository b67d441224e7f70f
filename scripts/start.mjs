// npm start: sets up, builds the package and the demo, and serves it until Ctrl-C.

import { buildDemo } from "./demo.mjs";
import { buildPackage } from "./package.mjs";
import { serve } from "./serve.mjs";
import { setUp } from "./setup.mjs";
import { at, door } from "./steps.mjs";

await door(async () => {
  await setUp();
  await buildPackage();
  await buildDemo();
  const { url } = await serve(at("www", "dist"), process.env.PORT ? { port: Number(process.env.PORT) } : {});
  console.log(`\nexpline is at ${url} (Ctrl-C stops it)`);
});
