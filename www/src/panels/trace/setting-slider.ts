import { traceLimits } from "../../document/trace/trace.ts";
import type { EditorState } from "../../editor/editor.ts";
import { ownSettings, setTrace } from "../../editor/trace/trace-edits.ts";
import { h } from "../controls/dom.ts";
import { sliderField, toggleField } from "../controls/fields.ts";
import type { Section } from "../mode/panel-parts.ts";
import type { Shell } from "../shell.ts";

/** Sliders over Trace's settings. */

type Numeric = "detail" | "corner" | "speckle" | "threshold" | "blur" | "colors";

interface SliderSpec {
  readonly name: Numeric;
  readonly label: string;
  readonly testid: string;
  readonly about: string;
  readonly least?: number;
  readonly most: number;
  readonly step: number;
  readonly direction?: string;
  print(position: number): string;
  /** From the slider's position to the setting and back, where they differ. */
  readonly scale?: { toValue(position: number): number; toPosition(value: number): number };
}

/** A slider over one of the settings; "auto" shows where it stands without being set by hand. */
export function settingSlider({ editor }: Shell, spec: SliderSpec): ReturnType<typeof sliderField> {
  const { name, label, testid, about, least = 0, most, step, direction, print } = spec;
  return sliderField({
    label, testid, about, least, most, step, print,
    ...(direction === undefined ? {} : { direction }),
    write: (position) => setTrace(editor, label, { [name]: spec.scale?.toValue(position) ?? position }),
    reset: () => setTrace(editor, label, { [name]: ownSettings(editor.state.value.trace)[name] }),
    edits: editor.traceEdits,
  });
}

/** Square pixels by their logarithm: from one to ten is as far as from a hundred to a thousand. */
export const area = {
  toValue: (position: number): number => (position === 0 ? 0 : Math.round(traceLimits.speckle ** (position / 100))),
  toPosition: (value: number): number => (value < 1 ? 0 : Math.round((100 * Math.log(value)) / Math.log(traceLimits.speckle))),
};

/** A slider, and the switch that leaves it to the tracer. */
export function withAuto(shell: Shell, spec: SliderSpec & { readonly name: "threshold" | "blur" }, shown: (state: EditorState) => number): Section {
  const { editor } = shell;
  const slider = settingSlider(shell, spec);
  const auto = toggleField({
    label: `Automatic ${spec.label.toLowerCase()}`, testid: `${spec.testid}-auto`, about: `${spec.label} is chosen from the picture.`,
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

