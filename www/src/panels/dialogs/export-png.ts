import { whenLoaded } from "../../editor/loading.ts";
import { button } from "../controls/dialog.ts";
import { h, setAttribute, setText } from "../controls/dom.ts";
import type { FileLook } from "../page-io.ts";
import type { Shell } from "../shell.ts";
import type { Box } from "./export-result.ts";

/** Chosen once, kept for the next time the dialog opens. */
let scale = 2;
let onPaper = false;

/** What there is a picture of. */
interface PngSubject {
  readonly stem: string;
  readonly d: () => string;
  readonly box: Box;
  /** How it looks as an SVG file. */
  readonly look: () => FileLook;
  /** The picture has the colours of the stage. */
  readonly asOnStage: () => boolean;
}

/** Under ink that is dark in any theme. */
const lightPaper = "#fff";

export interface PngGroup {
  readonly element: HTMLElement;
  /** Prints the size anew, once it looks otherwise. */
  refresh(): void;
}

/** The picture, its scale and what is under it; the size it will have is printed on the button. */
export function pngGroup(shell: Shell, subject: PngSubject): PngGroup {
  const { box, look } = subject;
  const save = button("PNG", { testid: "export-png", title: "Download a picture", click: () => download(shell, subject) });
  const refresh = (): void => whenLoaded(shell.editor, shell.io.pngSize({ ...look(), box }, scale), (size) => showSize(save, size));
  return { element: h("span", { class: "button-group", role: "group", "aria-label": "Picture" }, save, scaleChoice(refresh), paperChoice()), refresh };
}

function download({ editor, io, toasts }: Shell, { stem, d, box, look, asOnStage }: PngSubject): void {
  const colour = (name: string): string => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  // Light ink of the dark theme is for dark paper: where there is none, nobody knows what the picture will lie on.
  const stage = asOnStage() ? { stage: { ...(onPaper ? { ink: colour("--curve") } : {}), fill: colour("--point") } } : {};
  const paper = !onPaper ? null : asOnStage() ? colour("--canvas") : lightPaper;
  const name = `${stem}@${scale}x.png`;
  whenLoaded(editor, io.writePng({ d: d(), box, scale, paper, ...look(), ...stage }), (blob) => {
    if (blob === null) toasts.say("This picture is too large for the browser. Choose a smaller scale.");
    else io.download(name, blob);
  });
}

function showSize(save: HTMLButtonElement, size: { readonly width: number; readonly height: number } | null): void {
  const label = save.querySelector("span");
  if (label !== null) setText(label, size === null ? "PNG" : `PNG ${size.width} × ${size.height}`);
  setAttribute(save, "data-width", size === null ? null : String(size.width));
  setAttribute(save, "data-height", size === null ? null : String(size.height));
  save.disabled = size === null;
}

function scaleChoice(changed: () => void): HTMLElement {
  const scales = h("select", { class: "select", testid: "export-png-scale", "aria-label": "Picture scale" },
    ...[1, 2, 4].map((each) => h("option", { value: each }, `${each}×`)),
  );
  scales.value = String(scale);
  scales.addEventListener("change", () => {
    scale = Number(scales.value);
    changed();
  });
  return scales;
}

function paperChoice(): HTMLElement {
  const papers = h("select", { class: "select", testid: "export-png-paper", "aria-label": "Picture background" },
    h("option", { value: "none" }, "transparent"),
    h("option", { value: "paper" }, "paper"),
  );
  papers.value = onPaper ? "paper" : "none";
  papers.addEventListener("change", () => {
    onPaper = papers.value === "paper";
  });
  return papers;
}
