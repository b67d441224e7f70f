import { withInertNames } from "./inert.ts";
import { SvgFileError, type SvgLimits } from "./limits.ts";
import { checkMarkup } from "./scan.ts";
import { shapeNames } from "./shapes.ts";

/** What begins as an SVG file does; where it is not well formed, the place is told. */
const asFile = /^(?:<\?xml|<!--|<(?:\w+:)?svg[\s>/])/u;
/** As JSX writes attributes. */
const braces = /\s[\w:-]+=\{|\s\{\.\.\./u;
const inBraces = /=\{\s*(["'])([^"'{}]*)\1\s*\}/gu;

/**
 * The root of an SVG document, or of the picture in what people copy out of programs: JSX, an element of HTML with an
 * `svg` in it, a `path` alone, which is no whole picture. The browser's own parsers read it into a document that is
 * never attached to the page.
 */
export function rootOf(source: string, limits: SvgLimits): { readonly root: Element; readonly isWhole: boolean } {
  const text = withInertNames(checkMarkup(source, limits));
  if (asFile.test(text) && !braces.test(text)) return { root: strictRoot(text), isWhole: true };
  const loose = text.replace(inBraces, "=$1$2$1");
  const found = htmlOf(loose).querySelector("svg");
  if (found !== null) return { root: found, isWhole: true };
  // A part of a sprite is drawn where it is used; alone, it is what is meant.
  const made = htmlOf(`<svg>${loose.replace(/^<symbol\b/u, "<svg").replace(/<\/symbol>$/u, "</svg>")}</svg>`).querySelector("svg");
  // A page without a picture, or words.
  if (made?.querySelector([...shapeNames].join()) == null) throw loose.includes("<") ? noSvg() : notWellFormed("");
  return { root: made, isWhole: false };
}

/** Nothing in it runs or is fetched: the document is in no window. */
function htmlOf(text: string): Document {
  return new DOMParser().parseFromString(text, "text/html");
}

function strictRoot(text: string): Element {
  const parsed = new DOMParser().parseFromString(text, "image/svg+xml");
  const root = parsed.documentElement;
  const broken = parsed.getElementsByTagName("parsererror")[0];
  if (broken !== undefined) throw notWellFormed(broken.textContent ?? "");
  if (root.localName !== "svg") throw noSvg();
  return root;
}

function noSvg(): SvgFileError {
  return new SvgFileError("E_PARSE_SVG", "svg: the root element is not svg", { reason: "root" });
}

function notWellFormed(report: string): SvgFileError {
  const place = /line (\d+) at column (\d+)/u.exec(report) ?? /line(?: number)? (\d+),? col(?:umn)? (\d+)/iu.exec(report);
  const where = place === null ? {} : { line: Number(place[1]), column: Number(place[2]) };
  return new SvgFileError("E_PARSE_SVG", "svg: not well formed", { reason: "markup", ...where });
}
