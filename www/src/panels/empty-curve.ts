import "../styles/gallery.css";
import { curveSamples } from "../document/samples.ts";
import type { EditorState } from "../editor/editor.ts";
import { openSample } from "../editor/route.ts";
import { h } from "./dom.ts";
import type { Shell } from "./shell.ts";
import { thumbnail } from "./thumbnail.ts";

const offered = ["circle-2", "heart", "glyph"];

function isEmpty(state: EditorState): boolean {
  return state.mode === "curve" && state.engine.status === "ready" && state.curve.contours.length === 0 && state.tool !== "pen";
}

/** An empty drawing: the pen, or three samples to start from. Presses beside the buttons go through to the stage. */
export function mountEmptyCurve({ editor, regions, until }: Shell): void {
  let card: HTMLElement | null = null;
  const build = (): HTMLElement => {
    const samples = curveSamples.filter(({ id }) => offered.includes(id)).map((sample) =>
      h("button", { class: "sample", type: "button", title: sample.note, click: () => openSample(editor, sample.id) }, thumbnail(sample.curve), h("span", { class: "sample-title" }, sample.title)));
    return h("div", { class: "empty empty-curve", testid: "empty-curve" },
      h("h2", {}, "Click to place points, or start from a sample"),
      h("button", { class: "button primary", type: "button", click: () => editor.actions.run("tool-pen") }, h("span", {}, "Take the pen")),
      h("div", { class: "samples" }, ...samples));
  };
  const update = (state: EditorState): void => {
    if (!isEmpty(state)) {
      card?.remove();
      card = null;
    } else if (card === null) {
      card = build();
      regions.stage.append(card);
    }
  };
  editor.state.subscribe(update, { now: true, until });
}
