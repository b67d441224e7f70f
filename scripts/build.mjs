// npm run build: the package, in pkg/.

import { buildPackage } from "./package.mjs";
import { checkSize } from "./sizes.mjs";
import { setUp } from "./setup.mjs";
import { door } from "./steps.mjs";

await door(async () => {
  await setUp();
  await buildPackage();
  checkSize();
});
