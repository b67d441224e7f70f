import { toPage, type PagePoint, type ScreenPoint } from "./pointer/camera.ts";
import type { EditorState, Modifiers } from "./state.ts";
import type { PointerKind } from "./pointer/hit-test.ts";

/** A pointer event as tools see it: plain numbers, both coordinate systems, the modifiers of this moment. */
export interface PointerSample {
  readonly screen: ScreenPoint;
  readonly page: PagePoint;
  readonly kind: PointerKind;
  readonly modifiers: Modifiers;
  /** 1 for a single press, 2 for the second of two quick ones at one place. */
  readonly clicks: number;
  /** Every place since the last sample of this press, this one among them: a frame's moves for those who draw. */
  readonly trail?: readonly PagePoint[];
}

/** How far a press may wander before it is a drag, CSS pixels. */
export const dragThreshold: Readonly<Record<PointerKind, number>> = { mouse: 3, pen: 3, touch: 6 };

export function sampleAt(state: EditorState, screen: ScreenPoint, kind: PointerKind, modifiers: Modifiers, clicks = 1): PointerSample {
  return { screen, page: toPage(state.view, state.stage, screen), kind, modifiers, clicks };
}

export function distanceBetween(a: ScreenPoint, b: ScreenPoint): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

/** What the pointer does depends on the tool; which tool is up is a matter of the editor's state. */
export interface Tool {
  /** The pointer moves with no button down. */
  hover(sample: PointerSample): void;
  press(sample: PointerSample): void;
  /** The pointer moves, or a modifier changes, with the button down. */
  drag(sample: PointerSample): void;
  release(sample: PointerSample): void;
  /** Esc, a second finger, a lost pointer: as before the press. Says whether there was anything to cancel. */
  cancel(): boolean;
  /** Enter, or another tool: what was begun is done. */
  finish(): boolean;
}

/** A drag, evaluated from its start at every step, so that modifiers pressed or released on the way count at once. */
export interface Drag {
  update(sample: PointerSample): void;
  finish(sample: PointerSample): void;
  cancel(): void;
}
