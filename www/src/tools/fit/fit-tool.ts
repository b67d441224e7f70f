import type { Pair } from "../../document/fit/fit.ts";
import { toPage } from "../../editor/pointer/camera.ts";
import type { Editor } from "../../editor/editor.ts";
import { addPoint, addStroke, eraseAt, setFitView } from "../../editor/fit/fit-edits.ts";
import type { FitTool } from "../../editor/fit/fit-state.ts";
import { knotAt } from "../../editor/fit/knot-hit.ts";
import { distanceBetween, dragThreshold, type PointerSample, type Tool } from "../../editor/tool.ts";

/** Draws strokes, places points, erases, and chooses knots: which of them is a matter of Fit's tool. */

/** CSS pixels. */
const brushRadius = 14;
/** A hand does not mean two places nearer than this, in CSS pixels. */
const leastStep = 0.75;

interface Press {
  readonly start: PointerSample;
  /** What it was pressed with: another finger may choose another tool meanwhile. */
  readonly tool: FitTool;
  /** A mouse on a knot means the knot; a finger is too wide to tell. */
  readonly onKnot: boolean;
  dragging: boolean;
  stroke: Pair[];
}

export function createFitTool(editor: Editor): Tool {
  let press: Press | null = null;
  /** The next placed point begins a stroke of its own. */
  let begins = true;

  const view = () => editor.state.value.fitView;
  const radius = (): number => brushRadius / editor.state.value.view.zoom;

  function drawTo(now: Press, sample: PointerSample): void {
    const least = leastStep / editor.state.value.view.zoom;
    for (const { x, y } of sample.trail ?? [sample.page]) {
      const last = now.stroke.at(-1);
      if (last === undefined || Math.hypot(x - last[0], y - last[1]) >= least) now.stroke.push([x, y]);
    }
    setFitView(editor, { stroke: [...now.stroke] });
  }

  function erase(sample: PointerSample): void {
    for (const { x, y } of sample.trail ?? [sample.page]) eraseAt(editor, x, y, radius());
    setFitView(editor, { brush: sample.page });
  }

  function choose(sample: PointerSample): boolean {
    const knot = knotAt(editor.state.value, sample.screen, sample.kind);
    const { chosen } = view();
    const adds = sample.modifiers.shift && knot !== null;
    if (adds) setFitView(editor, { chosen: chosen.includes(knot) ? chosen.filter((each) => each !== knot) : [...chosen, knot] });
    else setFitView(editor, { chosen: knot === null ? [] : [knot] });
    return knot !== null;
  }

  function hover(sample: PointerSample): void {
    const { tool } = view();
    const over = knotAt(editor.state.value, sample.screen, sample.kind);
    const brush = tool === "erase" ? sample.page : null;
    const cursor = tool === "erase" ? "none" : over === null ? "crosshair" : "pointer";
    if (over !== view().over || brush !== view().brush) setFitView(editor, { over, brush });
    if (editor.state.value.cursor !== cursor) editor.patch({ cursor, hover: { kind: "empty" } });
  }

  return {
    hover,
    press(sample) {
      const onKnot = sample.kind === "mouse" && knotAt(editor.state.value, sample.screen, sample.kind) !== null;
      press = { start: sample, tool: view().tool, onKnot, dragging: false, stroke: [[sample.page.x, sample.page.y]] };
      if (press.tool !== "erase") return;
      editor.fitEdits.begin("Erase");
      press.dragging = true;
      erase(sample);
    },
    drag(sample) {
      if (press === null) return;
      if (!press.dragging && distanceBetween(press.start.screen, sample.screen) < dragThreshold[sample.kind]) return;
      press.dragging = true;
      switch (press.tool) {
        case "draw":
          return press.onKnot ? undefined : drawTo(press, sample);
        case "erase":
          return erase(sample);
        case "points":
          return;
      }
    },
    release(sample) {
      if (press === null) return;
      const { start, tool, onKnot, dragging, stroke } = press;
      press = null;
      switch (tool) {
        case "erase":
          editor.fitEdits.commit();
          return;
        case "draw":
          setFitView(editor, { stroke: [] });
          if (!dragging || onKnot) choose(start);
          if (dragging && onKnot) editor.notify({
            kind: "toast",
            text: "A knot lies where the points ask for it. In Curve it is a point that can be moved.",
            actionId: "fit-edit",
          });
          else if (dragging && stroke.length > 1) addStroke(editor, stroke);
          return;
        case "points": {
          if (choose(sample)) return;
          // The second of two quick presses ends the stroke that the first has put its last point on.
          if (sample.clicks > 1) {
            begins = true;
            return;
          }
          const { x, y } = toPage(editor.state.value.view, editor.state.value.stage, sample.screen);
          addPoint(editor, [x, y], begins || editor.state.value.fit.data.length === 0 || editor.state.value.fit.sample !== undefined);
          begins = false;
        }
      }
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
