/** Selectors of style sheets, as the browser writes them again: what each weighs and what looking it up may cost. */

export interface Selector {
  readonly text: string;
  /** Its specificity: of two rules the heavier wins. */
  readonly weight: number;
}

const token = /\[(?:"(?:\\.|[^"\\])*"|[^\]"])*\]|(?:::?|[.#])?(?:\\[\da-f]{1,6}\s?|\\.|[\w-]|[^\0-\x7f])+\(?|[^]/giu;
const [anId, aClass, aKind] = [2 ** 32, 2 ** 16, 1];

/** The selectors of a list, one by one; calls within calls are read by recursion, no deeper than sheets are taken. */
export function selectorsOf(list: string): readonly Selector[] {
  const tokens = list.match(token) ?? [];
  let at = 0;
  const untilClosed = (): Selector[] => {
    const found: Selector[] = [{ text: "", weight: 0 }];
    for (; at < tokens.length && tokens[at] !== ")"; at += 1) {
      const [first = "", start] = [tokens[at], at];
      const last = found.pop() ?? { text: "", weight: 0 };
      if (first === ",") {
        found.push(last, { text: "", weight: 0 });
        continue;
      }
      let weight = weightOf(first);
      if (first.endsWith("(")) {
        at += 1;
        weight = weightOfCall(first, untilClosed());
      }
      found.push({ text: last.text + tokens.slice(start, at + 1).join(""), weight: last.weight + weight });
    }
    return found;
  };
  return untilClosed();
}

/** Longer selectors come of rules in rules that multiply. */
const longest = 10_000;

/**
 * The selectors of a rule that stands in another of those selectors, or in none: `&` is what the outer rule chooses.
 * Null where that becomes too long.
 */
export function nestedIn(list: string, outer: readonly Selector[] | null): string | null {
  if (!list.includes("&")) return list;
  // In no rule it is the document's root, and weighs nothing.
  const whole = outer === null ? ":where(:root)" : `:is(${outer.map(({ text }) => text).join()})`;
  const alone = outer?.length === 1 ? outer[0]?.text : undefined;
  const tokens = list.match(token) ?? [];
  let text = "";
  tokens.forEach((part, i) => {
    // At the start of a selector the outer one can be written as it is, which is looked up faster.
    const isFirst = i === 0 && /^[\s.#:[>+~]/u.test(tokens[1] ?? " ");
    if (text.length <= longest) text += part === "&" ? (isFirst ? (alone ?? whole) : whole) : part;
  });
  return text.length > longest ? null : text;
}

function weightOf(part: string): number {
  if (part.startsWith("#")) return anId;
  if (/^(?:[.[]|:(?!:))/u.test(part)) return aClass;
  return /^[^\s*>+~|,)]/u.test(part) ? aKind : 0;
}

function weightOfCall(name: string, inner: readonly Selector[]): number {
  if (name === ":where(") return 0;
  return /^:(?:is|not|has|-webkit-any)\($/u.test(name) ? Math.max(...inner.map(({ weight }) => weight)) : aClass;
}

/** How large a document is, in each direction that a selector may look. */
export interface Extent {
  readonly elements: number;
  readonly depth: number;
  readonly widest: number;
}

export function extentOf(document: Document): Extent {
  const depths = new Map<Element, number>();
  let [depth, widest] = [1, 1];
  for (const element of document.getElementsByTagName("*")) {
    const own = 1 + (element.parentElement === null ? 0 : (depths.get(element.parentElement) ?? 0));
    depths.set(element, own);
    depth = Math.max(depth, own);
    widest = Math.max(widest, element.childElementCount);
  }
  return { elements: depths.size, depth, widest };
}

/**
 * At most so many elements are looked at by a selector, up to a factor of a few: each part of it at every element, at
 * those around where it has a blank or `:has`, at those beside where it looks sideways, and again for each call within
 * a call.
 */
export function costOf(selector: string, { elements, depth, widest }: Extent): number {
  const bare = selector.replace(/\s*([,>+~])\s*/gu, "$1").replace(/:nth-[\w-]+\([-+n\d]*\)/gu, ":nth");
  const parts = bare.match(/[.#:[>+~\s*]|^\w/gu)?.length ?? 1;
  const calls = 1 + (bare.match(/\((?=[^()]*[\s>+~(])/gu)?.length ?? 0);
  const up = /\s|:has/u.test(bare) ? depth ** calls : 1;
  const beside = /[+~]|:has|:nth|-child|-of-type/u.test(bare) ? widest ** calls : 1;
  return elements * parts * up * beside;
}
