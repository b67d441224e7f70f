import { chosenSegments } from "../../document/curve/frequency/segments.ts";
import { omegaOf, type Contour, type CurveDocument, type Space } from "../../document/document.ts";
import { activeContours, setSpace } from "../../editor/curve/edits.ts";
import { levelling, renewing } from "../../editor/curve/on-demand.ts";
import type { Editor, EditorState } from "../../editor/editor.ts";
import { whenLoaded } from "../../editor/loading.ts";
import { h, setAttribute, setText } from "../controls/dom.ts";
import { choiceField, numberField, selectField, sliderField, toggleField } from "../controls/fields.ts";
import { icon } from "../controls/icons.ts";

/** What the section of the curve is made of, row by row. */

export interface Row {
  readonly elements: readonly HTMLElement[];
  /** `contours` are those that the controls act on. */
  update(state: EditorState, contours: readonly Contour[]): void;
}

/** Of contours with finer points, level 0 has space, frequency and number. */
function areRefined(contours: readonly Contour[]): boolean {
  return contours.some(({ grid, places }) => grid !== undefined || places !== undefined);
}

/** What all of them have; undefined where they differ, null where there are none. */
function shared<T>(contours: readonly Contour[], read: (contour: Contour) => T): T | undefined | null {
  const [first, ...others] = contours.map(read);
  return first === undefined ? null : others.every((each) => each === first) ? first : undefined;
}

/** Families are changed seldom: what it takes comes with the first change. */
function editFamily(editor: Editor, run: (edits: typeof import("../../editor/curve/family-edits.ts")) => void): void {
  whenLoaded(editor, import("../../editor/curve/family-edits.ts"), run);
}

export function familyRow(editor: Editor): Row {
  const family = choiceField({
    label: "Family",
    testid: "family",
    about: "How points define the curve. Switching keeps them and says how far the curve moves.",
    options: [
      { value: "hermite", label: "Hermite", about: "Points with handles: each segment depends on its two ends." },
      { value: "interpolating", label: "Interpolating", about: "Points on the curve, without handles: smooth throughout, and each acts only nearby." },
    ],
    write: (value) => editFamily(editor, ({ setFamily }) => setFamily(editor, value)),
  });
  return { elements: [family.element], update: (_, contours) => family.show(shared(contours, ({ family: each }) => each)) };
}

const spaces: readonly (readonly [Space, string])[] = [
  ["trigonometric", "Trigonometric"],
  ["hyperbolic", "Hyperbolic"],
  ["polynomial", "Polynomial"],
];

/** What each space draws exactly: the reason to choose it. */
const exactIn: Readonly<Record<Space, string>> = {
  trigonometric: "Exact: ellipses, sine waves, cycloids",
  hyperbolic: "Exact: hyperbolas, catenaries",
  polynomial: "Exact: parabolas, any cubic Bézier",
};

export function spaceRow(editor: Editor): Row {
  const space = selectField({
    label: "Space",
    testid: "space",
    about: "What segments are made of, and so which shapes are exact.",
    options: spaces,
    write: (value) => setSpace(editor, value),
    reset: () => setSpace(editor, "trigonometric"),
  });
  const exact = h("p", { class: "field-note" });
  return {
    elements: [space.element, exact],
    update({ curve }, contours) {
      space.show(areRefined(contours) ? null : curve.space);
      setText(exact, exactIn[curve.space]);
    },
  };
}

const orders: readonly (readonly ["3" | "4" | "5", string])[] = [
  ["3", "Tangent, 3 roots"],
  ["4", "Curvature, 4 roots"],
  ["5", "C³, 5 roots"],
];

export function orderRow(editor: Editor): Row {
  const order = selectField({
    label: "Smoothness",
    testid: "order",
    about: "What is continuous along the curve. Each extra root adds a derivative and widens a point's reach by a segment; 5 roots have two harmonics.",
    options: orders,
    write: (value) => editFamily(editor, ({ setOrder }) => setOrder(editor, value === "3" ? 3 : value === "4" ? 4 : 5)),
    reset: () => editFamily(editor, ({ setOrder }) => setOrder(editor, 3)),
  });
  return {
    elements: [order.element],
    update(_, contours) {
      order.element.hidden = shared(contours, ({ family }) => family) !== "interpolating";
      const common = shared(contours, (contour) => contour.order ?? 3);
      order.show(areRefined(contours) ? null : common === 5 ? "5" : common === 4 ? "4" : "3");
    },
  };
}

