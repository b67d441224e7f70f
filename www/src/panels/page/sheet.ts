import { h } from "../controls/dom.ts";
import { icon } from "../controls/icons.ts";

const snaps = ["peek", "half", "full"] as const;
type Snap = (typeof snaps)[number];

const dragThresholdPx = 24;

/**
 * On a phone the panel is a sheet over the foot of the stage. It rests at three heights, by a drag on its bar or by two
 * buttons; the main number and the main slider stay in sight at the lowest.
 */
export function mountSheet(panel: HTMLElement, peekParts: readonly HTMLElement[], until: AbortSignal): { readonly head: HTMLElement; add(part: HTMLElement): void; uncover(): void } {
  const up = h("button", { class: "icon-button", type: "button", testid: "sheet-up", "aria-label": "Raise the panel" }, icon("up"));
  const down = h("button", { class: "icon-button", type: "button", testid: "sheet-down", "aria-label": "Lower the panel" }, icon("down"));
  const bar = h("div", { class: "sheet-bar" }, h("span", { class: "sheet-grip", "aria-hidden": "true" }), up, down);
  const peek = h("div", { class: "sheet-peek" });
  const head = h("div", { class: "sheet-head" }, bar, peek);
  let snap: Snap = "peek";

  const show = (next: Snap): void => {
    snap = next;
    panel.dataset["snap"] = snap;
    up.disabled = snap === "full";
    down.disabled = snap === "peek";
  };
  const step = (by: number): void => show(snaps[Math.max(0, Math.min(snaps.length - 1, snaps.indexOf(snap) + by))] ?? "peek");
  up.addEventListener("click", () => step(1));
  down.addEventListener("click", () => step(-1));

  let fromY: number | null = null;
  bar.addEventListener("pointerdown", (event) => {
    if (event.target instanceof Element && event.target.closest("button") !== null) return;
    fromY = event.clientY;
    bar.setPointerCapture(event.pointerId);
  });
  bar.addEventListener("pointerup", (event) => {
    if (fromY === null) return;
    const moved = event.clientY - fromY;
    fromY = null;
    if (Math.abs(moved) >= dragThresholdPx) step(moved < 0 ? 1 : -1);
    else if (snap === "peek") step(1);
  });
  bar.addEventListener("pointercancel", () => { fromY = null; });

  // The same elements, in the sheet's head on a phone and in their own places otherwise.
  const homes: { readonly part: HTMLElement; readonly mark: Comment }[] = [];
  const phone = window.matchMedia("(width < 37.5em)");
  const arrange = (): void => {
    if (phone.matches) peek.append(...homes.map(({ part }) => part));
    else for (const { part, mark } of homes) mark.after(part);
  };
  const add = (part: HTMLElement): void => {
    const mark = document.createComment("");
    part.before(mark);
    homes.push({ part, mark });
    arrange();
  };
  phone.addEventListener("change", arrange, { signal: until });
  show("peek");
  for (const part of peekParts) add(part);
  return { head, add, uncover: () => snap === "full" && show("half") };
}
