import type { Imported } from "../../document/imported.ts";
import { whileLoading } from "../../editor/loading.ts";
import { openDialog, type Dialog } from "../controls/dialog.ts";
import { naturalDestination, naturalPlacement, place } from "../files/load.ts";
import { openPicture } from "../files/open-picture.ts";
import { asProblem } from "../messages/errors.ts";
import type { Shell } from "../shell.ts";
import { importForm, type ImportForm } from "./import-form.ts";

/**
 * A file, or text: SVG, a bare path, points or an expline file. Errors stand beside the text; nothing changes until it
 * can be read.
 */
export function openImport(shell: Shell, given = ""): void {
  const form = importForm(naturalDestination(shell), given, (to) => naturalPlacement(shell, to) === "replace");
  const dialog = openDialog({ title: "Import", testid: "import-dialog" }, ...form.body);
  dialog.foot.append(...form.foot);
  new Importing(shell, form, dialog).listen();
  form.text.focus();
}

/** Characters from which on a browser takes a second for pasting, as if they were typed, and none for setting them. */
const mostTyped = 50_000;

/**
 * Reads one thing at a time: whoever presses twice, or chooses another file, means the last; who closes the dialog,
 * none.
 */
class Importing {
  readonly #shell: Shell;
  readonly #form: ImportForm;
  readonly #dialog: Dialog;
  /** What could be read of a drawing that is broken further on. */
  #readSoFar: Imported | null = null;
  /** Ends what is under way. */
  #under = new AbortController();

  constructor(shell: Shell, form: ImportForm, dialog: Dialog) {
    this.#shell = shell;
    this.#form = form;
    this.#dialog = dialog;
  }

  listen(): void {
    const { apply, partly, text, file } = this.#form;
    const readText = (): void => this.#begin((signal) => this.#attempt(text.value, signal));
    apply.addEventListener("click", readText);
    partly.addEventListener("click", () => {
      const read = this.#readSoFar;
      if (read !== null) this.#begin((signal) => this.#finish(read, signal));
    });
    text.addEventListener("keydown", (event) => {
      if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) readText();
    });
    text.addEventListener("paste", (event) => {
      const pasted = event.clipboardData?.getData("text/plain") ?? "";
      if (pasted.length < mostTyped) return;
      event.preventDefault();
      text.setRangeText(pasted, text.selectionStart, text.selectionEnd, "end");
      text.dispatchEvent(new Event("input"));
    });
    text.addEventListener("input", () => {
      this.#form.calm();
      partly.hidden = true;
    });
    file.addEventListener("change", () => {
      const chosen = file.files?.[0];
      if (chosen === undefined) return;
      this.#begin((signal) => this.#open(chosen, signal));
      file.value = "";
    });
    this.#dialog.element.addEventListener("close", () => this.#under.abort());
  }

  /** The page is not idle before the drawing is on the stage. */
  #begin(work: (signal: AbortSignal) => Promise<void>): void {
    this.#under.abort();
    this.#under = new AbortController();
    void whileLoading(this.#shell.editor, work(this.#under.signal));
  }

  async #open(chosen: File, signal: AbortSignal): Promise<void> {
    try {
      const incoming = await this.#shell.io.readIncoming(chosen);
      if (signal.aborted) return;
      this.#form.calm();
      if (!("picture" in incoming)) return await this.#attempt(incoming.text, signal);
      await openPicture(this.#shell, incoming.name, incoming.picture);
      this.#dialog.close();
    } catch (error) {
      this.#fail(error, signal);
    }
  }

  async #attempt(source: string, signal: AbortSignal): Promise<void> {
    const { io, editor } = this.#shell;
    this.#readSoFar = null;
    const file = await io.fileInText(source);
    if (file !== null) return this.#open(file, signal);
    try {
      const imported = await io.readImport(source, editor.state.value.curve.space);
      if (imported.kind === "json" || imported.broken === null) return await this.#finish(imported, signal);
      if (imported.contours.length > 0) this.#readSoFar = imported;
      this.#fail(imported.broken, signal);
    } catch (error) {
      this.#fail(error, signal);
    }
    this.#form.text.focus();
  }

  async #finish(imported: Imported, signal: AbortSignal): Promise<void> {
    if (signal.aborted) return;
    try {
      await place(this.#shell, imported, this.#form.destination(), this.#form.placement());
    } catch (error) {
      return this.#fail(error, signal);
    }
    this.#dialog.close();
  }

  #fail(error: unknown, signal: AbortSignal): void {
    if (signal.aborted) return;
    this.#form.complain(asProblem(error));
    this.#form.partly.hidden = this.#readSoFar === null;
  }
}
