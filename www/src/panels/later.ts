import type { Mode } from "../document/document.ts";
import { h, setAttribute, setText } from "./dom.ts";
import type { Shell } from "./shell.ts";

interface Coming {
  readonly title: string;
  /** What the mode will do. */
  readonly will: string;
  readonly parts: readonly string[];
  /** What helps today. */
  readonly today: string;
  readonly actions: readonly (readonly [label: string, action: string])[];
}

const coming: Readonly<Record<Exclude<Mode, "curve" | "fit" | "surface">, Coming>> = {
  trace: {
    title: "Trace",
    will: "Drop a picture and get contours with their corners kept and exact arcs where there are arcs.",
    parts: ["Sub-pixel contours from brightness or edges", "Cusps where the picture has corners", "Progress, cancel, and the measured error"],
    today: "An SVG logo, exported from any tracer or editor, opens in Curve exactly: arcs stay arcs.",
    actions: [["Import an SVG", "import"], ["Back to Curve", "mode-curve"]],
  },
};

export type LaterMode = keyof typeof coming;

export interface LaterPanel {
  readonly element: HTMLElement;
}

/** The panel of a mode that is not there yet: what will come, what is possible today, and the way back. */
export function laterPanel(mode: LaterMode): LaterPanel {
  const { will, parts } = coming[mode];
  return {
    element: h("section", { class: "section later" },
      h("p", { class: "badge" }, "Comes with a later release"),
      h("p", {}, will),
      h("ul", { class: "later-parts quiet" }, ...parts.map((part) => h("li", {}, part)))),
  };
}

/** The empty stage of each mode: one primary thing to do, and where to start. A mode that is there takes its own away. */
export function mountEmptyStates(shell: Shell): { drop(mode: Mode): void } {
  const { editor, regions, until } = shell;
  const modes = Object.keys(coming) as LaterMode[];
  const cards = modes.map((mode) => {
    const { title, today, actions } = coming[mode];
    const buttons = actions.map(([label, action], i) => h("button", { class: i === 0 ? "button primary" : "button", type: "button", click: () => editor.actions.run(action) }, h("span", {}, label)));
    const note = h("p", { class: "quiet", "data-part": "sample" });
    return { mode, note, element: h("div", { class: "empty", testid: `empty-${mode}`, hidden: true }, h("h2", {}, `${title} is on its way`), h("p", {}, today), note, h("div", { class: "empty-actions" }, ...buttons)) };
  });
  const gone = new Set<Mode>();
  for (const { element } of cards) regions.stage.append(element);
  editor.state.subscribe((state) => {
    setAttribute(regions.stage, "data-mode", state.mode);
    for (const { mode, element, note } of cards) {
      element.hidden = state.mode !== mode || gone.has(mode);
      const { sample } = state.trace;
      setText(note, sample === undefined ? "" : `The sample ${sample} opens here then; this link will work.`);
    }
  }, { now: true, until });
  return {
    drop(mode) {
      gone.add(mode);
      cards.find((card) => card.mode === mode)?.element.remove();
    },
  };
}