export function frequencyRow(editor: Editor): Row {
  const write = (value: number | "auto", run?: string): void => {
    // The press that takes the value may choose something else, before what sets it has come.
    const { selection } = editor.state.value;
    editFamily(editor, ({ setOmega }) => setOmega(editor, selection, value, run));
  };
  const omega = numberField({
    label: "Frequency",
    testid: "omega",
    about: "Radians per segment, 0.01 to 3.10. Auto keeps circles exact.",
    least: 0.01,
    most: 3.1,
    step: 0.01,
    word: "Auto",
    unit: "rad",
    format: (value) => String(Number(value.toFixed(4))),
    write: (value) => write(value ?? "auto", "omega"),
    reset: () => write("auto"),
  });
  const auto = h("button", {
    class: "small-button",
    type: "button",
    testid: "omega-auto",
    title: "From the number of points: circles stay exact.",
    click: () => write("auto"),
  }, "Auto");
  omega.element.querySelector(".number-box")?.after(auto);
  const note = h("p", { class: "field-note num" });
  return {
    elements: [omega.element, note],
    update(state, contours) {
      // A drag changes no frequency, and may be of very many points.
      if (state.drag !== null) return;
      const { curve } = state;
      setAttribute(auto, "aria-pressed", String(curve.omega === "auto" && contours.every((each) => each.omega === undefined)));
      auto.disabled = curve.space === "polynomial";
      omega.show(curve.space === "polynomial" || areRefined(contours) ? null : frequencyOf(state));
      setText(note, shared(contours, (contour) => frequencyNote(curve, contour)) ?? "");
    },
  };
}

/** The frequency of what is chosen, even where it follows from the number of points; undefined where they differ. */
function frequencyOf(state: EditorState): number | undefined {
  const { curve, selection } = state;
  const values = new Set(activeContours(state).flatMap((c) => {
    const contour = curve.contours[c];
    return contour === undefined ? [] : chosenSegments(contour, c, selection).map((segment) => omegaOf(curve, contour, segment));
  }));
  const [first = curve.omega === "auto" ? NaN : curve.omega, ...others] = values;
  return others.length === 0 ? first : undefined;
}

function frequencyNote(curve: CurveDocument, contour: Contour): string {
  if (curve.space === "polynomial" || contour.points.length < 2) return "";
  if (contour.grid !== undefined) return "All set at level 0";
  if (contour.roots !== undefined) return "The contour has its own";
  if (contour.omega !== undefined || curve.omega !== "auto") return "";
  const value = omegaOf(curve, contour, 0);
  return value === 0 ? "Auto: 0 on an open contour" : `Auto: 2π/${Math.round((2 * Math.PI) / value)}`;
}

export function pointsRow(editor: Editor): Row {
  const points = numberField({
    label: "Points",
    testid: "points",
    about: "Changing it resamples the contour at equal parameters.",
    least: 2,
    most: 256,
    step: 1,
    format: String,
    write: (value) => value !== null && renewing(editor, ({ resample }) => resample(editor, value, "points")),
  });
  const steps = stepper(editor);
  points.element.querySelector(".number-box")?.after(steps);
  const note = h("p", { class: "field-note" }, "Select one contour to change its points");
  return {
    elements: [points.element, note],
    update(_, contours) {
      const count = contours.reduce((sum, each) => sum + each.points.length, 0);
      const isOne = contours.length === 1;
      note.hidden = contours.length < 2;
      points.show(isOne && !areRefined(contours) ? count : null);
      for (const button of steps.querySelectorAll("button")) button.disabled = !isOne;
      if (contours.length > 0) points.input.value = String(count);
    },
  };
}

/** − and + beside the number of points. */
function stepper(editor: Editor): HTMLElement {
  const step = (by: number) => () => renewing(editor, ({ resample }) => {
    const contour = editor.state.value.curve.contours[activeContours(editor.state.value)[0] ?? 0];
    if (contour !== undefined) resample(editor, contour.points.length + by, "points");
  });
  return h(
    "span",
    { class: "stepper" },
    h("button", { class: "icon-button", type: "button", "aria-label": "One point fewer", title: "One point fewer", click: step(-1) }, icon("minus")),
    h("button", { class: "icon-button", type: "button", "aria-label": "One point more", title: "One point more", click: step(1) }, icon("plus")),
  );
}

export function levelRow(editor: Editor): Row & { readonly element: HTMLElement } {
  const write = (level: number): void => levelling(editor, ({ setLevel }) => setLevel(editor, level));
  const level = sliderField({
    label: "Level",
    testid: "level",
    about: "Doubles the points for finer edits without moving the curve.",
    least: 0,
    most: 6,
    step: 1,
    direction: "finer",
    print: String,
    write,
    reset: () => write(0),
    edits: editor,
  });
  return {
    element: level.element,
    elements: [level.element],
    update({ curve, sketch }) {
      level.show(sketch.proposal?.level ?? curve.level);
      level.input.disabled = curve.contours.length === 0;
    },
  };
}

export function actionsRow(editor: Editor): Row {
  const closed = toggleField({
    label: "Closed",
    testid: "closed",
    about: "Joins the last point to the first.",
    write: (on) => renewing(editor, ({ setClosed }) => setClosed(editor, on)),
  });
  const command = (label: string, testid: string, title: string, action: string): HTMLButtonElement =>
    h("button", { class: "small-button", type: "button", testid, title, click: () => editor.actions.run(action) }, label);
  const refine = command("Refine here", "curve-refine", "Adds points around the selection only, without moving the curve", "refine-here");
  const simplify = command("Simplify", "curve-simplify", "Copies the drawing, or the selected contours, to Fit to find a curve with fewer points", "simplify");
  return {
    elements: [h("div", { class: "field-row" }, closed.element, refine, simplify)],
    update({ selection }, contours) {
      refine.disabled = selection.points.length === 0 || contours[0]?.grid !== undefined;
      simplify.disabled = contours.length === 0;
      closed.show(shared(contours, (contour) => contour.closed));
    },
  };
}
