import type { Editor, Modifiers, Target } from "../../editor/editor.ts";
import { late } from "../../editor/loading.ts";
import { hitTest, sameTarget } from "../../editor/pointer/hit-test.ts";
import type { Drag, PointerSample, Tool } from "../../editor/tool.ts";
import { pressOrDrag } from "../press-or-drag.ts";
import { brush } from "./brushing.ts";
import { click, doubleClick } from "./clicking.ts";
import { dragHandle } from "./dragging-handle.ts";
import { dragPoints } from "./dragging-points.ts";
import { dragSegment } from "./dragging-segment.ts";
import { panWith } from "./panning.ts";
import { endsAt, segmentAt } from "./segment-at.ts";

/** Select and edit. */

type Grips = typeof import("./grips/grips.ts");

const nowhere: Target = { kind: "empty" };

export function createSelectTool(editor: Editor): Tool {
  /** They are of use when something is chosen. */
  const grips = late(editor, ({ selection }) => selection.points.length > 0, () => import("./grips/grips.ts"));
  /** What the last click hit: the second click of a double-click means the same thing, whatever appeared since. */
  let lastClicked = nowhere;

  const gestures = pressOrDrag<Target>({
    hit: (sample) => (sample.clicks === 2 ? lastClicked : targetOf(editor, grips(), sample)),
    begin: (start, target) => dragOf(editor, grips(), start, target),
    click(hit, sample) {
      // Inside of what is chosen a click means what it means elsewhere.
      const target = hit.kind === "grip" && hit.grip === "inside" ? nowhere : hit;
      if (sample.clicks === 2) doubleClick(editor, target, sample);
      else click(editor, target, sample);
      lastClicked = target;
    },
    dragged() {
      lastClicked = nowhere;
    },
  });

  return {
    ...gestures,
    hover: (sample) => announce(editor, targetOf(editor, grips(), sample), sample.modifiers),
    finish: () => false,
  };
}

function targetOf(editor: Editor, grips: Grips | null, sample: PointerSample): Target {
  const target = hitTest(editor.state.value, sample.screen, sample.kind);
  return (target.kind === "empty" ? grips?.gripUnder(editor, sample) : null) ?? target;
}

function dragOf(editor: Editor, grips: Grips | null, start: PointerSample, target: Target): Drag {
  switch (target.kind) {
    case "point":
      return dragPoints(editor, start, target.point);
    case "handle":
      return dragHandle(editor, start, target.handle);
    case "curve": {
      const { curve } = editor.state.value;
      return dragSegment(editor, start, endsAt(curve, target.contour, target.t), segmentAt(curve, target.contour, target.t));
    }
    case "grip":
      return grips?.dragGrip(editor, start, target.grip) ?? panWith(editor, start);
    case "empty":
      return start.kind === "touch" ? panWith(editor, start) : brush(editor, start);
  }
}

/** Hover and cursor say what a press would do. */
function announce(editor: Editor, target: Target, modifiers: Modifiers): void {
  const { hover, cursor: shown } = editor.state.value;
  const cursor = cursorFor(target, modifiers);
  if (!sameTarget(target, hover) || cursor !== shown) editor.patch({ hover: target, cursor });
}

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
