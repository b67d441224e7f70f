import "../../styles/gallery.css";
import type { EditorState } from "../../editor/editor.ts";
import { h } from "../controls/dom.ts";
import type { Shell } from "../shell.ts";

/** What an empty stage offers, for as long as it is empty. Presses beside the buttons go through to the stage. */
export function mountEmptyStage({ editor, regions, until }: Shell, isEmpty: (state: EditorState) => boolean, build: () => HTMLElement): void {
  let card: HTMLElement | null = null;
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

export interface SampleCard {
  readonly id: string;
  readonly title: string;
  readonly note: string;
}

/** Samples as cards to press, the one that is open marked. */
export function sampleCards<S extends SampleCard>(
  samples: readonly S[],
  present: string | undefined,
  pictureOf: (sample: S) => Element,
  open: (id: string) => void,
): HTMLElement[] {
  return samples.map((sample) =>
    h("button", {
      class: "sample",
      type: "button",
      testid: `sample-${sample.id}`,
      title: sample.note,
      "aria-current": sample.id === present ? "true" : null,
      click: () => open(sample.id),
    },
      pictureOf(sample), h("span", { class: "sample-title" }, sample.title), h("span", { class: "sample-note quiet" }, sample.note)));
}
