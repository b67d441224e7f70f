// The reference: TypeDoc reads the package's own declarations, as an editor does, and writes a Markdown file for each
// name.

import { readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { Application, LogLevel } from "typedoc";

import { StepError, at } from "../steps.mjs";

/** Types that only say what a parameter takes: an editor shows what they are. */
const NAMELESS = ["Bytes", "CompiledModule", "FitterStrength", "Nobodys", "Readable"];

const OPTIONS = {
  name: "expline",
  entryPoints: [at("pkg/types/index.d.ts")],
  tsconfig: at("site/tsconfig.api.json"),
  plugin: ["typedoc-plugin-markdown"],
  logLevel: "Warn",
  readme: "none",
  router: "member",
  entryFileName: "index",
  sort: ["source-order"],
  disableSources: true,
  excludeInternal: true,
  excludePrivate: true,
  hideGenerator: true,
  hideBreadcrumbs: true,
  hidePageHeader: true,
  indexFormat: "table",
  parametersFormat: "none",
  interfacePropertiesFormat: "table",
  typeDeclarationFormat: "table",
  expandObjects: true,
  expandParameters: true,
  githubPages: false,
  intentionallyNotExported: NAMELESS,
  validation: { notExported: true, invalidLink: true, notDocumented: false },
};

/**
 * A page without what its signatures say already (results, where a member was inherited from) and without the
 * names that only the package knows.
 */
function plain(text) {
  const kept = [];
  let leaving = 0;
  let isCode = false;
  for (const line of text.split("\n")) {
    if (line.startsWith("```")) isCode = !isCode;
    const [, marks, heading] = (!isCode && /^(#+) (.*)$/.exec(line)) || [];
    if (leaving > 0 && ((marks && marks.length <= leaving) || line === "***")) leaving = 0;
    if (marks && /^(?:Returns|Inherited from|Overrides|Implementation of)$/.test(heading)) leaving = marks.length;
    if (leaving === 0) kept.push(line);
  }
  return kept
    .join("\n")
    .replaceAll("\\<`ArrayBufferLike`\\>", "")
    .replace(/^## Extends\n+- `(?:Found|MeasuredCurve)`\n+/m, "")
    .replace(/^#+ (?:Type Declaration|(?:Get|Set) Signature)\n+/gm, "")
    .replace(/ \| Inherited from \|\n\| (.*) \| ------ \|$/gm, " |\n| $1 |")
    .replace(/^(\| <a id="[^"]*"><\/a>.*) \| [^|]* \|$/gm, (row, before) => (text.includes("| Inherited from |") ? `${before} |` : row));
}

/** Writes the Markdown files; what TypeDoc has to complain about ends the build. */
export async function writeReference(out) {
  rmSync(out, { recursive: true, force: true });
  const said = [];
  const app = await Application.bootstrapWithPlugins(OPTIONS);
  app.logger.log = (message, level) => void (level >= LogLevel.Warn && said.push(message));
  const project = await app.convert();
  if (project) {
    app.validate(project);
    await app.outputs.writeOutput({ name: "markdown", path: out }, project);
  }
  if (!project || said.length > 0) throw new StepError("TypeDoc has complaints about the declarations", said.join("\n"));
  const files = readdirSync(out, { recursive: true, encoding: "utf8" }).filter((name) => name.endsWith(".md"));
  for (const name of files) writeFileSync(join(out, name), plain(readFileSync(join(out, name), "utf8")));
  const leaked = files.filter((name) => /MeasuredCurve|@internal/.test(readFileSync(join(out, name), "utf8")));
  if (leaked.length > 0) throw new StepError(`the reference names what only the package knows: ${leaked.join(", ")}`);
  return `${files.length} names`;
}
