/** The field of the search: hits below it, gone through by arrow keys. The index comes with the first focus. */
import type { Found } from "./search.ts";

const MOST = 12;

const make = <K extends keyof HTMLElementTagNameMap>(name: K, attributes: Record<string, string>, text = ""): HTMLElementTagNameMap[K] => {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.textContent = text;
  return element;
};

export function mountSearchField(): void {
  const place = document.querySelector<HTMLElement>("[data-search]");
  if (place === null) return;
  const root = document.documentElement.dataset["root"] ?? "";
  const input = make("input", {
    type: "search", placeholder: "Search", "aria-label": "Search the documentation", role: "combobox", autocomplete: "off", spellcheck: "false",
    "aria-expanded": "false", "aria-controls": "hits", "aria-autocomplete": "list", "aria-keyshortcuts": "Control+K Meta+K",
  });
  const list = make("ul", { id: "hits", role: "listbox", "aria-label": "Hits" });
  const said = make("p", { class: "visually-hidden", role: "status" });
  list.hidden = true;
  place.append(input, list, said);
  let search: ((words: string) => Found[]) | undefined;
  let chosen = -1;

  const choose = (next: number): void => {
    const options = [...list.querySelectorAll<HTMLElement>("[role=option]")];
    chosen = options.length === 0 ? -1 : (next + options.length) % options.length;
    options.forEach((option, i) => option.setAttribute("aria-selected", String(i === chosen)));
    options[chosen]?.scrollIntoView({ block: "nearest" });
    if (chosen < 0) input.removeAttribute("aria-activedescendant");
    else input.setAttribute("aria-activedescendant", options[chosen]?.id ?? "");
  };
  const close = (): void => {
    list.hidden = true;
    input.setAttribute("aria-expanded", "false");
    input.removeAttribute("aria-activedescendant");
  };
  const show = (): void => {
    const words = input.value.trim();
    if (search === undefined || words === "") return close();
    const found = search(words).slice(0, MOST);
    list.replaceChildren(
      ...found.map((hit, i) => {
        const option = make("li", { role: "option", id: `hit-${i}` });
        const link = make("a", { href: root + hit.href, tabindex: "-1" });
        link.append(make("b", {}, hit.title), make("span", {}, hit.page === hit.title ? "" : hit.page), make("small", {}, hit.start));
        option.append(link);
        return option;
      }),
    );
    if (found.length === 0) list.append(make("li", { class: "none" }, "Nothing found."));
    said.textContent = found.length === 0 ? "Nothing found" : `${found.length} hits`;
    list.hidden = false;
    input.setAttribute("aria-expanded", "true");
    choose(0);
  };
  const load = async (): Promise<void> => {
    if (search !== undefined) return;
    const { loadSearch } = await import("./search.ts");
    search = await loadSearch(`${root}assets/search.json`);
    show();
  };

  input.addEventListener("focus", () => void load());
  input.addEventListener("input", show);
  input.addEventListener("keydown", (event) => {
    if (event.key === "ArrowDown") choose(chosen + 1);
    else if (event.key === "ArrowUp") choose(chosen - 1);
    else if (event.key === "Enter") list.querySelector<HTMLElement>("[aria-selected=true] a")?.click();
    else if (event.key === "Escape" && !list.hidden) close();
    else return;
    event.preventDefault();
  });
  list.addEventListener("click", close);
  document.addEventListener("pointerdown", (event) => !place.contains(event.target as Node) && close());
  place.addEventListener("focusout", (event) => !place.contains(event.relatedTarget as Node | null) && close());
  document.addEventListener("keydown", (event) => {
    if (event.key.toLowerCase() !== "k" || !(event.ctrlKey || event.metaKey)) return;
    event.preventDefault();
    input.focus();
    input.select();
  });
}
