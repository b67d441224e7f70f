import type { View } from "../../document/document.ts";

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
}

export const leastZoom = 0.05;
export const mostZoom = 64;

/** Within the limits; of a drawing that is larger than they show, what is seen of it already stays in reach. */
export function clampZoom(zoom: number, from: View): number {
  return Math.min(mostZoom, Math.max(Math.min(leastZoom, from.zoom), zoom));
}

export function toScreen(view: View, stage: StageBox, point: PagePoint): ScreenPoint {
  return { x: stage.width / 2 + (point.x - view.x) * view.zoom, y: stage.height / 2 + (point.y - view.y) * view.zoom };
}

export function toPage(view: View, stage: StageBox, point: ScreenPoint): PagePoint {
  return { x: view.x + (point.x - stage.width / 2) / view.zoom, y: view.y + (point.y - stage.height / 2) / view.zoom };
}

/** The view zoomed so that the document stays put under one place of the screen. */
export function zoomedAt(view: View, stage: StageBox, at: ScreenPoint, zoom: number): View {
  const next = clampZoom(zoom, view);
  const page = toPage(view, stage, at);
  return { zoom: next, x: page.x - (at.x - stage.width / 2) / next, y: page.y - (at.y - stage.height / 2) / next };
}

/** The view moved with the hand, by CSS pixels. */
export function panned(view: View, dx: number, dy: number): View {
  return { ...view, x: view.x - dx / view.zoom, y: view.y - dy / view.zoom };
}

interface Box {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
}

/** What views were made to show. */
const fittings = new WeakMap<View, readonly [box: Box, most: number, share: number]>();

/** A view that shows the whole box, never closer than `most`; handles and what lies over the stage have a share of it on every side. */
export function fitted(box: Box, stage: StageBox, most: number, share = 0.1): View {
  const margin = Math.max(24, Math.min(stage.width, stage.height) * share);
  // The hint and the zoom box are below; on a phone the zoom box is above, and two lines of hint over the tools are below.
  const [above = 0, below = 0] = (stage.width < 600 ? [64, 112] : [48, 48]).map((least) => Math.max(margin, Math.min(least, stage.height * 0.35)));
  const wide = Math.max(1, stage.width - 2 * margin) / Math.max(1e-9, box.maxX - box.minX);
  const high = Math.max(1, stage.height - above - below) / Math.max(1e-9, box.maxY - box.minY);
  const zoom = Math.min(wide, high, most, mostZoom);
  const view = { zoom, x: (box.minX + box.maxX) / 2, y: (box.minY + box.maxY) / 2 + (below - above) / 2 / zoom };
  fittings.set(view, [box, most, share]);
  return view;
}

/** A view for a stage of another size: what was fitted stays in sight, what somebody has moved stays where it was put. */
export function resized(view: View, stage: StageBox): View {
  const [box, most, share] = fittings.get(view) ?? [];
  return box === undefined || most === undefined ? view : fitted(box, stage, most, share);
}
