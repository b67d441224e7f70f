/** Files and text that arrive by a file field, by drop or by paste: what they are, by type, name and first bytes. */
import { Problem } from "../document/problem.ts";

export type Incoming = { readonly name: string; readonly text: string } | { readonly name: string; readonly picture: Blob };

const mostTextBytes = 32 * 1024 * 1024;

function extensionOf(name: string): string {
  return /\.([a-z0-9]+)$/iu.exec(name)?.[1]?.toLowerCase() ?? "";
}

const textTypes: ReadonlySet<string> = new Set(["svg", "json", "txt", "csv", "tsv", "dat", "xy"]);
const pictureTypes: ReadonlySet<string> = new Set(["png", "jpg", "jpeg", "webp", "avif", "gif", "bmp", "tif", "tiff", "heic"]);

/** A picture, or the text of a file that can be drawn. @throws Problem for anything else. */
export async function readIncoming(file: File): Promise<Incoming> {
  const named = file.name !== "";
  const name = named ? shortName(file.name) : "The pasted file";
  const extension = extensionOf(file.name);
  const isSvg = file.type === "image/svg+xml" || extension === "svg";
  if (!isSvg && (file.type.startsWith("image/") || pictureTypes.has(extension))) {
    const title = named ? name : "Pasted picture";
    await (await import("./picture/picture-file.ts")).checkPicture(file, title);
    return { name: title, picture: file };
  }
  const isText = isSvg || textTypes.has(extension) || file.type === "application/json" || file.type.startsWith("text/");
  if (!isText) throw new Problem("file-type", { name });
  if (file.size > mostTextBytes) throw new Problem("svg-big", { field: "bytes", most: mostTextBytes });
  const text = await file.text();
  // A binary file under a text name is told apart by its first bytes.
  if (text.slice(0, 1000).includes("\u0000")) throw new Problem("file-type", { name });
  return { name, text };
}

/** A file name as it may be shown: at most 60 characters, and nothing that reorders or hides them. */
function shortName(name: string): string {
  const plain = name.replace(/[\p{Cc}\p{Cf}\p{Zl}\p{Zp}]/gu, "\uFFFD");
  return plain.length <= 60 ? plain : `${plain.slice(0, 40)}…${plain.slice(-16)}`;
}

/** True while what has the focus takes text itself: the page leaves its pastes and drops alone. */
export function takesText(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.isContentEditable || target instanceof HTMLTextAreaElement) return true;
  return target instanceof HTMLInputElement && !["range", "checkbox", "radio", "button", "file", "submit"].includes(target.type);
}

export interface IncomingHandlers {
  files(files: readonly File[]): void;
  text(text: string): void;
  /** Something is being dragged over the page, or no longer. */
  dragging(over: boolean): void;
}

/** Listens on the whole page for drops and pastes. */
export function listenForIncoming(handlers: IncomingHandlers, until: AbortSignal): void {
  let depth = 0;
  const over = (change: number): void => {
    depth = Math.max(0, depth + change);
    handlers.dragging(depth > 0);
  };
  const options = { signal: until };
  window.addEventListener("dragenter", (event) => carriesDrawing(event.dataTransfer) && over(1), options);
  window.addEventListener("dragleave", (event) => carriesDrawing(event.dataTransfer) && over(-1), options);
  window.addEventListener("dragover", (event) => carriesDrawing(event.dataTransfer) && !takesText(event.target) && event.preventDefault(), options);
  window.addEventListener("drop", (event) => {
    depth = 0;
    handlers.dragging(false);
    const files = [...(event.dataTransfer?.files ?? [])];
    if (files.length === 0 && takesText(event.target)) return;
    event.preventDefault();
    if (files.length > 0) handlers.files(files);
    else handlers.text(event.dataTransfer?.getData("text/plain") ?? "");
  }, options);
  window.addEventListener("paste", (event) => {
    if (takesText(event.target)) return;
    const files = [...(event.clipboardData?.files ?? [])].map(withoutStandIn);
    const text = event.clipboardData?.getData("text/plain") ?? "";
    if (files.length === 0 && text === "") return;
    event.preventDefault();
    if (files.length > 0 && (text === "" || fileName.test(text))) handlers.files(files);
    else handlers.text(text);
  }, options);
}

/** Beside a copied file some systems put its name on the clipboard, as text. */
const fileName = /^[^\n]*\.[a-z]\w{1,4}\s*$/iu;

/** Pixels on the clipboard come as a file of this name, which is nobody's. */
function withoutStandIn(file: File): File {
  return /^image\.(?:png|jpe?g|webp|gif|bmp)$/u.test(file.name) ? new File([file], "", { type: file.type }) : file;
}

function carriesDrawing(data: DataTransfer | null): boolean {
  return data !== null && (data.types.includes("Files") || data.types.includes("text/plain"));
}
