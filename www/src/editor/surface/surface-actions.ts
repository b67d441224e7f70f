import { noNetPoints } from "../../document/surface/surface.ts";
import type { Action, Editor, EditorState } from "../editor.ts";
import { boardViews } from "./orbit.ts";
import type { DragAxis } from "./solid.ts";
import {
  applyProposedLevel, chooseAllNet, chooseNet, lookFrom, nudgeNet, refineHere, setSurfaceLevels, stepNet, turnView,
} from "./surface-edits.ts";

/** The actions of Surface mode; keys that Curve has, too, mean here what they mean there. */

const here = (state: EditorState): boolean => state.mode === "surface" && state.surface.net.length > 0;
const chosen = (state: EditorState): boolean => here(state) && state.chosen.length > 0;
const noneChosen = (state: EditorState): boolean => here(state) && state.chosen.length === 0;
const dragging = (state: EditorState): boolean => here(state) && state.solid.drag !== null;

const directions: readonly (readonly [string, number, number])[] = [["Left", -1, 0], ["Right", 1, 0], ["Up", 0, 1], ["Down", 0, -1]];

/** Degrees and CSS pixels of one key press. */
export const turn = 15;
const pan = 40;

export function registerSurfaceActions(editor: Editor, hold: (axis: DragAxis) => boolean): void {
  const add = (id: string, label: string, group: Action["group"], keys: readonly string[], run: Action["run"], more: Partial<Action> = {}): void =>
    editor.actions.register({ id: `surface-${id}`, label, group, keys, run, enabled: here, ...more });

  add("next-point", "Next control point", "Surface", ["]"], () => stepNet(editor, 1, false));
  add("previous-point", "Previous control point", "Surface", ["["], () => stepNet(editor, -1, false));
  add("extend-next", "Extend to next control point", "Surface", ["Shift+]", "Alt+]"], () => stepNet(editor, 1, true));
  add("extend-previous", "Extend to previous control point", "Surface", ["Shift+[", "Alt+["], () => stepNet(editor, -1, true));
  add("select-all", "Select all control points", "Surface", ["Mod+A"], () => chooseAllNet(editor));
  add("select-none", "Select none", "Surface", ["Mod+Shift+A"], () => chooseNet(editor, noNetPoints), { enabled: chosen });
  add("refine", "Refine here", "Surface", ["Enter"], () => refineHere(editor), { enabled: chosen });
  add("level-up", "Levels up", "Surface", ["}"], () => byLevels(editor, 1));
  add("level-down", "Levels down", "Surface", ["{"], () => byLevels(editor, -1));
  add("apply-level", "Apply level", "Surface", [], () => applyProposedLevel(editor));
  for (const axis of ["x", "y", "z"] as const) {
    add(`hold-${axis}`, `Keep the drag on ${axis.toUpperCase()}`, "Surface", [axis.toUpperCase()], () => void hold(axis), { enabled: dragging, live: true });
  }
  (["front", "side", "top"] as const).forEach((side, i) => {
    add(`look-${side}`, `View from the ${side}`, "Surface", [`Shift+${i + 1}`], () => lookFrom(editor, boardViews[side]), { live: true });
  });
  for (const [name, right, up] of directions) {
    const where = name.toLowerCase();
    // As with the pointer: what is not on a point turns the view, and Shift moves it sideways.
    add(`turn-${where}`, `Turn the view ${where}, none selected`, "Surface", [`Arrow${name}`], () => turnView(editor, right * turn, -up * turn), { enabled: noneChosen });
    add(`turn-${where}-fine`, `Turn the view ${where}`, "Surface", [`Alt+Arrow${name}`], () => turnView(editor, right, -up), { enabled: noneChosen });
    add(`pan-${where}`, `Pan ${where}, none selected`, "Surface", [`Shift+Arrow${name}`], () => editor.modes.get("surface")?.view?.pan(right * pan, -up * pan), {
      enabled: noneChosen,
    });
    for (const [suffix, by, key] of [["", 1, ""], ["-far", 10, "Shift+"], ["-fine", 0.1, "Alt+"]] as const) {
      add(
        `nudge-${where}${suffix}`,
        `Nudge control point ${where}`,
        "Surface",
        [`${key}Arrow${name}`],
        () => nudgeNet(editor, right * by, up * by),
        { enabled: chosen },
      );
    }
  }
}

function byLevels(editor: Editor, by: number): void {
  const { levelU, levelV } = editor.state.value.surface;
  setSurfaceLevels(editor, levelU + by, levelV + by);
}
