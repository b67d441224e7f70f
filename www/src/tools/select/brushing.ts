import { nothingSelected, samePoint, type PointRef, type Selection } from "../../document/document.ts";
import type { PagePoint } from "../../editor/pointer/camera.ts";
import { nothingSketched } from "../../editor/sketch.ts";
import type { Editor } from "../../editor/editor.ts";
import type { Drag, PointerSample } from "../../editor/tool.ts";

/** The marquee. Shift held at the press adds, Shift pressed on the way makes a square, Alt takes away. */
export function brush(editor: Editor, start: PointerSample): Drag {
  const before = editor.state.value.selection;
  const adds = start.modifiers.shift;

  function inside(from: PagePoint, to: PagePoint): PointRef[] {
    const [minX, maxX] = [Math.min(from.x, to.x), Math.max(from.x, to.x)];
    const [minY, maxY] = [Math.min(from.y, to.y), Math.max(from.y, to.y)];
    return editor.state.value.curve.contours.flatMap((contour, c) =>
      contour.points.flatMap((point, index) =>
        point.x >= minX && point.x <= maxX && point.y >= minY && point.y <= maxY ? [{ contour: c, index }] : [],
      ),
    );
  }

  function chosen(caught: readonly PointRef[], subtracts: boolean): Selection {
    const isCaught = (ref: PointRef): boolean => caught.some((other) => samePoint(other, ref));
    if (subtracts) return { points: before.points.filter((ref) => !isCaught(ref)), handle: null };
    const kept = adds ? before.points.filter((ref) => !isCaught(ref)) : nothingSelected.points;
    return { points: [...kept, ...caught], handle: null };
  }

  return {
    update(sample) {
      const to = sample.modifiers.shift && !adds ? squared(start.page, sample.page) : sample.page;
      editor.patch({
        selection: chosen(inside(start.page, to), sample.modifiers.alt),
        sketch: { ...nothingSketched, marquee: { from: start.page, to } },
        cursor: "crosshair",
      });
    },
    finish() {
      editor.patch({ sketch: nothingSketched });
    },
    cancel() {
      editor.patch({ selection: before, sketch: nothingSketched });
    },
  };
}

function squared(from: PagePoint, to: PagePoint): PagePoint {
  const size = Math.max(Math.abs(to.x - from.x), Math.abs(to.y - from.y));
  return { x: from.x + Math.sign(to.x - from.x) * size, y: from.y + Math.sign(to.y - from.y) * size };
}
