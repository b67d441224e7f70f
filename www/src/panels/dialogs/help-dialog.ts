import type { Mode } from "../../document/document.ts";
import type { Action, Settings } from "../../editor/editor.ts";
import { openDialog } from "../controls/dialog.ts";
import { freshId, h } from "../controls/dom.ts";
import { printedKey, type Shell } from "../shell.ts";

type Gesture = readonly [string, string];

/** What the pointer does on each mode's stage. */
const gesturesOf: Readonly<Record<Mode, readonly Gesture[]>> = {
  curve: [
    ["Drag a point", "moves it; every selected point goes along"],
    ["Drag a handle", "turns and stretches it; the other side follows by kind"],
    ["Alt-drag a handle", "breaks it into a cusp, while Alt is held"],
    ["Alt-drag a point", "pulls out fresh handles"],
    ["Drop an end on another end", "joins them; of one contour, closes it"],
    ["Drag the curve", "bends it; a straight line moves, and Alt does the other"],
    ["Shift while dragging", "keeps to the axes, 45° or 15° steps"],
    ["Ctrl while dragging", "switches snapping off"],
    ["Double-click the curve", "inserts a point; the curve stays where it is"],
    ["Double-click a point", "smooth ↔ cusp"],
    ["Drag across empty space", "selects; Shift adds, Alt takes away"],
    ["Drag a grip of the frame", "stretches or turns whole contours, exactly; Shift keeps the proportions"],
    ["Shift or Alt with the arrow keys", "nudges by 10 or by a tenth"],
  ],
  fit: [
    ["Drag", "draws a stroke; with Erase it takes points away"],
    ["Press a knot", "chooses it; Shift adds"],
    ["Click, with Points", "adds a point; a double-click ends the stroke"],
  ],
  trace: [
    ["Drag", "moves the picture"],
    ["Press a point", "chooses it"],
    ["Double-click a point", "makes it a corner, or smooth"],
  ],
  surface: [
    ["Drag a control point", "moves it; Shift along the normal, X Y Z along an axis"],
    ["Drag elsewhere", "turns the view; Shift moves it"],
    ["Shift-click a control point", "adds it to the chosen ones, or takes it away"],
  ],
};

const everywhere: readonly Gesture[] = [
  ["Wheel, pinch", "zooms at the pointer"],
  ["Space-drag, middle button", "pans"],
  ["Two-finger tap", "undoes; three fingers redo"],
  ["Ctrl+V", "adds an SVG, a path, points or an expline file from the clipboard"],
  ["Right-click, long press", "opens the menu of what is there"],
];

const switches: readonly (readonly [keyof Settings & ("singleKeys" | "scrollPans" | "moveByClicks" | "penPans"), string, string])[] = [
  ["singleKeys", "Single-key shortcuts", "Keys such as V, P, C without Ctrl. Switch off if you use speech input."],
  ["moveByClicks", "Move by clicks", "Click a point, then click where it shall go: moving without dragging."],
  ["scrollPans", "Scroll pans", "The wheel moves the view instead of zooming."],
  ["penPans", "Fingers pan with a pen", "Once a pen was used, fingers only move the view."],
];

/** Every key, read from the actions themselves, the gestures of this mode, and the switches that change them. */
export function openHelp({ editor }: Shell): void {
  const { mode, settings } = editor.state.value;
  const groups = new Map<string, Action[]>();
  for (const action of editor.actions.all()) if (action.keys.length > 0 && !/-(?:far|fine)$/u.test(action.id)) {
    groups.set(action.group, [...(groups.get(action.group) ?? []), action]);
  }
  const keyRow = (action: Action): HTMLElement =>
    h("div", { class: "key-row" }, h("dt", {}, ...action.keys.slice(0, 2).map((key) => h("kbd", {}, printedKey(key)))), h("dd", {}, action.label));
  const own = ([group]: readonly [string, unknown]): number => (group.toLowerCase() === mode ? 0 : 1);
  const keyLists = [...groups].sort((a, b) => own(a) - own(b)).map(([group, actions]) =>
    h("section", { class: "key-group" }, h("h3", { class: "section-title" }, group), h("dl", {}, ...actions.map(keyRow))));
  const gestureList = h("section", { class: "key-group" },
    h("h3", { class: "section-title" }, "Gestures"),
    h("dl", { class: "gestures" }, ...[...gesturesOf[mode], ...everywhere].map(([what, does]) => h("div", {}, h("dt", {}, what), h("dd", { class: "quiet" }, does)))),
  );
  const toggles = switches.map(([name, label, about]) => {
    const id = freshId(name);
    const input = h("input", { id, class: "check", type: "checkbox", testid: `set-${name}`, checked: settings[name] });
    input.addEventListener("change", () => editor.setSettings({ [name]: input.checked }));
    return h("div", { class: "setting" }, input, h("label", { for: id }, label, h("span", { class: "quiet" }, about)));
  });
  openDialog(
    { title: "Help", testid: "help-dialog", wide: true },
    h("p", { class: "lead" },
      "expline draws with points and tangents whose segments contain sines and cosines: circles, ellipses and cycloids are exact, and everything else bends like the Béziers you know.",
    ),
    h("div", { class: "settings" }, ...toggles),
    h("div", { class: "help-columns" }, gestureList, ...keyLists),
    h("p", { class: "quiet" }, "Everything runs in this page: no account, no cookies, nothing is sent anywhere. A drawing is kept in this browser until you clear it."),
  );
}
