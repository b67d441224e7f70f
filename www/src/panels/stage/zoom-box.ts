import { shownZoom, zoomTo } from "../../editor/actions/standard-actions.ts";
import type { Editor } from "../../editor/editor.ts";
import { h } from "../controls/dom.ts";
import { withKey } from "../shell.ts";

/** Over the stage: how large things are, as a number that can be typed, and what changes it. */
export function mountZoomBox(editor: Editor, box: HTMLElement, until: AbortSignal): void {
  const step = (id: string, sign: string): HTMLElement => {
    const label = editor.actions.get(id)?.label ?? id;
    return h("button", { type: "button", testid: id, "aria-label": label, title: withKey(editor, label, id), click: () => editor.actions.run(id) }, sign);
  };
  const print = (): void => {
    const text = shownZoom(editor);
    if (percent.value !== text) percent.value = text;
  };
  const percent = h("input", {
    inputmode: "decimal", testid: "zoom-pct", "aria-label": "Zoom in percent",
    change: () => {
      const typed = Number(percent.value.replace("%", "").replace(",", ".").trim());
      if (Number.isFinite(typed) && typed > 0) zoomTo(editor, typed / 100);
      print();
    },
    focus: () => percent.select(),
    // What the wheel has changed in the meantime is not shown to who types.
    blur: print,
    keydown: ({ key }: KeyboardEvent) => key === "Escape" && print(),
  });
  box.append(step("zoom-out", "\u2212"), percent, step("zoom-in", "+"), step("zoom-fit", "\u2922"));
  editor.state.subscribe(() => document.activeElement !== percent && print(), { until, now: true });
}
