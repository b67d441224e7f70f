import { omegaOf, type Contour, type CurveDocument, type Space } from "../../document/document.ts";
import type { EditorState } from "../../editor/editor.ts";
import { activeContour, renewing, setOmega, setSpace } from "../../editor/curve/edits.ts";
import { setLevel } from "../../editor/curve/level-edits.ts";
import { whileLoading } from "../../editor/loading.ts";
import { h, setAttribute, setText } from "../controls/dom.ts";
import { choiceField, numberField, selectField, sliderField, toggleField } from "../controls/fields.ts";
import { icon } from "../controls/icons.ts";
import type { Section } from "../mode/panel-parts.ts";
import type { Shell } from "../shell.ts";

const spaces: readonly (readonly [Space, string])[] = [
  ["trigonometric", "Trigonometric"],
  ["hyperbolic", "Hyperbolic"],
  ["polynomial", "Polynomial"],
];

const orders: readonly (readonly ["3" | "4" | "5", string])[] = [
  ["3", "Tangent, 3 roots"],
  ["4", "Curvature, 4 roots"],
  ["5", "C³, 5 roots"],
];

/** What each space draws exactly: the reason to choose it. */
const exactIn: Readonly<Record<Space, string>> = {
  trigonometric: "Exact: ellipses, sine waves, cycloids",
  hyperbolic: "Exact: hyperbolas, catenaries",
  polynomial: "Exact: parabolas, any cubic Bézier",
};

function firstContour(state: EditorState, shell: Shell): Contour | undefined {
  return state.curve.contours[activeContour(shell.editor)];
}

/** The one frequency of the drawing, or NaN where it follows from the curve or differs between segments. */
function frequencyOf(curve: CurveDocument): number {
  return curve.omega === "auto" ? NaN : curve.omega;
}

