import { stretching, transformPoints, turning, type Affine } from "../../document/curve/affine.ts";
import { joinEnds } from "../../document/curve/joining.ts";
import { mostAcross, pointAt } from "../../document/document.ts";
import { around, boundsOf, documentBounds, type Bounds } from "../../kernel/curve/samples.ts";
import { isInside, shapeAt } from "../../kernel/paths/shapes.ts";
import type { Editor, EditorState, Grip, StretchingGrip } from "../editor.ts";
import { refuse } from "./edits.ts";
import { fitted, toScreen, type PagePoint, type ScreenPoint } from "../pointer/camera.ts";

/** The frame around contours that are chosen as a whole, its grips, and what turns and stretches what is chosen. */

/** Where a grip is on the frame: 0 … 1 across and down. */
const places = { nw: [0, 0], n: [0.5, 0], ne: [1, 0], e: [1, 0.5], se: [1, 1], s: [0.5, 1], sw: [0, 1], w: [0, 0.5] } as const satisfies Record<StretchingGrip, readonly [number, number]>;

/** The frame stands off the drawing, CSS pixels, so that points on its edge stay free; fingers need more room. */
const margin = { mouse: 16, touch: 28 } as const;
/** From the frame to the grip that turns it. */
const stem = { mouse: 24, touch: 40 } as const;
/** A side shorter than this on the screen has no grip in its middle. */
const leastSide = 72;

function boxAt({ x, y }: PagePoint): Bounds {
  return { minX: x, minY: y, maxX: x, maxY: y };
}

/** The bounds of the chosen contours; null unless every point of theirs is chosen. */
export function frameOf({ mode, tool, curve, selection }: Pick<EditorState, "mode" | "tool" | "curve" | "selection">): Bounds | null {
  if (mode !== "curve" || tool !== "select" || selection.points.length < 2 || selection.handle !== null) return null;
  const counts = new Map<number, number>();
  for (const { contour } of selection.points) counts.set(contour, (counts.get(contour) ?? 0) + 1);
  const chosen = [...counts].map(([index, count]) => ({ contour: curve.contours[index], count }));
  if (chosen.some(({ contour, count }) => contour?.points.length !== count)) return null;
  return around(chosen.map(({ contour }) => (contour === undefined ? null : boundsOf(curve, contour))));
}

/** The frame on the screen, standing off the drawing. */
export function frameOnScreen(state: EditorState): Bounds | null {
  const box = frameOf(state);
  if (box === null) return null;
  const from = toScreen(state.view, state.stage, { x: box.minX, y: box.minY });
  const to = toScreen(state.view, state.stage, { x: box.maxX, y: box.maxY });
  const off = margin[state.touch ? "touch" : "mouse"];
  return { minX: from.x - off, minY: from.y - off, maxX: to.x + off, maxY: to.y + off };
}

export interface PlacedGrip extends ScreenPoint {
  readonly grip: Exclude<Grip, "corner">;
}

/** Where the grips are on the screen. */
export function gripsOf(state: EditorState): PlacedGrip[] {
  const box = frameOnScreen(state);
  if (box === null) return [];
  const [width, height] = [box.maxX - box.minX, box.maxY - box.minY];
  const sides = (Object.keys(places) as (keyof typeof places)[]).flatMap((grip): PlacedGrip[] => {
    const [x, y] = places[grip];
    const hasRoom = x === 0.5 ? width >= leastSide : y === 0.5 ? height >= leastSide : true;
    return hasRoom ? [{ grip, x: box.minX + x * width, y: box.minY + y * height }] : [];
  });
  return [...sides, { grip: "turn", x: box.minX + width / 2, y: box.minY - stem[state.touch ? "touch" : "mouse"] }];
}

export function nearestGrip(state: EditorState, at: ScreenPoint, reach: number): PlacedGrip["grip"] | null {
  const found = gripsOf(state)
    .map(({ grip, x, y }) => ({ grip, distance: Math.hypot(x - at.x, y - at.y) }))
    .filter(({ distance }) => distance <= reach)
    .sort((a, b) => a.distance - b.distance);
  return found[0]?.grip ?? null;
}

/** Whether a place is inside of what the frame is around: a press there takes hold of all of it. */
export function isInsideFramed(state: EditorState, at: PagePoint): boolean {
  return frameOf(state) !== null && isInside(state.curve, new Set(state.selection.points.map(({ contour }) => contour)), at);
}

export function centreOf({ minX, minY, maxX, maxY }: Bounds): PagePoint {
  return { x: (minX + maxX) / 2, y: (minY + maxY) / 2 };
}

