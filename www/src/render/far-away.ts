import { translated } from "../document/curve/contours.ts";
import type { Contour, CurveDocument } from "../document/document.ts";
import type { Pair } from "../document/fit/fit.ts";
import type { EditorState } from "../editor/editor.ts";
import type { PagePoint } from "../editor/pointer/camera.ts";
import { gridOf } from "../editor/pointer/snapping.ts";
import { asMoved } from "../kernel/fit/moved.ts";
import { isFarAway, type Scene } from "./scene.ts";

/**
 * The picture of what is far from the origin. Browsers keep the places of a path in single precision, seven digits: of
 * a field in the coordinates of a map they leave stairs, and of its outline nothing. So such a scene is drawn nearer to
 * the origin: the document, what is sketched on it and the view are moved by one step, and what is seen is the same.
 */

/** What the picture's own origin is in the document. */
let anchor: PagePoint = { x: 0, y: 0 };

/** What was moved to it: whoever draws knows paths by what they are of. */
let moved = new WeakMap<object, object>();

/** CSS pixels that places of the picture's origin are apart: multiples of every step that a grid may show. */
const apart = 4096;

/** The same scene nearer to the origin; itself where that is near. */
export function nearby(scene: Scene): Scene {
  const { state } = scene;
  const { view, mode, fitView, fitRun } = state;
  if (mode === "trace" || mode === "surface" || !isFarAway(view)) return scene;
  if (isFarAway(near(view))) {
    anchor = anchorOf(state);
    moved = new WeakMap();
  }
  return {
    ...scene,
    origin: drawing(scene.origin),
    state: {
      ...state,
      view: near(view),
      curve: drawing(state.curve),
      hover: "x" in state.hover ? near(state.hover) : state.hover,
      sketch: sketched(state.sketch),
      fit: once(state.fit, (fit) => ({ ...fit, data: places(fit.data) })),
      fitView: { ...fitView, stroke: places(fitView.stroke), brush: maybe(fitView.brush, near) },
      fitRun: { ...fitRun, outcome: maybe(fitRun.outcome, (outcome) => once(outcome, (far) => asMoved(far, -anchor.x, -anchor.y))) },
    },
  };
}

function anchorOf(state: EditorState): PagePoint {
  const { view } = state;
  const grid = gridOf(state);
  const halvings = Math.round(Math.log2(apart / ((grid ?? 1) * view.zoom)));
  const step = grid === null ? 2 ** halvings : grid * 2 ** Math.max(0, halvings);
  return { x: Math.round(view.x / step) * step, y: Math.round(view.y / step) * step };
}

function near<T extends PagePoint>(place: T): T {
  return { ...place, x: place.x - anchor.x, y: place.y - anchor.y };
}

function once<T extends object>(far: T, make: (far: T) => T): T {
  const known = moved.get(far) as T | undefined;
  if (known !== undefined) return known;
  const fresh = make(far);
  moved.set(far, fresh);
  return fresh;
}

function maybe<T>(value: T | null, move: (value: T) => T): T | null {
  return value === null ? null : move(value);
}

function places(far: readonly Pair[]): readonly Pair[] {
  return once(far, (pairs) => pairs.map(([x, y]) => [x - anchor.x, y - anchor.y] as const));
}

function outline(far: Contour): Contour {
  return once(far, (contour) => translated(contour, -anchor.x, -anchor.y));
}

function drawing(far: CurveDocument): CurveDocument {
  return once(far, ({ artboard, ...curve }) => ({ ...curve, contours: curve.contours.map(outline), ...(artboard === undefined ? {} : { artboard: near(artboard) }) }));
}

function sketched(sketch: EditorState["sketch"]): EditorState["sketch"] {
  const { guides, marquee, rubber, stroke, joint, finger, proposal } = sketch;
  const between = <T extends { readonly from: PagePoint; readonly to: PagePoint }>(ends: T): T => ({ ...ends, from: near(ends.from), to: near(ends.to) });
  return {
    guides: guides.map(between),
    marquee: maybe(marquee, between),
    rubber: maybe(rubber, (each) => ({ ...each, contour: outline(each.contour) })),
    stroke: places(stroke),
    joint: maybe(joint, near),
    finger: maybe(finger, near),
    proposal: maybe(proposal, drawing),
  };
}
