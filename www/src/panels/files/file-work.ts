import type { CurveDocument } from "../../document/document.ts";
import { Problem } from "../../document/problem.ts";
import { curveSample } from "../../document/curve/samples.ts";
import { betweenGestures } from "../../editor/history/gestures.ts";
import { documentPathD } from "../../kernel/paths/paths.ts";
import { decimalsIn } from "../../document/unit.ts";
import { unitOf } from "../../kernel/unit.ts";
import { documentBounds } from "../../kernel/curve/samples.ts";
import type { Brought } from "../page-io.ts";
import { printedKey, type Shell } from "../shell.ts";
import { pasteCopy, rememberCopy } from "./clipboard.ts";
import { naturalDestination, place, readWhole } from "./load.ts";
import { layersOf, lookOf } from "./look.ts";
import { openPicture } from "./open-picture.ts";
import { report } from "./report.ts";

/** Copying, sharing, and taking in what is pasted or dropped. */

/**
 * The contours that hold the selection, without the sheet that they lie on; the whole drawing when nothing is selected.
 */
function chosenContours(shell: Shell): CurveDocument {
  const { curve, selection } = shell.editor.state.value;
  const chosen = new Set(selection.points.map((ref) => ref.contour));
  if (chosen.size === 0) return curve;
  const { artboard: _sheet, ...rest } = curve;
  return { ...rest, contours: curve.contours.filter((_, i) => chosen.has(i)) };
}

/** Of what is copied. */
function printedOf(curve: CurveDocument): { readonly tolerance: number; readonly decimals: number } {
  const unit = unitOf(curve);
  return { tolerance: 0.02 * unit, decimals: decimalsIn(unit, 4) };
}

/** What goes to the clipboard, and what is done when it is there. */
export interface Copy {
  readonly text: string;
  readonly done: () => void | Promise<void>;
}

/** Of Curve what is chosen; of another mode what its Export writes. */
export async function svgCopy(shell: Shell): Promise<Copy | null> {
  const { editor, io, toasts } = shell;
  const { mode } = editor.state.value;
  const parts = editor.modes.get(mode);
  const part = mode === "curve" ? chosenContours(shell) : parts?.drawing?.(editor.state.value) ?? null;
  if (part === null) return null;
  const printed = printedOf(part);
  const title = curveSample(part.sample ?? "")?.title ?? "expline drawing";
  const look = lookOf(part, mode);
  const layers = look.filled ? layersOf(editor, part).map(({ drawing, ...color }) => ({ ...color, d: documentPathD(drawing, printed).d })) : [];
  const text = await io.writeSvg({ title, d: documentPathD(part, printed).d, box: documentBounds(part), ...look, layers });
  // Before the clipboard has it: from then on it may be pasted.
  if (mode === "curve") rememberCopy(editor, text, part);
  return { text, done: () => toasts.say(`Copied ${counted(part)} as SVG.`) };
}

function counted({ contours: { length } }: CurveDocument): string {
  return length === 1 ? "the contour" : `${length} contours`;
}

function gestureOver({ editor }: Shell): Promise<void> {
  return new Promise((go) => betweenGestures(editor, go));
}

export async function svgCut(shell: Shell): Promise<Copy | null> {
  const part = chosenContours(shell);
  const gone = new Set(part.contours);
  const copy = await svgCopy(shell);
  return copy && {
    text: copy.text,
    async done() {
      await gestureOver(shell);
      shell.editor.dispatch({ name: "Cut", apply: (curve) => ({ ...curve, contours: curve.contours.filter((contour) => !gone.has(contour)) }) });
      // As news of the step, which go when it is undone.
      shell.editor.notify({ kind: "toast", text: `Cut ${counted(part)}.` });
    },
  };
}

export async function linkCopy({ editor, io, toasts }: Shell): Promise<Copy> {
  const { hash, alone } = await io.shareLink(editor.getState());
  const url = new URL(window.location.href);
  url.search = "";
  url.hash = hash;
  const holds = alone ? `what is in ${editor.actions.get(`mode-${editor.state.value.mode}`)?.label ?? "this mode"}; with the other modes it would be too long` : "the whole drawing";
  return { text: url.href, done: () => toasts.say(`Link copied. It contains ${holds}; nothing was uploaded.`) };
}

