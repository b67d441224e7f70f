import { movePoints } from "../../document/curve/commands.ts";
import { locate } from "../../document/curve/contours.ts";
import { isSelected, nothingSelected, pointAt, samePoint, type Contour, type Grid, type PointRef, type Selection } from "../../document/document.ts";
import type { Segment } from "../../editor/curve/bending.ts";
import { panned, type ScreenPoint } from "../../editor/pointer/camera.ts";
import { renewing, resetSelectedHandles, toggleCusp } from "../../editor/curve/edits.ts";
import type { Editor, Modifiers, Target } from "../../editor/editor.ts";
import { late } from "../../editor/loading.ts";
import { hitTest, sameTarget } from "../../editor/pointer/hit-test.ts";
import type { Drag, PointerSample, Tool } from "../../editor/tool.ts";
import { pressOrDrag } from "../press-or-drag.ts";
import { brush } from "./brushing.ts";
import { dragHandle } from "./dragging-handle.ts";
import { dragPoints } from "./dragging-points.ts";
import { dragSegment } from "./dragging-segment.ts";

/** Select and edit. */

/** The cursor announces the outcome of a press. */
function cursorFor(target: Target, modifiers: Modifiers): string {
  switch (target.kind) {
    case "point":
      return modifiers.alt ? "crosshair" : "move";
    case "handle":
      return modifiers.alt ? "alias" : "grab";
    case "curve":
      return modifiers.alt ? "move" : "grab";
    case "grip":
      return target.cursor;
    case "empty":
      return "default";
  }
}

export function createSelectTool(editor: Editor): Tool {
  /** Its grips are of use when contours are chosen as a whole. */
  const frame = late(editor, ({ selection }) => selection.points.length > 1, () => import("./dragging-frame.ts"));

  function targetOf(sample: PointerSample): Target {
    const target = hitTest(editor.state.value, sample.screen, sample.kind);
    return (target.kind === "empty" ? frame()?.gripUnder(editor, sample) : null) ?? target;
  }

  /** What the last click hit: the second click of a double-click means the same thing, whatever appeared since. */
  let lastClicked: Target = { kind: "empty" };

  function segmentSelection(contour: number, t: number): Selection {
    const shape = editor.state.value.curve.contours[contour];
    if (shape === undefined) return nothingSelected;
    const { segment } = locate(shape, t);
    const { grid } = shape;
    if (grid !== undefined) return besideOnGrid(contour, shape, grid, t);
    return { points: [{ contour, index: segment }, { contour, index: (segment + 1) % shape.points.length }], handle: null };
  }

  function segmentAt(contour: number, t: number): Segment {
    const shape = editor.state.value.curve.contours[contour];
    const { segment, x } = shape === undefined ? { segment: 0, x: 0 } : locate(shape, t);
    return { contour, index: segment, x };
  }

  /** Of refined control points, the two whose parameters enclose `t`. */
  function besideOnGrid(contour: number, shape: Contour, grid: Grid, t: number): Selection {
    const count = shape.points.length;
    const before = Math.floor((t - grid.offset) / grid.step);
    const within = (index: number): number => (shape.closed ? ((index % count) + count) % count : Math.max(0, Math.min(count - 1, index)));
    return { points: [{ contour, index: within(before) }, { contour, index: within(before + 1) }], handle: null };
  }

  function dragFor(start: PointerSample, target: Target): Drag {
    switch (target.kind) {
      case "point":
        return dragPoints(editor, start, target.point);
      case "handle":
        return dragHandle(editor, start, target.handle);
      case "curve":
        return dragSegment(editor, start, segmentSelection(target.contour, target.t), segmentAt(target.contour, target.t));
      case "grip":
        return frame()?.dragFrame(editor, start, target.grip) ?? panWith(start);
      case "empty":
        return start.kind === "touch" ? panWith(start) : brush(editor, start);
    }
  }

  function panWith(start: PointerSample): Drag {
    const before = editor.state.value.view;
    let last: ScreenPoint = start.screen;
    return {
      update(sample) {
        editor.patch({ view: panned(editor.state.value.view, sample.screen.x - last.x, sample.screen.y - last.y) });
        last = sample.screen;
      },
      finish() {
        last = start.screen;
      },
      cancel() {
        editor.patch({ view: before });
      },
    };
  }

  function clickPoint(point: PointRef, adds: boolean): void {
    const { selection } = editor.state.value;
    if (!adds) return editor.patch({ selection: { points: [point], handle: null } });
    const points = isSelected(selection, point) ? selection.points.filter((other) => !samePoint(other, point)) : [...selection.points, point];
    editor.patch({ selection: { points, handle: null } });
  }

  function click(target: Target, sample: PointerSample): void {
    switch (target.kind) {
      case "point":
        return clickPoint(target.point, sample.modifiers.shift);
      case "handle": {
        const { contour, index } = target.handle;
        return editor.patch({ selection: { points: [{ contour, index }], handle: target.handle } });
      }
      case "curve": {
        const segment = segmentSelection(target.contour, target.t);
        const { selection } = editor.state.value;
        const kept = sample.modifiers.shift ? selection.points.filter((ref) => !isSelected(segment, ref)) : [];
        return editor.patch({ selection: { points: [...kept, ...segment.points], handle: null } });
      }
      case "grip":
        return;
      case "empty":
        if (editor.state.value.settings.moveByClicks && moveTo(sample)) return;
        if (!sample.modifiers.shift) editor.patch({ selection: nothingSelected });
    }
  }

  /** Move by clicks: the one chosen point goes where the click was. */
  function moveTo(sample: PointerSample): boolean {
    const { curve, selection } = editor.state.value;
    const ref = selection.points[0];
    const point = ref === undefined || selection.points.length > 1 ? undefined : pointAt(curve, ref);
    if (point === undefined) return false;
    editor.dispatch(movePoints(selection, sample.page.x - point.x, sample.page.y - point.y));
    return true;
  }

  function doubleClick(target: Target): void {
    switch (target.kind) {
      case "point":
        return toggleCusp(editor, { points: [target.point], handle: null });
      case "handle": {
        const { contour, index } = target.handle;
        return resetSelectedHandles(editor, { points: [{ contour, index }], handle: null });
      }
      case "curve":
        return renewing(editor, ({ insertAt }) => insertAt(editor, target.contour, target.t));
      case "grip":
      case "empty":
    }
  }

  const gestures = pressOrDrag<Target>({
    hit: (sample) => (sample.clicks === 2 ? lastClicked : targetOf(sample)),
    begin: dragFor,
    click(target, sample) {
      if (sample.clicks === 2) doubleClick(target);
      else click(target, sample);
      lastClicked = target;
    },
    dragged() {
      lastClicked = { kind: "empty" };
    },
  });

  return {
    ...gestures,
    hover(sample) {
      const target = targetOf(sample);
      const cursor = cursorFor(target, sample.modifiers);
      const { hover, cursor: shown } = editor.state.value;
      if (!sameTarget(target, hover) || cursor !== shown) editor.patch({ hover: target, cursor });
    },
    finish() {
      return false;
    },
  };
}
