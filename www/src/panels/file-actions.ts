import { writeState } from "../document/file/write.ts";
import type { Action } from "../editor/editor.ts";
import { whenLoaded, whileLoading } from "../editor/loading.ts";
import type { Copy } from "./files/file-work.ts";
import { printedKey, type Shell } from "./shell.ts";

type FileWork = typeof import("./files/file-work.ts");

/** What copies, shares and takes in is loaded when something first is. */
const fileWork = (): Promise<FileWork> => import("./files/file-work.ts");

/** The actions that reach outside the page: files, links, the clipboard, and the dialogs for them. */
export function registerFileActions(shell: Shell): void {
  const { editor, io, toasts } = shell;
  const add = (id: string, label: string, group: Action["group"], keys: readonly string[], run: () => void, enabled?: Action["enabled"]): void => {
    editor.actions.register({ id, label, group, keys, run, ...(enabled === undefined ? {} : { enabled }) });
  };
  const drawn: Action["enabled"] = (state) => state.mode === "curve" && state.curve.contours.length > 0 && state.engine.status === "ready";
  const shown: Action["enabled"] = (state) => drawn(state) || (editor.modes.get(state.mode)?.drawing?.(state) ?? null) !== null;
  const running: Action["enabled"] = (state) => state.engine.status === "ready";

  // Dialogs come when they are first asked for, and one at a time: who asked again before it was there gets it once.
  const dialog = <T>(load: () => Promise<T>, open: (loaded: T) => void) => (): void =>
    whenLoaded(editor, load(), (loaded) => document.querySelector("dialog[open]") === null && open(loaded));
  add("samples", "Samples", "File", [], dialog(() => import("./dialogs/samples-dialog.ts"), ({ openSamples }) => openSamples(shell)), running);
  add("import", "Import", "File", ["Mod+O"], dialog(() => import("./dialogs/import-dialog.ts"), ({ openImport }) => openImport(shell)), running);
  add("export", "Export", "File", ["Mod+E"], dialog(() => import("./dialogs/export-dialog.ts"), ({ openExport }) => openExport(shell)), running);
  // The clipboard is asked at once, and gets its text when that is there.
  const copying = (write: (work: FileWork) => Promise<Copy | null>) => (): void => {
    const work = fileWork();
    const copy = work.then(write);
    const taken = io.copyText(copy.then((it) => it?.text ?? Promise.reject(new Error("nothing to copy"))));
    whenLoaded(editor, work, ({ copied }) => copied(shell, copy, taken));
  };
  add("share", "Copy a link", "File", [], copying(({ linkCopy }) => linkCopy(shell)));
  add("help", "Help", "Help", ["?"], dialog(() => import("./dialogs/help-dialog.ts"), ({ openHelp }) => openHelp(shell)));
  add("save-json", "Download JSON", "File", ["Mod+S"], () => {
    const { value } = editor.state;
    io.download(`${value[value.mode].sample ?? "expline"}.json`, new Blob([writeState(editor.getState())], { type: "application/json" }));
  });
  add("copy", "Copy as SVG", "Edit", ["Mod+C"], copying(({ svgCopy }) => svgCopy(shell)), shown);
  add("cut", "Cut contours", "Edit", ["Mod+X"], copying(({ svgCut }) => svgCut(shell)), drawn);
  // Mod+V is the browser's paste event; this is the menu's way to the same place.
  add("paste", "Paste", "Edit", [], () => {
    // A page that is not served safely has no clipboard at all.
    const there = async (): Promise<string> => navigator.clipboard.readText();
    const pasted = there().then(async (text) => (await fileWork()).receiveText(shell, text), () => toasts.error("clipboard", `The browser blocked pasting. Press ${printedKey("Mod+V")} instead.`));
    void whileLoading(editor, pasted);
  }, running);
}
