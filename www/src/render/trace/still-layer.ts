import type { Scene } from "../scene.ts";

/** The part of the stage that stays while a pointer goes over it: drawn once, and laid down again until what it shows is another. */

export interface StillLayer {
  /** Draws with `draw` if one of `of` is another than last time, and puts the outcome on the scene. */
  paint(scene: Scene, of: readonly unknown[], draw: (scene: Scene) => void): void;
}

export function createStillLayer(): StillLayer {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d");
  let drawn: readonly unknown[] = [];
  return {
    paint(scene, of, draw) {
      const { width, height } = scene.context.canvas;
      // Without a second canvas every picture is drawn anew, as any other.
      if (context === null || width === 0 || height === 0) return draw(scene);
      const shown = [...of, scene.state.view, scene.state.stage, scene.palette, scene.ratio, width, height];
      if (shown.length !== drawn.length || shown.some((each, i) => each !== drawn[i])) {
        if (canvas.width !== width) canvas.width = width;
        if (canvas.height !== height) canvas.height = height;
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.clearRect(0, 0, width, height);
        context.save();
        draw({ ...scene, context });
        context.restore();
        drawn = shown;
      }
      scene.context.setTransform(1, 0, 0, 1, 0, 0);
      scene.context.drawImage(canvas, 0, 0);
    },
  };
}
