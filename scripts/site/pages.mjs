// The pages of the site: docs/guide/index.md names them, in order; the others are made of what the repository has.

import { cpSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";

import { tables } from "../../bench/tables.mjs";
import { StepError, at } from "../steps.mjs";
import { bundleSite } from "./bundle.mjs";
import { rendered } from "./markdown.mjs";
import { llmsText, searchIndex } from "./reading.mjs";
import { page } from "./template.mjs";

const GUIDE = "docs/guide";
const CONTENTS = `${GUIDE}/index.md`;

/** Files of the repository that are pages under other names, so that links work in both. */
const ELSEWHERE = new Map([
  [CONTENTS, "index.html"],
  ["ts/index.ts", "api/index.html"],
  ["site/playground/playground.ts", "playground.html"],
  ["bench/recorded.json", "benchmarks.html"],
  ["CHANGELOG.md", "changelog.html"],
]);

const read = (path) => readFileSync(at(path), "utf8");

/** What the contents list: under each heading a title, a file and what one finds there. */
export function contentsOf(text) {
  return text
    .split(/^## /m)
    .slice(1)
    .map((part) => {
      const [title] = part.split("\n", 1);
      const entries = [...part.matchAll(/^- \[([^\]]+)\]\(([^)]+)\): (.*)$/gm)];
      return { title, entries: entries.map(([, name, link, words]) => ({ title: name, source: join(GUIDE, link), words })) };
    });
}

/** The recorded run of the benchmark, and the tables that the README has beside it. */
function benchmarks() {
  const readme = read("README.md");
  const numbers = readme.slice(readme.indexOf("<!-- end of times -->"), readme.indexOf("\n## The demo"));
  const head = "# Benchmarks\n\nTimes of one run that was kept, and how near tracers come to what they trace. `npm run bench` prints the first, `npm run bench:trace` the second, on a machine of yours.\n\n## Times\n\n";
  return `${head}${tables(JSON.parse(read("bench/recorded.json")))}\n\n## Traces and accuracy\n${numbers.replace(/^<!--.*-->/, "")}`;
}

const PLAYGROUND = `# Playground

Code, and what its \`export default\` is, drawn: curves, surfaces, path data, points, SVG, or a list of these.

<div class="play"><noscript>The playground needs JavaScript.</noscript></div>

It runs in a frame that has no part in this page, in nothing it has stored, and in no network; after ten seconds it is stopped. A link holds the code itself, and runs nothing before you press Run.
`;

/** The reference: its pages, and where each name of the interface lies. */
function referencePages(folder) {
  const files = readdirSync(folder, { recursive: true, encoding: "utf8" }).filter((name) => name.endsWith(".md")).sort();
  const pages = files.map((name) => {
    const text = readFileSync(join(folder, name), "utf8");
    const [, kind, title] = /^# (?:([A-Z][\w ]*): )?(.*)$/m.exec(text);
    const head = name === "index.md" ? "# API reference\n\nEvery name that `expline` exports. `expline/slim` exports the same, `expline/edit` what is for the pointer.\n" : `# ${title}\n`;
    return { source: name, file: `api/${name.replace(/\.md$/, ".html")}`, kind: kind?.toLowerCase(), section: "Reference", text: text.replace(/^# .*\n/m, head) };
  });
  const names = new Map();
  for (const { file, kind, text } of pages) {
    const name = /([\w]+)\.html$/.exec(file)[1];
    if (kind === undefined || name === "default") continue;
    names.set(name, { file, anchors: new Set([...text.matchAll(/^### (\w+)/gm)].map(([, member]) => member.toLowerCase())) });
  }
  return { pages, names };
}

/** Every page as it is to be made, the contents first. */
function pagesOf(contents, reference) {
  const made = { "benchmarks.html": benchmarks, "changelog.html": () => read("CHANGELOG.md"), "playground.html": () => PLAYGROUND };
  const listed = contents.flatMap(({ title: section, entries }) =>
    entries.map(({ title, source, words }) => {
      const file = ELSEWHERE.get(source) ?? `${source.slice(GUIDE.length + 1, -3)}.html`;
      return { source, file, section, title, words, text: made[file]?.() ?? (source.endsWith(".md") ? read(source) : undefined) };
    }),
  );
  const unlisted = readdirSync(at(GUIDE)).filter((name) => name !== "index.md" && !listed.some(({ source }) => source === `${GUIDE}/${name}`));
  if (unlisted.length > 0) throw new StepError(`${CONTENTS} does not list ${unlisted.join(", ")}`);
  const own = listed.filter(({ text }) => text !== undefined);
  return [{ source: CONTENTS, file: "index.html", section: "", title: "expline", text: read(CONTENTS) }, ...own, ...reference];
}

function renderedPage(given, { names, listed }) {
  const isReference = given.file.startsWith("api/");
  const isGuide = given.source.startsWith(GUIDE);
  // Links among the files of the reference lead from one to the other as they lie there.
  const places = isReference ? new Map(listed.map(({ source, file }) => [source, file])) : ELSEWHERE;
  const how = { ...given, places, names: isGuide ? names : undefined, lenient: !isGuide && !isReference, playground: isGuide ? "playground.html" : undefined };
  const { html, sections, figures } = rendered(given.text, how);
  return { ...given, html, sections, figures, title: sections[0]?.title ?? given.title };
}

/** Writes the site into `out`; `reference` is the folder of the reference's Markdown. */
export async function writeSite(out, reference) {
  const contents = contentsOf(read(CONTENTS));
  const { pages: listed, names } = referencePages(reference);
  const pages = pagesOf(contents, listed).map((given) => renderedPage(given, { names, listed }));
  rmSync(out, { recursive: true, force: true });
  const put = (name, text) => {
    mkdirSync(dirname(join(out, name)), { recursive: true });
    writeFileSync(join(out, name), text);
  };
  const fileOf = (source) => pages.find((one) => one.source === source)?.file ?? ELSEWHERE.get(source);
  const nav = contents.map(({ title, entries }) => ({ title, entries: entries.map((entry) => ({ title: entry.title, file: fileOf(entry.source), words: entry.words })) }));
  for (const one of pages) put(one.file, page(one, nav, pages));
  put("assets/search.json", searchIndex(pages));
  put("llms.txt", llmsText(nav, pages, read("README.md")));
  cpSync(at("www/public/favicon.svg"), join(out, "favicon.svg"));
  await bundleSite(out);
  return `${pages.length} pages`;
}
