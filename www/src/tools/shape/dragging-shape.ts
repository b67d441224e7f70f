import type { Box } from "../../document/artboard.ts";
import { nothingSelected, type CurveDocument } from "../../document/document.ts";
import { sayDrawn, shapeIn, sizeOf, type ShapeId } from "../../editor/curve/adding/shapes.ts";
import { refuse } from "../../editor/curve/edits.ts";
import type { Editor, EditorState, Modifiers } from "../../editor/editor.ts";
import type { PagePoint } from "../../editor/pointer/camera.ts";
import { gridOf, snapPlace } from "../../editor/pointer/snapping.ts";
import { nothingSketched } from "../../editor/sketch.ts";
import type { Drag, PointerSample } from "../../editor/tool.ts";
import { curveDrag } from "../select/curve-drag.ts";
import { whileDrawing } from "./shape-hint.ts";

/** A shape drawn from corner to corner of its box. */

/** A side that is shorter on the screen, in CSS pixels, is none. */
const leastSide = 0.5;

export function dragShape(editor: Editor, start: PointerSample, shape: ShapeId): Drag {
  // The shape that is drawn does not snap to itself.
  const { curve } = editor.state.value;
  const touch = start.kind === "touch";
  let from = snapTo(editor.state.value, curve, start).value;
  let to = from;
  let last = start.page;
  let box: Box | null = null;
  editor.begin(shapeIn(curve, shape, boxOf(from, to, start.modifiers)).name);

  function update(sample: PointerSample): void {
    const { space, view } = editor.state.value;
    const snapped = snapTo(editor.state.value, curve, sample);
    const step = { x: sample.page.x - last.x, y: sample.page.y - last.y };
    last = sample.page;
    if (space) [from, to] = [movedBy(from, step), movedBy(to, step)];
    else to = snapped.value;
    const next = boxOf(from, to, sample.modifiers);
    if (Math.min(next.maxX - next.minX, next.maxY - next.minY) * view.zoom < leastSide) return;
    box = next;
    // Where Shift or Space has put the corner elsewhere, it is on nothing.
    const isThere = !space && isCornerOf(next, snapped.value);
    editor.preview(shapeIn(curve, shape, next), {
      drag: { dx: to.x - from.x, dy: to.y - from.y, snapped: null },
      hint: whileDrawing(shape, touch, [sizeOf(next), isThere && snapped.to !== null ? `snapped ${snapped.to}` : null]),
      cursor: "crosshair",
      sketch: { ...nothingSketched, guides: isThere ? snapped.guides : [], finger: touch ? sample.page : null },
    });
  }

  function end(): void {
    editor.commit();
    if (box === null) refuse(editor, "That had no width or no height. Drag from corner to corner.");
    else sayDrawn(editor, curve, shape, box);
  }

  const drag = curveDrag(editor, update, end);
  return {
    ...drag,
    cancel() {
      drag.cancel();
      editor.patch({ hint: "" });
    },
  };
}

/** Where a corner goes. */
export function snapTo({ settings, view }: EditorState, curve: CurveDocument, { page, modifiers }: PointerSample): ReturnType<typeof snapPlace> {
  if (!settings.snap || modifiers.mod) return { value: page, guides: [], to: null };
  return snapPlace(curve, nothingSelected, page, view.zoom, gridOf({ curve, settings }));
}

/** Shift makes the sides equal, by the longer one; with Alt, `from` is in the middle. */
function boxOf(from: PagePoint, to: PagePoint, { shift, alt }: Modifiers): Box {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const side = Math.max(Math.abs(dx), Math.abs(dy));
  const end = shift ? { x: from.x + (dx < 0 ? -side : side), y: from.y + (dy < 0 ? -side : side) } : to;
  const begin = alt ? { x: 2 * from.x - end.x, y: 2 * from.y - end.y } : from;
  return { minX: Math.min(begin.x, end.x), minY: Math.min(begin.y, end.y), maxX: Math.max(begin.x, end.x), maxY: Math.max(begin.y, end.y) };
}

function isCornerOf({ minX, minY, maxX, maxY }: Box, { x, y }: PagePoint): boolean {
  return (x === minX || x === maxX) && (y === minY || y === maxY);
}

function movedBy({ x, y }: PagePoint, step: PagePoint): PagePoint {
  return { x: x + step.x, y: y + step.y };
}
