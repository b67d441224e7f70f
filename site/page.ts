/** What every page does: the theme, copying code, contents on a phone, and the search once it is wanted. */
import { mountSearchField } from "./search-field.ts";
import { nextTheme, storedTheme } from "./theme.ts";

function mountTheme(): void {
  const button = document.querySelector<HTMLButtonElement>("button.theme");
  if (button === null) return;
  let theme = storedTheme();
  const say = (): void => {
    button.textContent = { system: "◐", light: "☀", dark: "☾" }[theme];
    button.setAttribute("aria-label", `Colours: ${theme === "system" ? "as the system" : theme}`);
    button.title = button.getAttribute("aria-label") ?? "";
  };
  button.addEventListener("click", () => {
    theme = nextTheme(theme);
    say();
  });
  say();
  button.hidden = false;
}

const SAID_FOR = 1500;

function mountCopying(): void {
  for (const block of document.querySelectorAll<HTMLElement>(".code")) {
    const button = document.createElement("button");
    button.type = "button";
    button.className = "copy";
    button.textContent = "Copy";
    button.setAttribute("aria-live", "polite");
    button.addEventListener("click", async () => {
      const copied = await navigator.clipboard.writeText(block.querySelector("code")?.textContent ?? "").then(() => true, () => false);
      button.textContent = copied ? "Copied" : "Not allowed";
      setTimeout(() => (button.textContent = "Copy"), SAID_FOR);
    });
    block.prepend(button);
  }
}

/** The contents stand beside the text where there is room, and otherwise above it, closed. */
function mountContents(): void {
  const contents = document.querySelector<HTMLDetailsElement>("details.contents");
  if (contents === null) return;
  const roomy = window.matchMedia("(min-width: 60rem)");
  const follow = (): void => void (contents.open = roomy.matches);
  roomy.addEventListener("change", follow);
  follow();
  const here = contents.querySelector('[aria-current="page"]');
  if (here instanceof HTMLElement && contents.scrollHeight > contents.clientHeight) {
    contents.scrollTop = Math.max(0, here.offsetTop - contents.clientHeight / 2);
  }
}

mountTheme();
mountCopying();
mountContents();
mountSearchField();
