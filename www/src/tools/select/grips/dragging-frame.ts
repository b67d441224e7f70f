import { stretching, transformPoints, turning, type Affine } from "../../../document/curve/affine.ts";
import { centreOf, frameOf, gripAndAnchor, isInsideFramed, nearestGrip } from "../../../editor/curve/framing.ts";
import type { Editor, Grip, Guide, StretchingGrip, Target } from "../../../editor/editor.ts";
import type { PagePoint } from "../../../editor/pointer/camera.ts";
import { reachOf } from "../../../editor/pointer/hit-test.ts";
import { gridOf, snapPlace } from "../../../editor/pointer/snapping.ts";
import { nothingSketched } from "../../../editor/sketch.ts";
import type { Drag, PointerSample } from "../../../editor/tool.ts";
import { curveDrag } from "../curve-drag.ts";
import { dragInside } from "./dragging-inside.ts";

/** Turning and stretching what is chosen by the grips of its frame: circles become ellipses, and are exact. */

interface Change {
  readonly map: Affine;
  readonly says: string;
  readonly guides: readonly Guide[];
}

const none = nothingSketched.guides;
/** A drawing that is pressed flat could not be stretched again. */
const leastFactor = 1e-3;

/** Shift keeps the proportions, Alt stretches from the middle. */
function stretchBy(editor: Editor, start: PointerSample, grip: StretchingGrip): (sample: PointerSample) => Change | null {
  const { curve, selection } = editor.state.value;
  const frame = frameOf(editor.state.value);
  if (frame === null) return () => null;
  const { grip: held, anchor } = gripAndAnchor(frame, grip);
  const middle = centreOf(frame);
  const factorOf = (way: number, before: number): number => {
    const factor = Math.abs(before) < 1e-9 ? 1 : way / before;
    return Math.abs(factor) < leastFactor ? leastFactor : factor;
  };
  return ({ page, modifiers }) => {
    const { settings, view } = editor.state.value;
    const fixed = modifiers.alt ? middle : anchor;
    const step = { x: page.x - start.page.x, y: page.y - start.page.y };
    const snaps = settings.snap && !modifiers.mod && !modifiers.shift;
    const free = { x: held.x + step.x, y: held.y + step.y };
    const found = snaps ? snapPlace(curve, selection, free, view.zoom, gridOf(editor.state.value)) : { value: free, guides: none };
    const [before, now] = [difference(held, fixed), difference(found.value, fixed)];
    const sides = grip.length === 1;
    const across = grip === "n" || grip === "s" ? 1 : factorOf(now.x, before.x);
    const down = grip === "e" || grip === "w" ? 1 : factorOf(now.y, before.y);
    const along = factorOf(now.x * before.x + now.y * before.y, before.x ** 2 + before.y ** 2);
    const both = sides ? (grip === "n" || grip === "s" ? down : across) : along;
    const [width, height] = modifiers.shift ? [both, both] : [across, down];
    return { map: stretching(fixed, width, height), says: `${Math.round(width * 1000) / 10} % wide, ${Math.round(height * 1000) / 10} % high`, guides: found.guides };
  };
}

function difference(a: PagePoint, b: PagePoint): PagePoint {
  return { x: a.x - b.x, y: a.y - b.y };
}

/** Shift turns by steps of 15°. */
function turnBy(editor: Editor, start: PointerSample): (sample: PointerSample) => Change | null {
  const frame = frameOf(editor.state.value);
  if (frame === null) return () => null;
  const centre = centreOf(frame);
  const angleOf = ({ x, y }: PagePoint): number => (Math.atan2(y - centre.y, x - centre.x) * 180) / Math.PI;
  const from = angleOf(start.page);
  return ({ page, modifiers }) => {
    const free = angleOf(page) - from;
    const whole = modifiers.shift ? 15 * Math.round(free / 15) : free;
    const degrees = whole - 360 * Math.round(whole / 360);
    return { map: turning(centre, degrees), says: `rotated by ${Math.round(degrees * 10) / 10 + 0}°`, guides: [{ from: centre, to: page }] };
  };
}

const cursors: Readonly<Record<Exclude<Grip, "corner">, string>> = {
  nw: "nwse-resize", n: "ns-resize", ne: "nesw-resize", e: "ew-resize", se: "nwse-resize", s: "ns-resize", sw: "nesw-resize", w: "ew-resize", turn: "grab", inside: "move",
};

/** The grip under the pointer, or what the frame is around. */
export function gripUnder(editor: Editor, { screen, page, kind, modifiers }: PointerSample): Target | null {
  const grip = nearestGrip(editor.state.value, screen, reachOf[kind]);
  if (grip === null) {
    if (!isInsideFramed(editor.state.value, page)) return null;
    const hint = kind === "touch" ? "Drag to move what is selected." : "Drag to move what is selected, Alt-drag to copy it. Shift keeps it level or upright.";
    return { kind: "grip", grip: "inside", cursor: modifiers.alt ? "copy" : cursors.inside, hint };
  }
  const hint = grip === "turn" ? "Drag to rotate; Shift for 15° steps." : "Drag to scale; Shift keeps proportions, Alt scales from the centre.";
  return { kind: "grip", grip, cursor: cursors[grip], hint };
}

export function dragFrame(editor: Editor, start: PointerSample, grip: Exclude<Grip, "corner">): Drag {
  if (grip === "inside") return dragInside(editor, start);
  const { selection } = editor.state.value;
  const change = grip === "turn" ? turnBy(editor, start) : stretchBy(editor, start, grip);
  const name = grip === "turn" ? "Turn" : "Stretch";
  editor.begin(name);
  return curveDrag(editor, (sample) => {
    const next = change(sample);
    if (next === null) return;
    const step = { dx: sample.page.x - start.page.x, dy: sample.page.y - start.page.y };
    editor.preview({ ...transformPoints(name, selection, next.map), select: selection }, {
      drag: { ...step, snapped: null, says: next.says },
      sketch: { ...nothingSketched, guides: next.guides, finger: null },
    });
  });
}
