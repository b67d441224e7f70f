/** Browsers read style sheets by recursion: brackets within brackets, ten thousand deep, bring a page down. */

/** Nobody writes brackets in a style deeper than this. */
export const deepest = 64;

/** A bracket that is written as a character reference, decimal, hexadecimal or by name. */
const coded = /&(?:#0*(?:40|91|123);?|#x0*(?:28|5b|7b);?|(?:lpar|lbrack|lsqb|lbrace|lcub);)/iuy;

/** How deep the brackets of a text stand in one another, or more: which of them are text is not looked at. */
export function bracketDepth(text: string): number {
  let [depth, most] = [0, 0];
  for (let i = 0; i < text.length; i += 1) {
    const char = text[i];
    coded.lastIndex = i;
    if (char === "(" || char === "[" || char === "{" || (char === "&" && coded.test(text))) depth += 1;
    else if (depth > 0 && (char === ")" || char === "]" || char === "}")) depth -= 1;
    if (depth > most) most = depth;
  }
  return most;
}
