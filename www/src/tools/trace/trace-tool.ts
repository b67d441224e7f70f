import { panned } from "../../editor/pointer/camera.ts";
import type { Editor } from "../../editor/editor.ts";
import { setTraceView, toggleCorner } from "../../editor/trace/trace-edits.ts";
import { pointAt } from "../../editor/trace/trace-hit.ts";
import type { PointOfOutline } from "../../editor/trace/trace-state.ts";
import { distanceBetween, dragThreshold, type PointerSample, type Tool } from "../../editor/tool.ts";

/** Chooses points of the outlines, toggles corners by a double-click, and moves the paper by a drag. */

function same(a: PointOfOutline | null, b: PointOfOutline | null): boolean {
  return a === b || (a !== null && b !== null && a.contour === b.contour && a.index === b.index);
}

export function createTraceTool(editor: Editor): Tool {
  let press: { readonly start: PointerSample; last: PointerSample; dragging: boolean } | null = null;

  const view = () => editor.state.value.traceView;

  return {
    hover(sample) {
      const over = pointAt(editor.state.value, sample.screen, sample.kind);
      const cursor = over === null ? "grab" : "pointer";
      if (!same(over, view().over)) setTraceView(editor, { over });
      if (editor.state.value.cursor !== cursor) editor.patch({ cursor, hover: { kind: "empty" } });
    },
    press(sample) {
      press = { start: sample, last: sample, dragging: false };
    },
    drag(sample) {
      if (press === null) return;
      if (!press.dragging && distanceBetween(press.start.screen, sample.screen) < dragThreshold[sample.kind]) return;
      if (!press.dragging) editor.patch({ cursor: "grabbing" });
      press.dragging = true;
      const { x, y } = press.last.screen;
      editor.patch({ view: panned(editor.state.value.view, sample.screen.x - x, sample.screen.y - y) });
      press.last = sample;
    },
    release(sample) {
      const was = press;
      press = null;
      if (was === null) return;
      if (was.dragging) return editor.patch({ cursor: "grab" });
      const point = pointAt(editor.state.value, sample.screen, sample.kind);
      setTraceView(editor, { chosen: point });
      if (point !== null && sample.clicks === 2) toggleCorner(editor, point);
    },
    cancel() {
      const had = press !== null || view().chosen !== null;
      press = null;
      setTraceView(editor, { chosen: null });
      return had;
    },
    finish() {
      return false;
    },
  };
}
