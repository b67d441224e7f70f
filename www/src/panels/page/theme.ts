/** Light, dark, or as the system has it. The choice is kept on this device; the page's colours follow by CSS alone. */
export type Theme = "system" | "light" | "dark";

const key = "expline.theme";
const themes: readonly Theme[] = ["system", "light", "dark"];

function stored(): Theme {
  try {
    return themes.find((theme) => theme === localStorage.getItem(key)) ?? "system";
  } catch {
    return "system";
  }
}

function apply(theme: Theme): void {
  if (theme === "system") delete document.documentElement.dataset["theme"];
  else document.documentElement.dataset["theme"] = theme;
}

/**
 * Whatever the theme, paper is white. Some browsers print what there is before their media change, and some tell
 * nothing but the media.
 */
function announce(event?: Event): void {
  document.documentElement.toggleAttribute("data-print", event?.type === "beforeprint" || window.matchMedia("print").matches);
  window.dispatchEvent(new Event("themechange"));
}

export interface ThemeControl {
  readonly current: () => Theme;
  /** On to the next of system, light, dark. */
  next(): Theme;
}

/** The canvas cannot see CSS change: every change is told to it by a `themechange` event. */
export function mountTheme(until: AbortSignal): ThemeControl {
  let theme = stored();
  apply(theme);
  for (const query of ["(prefers-color-scheme: dark)", "(forced-colors: active)", "print"]) {
    window.matchMedia(query).addEventListener("change", announce, { signal: until });
  }
  for (const type of ["beforeprint", "afterprint"]) window.addEventListener(type, announce, { signal: until });
  return {
    current: () => theme,
    next() {
      theme = themes[(themes.indexOf(theme) + 1) % themes.length] ?? "system";
      apply(theme);
      try {
        localStorage.setItem(key, theme);
      } catch {
        // The choice then lasts as long as the page.
      }
      announce();
      return theme;
    },
  };
}
