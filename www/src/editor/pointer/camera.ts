import type { Box } from "../../document/artboard.ts";
import { mostAcross, type View } from "../../document/document.ts";

/** The only place where screen and document coordinates are turned into each other. */

declare const screenBrand: unique symbol;
declare const pageBrand: unique symbol;

/** CSS pixels from the stage's top left corner. */
export interface ScreenPoint {
  readonly x: number;
  readonly y: number;
  readonly [screenBrand]?: true;
}

/** Document units. */
export interface PagePoint {
  readonly x: number;
  readonly y: number;
  readonly [pageBrand]?: true;
}

/** The stage in the window, CSS pixels. */
export interface StageBox {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
  /** How large the page's text is, as a multiple of what browsers begin with; 1 where it is not said. */
  readonly text?: number;
}

/**
 * 5 % and 6400 %, and beyond them as far as the drawing is larger or smaller than drawings are: all of it can be seen,
 * and its parts too.
 */
function limitsFor(box: Box | null): readonly [least: number, most: number] {
  const size = box === null ? 0 : Math.max(box.maxX - box.minX, box.maxY - box.minY);
  return size > 0 ? [Math.min(0.05, 40 / size), Math.min(mostAcross / size, Math.max(64, Math.min(1e9, 16_000 / size)))] : [0.05, 64];
}

/** Within the limits of what is drawn; what is seen already, by whatever way, stays in reach. */
function clampZoom(zoom: number, from: View, box: Box | null): number {
  const [least, most] = limitsFor(box);
  return Math.min(Math.max(most, from.zoom), Math.max(Math.min(least, from.zoom), zoom));
}

/** CSS pixels downwards per document unit of y. */
export function zoomDown({ zoom, up }: View): number {
  return up === true ? -zoom : zoom;
}

export function toScreen(view: View, stage: StageBox, point: PagePoint): ScreenPoint {
  return { x: stage.width / 2 + (point.x - view.x) * view.zoom, y: stage.height / 2 + (point.y - view.y) * zoomDown(view) };
}

export function toPage(view: View, stage: StageBox, point: ScreenPoint): PagePoint {
  return { x: view.x + (point.x - stage.width / 2) / view.zoom, y: view.y + (point.y - stage.height / 2) / zoomDown(view) };
}

/** The view zoomed so that the document stays put under one place of the screen. */
export function zoomedAt(view: View, stage: StageBox, at: ScreenPoint, zoom: number, box: Box | null): View {
  const next = { ...view, zoom: clampZoom(zoom, view, box) };
  const [page, there] = [toPage(view, stage, at), toPage(next, stage, at)];
  return { ...next, x: view.x + page.x - there.x, y: view.y + page.y - there.y };
}

/** The view moved with the hand, by CSS pixels. */
export function panned(view: View, dx: number, dy: number): View {
  return { ...view, x: view.x - dx / view.zoom, y: view.y - dy / zoomDown(view) };
}

/** What views were made to show. */
const fittings = new WeakMap<View, readonly [box: Box, most: number, share: number]>();

/**
 * A view that shows the whole box, never closer than `most`; handles and what lies over the stage have a share of it on
 * every side.
 */
export function fitted(box: Box, stage: StageBox, most = Infinity, share = 0.1): View {
  const margin = Math.max(24, Math.min(stage.width, stage.height) * share);
  // The hint, in two lines where the stage is low, and the zoom box are below; on a phone the zoom box is above, and
  // two lines of hint over the tools are below. Larger text is higher, and has more lines; on phones it ends growing,
  // and on the lowest stages there is none, and all is below.
  const { width, height } = stage;
  const text = height < 200 ? 1 : stage.text ?? 1;
  const [least, lines] = width < 600 ? [64, 112] : [48, 60];
  const above = Math.max(margin, height < 130 ? 0 : Math.min(least * text ** 0.5, height * (0.425 - 0.1 * text)));
  const below = Math.max(margin, Math.min(lines * text ** 1.5, 0.6 * width, Math.max(60, height * (0.1 + 0.275 * text))));
  const wide = Math.max(1, width - 2 * margin) / Math.max(1e-9, box.maxX - box.minX);
  const high = Math.max(1, height - above - below) / Math.max(1e-9, box.maxY - box.minY);
  const zoom = Math.min(wide, high, most, limitsFor(box)[1]);
  const view = { zoom, x: (box.minX + box.maxX) / 2, y: (box.minY + box.maxY) / 2 + (below - above) / 2 / zoom };
  fittings.set(view, [box, most, share]);
  return view;
}

/**
 * A view for a stage of another size: what was fitted stays in sight, what somebody has moved stays where it was put.
 */
export function resized(view: View, stage: StageBox): View {
  const [box, most, share] = fittings.get(view) ?? [];
  return box === undefined || most === undefined ? view : fitted(box, stage, most, share);
}

/** The view with y pointing up or down; what was fitted stays in its place on the stage. */
export function turned(view: View, up: boolean): View {
  const { zoom, x, y } = view;
  const fitting = fittings.get(view);
  const next = { zoom, x, y: fitting === undefined ? y : fitting[0].minY + fitting[0].maxY - y, ...(up ? { up } : {}) };
  if (fitting !== undefined) fittings.set(next, fitting);
  return next;
}
