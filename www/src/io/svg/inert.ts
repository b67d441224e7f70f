import { skipDeclaration, tagEnd } from "./scan.ts";

/**
 * What style sheets and `style` attributes are called while the browser parses them; as long, so that places in the
 * file stay.
 */
export const inertStyle = "x-css";

const quoted = `"[^"]*"|'[^']*'`;
const styleName = "(?:(?<=^</?(?:[\\w.-]+:)?)|(?<![\\w.:=<-]))style(?=[\\s/>=]|$)";
/** Attributes that hold programs: `onclick`. */
const handlerName = "(?<![\\w.:=<-])on(?=[a-z]+\\s*=)";
const named = new RegExp(`${quoted}|(${styleName})|(${handlerName})`, "giu");

/**
 * The markup with its styles and handlers of events under other names: browsers look into them even in documents that
 * are never shown, and where a page's policy forbids them, they report a violation.
 */
export function withInertNames(text: string): string {
  let [made, from] = ["", 0];
  for (let at = text.indexOf("<"); at !== -1; at = text.indexOf("<", from)) {
    const declared = skipDeclaration(text, at);
    const end = declared ?? tagEnd(text, at);
    const part = text.slice(at, end);
    made += text.slice(from, at) + (declared === null ? renamed(part) : part);
    from = end;
  }
  return made + text.slice(from);
}

function renamed(tag: string): string {
  return tag.replace(named, (whole, style?: string, handler?: string) => (style !== undefined ? inertStyle : handler !== undefined ? "x-" : whole));
}

/** The selector that finds in such markup what another finds in the file. */
export function inertSelector(selector: string): string {
  return selector.replace(/(?<=\[\s*)style(?=[\s\]~|^$*=])/giu, inertStyle);
}
