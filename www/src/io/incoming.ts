/** What arrives by drop or by paste, anywhere on the page. */

export interface IncomingHandlers {
  /** Whether something takes text itself: the page leaves its pastes and drops alone. */
  takesText(target: EventTarget | null): boolean;
  files(files: readonly File[]): void;
  text(text: string): void;
  /** Something is being dragged over the page, or no longer. */
  dragging(over: boolean): void;
}

/** Listens on the whole page for drops and pastes. */
export function listenForIncoming(handlers: IncomingHandlers, until: AbortSignal): void {
  const { takesText } = handlers;
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
