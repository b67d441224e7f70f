import type { View } from "../../document/document.ts";
import type { Scene, ScreenBox } from "../scene.ts";

/**
 * The part of the stage that stays while a pointer goes over it, and moves along with the paper: laid down again until
 * what it shows is another.
 */

export interface StillLayer {
  /**
   * Puts on the scene what `draw` draws, as long as nothing in `of` is another, without drawing more of it anew than
   * has come into sight. What is `heavy` is shown as it was, but larger or smaller, while it is zoomed, and drawn when
   * that is over.
   */
  paint(scene: Scene, of: readonly unknown[], heavy: boolean, draw: (scene: Scene) => void): void;
}

const same = (a: readonly unknown[], b: readonly unknown[]): boolean => a.length === b.length && a.every((each, i) => each === b[i]);

/** Frames without a move after which a zoom is over. */
const calmFrames = 6;

/**
 * From one view to another, in device pixels: `x` and `y` of the old picture's corner, and how many times as large it
 * is.
 */
export interface Shift {
  readonly x: number;
  readonly y: number;
  readonly scale: number;
}

export function shiftBetween({ state: { stage }, ratio }: Pick<Scene, "state" | "ratio">, from: View, to: View): Shift {
  const scale = to.zoom / from.zoom;
  const along = (size: number, before: number, after: number): number => ratio * ((size / 2) * (1 - scale) + (before - after) * to.zoom);
  return { x: along(stage.width, from.x, to.x), y: along(stage.height, from.y, to.y), scale };
}

/** The same where it is a move by whole pixels; null where the picture would not be what it was. */
function wholeSteps({ x, y, scale }: Shift): { readonly x: number; readonly y: number } | null {
  const [dx, dy] = [Math.round(x), Math.round(y)];
  // Coordinates of views are sums of steps; so much of a pixel is their rounding.
  return Math.abs(scale - 1) < 1e-12 && Math.hypot(dx - x, dy - y) < 1e-4 ? { x: dx, y: dy } : null;
}

/** What a picture of so many pixels leaves free of the stage, in boxes of whole pixels. */
export function uncovered(width: number, height: number, { x, y, scale }: Shift): ScreenBox[] {
  const left = Math.min(width, Math.max(0, Math.ceil(x)));
  const right = Math.max(left, Math.min(width, Math.floor(x + scale * width)));
  const top = Math.min(height, Math.max(0, Math.ceil(y)));
  const bottom = Math.max(top, Math.min(height, Math.floor(y + scale * height)));
  const boxes = [
    { x: 0, y: 0, width, height: top },
    { x: 0, y: bottom, width, height: height - bottom },
    { x: 0, y: top, width: left, height: bottom - top },
    { x: right, y: top, width: width - right, height: bottom - top },
  ];
  return boxes.filter((box) => box.width > 0 && box.height > 0);
}

export function createStillLayer(repaint: () => void): StillLayer {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d");
  let shown: readonly unknown[] = [];
  /** The view that the canvas holds, if it holds what is shown. */
  let kept: View | null = null;
  let last: View | null = null;
  let calm = 0;

  /** On paper of its own the colours are mixed as they are on the stage, to the last bit. */
  function layPaper(target: CanvasRenderingContext2D, { palette }: Scene): void {
    target.fillStyle = palette.canvas;
    target.fillRect(0, 0, canvas.width, canvas.height);
  }

  /** Draws anew what is in a box of device pixels. */
  function renew(target: CanvasRenderingContext2D, scene: Scene, { x, y, width, height }: ScreenBox, draw: (scene: Scene) => void): void {
    const { ratio } = scene;
    target.save();
    target.setTransform(1, 0, 0, 1, 0, 0);
    target.beginPath();
    target.rect(x, y, width, height);
    target.clip();
    layPaper(target, scene);
    draw({ ...scene, context: target, cut: { x: x / ratio, y: y / ratio, width: width / ratio, height: height / ratio } });
    target.restore();
  }

  function keep(target: CanvasRenderingContext2D, scene: Scene, draw: (scene: Scene) => void): void {
    const { width, height } = canvas;
    const steps = kept === null ? null : wholeSteps(shiftBetween(scene, kept, scene.state.view));
    target.setTransform(1, 0, 0, 1, 0, 0);
    if (steps === null || Math.abs(steps.x) >= width || Math.abs(steps.y) >= height) {
      target.save();
      layPaper(target, scene);
      draw({ ...scene, context: target });
      target.restore();
    } else if (steps.x !== 0 || steps.y !== 0) {
      target.globalCompositeOperation = "copy";
      target.drawImage(canvas, steps.x, steps.y);
      target.globalCompositeOperation = "source-over";
      for (const box of uncovered(width, height, { ...steps, scale: 1 })) renew(target, scene, box, draw);
    }
    kept = scene.state.view;
  }

  function layDown(scene: Scene, { x, y, scale }: Shift): void {
    scene.context.setTransform(scale, 0, 0, scale, x, y);
    scene.context.drawImage(canvas, 0, 0);
  }

  function layDownZoomed(scene: Scene, from: View, draw: (scene: Scene) => void): void {
    const shift = shiftBetween(scene, from, scene.state.view);
    layDown(scene, shift);
    for (const box of uncovered(canvas.width, canvas.height, shift)) renew(scene.context, scene, box, draw);
    repaint();
  }

  return {
    paint(scene, of, heavy, draw) {
      const { view, stage } = scene.state;
      const { width, height } = scene.context.canvas;
      const next = [...of, stage, scene.palette, scene.ratio, width, height];
      const isSame = same(next, shown);
      shown = next;
      calm = view === last ? calm + 1 : 0;
      last = view;
      if (!isSame) kept = null;
      // What has just become another may do so again with the next frame, and keeping it would be work for nothing.
      if (context === null || !isSame) return draw(scene);
      if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height, kept] = [width, height, null];
      if (heavy && kept !== null && calm < calmFrames && wholeSteps(shiftBetween(scene, kept, view)) === null) return layDownZoomed(scene, kept, draw);
      keep(context, scene, draw);
      layDown(scene, { x: 0, y: 0, scale: 1 });
    },
  };
}
