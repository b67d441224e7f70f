import type { Editor, Modifiers } from "../editor.ts";
import type { ScreenPoint } from "./camera.ts";
import type { PointerRecord } from "./pointer-record.ts";

/** DOM events as plain records. */

const isMac = /Mac|iPhone|iPad/.test(navigator.platform);

export function modifiersOf(event: MouseEvent | KeyboardEvent): Modifiers {
  return { shift: event.shiftKey, alt: event.altKey, mod: isMac ? event.metaKey : event.ctrlKey };
}

/** Where on the stage. */
export function placeOf(event: MouseEvent, editor: Editor): ScreenPoint {
  const { left, top } = editor.state.value.stage;
  return { x: event.clientX - left, y: event.clientY - top };
}

export function recordOf(event: PointerEvent, editor: Editor): PointerRecord {
  return {
    id: event.pointerId,
    kind: event.pointerType === "touch" ? "touch" : event.pointerType === "pen" ? "pen" : "mouse",
    button: event.button,
    screen: placeOf(event, editor),
    modifiers: modifiersOf(event),
    time: event.timeStamp,
  };
}
