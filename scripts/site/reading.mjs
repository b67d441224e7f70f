// The site for those who do not look at it page by page: the index of the search, and llms.txt.

import MiniSearch from "minisearch";

/** How a search looks at the index; the page that asks has to say the same (site/search.ts). */
const FIELDS = { fields: ["title", "page", "text"], storeFields: ["title", "page", "href", "start"] };
/** Characters of a part that are shown below a hit. */
const SHOWN = 110;

/** The index, one entry for each part of a page. */
export function searchIndex(pages) {
  const index = new MiniSearch({ ...FIELDS, idField: "href" });
  for (const { file, title: page, sections } of pages) {
    for (const { id, title, level, text } of sections) {
      const words = text.replace(/<[^>]*>|\\/g, "").replace(/\s+/g, " ").trim();
      const isRest = file.startsWith("api/") && level > 3;
      if (!isRest) index.add({ href: level === 1 ? file : `${file}#${id}`, title, page, text: words, start: words.slice(0, SHOWN) });
    }
  }
  return JSON.stringify(index);
}

/** The pages in one line each, and the README and the guides in full. */
export function llmsText(nav, pages, readme) {
  const lists = nav.map(({ title, entries }) => `## ${title}\n\n${entries.map((entry) => `- [${entry.title}](${entry.file}): ${entry.words}`).join("\n")}`);
  const [, tagline] = /^\*\*(.*)\*\*$/m.exec(readme);
  const guides = pages.filter(({ source, file }) => source.startsWith("docs/guide/") && file !== "index.html");
  const full = [{ file: "README.md", text: readme }, ...guides].map(({ file, text }) => `<!-- ${file} -->\n\n${text.trim()}`);
  return `# expline\n\n> ${tagline}\n\n${lists.join("\n\n")}\n\n---\n\n${full.join("\n\n---\n\n")}\n`;
}
