import type { Box } from "../../document/artboard.ts";
import { modes, type Mode } from "../../document/document.ts";
import { documentBounds } from "../../kernel/curve/samples.ts";
import { fitted, zoomedAt, type ScreenPoint } from "../pointer/camera.ts";
import {
  clearCurve, nudge, resetSelectedHandles, selectAll, selectEnd, selectNone, setKind, stepPart, stepSelection, toggleCusp,
} from "../curve/edits.ts";
import { framing, levelling, renewing, rounding, shaping } from "../curve/on-demand.ts";
import { late, whenLoaded } from "../loading.ts";
import type { Action, Editor, EditorState, OverlayId, ToolId } from "../editor.ts";

/** The actions of the stage and the editor. Panels add those of files and dialogs. */

const inCurve = (state: EditorState): boolean => state.mode === "curve";
const hasSelection = (state: EditorState): boolean => inCurve(state) && state.selection.points.length > 0;
const drawsShapes = (state: EditorState): boolean => inCurve(state) && (state.tool === "ellipse" || state.tool === "rectangle");
const hasCurve = (state: EditorState): boolean => inCurve(state) && state.curve.contours.length > 0;

function action(id: string, label: string, group: Action["group"], keys: readonly string[], run: Action["run"], more: Partial<Action> = {}): Action {
  return { id, label, group, keys, run, ...more };
}

/** What is only to be seen is said as well. */
const aloud = (run: Action["run"], text: (editor: Editor) => string): Action["run"] => (editor) => {
  run(editor);
  editor.notify({ kind: "announce", text: text(editor) });
};

/** Where the pointer, or the menu it opened, is on the curve. */
function insertAtHover(editor: Editor): void {
  const { hover } = editor.state.value;
  if (hover.kind === "curve") renewing(editor, ({ insertAt }) => insertAt(editor, hover.contour, hover.t));
}

/** The contour that the menu was opened over, else what is chosen. */
function reverseHere(editor: Editor): void {
  const { hover } = editor.state.value;
  renewing(editor, ({ reverse }) => (hover.kind === "curve" ? reverse(editor, [hover.contour]) : reverse(editor)));
}

/** What lies over what is seen only where there are colours. */
const isStacked = (state: EditorState): boolean => hasSelection(state) && state.curve.contours.some(({ ink }) => ink !== undefined);

const byLevels = (by: number) => (editor: Editor): void => levelling(editor, ({ setLevel }) => setLevel(editor, editor.state.value.curve.level + by));

/** An action that is loaded with all that change which points there are. */
function renewal(id: string, label: string, group: Action["group"], keys: readonly string[], edit: Renewal, enabled: (state: EditorState) => boolean): Action {
  return action(id, label, group, keys, (editor) => renewing(editor, (edits) => edits[edit](editor)), { enabled });
}

type Renewal = "insertAfterSelected" | "deleteAndHeal" | "deleteAndOpen" | "startHere" | "duplicate" | "toFront" | "toBack";

function stageCentre(state: EditorState): ScreenPoint {
  return { x: state.stage.width / 2, y: state.stage.height / 2 };
}

export function zoomBy(editor: Editor, factor: number, at?: ScreenPoint): void {
  const { view, stage, mode } = editor.state.value;
  const own = editor.modes.get(mode)?.view;
  if (own !== undefined) return own.zoom(factor, at ?? null);
  editor.patch({ view: zoomedAt(view, stage, at ?? stageCentre(editor.state.value), view.zoom * factor, boxOfAll(editor)) });
}

export function zoomTo(editor: Editor, zoom: number): void {
  const { view, stage, mode } = editor.state.value;
  const own = editor.modes.get(mode)?.view;
  if (own !== undefined) return own.zoomTo(zoom);
  editor.patch({ view: zoomedAt(view, stage, stageCentre(editor.state.value), zoom, boxOfAll(editor)) });
}

/** How large things are, as it is shown. */
export function shownZoom(editor: Editor): string {
  const { mode, view } = editor.state.value;
  const now = (editor.modes.get(mode)?.view?.zoomNow ?? view.zoom) * 100;
  return `${now < 1 ? Number(now.toPrecision(2)) : now < 1e6 ? Math.round(now) : now.toExponential(1).replace("+", "")} %`;
}

/** The box around all that the mode has on the plane; null while that is nothing. */
export function boxOfAll({ state: { value: state }, modes: all }: Editor): Box | null {
  const parts = all.get(state.mode);
  return parts?.box === undefined ? documentBounds(state.curve) : parts.box(state);
}

/** The whole drawing in view; `most` keeps small drawings from filling the stage. */
export function fitView(editor: Editor, most?: number): void {
  const { stage, mode } = editor.state.value;
  const own = editor.modes.get(mode)?.view;
  if (own !== undefined) return own.fit();
  const box = boxOfAll(editor);
  if (box === null) return editor.patch({ view: { zoom: 1, x: 400, y: 300 } });
  editor.patch({ view: fitted(box, stage, most) });
}

