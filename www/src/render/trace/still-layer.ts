import type { Scene } from "../scene.ts";

/** The part of the stage that stays while a pointer goes over it: laid down again until what it shows is another. */

export interface StillLayer {
  /** Puts on the scene what `draw` draws, as long as nothing in `of` is another, without drawing it anew. */
  paint(scene: Scene, of: readonly unknown[], draw: (scene: Scene) => void): void;
}

const same = (a: readonly unknown[], b: readonly unknown[]): boolean => a.length === b.length && a.every((each, i) => each === b[i]);

export function createStillLayer(): StillLayer {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d");
  let last: readonly unknown[] = [];
  let kept: readonly unknown[] = [];

  function keep(target: CanvasRenderingContext2D, scene: Scene, draw: (scene: Scene) => void): void {
    const { width, height } = scene.context.canvas;
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    target.setTransform(1, 0, 0, 1, 0, 0);
    target.clearRect(0, 0, width, height);
    target.save();
    draw({ ...scene, context: target });
    target.restore();
  }

  return {
    paint(scene, of, draw) {
      const { view, stage } = scene.state;
      const { width, height } = scene.context.canvas;
      const shown = [...of, view, stage, scene.palette, scene.ratio, width, height];
      // While the paper moves every frame is another, and keeping it would be work for nothing.
      const stays = same(shown, last);
      last = shown;
      if (context === null || !stays) return draw(scene);
      if (!same(shown, kept)) keep(context, scene, draw);
      kept = shown;
      scene.context.setTransform(1, 0, 0, 1, 0, 0);
      scene.context.drawImage(canvas, 0, 0);
    },
  };
}
