import type { Imported } from "../../document/imported.ts";
import type { Problem } from "../../document/problem.ts";
import { button, openDialog } from "../controls/dialog.ts";
import { freshId, h, setText } from "../controls/dom.ts";
import { choiceField } from "../controls/fields.ts";
import { icon } from "../controls/icons.ts";
import { naturalDestination, place, type Destination, type Placement } from "../files/load.ts";
import { openPicture } from "../files/open-picture.ts";
import { asProblem } from "../messages/errors.ts";
import { problemText } from "../messages/file-errors.ts";
import type { Shell } from "../shell.ts";

const accepted = ".svg,.json,.csv,.txt,image/svg+xml,application/json,text/plain,text/csv,image/*";

/** A file, or text: SVG, a bare path, points or an expline file. Errors stand beside the text; nothing changes until it can be read. */
export function openImport(shell: Shell, given = ""): void {
  const textId = freshId("import");
  const text = h("textarea", {
    id: textId,
    class: "code-field",
    testid: "import-text",
    rows: "7",
    spellcheck: "false",
    autocomplete: "off",
    placeholder: "M10 10h80v40a20 20 0 0 1-20 20H10z\n\nor <svg>…</svg>, or rows of x,y",
  });
  text.value = given;
  const file = h("input", { class: "file-field", testid: "import-file", type: "file", accept: accepted, "aria-label": "Choose a file" });
  const message = h("div", { class: "message-slot" });
  const replaces = h("input", { class: "check", type: "checkbox", id: freshId("replace"), testid: "import-replace", checked: true });
  let to = naturalDestination(shell);
  const destination = choiceField<Destination>({
    label: "Open it in", testid: "import-to", about: "To be edited as it is, or to be made simpler.",
    options: [
      { value: "curve", label: "Curve, to edit", about: "Every point and handle, as it is." },
      { value: "fit", label: "Fit, to simplify", about: "A curve of fewer points along it." },
    ],
    write: (value) => { to = value; },
  });
  destination.show(to);
  const dialog = openDialog(
    { title: "Import", testid: "import-dialog" },
    h("p", { class: "quiet" },
      "An SVG file, path data, points as x,y rows, an expline JSON file, or a picture, which is traced. Arcs, lines and cubics come in exactly.",
    ),
    h("label", { class: "file-drop" }, icon("plus"), h("span", {}, "Choose a file"), file),
    h("label", { class: "stacked-label", for: textId }, "or paste it here"),
    text,
    destination.element,
    message,
  );
  const partly = button("Import what was read", { testid: "import-partial", hidden: true });
  const apply = button("Import", { class: "primary", testid: "import-apply" });
  dialog.foot.append(
    h("span", { class: "field-check" }, replaces, h("label", { for: replaces.id }, "Replace the drawing")),
    h("span", { class: "space" }),
    partly,
    apply,
  );

  let readSoFar: Imported | null = null;
  const fail = (problem: Problem): void => {
    const shown = h("p", { class: "message message-error", testid: "error", "data-error": problem.id, role: "alert" },
      icon("warn"),
      h("span", {}, problemText(problem.id, problem.details)),
    );
    message.replaceChildren(shown);
    partly.hidden = readSoFar === null;
  };
  const how = (): Placement => (replaces.checked ? "replace" : "add");
  const finish = async (imported: Imported): Promise<void> => {
    try {
      await place(shell, imported, to, how());
    } catch (error) {
      return fail(asProblem(error));
    }
    dialog.close();
  };
  const attempt = async (source: string): Promise<void> => {
    readSoFar = null;
    try {
      const imported = await shell.io.readImport(source, shell.editor.state.value.curve.space);
      if (imported.kind === "json" || imported.broken === null) return finish(imported);
      if (imported.contours.length > 0) readSoFar = imported;
      fail(imported.broken);
    } catch (error) {
      fail(asProblem(error));
    }
    text.focus();
  };
  apply.addEventListener("click", () => void attempt(text.value));
  partly.addEventListener("click", () => readSoFar !== null && void finish(readSoFar));
  text.addEventListener("keydown", (event) => {
    if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) void attempt(text.value);
  });
  text.addEventListener("input", () => {
    message.replaceChildren();
    partly.hidden = true;
  });
  file.addEventListener("change", () => {
    const chosen = file.files?.[0];
    if (chosen === undefined) return;
    shell.io.readIncoming(chosen).then(
      (incoming) => {
        setText(message, "");
        if (!("picture" in incoming)) return void attempt(incoming.text);
        dialog.close();
        openPicture(shell, incoming.name, incoming.picture);
      },
      (error: unknown) => fail(asProblem(error)),
    );
    file.value = "";
  });
  text.focus();
}
