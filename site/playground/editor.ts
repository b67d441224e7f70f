/** The editor: CodeMirror with the few parts that code of a page's length wants. */
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { javascript } from "@codemirror/lang-javascript";
import { bracketMatching, indentOnInput, syntaxHighlighting } from "@codemirror/language";
import { EditorState } from "@codemirror/state";
import { EditorView, drawSelection, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { classHighlighter } from "@lezer/highlight";

/** Colours by the page's own tokens, which reach into the shadow. */
const look = EditorView.theme({
  "&": { height: "100%", fontSize: "0.8125rem", backgroundColor: "var(--panel)", color: "var(--ink)" },
  "&.cm-focused": { outline: "none" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.6" },
  ".cm-content": { caretColor: "var(--ink)", padding: "var(--s3) 0" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  ".cm-gutters": { backgroundColor: "var(--panel)", color: "var(--ink2)", border: "none" },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "var(--wash)" },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground": { backgroundColor: "var(--accent-wash)" },
  ".cm-matchingBracket, &.cm-focused .cm-matchingBracket": { backgroundColor: "var(--wash2)", outline: "1px solid var(--border)" },
  ".tok-keyword, .tok-operatorKeyword, .tok-bool, .tok-null": { color: "var(--focus)" },
  ".tok-string, .tok-string2": { color: "var(--cubic)" },
  ".tok-number": { color: "var(--linear)" },
  ".tok-comment": { color: "var(--ink2)", fontStyle: "italic" },
  ".tok-typeName, .tok-className": { color: "var(--handle)" },
  ".tok-propertyName": { color: "var(--coinc)" },
});

export interface Editor {
  code(): string;
  setCode(code: string): void;
}

/**
 * An editor in a shadow of its own: there its styles are sheets of a script, which a page without inline styles allows.
 * Tab indents; Escape and then Tab leaves it, as CodeMirror has it.
 */
export function mountEditor(host: HTMLElement, code: string, changed: () => void, run: () => void): Editor {
  const root = host.attachShadow({ mode: "open" });
  const extensions = [
    ...[keymap.of([{ key: "Mod-Enter", run: () => (run(), true) }, ...defaultKeymap, ...historyKeymap, indentWithTab])],
    ...[lineNumbers(), history(), drawSelection(), indentOnInput(), bracketMatching(), highlightActiveLine()],
    ...[javascript({ typescript: false }), syntaxHighlighting(classHighlighter), look],
    EditorView.contentAttributes.of({ "aria-label": "Code. Escape, then Tab leaves the editor." }),
    EditorView.updateListener.of(({ docChanged }) => docChanged && changed()),
  ];
  const view = new EditorView({ root, parent: root, state: EditorState.create({ doc: code, extensions }) });
  view.dom.dataset["editor"] = "";
  return {
    code: () => view.state.doc.toString(),
    setCode: (next) => view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: next } }),
  };
}