/** Fit has tools of its own, which these stand for there. */
const inFit: readonly ToolId[] = ["pen", "draw", "hand"];

const tools: readonly [ToolId, string, string][] = [
  ["select", "Select and edit", "V"],
  ["pen", "Pen", "P"],
  ["draw", "Draw", "D"],
  // As in Illustrator: O and R are taken.
  ["ellipse", "Ellipse", "L"],
  ["rectangle", "Rectangle", "M"],
  ["hand", "Pan", "H"],
];

const overlays: readonly [OverlayId, string, string | null][] = [
  ["handles", "Handles", null],
  ["polygon", "Control polygon", null],
  ["knots", "Knots", null],
  ["comb", "Curvature comb", "K"],
  ["subdivision", "Subdivision", null],
  ["weights", "Point weights", null],
  ["fill", "Fill", null],
  ["bezier", "Compare with Bézier", null],
  ["grid", "Grid", "G"],
];

const modeNames: Readonly<Record<Mode, string>> = { curve: "Curve", fit: "Fit", trace: "Trace", surface: "Surface" };

const directions: readonly [string, number, number][] = [["Left", -1, 0], ["Right", 1, 0], ["Up", 0, -1], ["Down", 0, 1]];

function nudgeActions(): Action[] {
  return directions.flatMap(([name, dx, dy]) =>
    ([["", 1, `Arrow${name}`], ["-far", 10, `Shift+Arrow${name}`], ["-fine", 0.1, `Alt+Arrow${name}`]] as const).map(([suffix, by, key]) =>
      action(`nudge-${name.toLowerCase()}${suffix}`, `Nudge ${name.toLowerCase()} by ${by}`, "Points", [key], (editor) => nudge(editor, dx * by, dy * by), {
        enabled: hasSelection,
      }),
    ),
  );
}

const editing: readonly Action[] = [
  action("undo", "Undo", "Edit", ["Mod+Z"], (editor) => editor.undo(), { enabled: (state) => state.canUndo }),
  action("redo", "Redo", "Edit", ["Mod+Shift+Z", "Mod+Y"], (editor) => editor.redo(), { enabled: (state) => state.canRedo }),
  action("select-all", "Select all", "Edit", ["Mod+A"], selectAll, { enabled: hasCurve }),
  action("select-none", "Select none", "Edit", ["Mod+Shift+A"], selectNone, { enabled: inCurve }),
  action(
    "select-contour",
    "Select whole contours",
    "Edit",
    ["E"],
    (editor) => framing(editor, ({ selectContours }) => selectContours(editor)),
    { enabled: (state) => hasSelection(state) || (inCurve(state) && state.hover.kind === "curve") },
  ),
  renewal("duplicate", "Duplicate contour", "Edit", ["Mod+D"], "duplicate", hasSelection),
  renewal("to-front", "Bring to front", "Edit", [], "toFront", isStacked),
  renewal("to-back", "Send to back", "Edit", [], "toBack", isStacked),
  action("clear", "Clear", "Edit", [], clearCurve, { enabled: hasCurve }),
];

const pointActions: readonly Action[] = [
  action("next-point", "Next point", "Points", ["]"], (editor) => stepSelection(editor, 1, false), { enabled: hasCurve }),
  action("previous-point", "Previous point", "Points", ["["], (editor) => stepSelection(editor, -1, false), { enabled: hasCurve }),
  action("extend-next", "Extend to next point", "Points", ["Shift+]", "Alt+]"], (editor) => stepSelection(editor, 1, true), { enabled: hasCurve }),
  action("extend-previous", "Extend to previous point", "Points", ["Shift+[", "Alt+["], (editor) => stepSelection(editor, -1, true), { enabled: hasCurve }),
  action("first-point", "First point", "Points", ["Home"], (editor) => selectEnd(editor, "first"), { enabled: hasCurve }),
  action("last-point", "Last point", "Points", ["End"], (editor) => selectEnd(editor, "last"), { enabled: hasCurve }),
  action("next-part", "Next handle", "Points", ["."], (editor) => stepPart(editor, 1), { enabled: hasSelection }),
  action("previous-part", "Previous handle", "Points", [","], (editor) => stepPart(editor, -1), { enabled: hasSelection }),
  action("toggle-cusp", "Smooth ↔ cusp", "Points", ["C"], (editor) => toggleCusp(editor), { enabled: hasSelection }),
  action("symmetric", "Symmetric", "Points", ["S"], (editor) => setKind(editor, "symmetric"), { enabled: hasSelection }),
  action("smooth", "Smooth", "Points", [], (editor) => setKind(editor, "smooth"), { enabled: hasSelection }),
  action("cusp", "Cusp", "Points", [], (editor) => setKind(editor, "cusp"), { enabled: hasSelection }),
  action("reset-handles", "Automatic handles", "Points", [], (editor) => resetSelectedHandles(editor), { enabled: hasSelection }),
  action("round-corners", "Round corners", "Points", ["Shift+C"], (editor) => rounding(editor, ({ roundChosen }) => roundChosen(editor)), { enabled: hasSelection }),
  renewal("insert", "Insert point after selection", "Points", ["Enter"], "insertAfterSelected", (state) => hasSelection(state) && !drawsShapes(state)),
  action("insert-here", "Insert point here", "Points", [], insertAtHover, { enabled: (state) => inCurve(state) && state.hover.kind === "curve" }),
  renewal("delete", "Delete and heal", "Points", ["Delete", "Backspace"], "deleteAndHeal", hasSelection),
  renewal("delete-open", "Delete and open", "Points", ["Shift+Delete", "Shift+Backspace"], "deleteAndOpen", hasSelection),
  renewal("start-here", "Start here", "Curve", [], "startHere", hasSelection),
  action(
    "refine-here",
    "Refine here",
    "Curve",
    [],
    (editor) => whenLoaded(editor, import("../curve/family-edits.ts"), ({ refineCurveHere }) => refineCurveHere(editor)),
    { enabled: hasSelection },
  ),
  action(
    "simplify",
    "Simplify in Fit",
    "Curve",
    [],
    (editor) => whenLoaded(editor, import("../fit/bring.ts"), ({ simplifyInFit }) => simplifyInFit(editor)),
    { enabled: hasCurve },
  ),
  action("reverse", "Reverse", "Curve", [], reverseHere, { enabled: hasCurve }),
  action("level-up", "Level up", "Curve", ["}"], byLevels(1), { enabled: hasCurve }),
  action("apply-level", "Apply level", "Curve", [], (editor) => levelling(editor, ({ applyProposal }) => applyProposal(editor)), { enabled: (state) => state.sketch.proposal !== null }),
  action("level-down", "Level down", "Curve", ["{"], byLevels(-1), { enabled: hasCurve }),
];

