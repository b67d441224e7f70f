/** The search itself, in the index that the build has made (scripts/site/reading.mjs). */
import MiniSearch from "minisearch";

/** A part of a page. */
export interface Found {
  readonly title: string;
  readonly page: string;
  /** Its address, from the site's root. */
  readonly href: string;
  /** How it begins. */
  readonly start: string;
}

const FIELDS = { fields: ["title", "page", "text"], storeFields: ["title", "page", "href", "start"], idField: "href" };
const HOW = { prefix: true, fuzzy: 0.15, combineWith: "AND", boost: { title: 6, page: 2 } } as const;

export async function loadSearch(address: string): Promise<(words: string) => Found[]> {
  const index = MiniSearch.loadJSON(await (await fetch(address)).text(), FIELDS);
  return (words) => index.search(words, HOW).map(({ title, page, href, start }) => ({ title, page, href, start }) as Found);
}
