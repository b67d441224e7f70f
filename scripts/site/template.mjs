// What every page has around its text.

import { escaped } from "./code.mjs";

/** Held by the pages themselves, whoever serves them: nothing is asked of another host, and no style is inline. */
const POLICY = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' data: blob:; base-uri 'none'; form-action 'none'";

const link = (root, file, title, here) => `<li><a href="${root}${file}"${file === here ? ' aria-current="page"' : ""}>${escaped(title)}</a></li>`;

/** The names of the reference by kind, on its own pages only. */
function referenceList(root, here, pages) {
  const kinds = [["class", "Classes"], ["function", "Functions"], ["variable", "Values"], ["interface", "Interfaces"], ["type alias", "Types"]];
  return kinds
    .map(([kind, title]) => {
      const own = pages.filter((one) => one.kind === kind);
      return `<h3>${title}</h3>\n<ul class="names">${own.map(({ file, title: name }) => link(root, file, name, here)).join("")}</ul>`;
    })
    .join("\n");
}

function navigation(root, here, nav, pages) {
  const parts = nav.map(({ title, entries }) => `<h2>${escaped(title)}</h2>\n<ul>${entries.map((entry) => link(root, entry.file, entry.title, here)).join("")}</ul>`);
  return parts.join("\n") + (here.startsWith("api/") ? `\n${referenceList(root, here, pages)}` : "");
}

/** The parts of a long page. */
function partsList(sections) {
  const parts = sections.filter(({ level }) => level === 2);
  if (parts.length < 2) return "";
  return `<nav class="parts" aria-label="On this page"><h2>On this page</h2><ul>${parts.map(({ id, title }) => `<li><a href="#${id}">${escaped(title)}</a></li>`).join("")}</ul></nav>`;
}

/** The pages before and behind, in the order of the contents. */
function neighbours(root, here, nav) {
  const all = nav.flatMap(({ entries }) => entries);
  const i = all.findIndex(({ file }) => file === here);
  if (i < 0) return "";
  const way = (entry, words, rel) => (entry ? `<a rel="${rel}" href="${root}${entry.file}"><small>${words}</small>${escaped(entry.title)}</a>` : "<span></span>");
  return `<nav class="neighbours" aria-label="Further pages">${way(all[i - 1], "Before", "prev")}${way(all[i + 1], "Next", "next")}</nav>`;
}

/** A page as HTML. */
export function page({ file, title, kind, words, html, sections, figures }, nav, pages) {
  const root = "../".repeat(file.split("/").length - 1);
  const isHome = file === "index.html";
  const scripts = ["page", ...(figures.length > 0 ? ["figures"] : []), ...(file === "playground.html" ? ["playground"] : [])];
  const kicker = kind ? `<p class="kicker">${kind}</p>\n` : "";
  return `<!doctype html>
<html lang="en" data-root="${root}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="${POLICY}">
<meta name="color-scheme" content="light dark">
<meta name="description" content="${escaped((words ?? `${title}: documentation of expline, splines for web vector editors.`).replaceAll("`", ""))}">
<title>${isHome ? "expline: documentation" : `${escaped(title)} · expline`}</title>
<link rel="icon" href="${root}favicon.svg" type="image/svg+xml">
<link rel="stylesheet" href="${root}assets/page.css">
<script src="${root}assets/early.js"></script>
${scripts.map((name) => `<script type="module" src="${root}assets/${name}.js"></script>`).join("\n")}
</head>
<body class="${file === "playground.html" ? "wide" : isHome ? "home" : ""}">
<a class="skip" href="#text">To the text</a>
<header class="top">
<a class="mark" href="${root}index.html"><img src="${root}favicon.svg" alt="" width="24" height="24">expline<span>docs</span></a>
<div class="search" data-search></div>
<a class="plain" href="${root}../">Demo</a>
<button class="theme" type="button" hidden></button>
</header>
<div class="sheet">
<details class="contents" open><summary>Contents</summary><nav aria-label="Contents">
${navigation(root, file, nav, pages)}
</nav></details>
<main id="text" tabindex="-1">
${kicker}${html}${neighbours(root, file, nav)}
</main>
${partsList(sections)}
</div>
</body>
</html>
`;
}
