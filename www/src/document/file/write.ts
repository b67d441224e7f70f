import type { DemoState } from "../document.ts";

/** The text of a state; reading it back is `parseState`, which is many times as long and seldom needed. */
export function writeState(state: DemoState): string {
  return JSON.stringify(state);
}
