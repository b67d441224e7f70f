import "../../styles/busy.css";
import { h } from "../controls/dom.ts";
import { icon } from "../controls/icons.ts";
import type { Shell } from "../shell.ts";

/** Over the stage: why there is nothing to see, with ways on. */

export interface Said {
  readonly id: string;
  readonly text: string;
  readonly offers: readonly Offer[];
}

export interface Offer {
  readonly label: string;
  readonly testid: string;
  run(): void;
}

/** Shows what it is given; null: there is nothing to be said. */
export function mountNotice({ regions }: Shell): (said: Said | null) => void {
  const box = h("div", { class: "notice", hidden: true });
  regions.stage.append(box);
  return (said) => {
    box.hidden = said === null;
    box.replaceChildren(...(said === null ? [] : partsOf(said)));
  };
}

function partsOf({ id, text, offers }: Said): HTMLElement[] {
  const words = h("p", { testid: "error", "data-error": id, role: "alert" }, icon("warn"), h("span", {}, text));
  const buttons = offers.map(({ label, testid, run }) => h("button", { class: "button", type: "button", testid, click: run }, h("span", {}, label)));
  return buttons.length === 0 ? [words] : [words, h("div", { class: "field-row" }, ...buttons)];
}

/** Why an engine has given nothing, and what has become of what it worked on. */
export function engineFailure(code: string | undefined, safe: string, again: () => void): Said {
  const text = code === "E_INIT" ? "The engine could not be loaded. Check the connection, then try again." : `The engine stopped (${code ?? "unknown"}). ${safe}`;
  return { id: "engine", text, offers: [{ label: "Try again", testid: "offer-again", run: again }] };
}
