import "../../styles/buttons.css";
import "../../styles/gallery.css";
import { curveSamples } from "../../document/curve/samples.ts";
import type { Editor } from "../../editor/editor.ts";
import { openSample } from "../../editor/route.ts";
import { h } from "../controls/dom.ts";
import { thumbnail } from "./thumbnail.ts";

const offered = ["circle-2", "heart", "glyph"];

/** What an empty drawing offers: the pen, and three samples. */
export function emptyCard(editor: Editor): HTMLElement {
  const samples = curveSamples.filter(({ id }) => offered.includes(id)).map((sample) =>
    h("button", { class: "sample", type: "button", title: sample.note, click: () => openSample(editor, sample.id) },
      thumbnail(sample.curve),
      h("span", { class: "sample-title" }, sample.title),
    ));
  const card = h("div", { class: "empty empty-curve", testid: "empty-curve" },
    h("h2", {}, `${editor.state.value.touch ? "Tap" : "Click"} to place points, or start from a sample`),
    h("button", { class: "button primary", type: "button", click: () => editor.actions.run("tool-pen") }, h("span", {}, "Use the pen")),
    h("div", { class: "samples" }, ...samples));
  placeByPress(editor, card);
  return card;
}

/** There is nothing to select yet: for as long as the card says so, a press on the stage is the pen's. */
function placeByPress(editor: Editor, card: HTMLElement): void {
  const press = ({ target, button }: PointerEvent): void => {
    if (!card.isConnected) window.removeEventListener("pointerdown", press, true);
    else if (button === 0 && editor.state.value.tool === "select" && target instanceof Element && target.closest("[data-part=surface]") !== null) editor.actions.run("tool-pen");
  };
  window.addEventListener("pointerdown", press, true);
}
