import { settingOf, type Setting } from "../../document/artboard.ts";
import { emptyCurve, nothingSelected, type CurveDocument } from "../../document/document.ts";
import type { Editor } from "../editor.ts";
import { routeOf } from "../route.ts";

type Opened = Setting & Pick<CurveDocument, "contours">;

/**
 * Contours that another mode has made, as the drawing in Curve: a copy, seen from where one was, ready to be edited.
 */
export function openInCurve(editor: Editor, name: string, { contours, ...setting }: Opened, says: (points: number) => string): void {
  const { view, curve: before } = editor.state.value;
  // A sample as it was opened is nobody's work.
  const own = before.contours.length > 0 && routeOf(editor, "curve").sample === null;
  editor.patch({ mode: "curve", tool: "select" });
  editor.dispatch({
    name,
    apply: () => ({ ...emptyCurve, contours, ...settingOf(setting) }),
    select: nothingSelected,
  });
  editor.setOverlay("bezier", false);
  const { zoom, x, y, up } = view;
  editor.patch({ view: up === true ? { zoom, x, y: 0 - y } : view, hint: "" });
  const said = says(contours.reduce((sum, { points }) => sum + points.length, 0));
  editor.notify({ kind: "toast", text: own ? `${said} Undo restores the previous drawing.` : said, ...(own ? { actionId: "undo" } : {}) });
}
