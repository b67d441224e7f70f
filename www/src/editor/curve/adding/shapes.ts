import type { Box } from "../../../document/artboard.ts";
import { ellipseIn, rectangleIn } from "../../../document/curve/drawing/shapes.ts";
import { type Command } from "../../../document/curve/commands.ts";
import { addContours } from "../../../document/curve/whole/commands.ts";
import type { CurveDocument } from "../../../document/document.ts";
import { decimalsIn, unitIn } from "../../../document/unit.ts";
import { turnedForFilling } from "../../../kernel/paths/shapes.ts";
import type { PagePoint } from "../../pointer/camera.ts";
import type { Editor, EditorState, ToolId } from "../../editor.ts";
import { gridOf } from "../../pointer/snapping.ts";

/** Ellipses and rectangles, each one more contour of the drawing. */

export type ShapeId = ToolId & ("ellipse" | "rectangle");

const names: Readonly<Record<ShapeId, string>> = { ellipse: "Ellipse", rectangle: "Rectangle" };

/** What the tool that is up draws; null where it is another tool's turn. */
export function shapeOf({ tool, mode }: Pick<EditorState, "tool" | "mode">): ShapeId | null {
  return mode === "curve" && (tool === "ellipse" || tool === "rectangle") ? tool : null;
}

function drawnIn(curve: CurveDocument, shape: ShapeId, box: Box): ReturnType<typeof turnedForFilling> {
  return turnedForFilling(curve, shape === "ellipse" ? ellipseIn(curve, box) : rectangleIn(box));
}

/** The shape that fills a box, the last of all contours, and chosen. */
export function shapeIn(curve: CurveDocument, shape: ShapeId, box: Box): Command {
  return addContours(names[shape], [drawnIn(curve, shape, box).contour], true);
}

/** "240 × 160", to a hundredth of the step that suits the size. */
export function sizeOf(box: Box): string {
  const printed = (side: number): string => String(Number(side.toFixed(decimalsIn(unitIn(box), 2))));
  return `${printed(box.maxX - box.minX)} × ${printed(box.maxY - box.minY)}`;
}

/**
 * Says what was drawn into what was there, and how to go on: the tool stays up for the next one. Which way round a
 * contour runs is not seen, so it is said where it makes a hole.
 */
export function sayDrawn(editor: Editor, before: CurveDocument, shape: ShapeId, box: Box): void {
  const { cuts } = drawnIn(before, shape, box);
  const made = `${names[shape]}, ${sizeOf(box)}${cuts ? ", cut out. Reverse in its menu fills it" : ""}.`;
  editor.patch({ hint: `${made} ${editor.state.value.touch ? "Choose Select" : "Press V"} to move, scale or rotate it.` });
  editor.notify({ kind: "announce", text: `${made} Added as contour ${editor.state.value.curve.contours.length}` });
}

/** What a click or a key makes is no larger on the screen, in CSS pixels. */
const mostUsual = 150;

/** 1, 2 or 5 times a power of ten: 100 where a unit is a pixel. */
export function usualSize({ view }: Pick<EditorState, "view">): number {
  const most = mostUsual / view.zoom;
  const ten = 10 ** Math.floor(Math.log10(most));
  return ten * ([5, 2].find((times) => times * ten <= most) ?? 1);
}

/** A circle or a square of the usual size around a place. */
export function placeShape(editor: Editor, shape: ShapeId, at: PagePoint): void {
  placeIn(editor, shape, boxAround(at, usualSize(editor.state.value)));
}

/** The same in the middle of what is seen; beside one that is there already, which would hide it. */
export function placeInView(editor: Editor): void {
  const { curve, view } = editor.state.value;
  const shape = shapeOf(editor.state.value);
  if (shape === null) return;
  const size = usualSize(editor.state.value);
  const step = gridOf(editor.state.value) ?? size / 100;
  const isTaken = (box: Box): boolean => {
    const [own] = drawnIn(curve, shape, box).contour.points;
    return curve.contours.some(({ points: [first] }) => first?.x === own?.x && first?.y === own?.y);
  };
  const box = (times: number): Box => {
    const onGrid = (place: number): number => step * Math.round((place + (times * size) / 5) / step);
    return boxAround({ x: onGrid(view.x), y: onGrid(view.y) }, size);
  };
  let times = 0;
  while (isTaken(box(times))) times += 1;
  placeIn(editor, shape, box(times));
}

function boxAround({ x, y }: PagePoint, size: number): Box {
  return { minX: x - size / 2, minY: y - size / 2, maxX: x + size / 2, maxY: y + size / 2 };
}

function placeIn(editor: Editor, shape: ShapeId, box: Box): void {
  const { curve } = editor.state.value;
  editor.dispatch(shapeIn(curve, shape, box));
  sayDrawn(editor, curve, shape, box);
}
