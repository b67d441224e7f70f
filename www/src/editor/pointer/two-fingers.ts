import { boxOfAll } from "../actions/standard-actions.ts";
import type { ScreenPoint } from "./camera.ts";
import type { Editor } from "../editor.ts";
import type { ModeParts } from "../mode.ts";
import type { Activity } from "./activity.ts";
import { createPinch } from "./pinch.ts";

const tapMs = 350;

/** Where every finger is that is down. */
export type Fingers = ReadonlyMap<number, ScreenPoint>;

/** A pinch of the first two fingers, or a tap with two or more; over when the last one is gone. */
export interface TwoFingers extends Activity {
  readonly kind: "pinch";
  /** Another finger came down. */
  joined(): void;
}

/** None unless two fingers are down. */
export function pinchOrTap(editor: Editor, own: ModeParts | undefined, fingers: Fingers, since: number): TwoFingers | null {
  const ids = [...fingers.keys()].slice(0, 2);
  const now = (): (ScreenPoint | undefined)[] => ids.map((id) => fingers.get(id));
  const [a, b] = now();
  if (a === undefined || b === undefined) return null;
  const { view, stage } = editor.state.value;
  const pinch = own?.view?.pinch(a, b) ?? createPinch(view, stage, boxOfAll(editor), a, b);
  let most = fingers.size;
  return {
    kind: "pinch",
    joined: () => void (most = Math.max(most, fingers.size)),
    endsWith: () => fingers.size === 0,
    moved() {
      const [one, other] = now();
      if (one !== undefined && other !== undefined) editor.patch(pinch.update(one, other));
    },
    released({ time }) {
      if (!pinch.moved && time - since <= tapMs) editor.actions.run(most >= 3 ? "redo" : "undo");
    },
    cancelled: () => undefined,
  };
}