/** Where a grip that stretches is on the drawing itself, and the place across from it, which stays. */
export function gripAndAnchor({ minX, minY, maxX, maxY }: Bounds, grip: keyof typeof places): { grip: PagePoint; anchor: PagePoint } {
  const [x, y] = places[grip];
  const at = (across: number, down: number): PagePoint => ({ x: minX + across * (maxX - minX), y: minY + down * (maxY - minY) });
  return { grip: at(x, y), anchor: at(1 - x, 1 - y) };
}

function chosenPoints({ curve, selection }: EditorState): PagePoint[] {
  return selection.points.flatMap((ref) => pointAt(curve, ref) ?? []);
}

/**
 * The middle of the frame, else of the chosen points: it stays where it is when they are flipped and stretched about
 * it.
 */
function middleOf(state: EditorState): PagePoint | null {
  const box = frameOf({ ...state, tool: "select" }) ?? around(chosenPoints(state).map(boxAt));
  return box === null ? null : centreOf(box);
}

/**
 * The mean of the chosen points: other than the middle of a frame it turns with them, so that a full turn in steps
 * leads back.
 */
function meanOf(state: EditorState): PagePoint | null {
  const points = chosenPoints(state);
  const sum = points.reduce((all, { x, y }) => ({ x: all.x + x, y: all.y + y }), { x: 0, y: 0 });
  return points.length === 0 ? null : { x: sum.x / points.length, y: sum.y / points.length };
}

function transform(editor: Editor, name: string, about: PagePoint | null, map: (about: PagePoint) => Affine): void {
  const { selection } = editor.state.value;
  if (about !== null) editor.dispatch(transformPoints(name, selection, map(about), `${name} ${JSON.stringify(selection.points)}`));
}

function flip(editor: Editor, across: number, down: number): void {
  transform(editor, "Flip", middleOf(editor.state.value), (centre) => stretching(centre, across, down));
}

function turn(editor: Editor, degrees: number): void {
  transform(editor, "Turn", meanOf(editor.state.value), (centre) => turning(centre, degrees));
}

function grow(editor: Editor, factor: number): void {
  transform(editor, "Stretch", middleOf(editor.state.value), (centre) => stretching(centre, factor, factor));
}

/** Ends that stand a pixel apart on the screen look like one. */
function join(editor: Editor): void {
  const { curve, selection, view } = editor.state.value;
  const [one, other, ...more] = selection.points;
  const command = one === undefined || other === undefined || more.length > 0 ? null : joinEnds(curve, [one, other], 1 / view.zoom);
  if (command === null) return refuse(editor, "Select two open ends of Hermite curves in the same space.");
  editor.dispatch(command);
}

/** What keys and menus do to the chosen points, by the names of the actions. */
export const transforms = {
  "turn-right": (editor: Editor): void => turn(editor, 15),
  "turn-left": (editor: Editor): void => turn(editor, -15),
  grow: (editor: Editor): void => grow(editor, 1.1),
  shrink: (editor: Editor): void => grow(editor, 1 / 1.1),
  "flip-across": (editor: Editor): void => flip(editor, -1, 1),
  "flip-down": (editor: Editor): void => flip(editor, 1, -1),
  join,
} as const;

/** Contours that are chosen as a whole fill the stage; of others the chosen points, with the segments beside them. */
export function showChosen(editor: Editor): void {
  const state = editor.state.value;
  const { curve, selection, stage } = state;
  const places = selection.points.flatMap(({ contour, index }) => {
    const shape = curve.contours[contour];
    const count = shape?.points.length ?? 0;
    const beside = [index - 1, index, index + 1].map((i) => (shape?.closed === true ? (i + count) % count : i));
    return beside.flatMap((i) => shape?.points[i] ?? []);
  });
  const box = frameOf({ ...state, tool: "select" }) ?? around(places.map(boxAt));
  const all = documentBounds(curve);
  if (box !== null && all !== null) editor.patch({ view: fitted(box, stage, mostAcross / Math.max(all.maxX - all.minX, all.maxY - all.minY)) });
}

/** Every point of the contours of which one is chosen, or which the pointer is over. */
export function selectContours(editor: Editor): void {
  const { curve, selection, hover } = editor.state.value;
  const wanted = new Set(hover.kind === "curve" ? [hover.contour] : selection.points.map(({ contour }) => contour));
  const points = curve.contours.flatMap((contour, c) => (wanted.has(c) ? contour.points.map((_, index) => ({ contour: c, index })) : []));
  editor.patch({ selection: { points, handle: null }, hint: "" });
}

/** The shape that a place is inside, all of it. */
export function selectShapeAt(editor: Editor, at: PagePoint): void {
  const points = shapeAt(editor.state.value.curve, at);
  if (points.length > 0) editor.patch({ selection: { points, handle: null }, hint: "" });
}
