import { movePoints } from "../../document/curve/commands.ts";
import { isSelected, nothingSelected, pointAt, samePoint, type PointRef, type Selection } from "../../document/document.ts";
import { resetSelectedHandles, toggleCusp } from "../../editor/curve/edits.ts";
import { framing, renewing } from "../../editor/curve/on-demand.ts";
import type { Editor, Target } from "../../editor/editor.ts";
import type { PagePoint } from "../../editor/pointer/camera.ts";
import type { PointerSample } from "../../editor/tool.ts";
import { endsAt } from "./segment-at.ts";

/** A click chooses what it hits, with Shift beside what is chosen already; a double-click changes it. */

export function click(editor: Editor, target: Target, { page, modifiers: { shift: adds } }: PointerSample): void {
  const { curve, selection, settings } = editor.state.value;
  switch (target.kind) {
    case "point":
      return editor.patch({ selection: adds ? toggled(selection, target.point) : only(target.point) });
    case "handle":
      return editor.patch({ selection: { ...only(target.handle), handle: target.handle } });
    case "curve": {
      const ends = endsAt(curve, target.contour, target.t);
      return editor.patch({ selection: adds ? joined(selection, ends) : ends });
    }
    case "grip":
      return;
    case "empty":
      if (settings.moveByClicks && moveTo(editor, page)) return;
      if (!adds) editor.patch({ selection: nothingSelected });
  }
}

export function doubleClick(editor: Editor, target: Target, { page }: PointerSample): void {
  switch (target.kind) {
    case "point":
      return toggleCusp(editor, only(target.point));
    case "handle":
      return resetSelectedHandles(editor, only(target.handle));
    case "curve":
      return renewing(editor, ({ insertAt }) => insertAt(editor, target.contour, target.t));
    case "grip":
      return;
    case "empty":
      // Where clicks move a point, the first of them has.
      if (!editor.state.value.settings.moveByClicks) framing(editor, ({ selectShapeAt }) => selectShapeAt(editor, page));
  }
}

function only({ contour, index }: PointRef): Selection {
  return { points: [{ contour, index }], handle: null };
}

function toggled(selection: Selection, point: PointRef): Selection {
  const others = selection.points.filter((other) => !samePoint(other, point));
  return { points: isSelected(selection, point) ? others : [...others, point], handle: null };
}

function joined(selection: Selection, more: Selection): Selection {
  return { points: [...selection.points.filter((ref) => !isSelected(more, ref)), ...more.points], handle: null };
}

/** Move by clicks: the one chosen point goes where the click was. */
function moveTo(editor: Editor, page: PagePoint): boolean {
  const { curve, selection } = editor.state.value;
  const [ref, another] = selection.points;
  const point = ref === undefined || another !== undefined ? undefined : pointAt(curve, ref);
  if (point === undefined) return false;
  editor.dispatch(movePoints(selection, page.x - point.x, page.y - point.y));
  return true;
}
