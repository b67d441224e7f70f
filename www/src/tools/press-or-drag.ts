import { distanceBetween, dragThreshold, type Drag, type PointerSample, type Tool } from "../editor/tool.ts";

/**
 * What pointers do in every tool that picks things: nothing happens on the press; within the threshold the release is a
 * click, beyond it a drag.
 */

export interface Gestures<Hit> {
  /** What lies under the pointer as it is pressed. */
  hit(sample: PointerSample): Hit;
  begin(start: PointerSample, hit: Hit): Drag;
  click(hit: Hit, sample: PointerSample): void;
  /** After a drag was carried out. */
  dragged?(): void;
}

export interface PressOrDrag extends Pick<Tool, "press" | "drag" | "release" | "cancel"> {
  /** The drag that is under way. */
  current(): Drag | null;
}

export function pressOrDrag<Hit>(gestures: Gestures<Hit>): PressOrDrag {
  let pressed: { readonly start: PointerSample; readonly hit: Hit } | null = null;
  let drag: Drag | null = null;
  return {
    current: () => drag,
    press(sample) {
      drag = null;
      pressed = { start: sample, hit: gestures.hit(sample) };
    },
    drag(sample) {
      if (pressed !== null) {
        const { start, hit } = pressed;
        if (distanceBetween(sample.screen, start.screen) < dragThreshold[sample.kind]) return;
        pressed = null;
        drag = gestures.begin(start, hit);
      }
      drag?.update(sample);
    },
    release(sample) {
      const [click, ended] = [pressed, drag];
      pressed = drag = null;
      if (ended !== null) {
        ended.update(sample);
        ended.finish(sample);
        gestures.dragged?.();
      } else if (click !== null) {
        gestures.click(click.hit, sample);
      }
    },
    cancel() {
      const [click, ended] = [pressed, drag];
      pressed = drag = null;
      ended?.cancel();
      return click !== null || ended !== null;
    },
  };
}
