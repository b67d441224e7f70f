import { h } from "../controls/dom.ts";
import type { Shell } from "../shell.ts";

/** Shows what there was before anything was made of it, as long as it is held. */
export function holdButton({ editor }: Shell, label: string, about: string): HTMLButtonElement {
  const hold = h("button", { class: "button", type: "button", testid: "compare-hold", title: about }, h("span", {}, label));
  const only = (on: boolean) => () => editor.patch({ originalOnly: on });
  hold.addEventListener("pointerdown", only(true));
  for (const type of ["pointerup", "pointercancel", "pointerleave", "blur"]) hold.addEventListener(type, only(false));
  hold.addEventListener("keydown", (event) => (event.key === " " || event.key === "Enter") && only(true)());
  hold.addEventListener("keyup", only(false));
  return hold;
}
