import type { Mode } from "../../document/document.ts";
import type { Action, Settings } from "../../editor/editor.ts";
import { openDialog } from "../controls/dialog.ts";
import { freshId, h } from "../controls/dom.ts";
import { printedKey, type Shell } from "../shell.ts";

type Gesture = readonly [string, string];

/** What the pointer does on each mode's stage. */
const gesturesOf: Readonly<Record<Mode, readonly Gesture[]>> = {
  curve: [
    ["Drag a point", "moves it, and all other selected points with it"],
    ["Drag a handle", "turns and stretches it; the other handle follows, depending on kind"],
    ["Alt-drag a handle", "breaks it into a cusp while Alt is held"],
    ["Alt-drag a point", "pulls out new handles"],
    ["Drop one end on another", "joins them, or closes the contour"],
    ["Drag the curve", "bends it, or moves it if straight; Alt swaps the two"],
    ["Shift while dragging", "constrains to the axes, 45° or 15° steps"],
    ["Ctrl while dragging", "turns snapping off"],
    ["Click an end with the pen", "continues that path, or joins it to the one you draw"],
    ["Drag with Ellipse or Rectangle", "draws from corner to corner; Shift for equal sides, Alt from the centre, Space moves it"],
    ["Double-click the curve", "inserts a point without changing the curve"],
    ["Double-click a point", "switches between smooth and cusp"],
    ["Double-click inside a shape", "selects all of it, with a frame to scale and rotate"],
    ["Drag across empty space", "selects; Shift adds, Alt subtracts"],
    ["Drag inside a selected shape", "moves all of it; Alt-drag copies it"],
    ["Drag a grip on the frame", "scales or rotates whole contours exactly; Shift keeps proportions"],
    ["Drag the dot inside a selected corner", "rounds all selected corners with exact arcs"],
    ["Shift or Alt with arrow keys", "nudges by 10 or by 0.1"],
    ["Right-click, long press", "opens a menu for what is there"],
  ],
  fit: [
    ["Drag", "draws a stroke, or removes points with Erase"],
    ["Click a knot", "selects it; Shift adds"],
    ["Click with Points", "adds a point; a double-click ends the stroke"],
  ],
  trace: [
    ["Drag", "pans the view"],
    ["Click a point", "selects it"],
    ["Double-click a point", "switches between corner and smooth"],
  ],
  surface: [
    ["Drag a control point", "moves it; hold Shift for the normal, X, Y or Z for an axis"],
    ["Drag elsewhere", "orbits; Shift pans"],
    ["Shift-click a control point", "adds it to the selection, or removes it"],
  ],
};

const everywhere: readonly Gesture[] = [
  ["Wheel, pinch", "zoom at the pointer"],
  ["Space-drag, middle-drag", "pan the view"],
  ["Two-finger tap", "undoes; three fingers redo"],
  ["Ctrl+V", "pastes an SVG, a path, points, a picture or an expline file"],
];

const switches: readonly (readonly [keyof Settings & ("singleKeys" | "scrollPans" | "moveByClicks" | "penPans"), string, string])[] = [
  ["singleKeys", "Single-key shortcuts", "Keys such as V, P and C without Ctrl. Turn off if you use speech input."],
  ["moveByClicks", "Move by clicks", "Click a point, then click where it should go, instead of dragging."],
  ["scrollPans", "Scroll pans", "The wheel pans instead of zooming."],
  ["penPans", "Fingers pan with a pen", "Once you use a pen, fingers only pan."],
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
      "expline builds curves from points and handles, with sines and cosines in every segment: circles, ellipses and cycloids are exact, and everything else bends like the Béziers you know.",
    ),
    h("div", { class: "settings" }, ...toggles),
    h("div", { class: "help-columns" }, gestureList, ...keyLists),
    h("p", {}, "For an editor of your own: ", h("a", { href: "docs/", target: "_blank", rel: "noopener" }, "the documentation of expline"), ", with a playground."),
    h("p", { class: "quiet" }, "Everything runs on this page: no account, no cookies, nothing is sent anywhere. Your drawing stays in this browser until you clear it."),
  );
}
