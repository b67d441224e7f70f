import type { Editor } from "../../editor/editor.ts";
import { setFitView } from "../../editor/fit/fit-edits.ts";
import { knotAt } from "../../editor/fit/knot-hit.ts";
import type { PointerSample, Tool } from "../../editor/tool.ts";
import { draw } from "./drawing.ts";
import { erase } from "./erasing.ts";
import type { FitPress } from "./fit-press.ts";
import { placePoint } from "./placing.ts";

/** Draws strokes, places points, erases, and chooses knots: which of them is a matter of Fit's tool. */
export function createFitTool(editor: Editor): Tool {
  let press: FitPress | null = null;
  /** The next placed point begins a stroke of its own. */
  let begins = true;

  const view = () => editor.state.value.fitView;
  const place: FitPress = {
    drag: () => undefined,
    release(sample) {
      begins = placePoint(editor, sample, begins);
    },
  };

  return {
    hover: (sample) => announce(editor, sample),
    press(sample) {
      const { tool } = view();
      press = tool === "draw" ? draw(editor, sample) : tool === "erase" ? erase(editor, sample) : place;
    },
    drag: (sample) => press?.drag(sample),
    release(sample) {
      const ended = press;
      press = null;
      ended?.release(sample);
    },
    cancel() {
      const had = press !== null || view().chosen.length > 0;
      press = null;
      editor.fitEdits.bail();
      setFitView(editor, { stroke: [], chosen: [] });
      return had;
    },
    finish() {
      const open = !begins;
      begins = true;
      if (view().stroke.length > 0 || view().brush !== null) setFitView(editor, { stroke: [], brush: null });
      return open;
    },
  };
}

/** The mark and the cursor say what a press would do. */
function announce(editor: Editor, { screen, page, kind }: PointerSample): void {
  const { fitView: view, tool } = editor.state.value;
  const over = knotAt(editor.state.value, screen, kind);
  const pans = tool === "hand";
  const erases = view.tool === "erase" && !pans;
  const brush = erases ? page : null;
  const cursor = erases ? "none" : pans ? "grab" : over === null ? "crosshair" : "pointer";
  if (over !== view.over || brush !== view.brush) setFitView(editor, { over, brush });
  if (editor.state.value.cursor !== cursor) editor.patch({ cursor, hover: { kind: "empty" } });
}
