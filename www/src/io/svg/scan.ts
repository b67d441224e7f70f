import { bracketDepth } from "./brackets.ts";
import { withoutEntities } from "./entities.ts";
import { overLimit, type SvgLimits } from "./limits.ts";

/**
 * One linear look at the markup before the browser's parser gets it: size, nesting, elements and attributes are
 * counted without building anything, and a document type is blanked out so that the parser expands nothing of it.
 */
export function checkMarkup(source: string, limits: SvgLimits): string {
  if (source.length > limits.maxBytes) throw overLimit("maxBytes", limits.maxBytes, source.length);
  const text = withoutDoctype(source.replace(/^\uFEFF/u, "").trimStart(), limits);
  const count = { nodes: 0, depth: 0 };
  let at = text.indexOf("<");
  while (at !== -1) {
    const end = skipDeclaration(text, at);
    at = text.indexOf("<", end ?? readTag(text, at, count, limits));
  }
  checkSheets(text, limits);
  return text.trimStart();
}

/** Far more than any sheet has, as the brackets of other text are counted along. */
const bracketsPerDepth = 16;

/** The parser reads style sheets at once, whether or not they are ever asked for. */
function checkSheets(text: string, limits: SvgLimits): void {
  if (!/<(?:[\w.-]+:)?style\b/iu.test(text)) return;
  const depth = bracketDepth(text);
  if (depth > bracketsPerDepth * limits.maxDepth) throw overLimit("maxDepth", limits.maxDepth, depth);
}

/** Every document type blanked, not cut: the parser's line numbers stay those of the file. */
function withoutDoctype(source: string, limits: SvgLimits): string {
  let text = source;
  let at = text.indexOf("<");
  while (at !== -1) {
    const end = skipDeclaration(text, at);
    if (end !== null && /^<!doctype/iu.test(text.slice(at, at + 9))) {
      const doctype = text.slice(at, end);
      text = text.slice(0, at) + doctype.replace(/[^\n]/gu, " ") + withoutEntities(text.slice(end), doctype, limits);
    }
    // Nothing but declarations stands before the first element, and no type after it.
    at = end === null ? -1 : text.indexOf("<", end);
  }
  return text;
}

/** Where a comment, CDATA section, processing instruction or document type that starts here ends; null for a tag. */
export function skipDeclaration(text: string, at: number): number | null {
  if (text.startsWith("<!--", at)) return after(text, "-->", at + 4);
  if (text.startsWith("<![CDATA[", at)) return after(text, "]]>", at + 9);
  if (text.startsWith("<?", at)) return after(text, "?>", at + 2);
  if (text.startsWith("<!", at)) return afterDoctype(text, at + 2);
  return null;
}

function after(text: string, mark: string, from: number): number {
  const found = text.indexOf(mark, from);
  return found === -1 ? text.length : found + mark.length;
}

/** Past the `>` of a document type, which may hold quotes and one bracketed subset. */
function afterDoctype(text: string, from: number): number {
  let bracketed = false;
  for (let i = from; i < text.length; i += 1) {
    const char = text[i];
    if (char === '"' || char === "'") i = after(text, char, i + 1) - 1;
    else if (char === "[") bracketed = true;
    else if (char === "]") bracketed = false;
    else if (char === ">" && !bracketed) return i + 1;
  }
  return text.length;
}

/** Past the last character of the tag that starts here but its `>`; each sign of an attribute is told. */
export function tagEnd(text: string, at: number, attribute: () => void = () => undefined): number {
  let i = at + 1;
  for (; i < text.length && text[i] !== ">"; i += 1) {
    const char = text[i];
    if (char === '"' || char === "'") i = after(text, char, i + 1) - 1;
    else if (char === "=") attribute();
    else if (char === "<") break; // broken markup: let the parser say where
  }
  return i;
}

/** Past the tag that starts here; counts it. */
function readTag(text: string, at: number, count: { nodes: number; depth: number }, limits: SvgLimits): number {
  let attributes = 0;
  const end = tagEnd(text, at, () => {
    attributes += 1;
    if (attributes > limits.maxAttributes) throw overLimit("maxAttributes", limits.maxAttributes, attributes);
  });
  if (text[at + 1] === "/") {
    count.depth -= 1;
    return end;
  }
  count.nodes += 1;
  if (count.nodes > limits.maxNodes) throw overLimit("maxNodes", limits.maxNodes, count.nodes);
  if (text[end - 1] !== "/") {
    count.depth += 1;
    if (count.depth > limits.maxDepth) throw overLimit("maxDepth", limits.maxDepth, count.depth);
  }
  return end;
}