const transforms: readonly Action[] = ([
  ["turn-right", "Rotate 15°", "R"],
  ["turn-left", "Rotate −15°", "Shift+R"],
  ["grow", "Scale up", ">"],
  ["shrink", "Scale down", "<"],
  ["flip-across", "Flip horizontally", "Shift+H"],
  ["flip-down", "Flip vertically", "Shift+V"],
  ["join", "Join ends", "J"],
] as const).map(([id, label, key]) =>
  action(id, label, "Points", [key], (editor) => framing(editor, ({ transforms: all }) => all[id](editor)), { enabled: hasSelection }),
);

const zooming = (id: string, label: string, keys: readonly string[], run: Action["run"]): Action =>
  action(id, label, "View", keys, aloud(run, (editor) => `Zoom ${shownZoom(editor)}`), { live: true });

const viewing: readonly Action[] = [
  zooming("zoom-in", "Zoom in", ["+", "="], (editor) => zoomBy(editor, 1.25)),
  zooming("zoom-out", "Zoom out", ["-"], (editor) => zoomBy(editor, 0.8)),
  zooming("zoom-100", "Zoom to 100 %", ["0"], (editor) => zoomTo(editor, 1)),
  zooming("zoom-fit", "Fit drawing in view", ["F"], (editor) => fitView(editor)),
  action("zoom-chosen", "Fit selection in view", "View", ["Shift+F"], (editor) => framing(editor, ({ showChosen }) => showChosen(editor)), { live: true, enabled: hasSelection }),
  action("original-only", "Original only (hold)", "View", ["O"], (editor) => editor.patch({ originalOnly: true }), {
    release: (editor) => editor.patch({ originalOnly: false }),
  }),
];

export function registerStandardActions(editor: Editor): void {
  // Who has chosen something may delete it next.
  late(editor, hasSelection, renewing.load);
  const switches = overlays.map(([id, label, key]) =>
    action(`overlay-${id}`, label, "View", key === null ? [] : [key], aloud(
      (target) => target.setOverlay(id, !target.state.value.settings.overlays[id]),
      (target) => `${label} ${target.state.value.settings.overlays[id] ? "on" : "off"}`,
    ), {
      ...(id === "grid" ? {} : { enabled: inCurve }),
      checked: (state) => state.settings.overlays[id],
    }),
  );
  const toolActions = tools.map(([id, label, key]) =>
    action(`tool-${id}`, label, "Tools", [key], aloud((target) => target.patch({ tool: id, hint: "" }), () => label), {
      enabled: (state) => inCurve(state) || (state.mode === "fit" && inFit.includes(id)),
      checked: (state) => state.tool === id,
    }),
  );
  const shape = action("place-shape", "Ellipse or rectangle in the middle", "Tools", ["Enter"], (target) => shaping(target, ({ placeInView }) => placeInView(target)), {
    enabled: drawsShapes,
  });
  const modeActions = modes.map((mode, index) =>
    action(`mode-${mode}`, modeNames[mode], "Modes", [String(index + 1)], (target) => target.patch({ mode, hint: "" }), {
      checked: (state) => state.mode === mode,
    }),
  );
  const all = [...editing, ...pointActions, ...transforms, ...nudgeActions(), ...viewing, ...switches, ...toolActions, shape, ...modeActions];
  for (const each of all) editor.actions.register(each);
}
