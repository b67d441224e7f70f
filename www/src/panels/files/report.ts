import type { DemoState } from "../../document/document.ts";
import { curveSample } from "../../document/curve/samples.ts";
import { Problem } from "../../document/problem.ts";
import { whenLoaded } from "../../editor/loading.ts";
import { asProblem } from "../messages/errors.ts";
import type { Shell } from "../shell.ts";

/** Says what went wrong; the words for it are loaded with the first thing that goes wrong. */
export function report(shell: Shell, ...errors: readonly unknown[]): void {
  const problems = errors.map(asProblem);
  const [first] = problems;
  if (first === undefined) return;
  whenLoaded(shell.editor, import("../messages/file-errors.ts"), ({ problemText }) => {
    const wayOut = first.id === "share-long" ? { label: "Download JSON", run: () => void shell.editor.actions.run("save-json") } : undefined;
    shell.toasts.error(first.id, [...new Set(problems.map(({ id, details }) => problemText(id, details)))].join(" "), wayOut);
  });
}

/** A whole state from outside in place of the present one; false (and a message) when it cannot be drawn. */
export function openState(shell: Shell, state: DemoState, fresh: boolean): boolean {
  try {
    // What is said of the drawing before, as of the sample that a page begins with, is not said of this one.
    shell.editor.patch({ hint: "" });
    shell.editor.setState(state, { fresh });
    // It belongs to a sample's lesson, and the page begins with one.
    shell.editor.setOverlay("bezier", curveSample(state.curve.sample ?? "")?.overlays.includes("bezier") === true);
    return true;
  } catch {
    report(shell, new Problem("share-bad"));
    return false;
  }
}
