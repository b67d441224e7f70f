import type { CurveDocument } from "../document/document.ts";
import { writeState } from "../document/file/write.ts";
import { curveSample } from "../document/samples.ts";
import type { Action } from "../editor/editor.ts";
import { documentPathD } from "../kernel/paths.ts";
import { documentBounds } from "../kernel/samples.ts";
import { errorText } from "./errors.ts";
import { naturalPlacement, place, readOrReport, report } from "./load.ts";
import type { Shell } from "./shell.ts";

/** The actions that reach outside the page: files, links, the clipboard, and the dialogs for them. */
export function registerFileActions(shell: Shell): void {
  const { editor, io, toasts } = shell;
  const add = (id: string, label: string, group: Action["group"], keys: readonly string[], run: () => void, enabled?: Action["enabled"]): void => {
    editor.actions.register({ id, label, group, keys, run, ...(enabled === undefined ? {} : { enabled }) });
  };
  const drawn: Action["enabled"] = (state) => state.mode === "curve" && state.curve.contours.length > 0 && state.engine.status === "ready";
  const running: Action["enabled"] = (state) => state.engine.status === "ready";

  // Dialogs come when they are first asked for: the page opens sooner without them.
  add("samples", "Samples", "File", [], () => void import("./dialogs/samples-dialog.ts").then(({ openSamples }) => openSamples(shell)), running);
  add("import", "Import", "File", ["Mod+O"], () => void import("./dialogs/import-dialog.ts").then(({ openImport }) => openImport(shell)), running);
  add("export", "Export", "File", ["Mod+E"], () => void import("./dialogs/export-dialog.ts").then(({ openExport }) => openExport(shell)), running);
  add("share", "Copy a link", "File", [], () => void share(shell));
  add("help", "Help", "Help", ["?"], () => void import("./dialogs/help-dialog.ts").then(({ openHelp }) => openHelp(shell)));
  add("save-json", "Download JSON", "File", ["Mod+S"], () => {
    const stem = editor.state.value.curve.sample ?? "expline";
    io.download(`${stem}.json`, new Blob([writeState(editor.getState())], { type: "application/json" }));
  });
  add("copy", "Copy as SVG", "Edit", ["Mod+C"], () => void copySvg(shell), drawn);
  add("cut", "Cut contours", "Edit", ["Mod+X"], () => void cut(shell), drawn);
  // Mod+V is the browser's paste event; this is the menu's way to the same place.
  add("paste", "Paste", "Edit", [], () => {
    navigator.clipboard.readText().then((text) => receiveText(shell, text), () => toasts.error("clipboard", errorText("clipboard")));
  }, running);
}

/** The contours that hold the selection; all of them when nothing is selected. */
function chosenContours(shell: Shell): CurveDocument {
  const { curve, selection } = shell.editor.state.value;
  const chosen = new Set(selection.points.map((ref) => ref.contour));
  return chosen.size === 0 ? curve : { ...curve, contours: curve.contours.filter((_, i) => chosen.has(i)) };
}

async function copySvg(shell: Shell): Promise<boolean> {
  const { io, toasts } = shell;
  const part = chosenContours(shell);
  const title = curveSample(part.sample ?? "")?.title ?? "expline drawing";
  const text = await io.writeSvg({ title, d: documentPathD(part, { tolerance: 0.02, decimals: 4 }).d, box: documentBounds(part) });
  const done = await io.copyText(text);
  if (done) toasts.say(part.contours.length === 1 ? "Copied the contour as SVG." : `Copied ${part.contours.length} contours as SVG.`);
  else toasts.error("clipboard", errorText("clipboard"));
  return done;
}

async function cut(shell: Shell): Promise<void> {
  const gone = new Set(chosenContours(shell).contours);
  if (await copySvg(shell)) shell.editor.dispatch({ name: "Cut", apply: (curve) => ({ ...curve, contours: curve.contours.filter((contour) => !gone.has(contour)) }) });
}

async function share(shell: Shell): Promise<void> {
  const { editor, io, toasts } = shell;
  try {
    const hash = await io.shareHash(editor.getState());
    const url = new URL(window.location.href);
    url.search = "";
    url.hash = hash;
    const done = await io.copyText(url.href);
    if (done) toasts.say("Link copied. It holds the whole drawing; nothing was sent.");
    else toasts.error("clipboard", errorText("clipboard"));
  } catch (error) {
    report(shell, error);
  }
}

/** Text from a paste or a drop: added to the drawing, or opened when it is a whole file. */
export async function receiveText(shell: Shell, text: string): Promise<void> {
  if (text.trim() === "" || shell.editor.state.value.engine.status !== "ready") return;
  const imported = await readOrReport(shell, text);
  if (imported === null) return;
  try {
    place(shell, imported, naturalPlacement(shell));
  } catch (error) {
    report(shell, error);
  }
}

/** Files from a drop or a paste, one after the other; each is reported on by itself. */
export async function receiveFiles(shell: Shell, files: readonly File[]): Promise<void> {
  for (const file of files.slice(0, 20)) {
    try {
      await receiveText(shell, (await shell.io.readIncoming(file)).text);
    } catch (error) {
      report(shell, error);
    }
  }
}
