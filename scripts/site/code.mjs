// Code as the pages show it: coloured by the parser that the playground's editor has, and opened there by a link.

import { classHighlighter, highlightCode } from "@lezer/highlight";
import { parser } from "@lezer/javascript";
import { deflateRawSync } from "node:zlib";

const PARSERS = {
  js: parser,
  mjs: parser,
  ts: parser.configure({ dialect: "ts" }),
  jsx: parser.configure({ dialect: "jsx" }),
};

export const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");

/** Code as HTML, with classes for what its tokens are; other languages as they are. */
function coloured(code, language) {
  const known = PARSERS[language];
  if (known === undefined) return escaped(code);
  let html = "";
  const put = (text, classes) => (html += classes ? `<span class="${classes}">${escaped(text)}</span>` : escaped(text));
  highlightCode(code, known.parse(code), classHighlighter, put, () => (html += "\n"));
  return html;
}

/** What the playground reads from a link (site/playground/share.ts). */
export const shared = (code) => `#code=${deflateRawSync(code, { level: 9 }).toString("base64url")}`;

/** A block of code; `playground` is the address of the page on which it runs, if it does. */
export function codeBlock(code, language, playground) {
  const open = playground && /from "expline/.test(code) ? `<a class="try" href="${playground}${shared(code)}">Try it</a>` : "";
  // What may be wider than its box can be scrolled by keys as well.
  return `<div class="code">${open}<pre tabindex="0"><code>${coloured(code.trimEnd(), language)}</code></pre></div>\n`;
}
