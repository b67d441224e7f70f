// Markdown → HTML: the documents of the repository as pages, whose links lead to pages.

import { readFileSync } from "node:fs";
import { basename, dirname, join, relative } from "node:path";

import MarkdownIt from "markdown-it";

import { StepError, at } from "../steps.mjs";
import { codeBlock, escaped } from "./code.mjs";

/** The name by which a heading can be linked to, as on the pages that show plain Markdown. */
export const anchorOf = (heading) => heading.toLowerCase().replace(/[^\p{L}\p{N}\s_-]/gu, "").replaceAll(" ", "-");

/** A paragraph that is nothing but a link to a figure's code is the figure. */
const FIGURE = /^(?:\.\.\/)+site\/figures\/([\w-]+)\.ts$/;
/** What a figure's file shows: the code that runs, and no other. */
const SHOWN = /^ *\/\/ shown\n([\s\S]*?)^ *\/\/ end of shown$/m;

function shownCode(name) {
  const [, code] = SHOWN.exec(readFileSync(at("site", "figures", `${name}.ts`), "utf8")) ?? [];
  if (code === undefined) throw new StepError(`the figure ${name} shows no code`);
  const indent = Math.min(...code.split("\n").filter((line) => line.trim() !== "").map((line) => /^ */.exec(line)[0].length));
  return code.split("\n").map((line) => line.slice(indent)).join("\n");
}

function figure(name, words) {
  const code = codeBlock(shownCode(name), "ts");
  return `<figure class="figure" data-figure="${name}" aria-label="${escaped(words)}"><div class="figure-stage"></div><figcaption>${escaped(words)}</figcaption>\n${code}</figure>\n`;
}

function figures(state) {
  state.tokens.forEach((token, i) => {
    const children = token.children ?? [];
    if (token.type !== "inline" || children[0]?.type !== "link_open" || children.at(-1)?.type !== "link_close") return;
    const [, name] = FIGURE.exec(children[0].attrGet("href")) ?? [];
    if (name === undefined || children.filter(({ type }) => type === "link_open").length > 1) return;
    const words = children.map(({ content }) => content).join("");
    const [before, after] = [state.tokens[i - 1], state.tokens[i + 1]];
    before.hidden = after.hidden = true;
    before.tag = after.tag = "";
    Object.assign(token, { type: "html_block", content: figure(name, words), children: null });
    state.env.figures.push(name);
  });
}

/** Headings get their names, and are noted with the text below them, which is what is searched. */
function sections(state) {
  const { found } = state.env;
  const names = new Map();
  state.tokens.forEach((token, i) => {
    const last = found.at(-1);
    if (token.type === "heading_open") {
      const title = state.tokens[i + 1].children.map(({ content }) => content).join("");
      const [plain, times] = [anchorOf(title), names.get(anchorOf(title)) ?? 0];
      names.set(plain, times + 1);
      const id = times === 0 ? plain : `${plain}-${times}`;
      token.attrSet("id", id);
      found.push({ id, title, level: Number(token.tag.slice(1)), text: "" });
    } else if (last && token.type === "inline" && state.tokens[i - 1].type !== "heading_open") {
      last.text += ` ${token.children.map(({ content, type }) => (type === "softbreak" ? " " : content)).join("")}`;
    } else if (last && token.type === "fence") {
      last.text += ` ${token.content}`;
    }
  });
}

/** The names of the interface in the text lead to the reference. */
function namesLead(state) {
  const { names, root } = state.env;
  if (names === undefined) return;
  for (const token of state.tokens) {
    if (token.type !== "inline") continue;
    let inLink = 0;
    token.children = token.children.flatMap((child) => {
      if (child.type === "link_open") inLink += 1;
      if (child.type === "link_close") inLink -= 1;
      if (child.type !== "code_inline" || inLink > 0) return [child];
      const [, name, member] = /^(?:new )?([A-Za-z]\w+)(?:\.(\w+))?(?:\(.*\))?$/.exec(child.content) ?? [];
      const page = names.get(name);
      if (page === undefined) return [child];
      const anchor = member !== undefined && page.anchors.has(member.toLowerCase()) ? `#${member.toLowerCase()}` : "";
      const open = new state.Token("link_open", "a", 1);
      open.attrs = [["href", `${root}${page.file}${anchor}`], ["class", "name"]];
      return [open, child, new state.Token("link_close", "a", -1)];
    });
  }
}

function fileOnSite(path, places) {
  if (places.has(path)) return places.get(path);
  return path.endsWith(".md") && dirname(path) === "docs/guide" ? `${basename(path, ".md")}.html` : undefined;
}

/** Links from file to file become links from page to page; a lenient page shows the words of those that cannot. */
function linksLead(state) {
  const { source, file, places, lenient } = state.env;
  for (const { children } of state.tokens) {
    let open;
    for (const token of children ?? []) {
      if (token.type === "link_close") token.tag = open.tag;
      if (token.type !== "link_open") continue;
      open = token;
      const [path, anchor] = token.attrGet("href").split("#");
      if (/^(?:https?:|$)/.test(path)) continue;
      const target = fileOnSite(join(dirname(source), path), places);
      if (target === undefined && !lenient) throw new StepError(`${source} links to ${path}, which is not on the site`);
      if (target === undefined) Object.assign(token, { tag: "span", attrs: [] });
      else token.attrSet("href", relative(dirname(file), target) + (anchor ? `#${anchor}` : ""));
    }
  }
}

const markdown = new MarkdownIt({ html: true, linkify: false });
markdown.core.ruler.push("figures", figures);
markdown.core.ruler.push("sections", sections);
markdown.core.ruler.push("links", linksLead);
markdown.core.ruler.push("names", namesLead);
markdown.renderer.rules.fence = (tokens, i, _, env) => codeBlock(tokens[i].content, tokens[i].info.trim(), env.playground && /^(?:js|ts)$/.test(tokens[i].info.trim()) ? env.playground : undefined);
markdown.renderer.rules.table_open = () => '<div class="table" tabindex="0"><table>\n';
markdown.renderer.rules.table_close = () => "</table></div>\n";
markdown.renderer.rules.heading_close = (tokens, i, options, _, self) => {
  const id = tokens[i - 2].attrGet("id");
  const level = tokens[i].tag;
  return `${level === "h2" || level === "h3" ? ` <a class="anchor" href="#${id}" aria-label="Link to this part">#</a>` : ""}${self.renderToken(tokens, i, options)}`;
};

/**
 * A document as HTML, with its headings and its figures. `source` is its path in the repository, `file` that of its
 * page on the site; `places` says which other files are pages, `names` where names of the interface lead.
 */
export function rendered(text, { source, file, places, names, lenient = false, playground }) {
  const root = "../".repeat(file.split("/").length - 1);
  const env = { source, file, places, names, lenient, root, playground: playground && root + playground, found: [], figures: [] };
  const html = markdown.render(text, env);
  return { html, sections: env.found, figures: env.figures };
}