/** Family, space, frequency, number of points, level, closed: what the curve is made of. */
export function curveSection(shell: Shell): Section & { readonly level: HTMLElement } {
  const { editor } = shell;
  // Families are changed seldom: what it takes comes with the first change.
  const edits = (run: (loaded: typeof import("../../editor/curve/family-edits.ts")) => void): void =>
    void whileLoading(editor, import("../../editor/curve/family-edits.ts").then(run));
  const family = choiceField({
    label: "Family",
    testid: "family",
    about: "How control points make a curve; the other family goes through the same points and says how far the curve moves.",
    options: [
      { value: "hermite", label: "Hermite", about: "Points with tangents: each segment depends on its two ends." },
      { value: "interpolating", label: "Interpolating", about: "Points on the curve, without tangents: smooth through all of them, and each acts near by only." },
    ],
    write: (value) => edits(({ setFamily }) => setFamily(editor, value)),
  });
  const order = selectField({
    label: "Smoothness",
    testid: "order",
    about: "What is continuous along the curve. One more root of the generator is one more derivative, and one more segment that a point acts on; 5 have two harmonics.",
    options: orders,
    write: (value) => edits(({ setOrder }) => setOrder(editor, value === "3" ? 3 : value === "4" ? 4 : 5)),
    reset: () => edits(({ setOrder }) => setOrder(editor, 3)),
  });
  const space = selectField({
    label: "Space",
    testid: "space",
    about: "The functions that segments are made of, and so the shapes that are exact.",
    options: spaces,
    write: (value) => setSpace(editor, value),
    reset: () => setSpace(editor, "trigonometric"),
  });
  const exact = h("p", { class: "field-note" });
  const omega = numberField({
    label: "Frequency",
    testid: "omega",
    about: "Radians per segment, 0.01 to 3.10, or Auto, which keeps circles exact.",
    least: 0.01,
    most: 3.1,
    step: 0.01,
    word: "Auto",
    unit: "rad",
    format: (value) => String(Number(value.toFixed(4))),
    write: (value) => setOmega(editor, value ?? "auto", "omega"),
    reset: () => setOmega(editor, "auto"),
  });
  const auto = h("button", {
    class: "small-button",
    type: "button",
    testid: "omega-auto",
    title: "Let the frequency follow from the number of points, so that circles stay exact.",
    click: () => setOmega(editor, "auto"),
  }, "Auto");
  omega.element.querySelector(".number-box")?.after(auto);
  const omegaNote = h("p", { class: "field-note num" });
  const points = numberField({
    label: "Points",
    testid: "points",
    about: "Number of points of this contour; changing it resamples at equal parameters.",
    least: 2,
    most: 256,
    step: 1,
    format: String,
    write: (value) => value !== null && renewing(editor, ({ resample }) => resample(editor, value, "points")),
  });
  points.element.querySelector(".number-box")?.after(stepper(shell));
  const level = sliderField({
    label: "Level",
    testid: "level",
    about: "Doubles the points and leaves the curve where it is, to edit finer.",
    least: 0,
    most: 6,
    step: 1,
    direction: "finer",
    print: String,
    write: (value) => setLevel(editor, value),
    reset: () => setLevel(editor, 0),
    gesture: { begin: () => editor.begin("Level"), commit: () => editor.commit() },
  });
  const refine = h("button", {
    class: "small-button",
    type: "button",
    testid: "curve-refine",
    title: "More points around the chosen ones, none elsewhere; the curve stays",
    click: () => editor.actions.run("refine-here"),
  }, "Refine here");
  const simplify = h("button", {
    class: "small-button",
    type: "button",
    testid: "curve-simplify",
    title: "A copy in Fit, where a curve of fewer points is found; of the chosen contours, if some are chosen",
    click: () => editor.actions.run("simplify"),
  }, "Simplify");
  const closed = toggleField({ label: "Closed", testid: "closed", about: "Whether the last point joins the first.", write: (on) => renewing(editor, ({ setClosed }) => setClosed(editor, on)) });
  const element = h("section", { class: "section", "aria-label": "Curve" },
    family.element,
    space.element,
    exact,
    order.element,
    omega.element,
    omegaNote,
    points.element,
    level.element,
    h("div", { class: "field-row" }, closed.element, refine, simplify),
  );
  return {
    element,
    level: level.element,
    update(state) {
      const contour = firstContour(state, shell);
      const refined = contour?.grid !== undefined || contour?.places !== undefined;
      family.show(contour?.family ?? null);
      order.element.hidden = contour?.family !== "interpolating";
      order.show(refined ? null : contour?.order === 5 ? "5" : contour?.order === 4 ? "4" : "3");
      refine.disabled = state.selection.points.length === 0 || contour?.grid !== undefined;
      simplify.disabled = contour === undefined;
      space.show(refined ? null : state.curve.space);
      setText(exact, exactIn[state.curve.space]);
      setAttribute(auto, "aria-pressed", String(state.curve.omega === "auto"));
      auto.disabled = state.curve.space === "polynomial";
      omega.show(state.curve.space === "polynomial" || refined ? null : frequencyOf(state.curve));
      setText(omegaNote, frequencyNote(state.curve, contour));
      points.show(refined ? null : contour?.points.length ?? null);
      if (refined) points.input.value = String(contour.points.length);
      level.show(contour === undefined ? null : state.sketch.proposal?.level ?? state.curve.level);
      closed.show(contour?.closed ?? null);
    },
  };
}

function frequencyNote(curve: CurveDocument, contour: Contour | undefined): string {
  if (curve.space === "polynomial" || contour === undefined || contour.points.length < 2) return "";
  if (contour.grid !== undefined) return "Level 0 sets space, frequency and number";
  if (contour.omega !== undefined) return "This contour has one for each segment";
  if (curve.omega !== "auto") return "";
  const value = omegaOf(curve, contour, 0);
  return value === 0 ? "Auto: 0 on an open contour" : `Auto: 2π/${Math.round((2 * Math.PI) / value)} = ${value.toFixed(4)}`;
}

/** − and + beside the number of points. */
function stepper(shell: Shell): HTMLElement {
  const step = (by: number) => () => {
    const { editor } = shell;
    renewing(editor, ({ resample }) => {
      const contour = firstContour(editor.state.value, shell);
      if (contour !== undefined) resample(editor, contour.points.length + by, "points");
    });
  };
  return h(
    "span",
    { class: "stepper" },
    h("button", { class: "icon-button", type: "button", "aria-label": "One point fewer", title: "One point fewer", click: step(-1) }, icon("minus")),
    h("button", { class: "icon-button", type: "button", "aria-label": "One point more", title: "One point more", click: step(1) }, icon("plus")),
  );
}
