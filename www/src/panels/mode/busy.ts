import "../../styles/busy.css";
import { h, setAttribute, setText } from "../controls/dom.ts";
import type { Shell } from "../shell.ts";

/** Over the stage: how far long work has come, with a way to stop it. */

/** What is done sooner needs no bar; what takes longer gets words and a way out. */
const [barAfterMs, wordsAfterMs] = [150, 300];

export interface Work {
  /** When it began, in milliseconds of the page. */
  readonly since: number;
  /** How much of it is done, from 0 to 1. */
  readonly value: number;
  readonly text: string;
}

export interface BusyOptions {
  /** What is going on. */
  readonly label: string;
  /** What becomes of it when it is stopped. */
  readonly about: string;
  readonly testid: string;
  stop(): void;
}

export interface Busy {
  /** Null: nothing is going on, or nothing of this mode. */
  show(work: Work | null): void;
}

export function mountBusy({ regions, until }: Shell, { label, about, testid, stop }: BusyOptions): Busy {
  const words = h("span", { class: "num" });
  const fill = h("div", { class: "busy-fill" });
  const cancel = h("button", { class: "small-button", type: "button", testid, title: about, click: stop }, "Cancel");
  const bar = h("div", { class: "busy-bar", testid: "progress", role: "progressbar", "aria-label": label, "aria-valuemin": "0", "aria-valuemax": "100" }, fill, words);
  const box = h("div", { class: "busy", hidden: true }, bar, cancel);
  regions.stage.append(box);
  let timer: ReturnType<typeof setTimeout> | undefined;

  const show = (work: Work | null): void => {
    clearTimeout(timer);
    const waited = work === null ? 0 : performance.now() - work.since;
    box.hidden = waited < barAfterMs;
    const worded = waited >= wordsAfterMs;
    words.hidden = cancel.hidden = !worded;
    if (work === null) return;
    // Words come by themselves, however seldom the work is heard of.
    if (!worded) timer = setTimeout(() => show(work), 60);
    setText(words, work.text);
    setAttribute(bar, "aria-valuenow", String(Math.round(100 * work.value)));
    setAttribute(bar, "aria-valuetext", work.text);
    fill.style.transform = `scaleX(${work.value.toFixed(3)})`;
  };
  until.addEventListener("abort", () => clearTimeout(timer), { once: true });
  return { show };
}
