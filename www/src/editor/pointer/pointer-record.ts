import type { Modifiers } from "../editor.ts";
import type { ScreenPoint } from "./camera.ts";
import type { PointerKind } from "./hit-test.ts";

/** What is known of a pointer at one moment. */
export interface PointerRecord {
  readonly id: number;
  readonly kind: PointerKind;
  /** 0 main, 1 middle, 2 right. */
  readonly button: number;
  readonly screen: ScreenPoint;
  readonly modifiers: Modifiers;
  /** Milliseconds. */
  readonly time: number;
}