/** Says what has become of a copy that the clipboard was asked to take. */
export async function copied(shell: Shell, coming: Promise<Copy | null>, taken: Promise<boolean>): Promise<void> {
  try {
    const copy = await coming;
    if (copy === null) return;
    if (!(await taken)) return (await import("../controls/by-hand.ts")).offerByHand(copy.text, printedKey("Mod+C"));
    await copy.done();
  } catch (error) {
    report(shell, error);
  }
}

/** Text from a paste or a drop: added to the drawing, or opened when it is a whole file. */
export async function receiveText(shell: Shell, text: string): Promise<void> {
  try {
    await takeIn(shell, text);
  } catch (error) {
    // A part of a page that has no drawing in it is no broken one.
    const isPage = error instanceof Problem && error.id === "svg-broken" && error.details.line === undefined;
    report(shell, isPage ? new Problem("paste-unknown") : error);
  }
}

/** @throws Problem */
async function takeIn(shell: Shell, text: string): Promise<void> {
  if (shell.editor.state.value.engine.status !== "ready") return;
  await gestureOver(shell);
  if (pasteCopy(shell.editor, text)) return;
  const file = await shell.io.fileInText(text);
  if (file !== null) return receiveFiles(shell, [file]);
  const imported = await readWhole(shell, text);
  await gestureOver(shell);
  await place(shell, imported, naturalDestination(shell));
}

/** Where a picture is waited for, a file that is none is told so. */
function forTrace({ editor }: Shell, file: File, error: unknown): unknown {
  const strange = error instanceof Problem && error.id === "file-type" && editor.state.value.mode === "trace";
  return strange ? new Problem("image-type", { name: error.details.name ?? file.name }) : error;
}

const mostFiles = 20;

/**
 * Files from a drop or a paste, one after the other: drawings first, then one picture, for it opens Trace. What was
 * refused, and what was left, is said last, for good news would take it away.
 */
export async function receiveFiles(shell: Shell, files: readonly File[]): Promise<void> {
  const problems: unknown[] = [];
  const attempt = async <T>(file: File, work: () => Promise<T>): Promise<T | null> => work().catch((error: unknown) => {
    problems.push(forTrace(shell, file, error));
    return null;
  });
  const pictures: { readonly file: File; readonly name: string; readonly picture: Blob }[] = [];
  for (const file of files.slice(0, mostFiles)) {
    await attempt(file, async () => {
      const incoming = await shell.io.readIncoming(file);
      if ("picture" in incoming) pictures.push({ file, ...incoming });
      else await takeIn(shell, incoming.text);
    });
  }
  let left = files.slice(mostFiles).length;
  let isOpen = false;
  for (const { file, name, picture } of pictures) {
    if (isOpen) left += 1;
    else if (shell.editor.state.value.engine.status === "ready") isOpen = await attempt(file, async () => (await openPicture(shell, name, picture), true)) ?? false;
  }
  report(shell, ...problems, ...(left === 0 ? [] : [new Problem("files-left", { count: left, most: mostFiles })]));
}

/** Beside a copied file some systems put its name on the clipboard, as text. */
const fileName = /^[^\n]*\.[a-z]\w{1,4}\s*$/iu;

/** Pixels on the clipboard come as a file of this name, which is nobody's. */
function withoutStandIn(file: File): File {
  return /^image\.(?:png|jpe?g|webp|gif|bmp)$/u.test(file.name) ? new File([file], "", { type: file.type }) : file;
}

/** Of what was brought, what was meant: a program that copies words or numbers may put a picture of them beside. */
export function receive(shell: Shell, { pasted, files, text, page }: Brought): Promise<void> {
  if (!pasted && files.length > 0) return receiveFiles(shell, files);
  if (files.length > 0 && (text === "" || fileName.test(text))) return receiveFiles(shell, files.map(withoutStandIn));
  return receiveText(shell, text || page);
}
