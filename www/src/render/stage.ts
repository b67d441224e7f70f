import type { Mode } from "../document/document.ts";
import { resized } from "../editor/pointer/camera.ts";
import type { Editor, EditorState } from "../editor/editor.ts";
import type { Frame } from "../editor/frame.ts";
import { late } from "../editor/loading.ts";
import { nothingSketched } from "../editor/sketch.ts";
import { drawArtboard, drawCurves, drawFill, drawSpans } from "./layers/curves.ts";
import { drawBezier } from "./layers/bezier.ts";
import { drawHandles, drawPoints, isCrowded } from "./layers/points.ts";
import { drawnDiffers } from "./drawn.ts";
import { readPalette } from "./palette.ts";
import { isFarAway, type Scene } from "./scene.ts";

/** The canvas: one picture per dirty frame, none otherwise. */

/** Some systems give a blank canvas, and say nothing, above this many pixels. */
const mostPixels = 16_777_216;
const mostRatio = 3;

export interface Stage {
  /** Asks for a new picture. */
  repaint(): void;
  /** What modes other than Curve draw, once they are there. */
  readonly painters: Map<Mode, Painter>;
}

export interface Painter {
  /** True: the paper is drawn by something beneath the canvas, which is wiped clear. */
  readonly clear?: boolean;
  paint(scene: Scene): void;
}

/** Device pixels per CSS pixel, within what a canvas can hold. */
function canvasRatio(width: number, height: number, deviceRatio: number): number {
  const wanted = Math.min(mostRatio, Math.max(1, deviceRatio));
  const area = Math.max(1, width * height);
  return Math.min(wanted, Math.sqrt(mostPixels / area));
}

export function createStage(editor: Editor, frame: Frame, surface: HTMLElement, canvas: HTMLCanvasElement, until: AbortSignal): Stage {
  const context = canvas.getContext("2d");
  let palette = readPalette(document.documentElement);
  let ratio = 1;
  let dirty = true;

  function measure(): void {
    const box = surface.getBoundingClientRect();
    // Text of another size leaves another stage.
    palette = readPalette(document.documentElement);
    const stage = { left: box.left, top: box.top, width: box.width, height: box.height, text: palette.em / 12 };
    editor.patch({ stage, view: resized(editor.state.value.view, stage) });
    ratio = canvasRatio(box.width, box.height, window.devicePixelRatio);
    const [width, height] = [Math.floor(box.width * ratio), Math.floor(box.height * ratio)];
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    // Whole device pixels seldom fill a stage exactly; the picture must not be stretched to it.
    canvas.style.width = `${width / ratio}px`;
    canvas.style.height = `${height / ratio}px`;
    repaint();
  }

  const painters = new Map<Mode, Painter>([["curve", curvePainter(editor, repaint)]]);
  const far = late(editor, ({ view }) => isFarAway(view), () => import("./far-away.ts"), repaint);

  function repaint(): void {
    dirty = true;
    frame.request();
  }

  function paint(): void {
    if (!dirty || context === null) return;
    dirty = false;
    const scene: Scene = { context, state: editor.state.value, palette, ratio, origin: editor.origin, focused: surface.contains(document.activeElement) };
    const painter = painters.get(scene.state.mode);
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = palette.canvas;
    if (painter?.clear === true) context.clearRect(0, 0, canvas.width, canvas.height);
    else context.fillRect(0, 0, canvas.width, canvas.height);
    // A stage of no size (a hidden tab, a folded phone) has nothing to draw on.
    if (canvas.width === 0 || canvas.height === 0) return;
    // Every picture begins with the same pens, whatever the last one left, or the canvas forgot when it was resized.
    context.save();
    painter?.paint(far()?.nearby(scene) ?? scene);
    context.restore();
  }

  const recolour = (): void => {
    palette = readPalette(document.documentElement);
    repaint();
    // A page that is being printed has no more frames, and of what a graphics card has shown there is nothing left.
    paint();
  };
  editor.state.subscribe((state, before) => {
    if (drawnDiffers(state, before)) repaint();
    if (surface.style.cursor !== state.cursor) surface.style.cursor = state.cursor;
  }, { until });
  const observer = new ResizeObserver(measure);
  observer.observe(surface);
  until.addEventListener("abort", () => observer.disconnect(), { once: true });
  window.addEventListener("themechange", recolour, { signal: until });
  window.addEventListener("resize", measure, { signal: until });
  for (const type of ["focusin", "focusout"]) surface.addEventListener(type, repaint, { signal: until });
  frame.add("paint", paint);
  measure();
  return { repaint, painters };
}

/**
 * Most of what may lie over a curve is seldom shown, or not before a pointer is there: it comes when it is first to be
 * shown.
 */
function curvePainter(editor: Editor, repaint: () => void): Painter {
  const grid = late(editor, ({ settings }) => settings.overlays.grid, () => import("./layers/grid.ts"), repaint);
  const analysis = late(editor, explains, () => import("./layers/analysis.ts"), repaint);
  const many = late(editor, ({ curve }) => isCrowded(curve), () => import("./small-points.ts"), repaint);
  const sketch = late(editor, sketches, () => import("./layers/sketch.ts"), repaint);
  const weights = late(editor, ({ settings }) => settings.overlays.weights, () => import("./layers/weights.ts"), repaint);
  const grips = late(editor, ({ selection }) => selection.points.length > 0, () => import("./layers/grips.ts"), repaint);
  const paint = (scene: Scene): void => {
    grid()?.drawGrid(scene);
    for (const layer of below) layer(scene);
    sketch()?.drawBefore(scene);
    drawBezier(scene);
    analysis()?.drawBelow(scene);
    weights()?.drawWeights(scene);
    grips()?.drawGrips(scene);
    for (const layer of curves) layer(scene);
    analysis()?.drawKnots(scene);
    drawHandles(scene);
    drawPoints(scene, many()?.createSmallPoints());
    sketch()?.drawSketch(scene);
  };
  return { paint };
}

/** From the grid up, below what the drawing was and above the weights and the frame. */
const below: readonly ((scene: Scene) => void)[] = [drawArtboard, drawFill];
const curves: readonly ((scene: Scene) => void)[] = [drawSpans, drawCurves];

/** Whether anything is to be shown that only explains the curve. */
function explains({ settings: { overlays, subdivisionSteps } }: EditorState): boolean {
  return overlays.comb || overlays.polygon || overlays.knots || overlays.subdivision || subdivisionSteps > 0;
}

/** Whether a tool may have something to show, beginning with where it would take hold. */
function sketches({ hover, drag, sketch }: EditorState): boolean {
  return hover.kind !== "empty" || drag !== null || sketch !== nothingSketched;
}
