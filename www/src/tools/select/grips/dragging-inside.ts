import { movePoints, type Command } from "../../../document/curve/commands.ts";
import { translated } from "../../../document/curve/contours.ts";
import type { Selection } from "../../../document/document.ts";
import { centreOf, frameOf } from "../../../editor/curve/framing.ts";
import type { Editor } from "../../../editor/editor.ts";
import type { PagePoint } from "../../../editor/pointer/camera.ts";
import { constrained, gridOf, snapPlace, type Snapped } from "../../../editor/pointer/snapping.ts";
import { nothingSketched } from "../../../editor/sketch.ts";
import type { Drag, PointerSample } from "../../../editor/tool.ts";
import { curveDrag } from "../curve-drag.ts";

/** Moving contours that are chosen as a whole by what they go round; with Alt, copies of them. */

interface Step {
  readonly dx: number;
  readonly dy: number;
}

/** The copies, over all that was there, and chosen in place of what they were made from. */
function copiesOf({ points }: Selection, { dx, dy }: Step): Command {
  const indices = [...new Set(points.map(({ contour }) => contour))].sort((a, b) => a - b);
  return {
    name: "Duplicate",
    apply: (curve) => ({ ...curve, contours: [...curve.contours, ...indices.flatMap((index) => curve.contours[index] ?? []).map((contour) => translated(contour, dx, dy))] }),
    select({ contours }) {
      const first = contours.length - indices.length;
      return { points: contours.slice(first).flatMap((contour, k) => contour.points.map((_, index) => ({ contour: first + k, index }))), handle: null };
    },
  };
}

/** Of a step, what brings a corner of the frame or its middle in line with points, whichever is nearest to it. */
function snappedStep(editor: Editor, places: readonly PagePoint[], step: Step): Step & Pick<Snapped<PagePoint>, "guides" | "to"> {
  const { curve, selection, view } = editor.state.value;
  const grid = gridOf(editor.state.value);
  const found = places.flatMap((place, i) => {
    const at = { x: place.x + step.dx, y: place.y + step.dy };
    // The grid is for one corner: of several, what is nearest to it would change on the way.
    const { value, guides, to } = snapPlace(curve, selection, at, view.zoom, i === 0 ? grid : null);
    return to === null ? [] : [{ dx: value.x - place.x, dy: value.y - place.y, off: Math.hypot(value.x - at.x, value.y - at.y), onGrid: to === "on the grid", guides, to }];
  });
  const [nearest] = found.sort((a, b) => Number(a.onGrid) - Number(b.onGrid) || a.off - b.off);
  return nearest ?? { ...step, guides: nothingSketched.guides, to: null };
}

/** Shift keeps to the axes and to 45°; Alt leaves what is chosen where it is and moves copies of it. */
export function dragInside(editor: Editor, start: PointerSample): Drag {
  const { selection } = editor.state.value;
  const box = frameOf(editor.state.value);
  const places = box === null ? [] : [{ x: box.minX, y: box.minY }, centreOf(box), { x: box.maxX, y: box.maxY }];
  let copies: Command | null = null;
  editor.begin("Move contours");
  return curveDrag(editor, ({ page, modifiers, kind }) => {
    const { settings } = editor.state.value;
    const free = { dx: page.x - start.page.x, dy: page.y - start.page.y };
    const snaps = settings.snap && !modifiers.mod && !modifiers.shift;
    const { guides, to, dx, dy } = snaps ? snappedStep(editor, places, free) : { ...(modifiers.shift ? constrained(free.dx, free.dy) : free), guides: nothingSketched.guides, to: null };
    copies = modifiers.alt && kind !== "touch" ? copiesOf(selection, { dx, dy }) : null;
    editor.preview(copies ?? { ...movePoints(selection, dx, dy), select: selection }, {
      drag: { dx, dy, snapped: to },
      cursor: copies === null ? "move" : "copy",
      sketch: { ...nothingSketched, guides, finger: null },
    });
  }, () => {
    if (copies === null) return editor.commit();
    // The history says what was done.
    editor.bail();
    editor.dispatch(copies);
  });
}
