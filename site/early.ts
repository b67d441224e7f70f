/** Before anything is painted: the theme, and contents that begin closed where they would hide the text. */
import { applyTheme, storedTheme } from "./theme.ts";

applyTheme(storedTheme());
document.documentElement.classList.add("scripted");
