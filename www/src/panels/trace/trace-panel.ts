import "../../styles/dialogs.css";
import "../../styles/gallery.css";
import "../../styles/trace.css";
import { traceSample } from "../../document/trace-samples.ts";
import { toleranceOf, traceLimits, workSizes, type TraceSettings, type TraceSource } from "../../document/trace.ts";
import type { EditorState } from "../../editor/editor.ts";
import { ownSettings, setTrace } from "../../editor/trace/trace-edits.ts";
import { h } from "../dom.ts";
import { choiceField, selectField, sliderField, toggleField } from "../fields.ts";
import { formatDeviation } from "../format.ts";
import type { Section } from "../curve/curve-panel.ts";
import type { ModePanel } from "../panel.ts";
import type { Shell } from "../shell.ts";
import { pictureSection } from "./picture-section.ts";
import { resultSection } from "./result-section.ts";

/** Trace mode's properties. */
export function tracePanel(shell: Shell): ModePanel {
  const settings = settingsSection(shell);
  const sections = [pictureSection(shell), settings, resultSection(shell), imageSection(shell)];
  return {
    element: h("div", { class: "trace-panel" }, ...sections.map((section) => section.element)),
    peek: settings.detail,
    note: ({ trace }) => traceSample(trace.sample ?? "")?.title ?? "",
    update(state) {
      for (const section of sections) section.update(state);
    },
  };
}

type Numeric = "detail" | "corner" | "speckle" | "threshold" | "blur";

interface SliderSpec {
  readonly name: Numeric;
  readonly label: string;
  readonly testid: string;
  readonly about: string;
  readonly most: number;
  readonly step: number;
  readonly direction?: string;
  print(position: number): string;
  /** From the slider's position to the setting and back, where they differ. */
  readonly scale?: { toValue(position: number): number; toPosition(value: number): number };
}

/** A slider over one of the settings; "auto" shows where it stands without being set by hand. */
function settingSlider({ editor }: Shell, spec: SliderSpec): ReturnType<typeof sliderField> {
  const { name, label, testid, about, most, step, direction, print } = spec;
  return sliderField({
    label, testid, about, least: 0, most, step, print,
    ...(direction === undefined ? {} : { direction }),
    write: (position) => setTrace(editor, label, { [name]: spec.scale?.toValue(position) ?? position }),
    reset: () => setTrace(editor, label, { [name]: ownSettings(editor.state.value.trace)[name] }),
    gesture: { begin: () => editor.traceEdits.begin(label), commit: () => editor.traceEdits.commit() },
  });
}

/** Square pixels by their logarithm: from one to ten is as far as from a hundred to a thousand. */
const area = {
  toValue: (position: number): number => (position === 0 ? 0 : Math.round(traceLimits.speckle ** (position / 100))),
  toPosition: (value: number): number => (value < 1 ? 0 : Math.round((100 * Math.log(value)) / Math.log(traceLimits.speckle))),
};

function settingsSection(shell: Shell): Section & { readonly detail: HTMLElement } {
  const detail = settingSlider(shell, {
    name: "detail", label: "Detail", testid: "trace-detail", about: "How far an outline may stray from the edge in the picture, in pixels.",
    most: traceLimits.detail, step: 1, direction: "smoother", print: (value) => `${value} · ${formatDeviation(toleranceOf(value))} px`,
  });
  const corner = settingSlider(shell, {
    name: "corner", label: "Corner angle", testid: "trace-corner", about: "A turn of at least so many degrees stays a sharp corner.",
    most: traceLimits.corner, step: 1, direction: "fewer corners", print: (value) => `${value}°`,
  });
  const speckle = settingSlider(shell, {
    name: "speckle", label: "Speckle", testid: "trace-speckle", about: "Contours that enclose fewer square pixels are left out.",
    most: 100, step: 1, direction: "cleaner", print: (position) => `${area.toValue(position)} px²`, scale: area,
  });
  return {
    detail: detail.element,
    element: h("section", { class: "section", "aria-label": "Trace" }, detail.element, corner.element, speckle.element),
    update({ trace }) {
      const { settings } = trace;
      detail.show(settings.detail);
      corner.show(settings.corner);
      speckle.show(area.toPosition(settings.speckle));
    },
  };
}

/** A slider, and the switch that leaves it to the tracer. */
function withAuto(shell: Shell, spec: SliderSpec & { readonly name: "threshold" | "blur" }, shown: (state: EditorState) => number): Section {
  const { editor } = shell;
  const slider = settingSlider(shell, spec);
  const auto = toggleField({
    label: `${spec.label} by itself`, testid: `${spec.testid}-auto`, about: `${spec.label} is found from the picture.`,
    write: (on) => setTrace(editor, spec.label, { [spec.name]: on ? "auto" : shown(editor.state.value) }),
  });
  return {
    element: h("div", { class: "trace-auto" }, slider.element, auto.element),
    update(state) {
      const value = state.trace.settings[spec.name];
      slider.show(value === "auto" ? shown(state) : value);
      auto.show(value === "auto");
    },
  };
}

function imageSection(shell: Shell): Section {
  const { editor } = shell;
  const mode = choiceField<TraceSource>({
    label: "Edges from", testid: "trace-mode", about: "What counts as an edge.",
    options: [
      { value: "brightness", label: "Brightness", about: "The border between dark and light: for logos and drawings." },
      { value: "edges", label: "Edges", about: "Places of steepest change: for shapes that differ little from their ground." },
    ],
    write: (value) => setTrace(editor, "Edges from", { mode: value }),
  });
  const threshold = withAuto(shell, {
    name: "threshold", label: "Threshold", testid: "trace-threshold", about: "The shade between ink and paper; see it in the view Edges.",
    most: traceLimits.threshold, step: 1, print: (value) => String(value),
  }, ({ traceRun }) => Math.round(traceRun.picture?.threshold ?? 128));
  const blur = withAuto(shell, {
    name: "blur", label: "Blur σ", testid: "trace-blur", about: "Smooths grain away before edges are looked for.",
    most: traceLimits.blur, step: 0.1, print: (value) => `${value} px`,
  }, () => 1);
  const invert = toggleField({ label: "Invert", testid: "trace-invert", about: "Light shapes on dark ground (I).", write: (on) => setTrace(editor, "Invert", { invert: on }) });
  const size = selectField<`${TraceSettings["size"]}`>({
    label: "Work size", testid: "trace-size", about: "Pixels of the longer side that are looked at; a picture is never made larger.",
    options: workSizes.map((each) => [`${each}`, `${each} px`] as const),
    write: (value) => setTrace(editor, "Work size", { size: workSizes.find((each) => `${each}` === value) ?? 1024 }),
  });
  const body = h("div", { class: "trace-image" }, mode.element, threshold.element, blur.element, invert.element, size.element);
  return {
    element: h("section", { class: "section", "aria-label": "Image" }, h("details", { class: "disclosure", open: true }, h("summary", {}, h("h3", { class: "section-title" }, "Image")), body)),
    update(state) {
      const { settings } = state.trace;
      mode.show(settings.mode);
      threshold.update(state);
      threshold.element.hidden = settings.mode === "edges";
      blur.update(state);
      invert.show(settings.invert);
      size.show(`${settings.size}`);
    },
  };
}
