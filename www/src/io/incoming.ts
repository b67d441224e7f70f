/** What arrives by drop or by paste, anywhere on the page. */

export interface Brought {
  readonly pasted: boolean;
  readonly files: readonly File[];
  readonly text: string;
  /** The part of a page that some programs copy. */
  readonly page: string;
}

export interface IncomingHandlers {
  /** Whether something takes text itself: the page leaves its pastes and drops alone. */
  takesText(target: EventTarget | null): boolean;
  take(brought: Brought): void;
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
  const take = (event: Event, data: DataTransfer | null): void => {
    const [files, text, page] = [[...(data?.files ?? [])], data?.getData("text/plain") ?? "", data?.getData("text/html") ?? ""];
    const pasted = event.type === "paste";
    if (takesText(event.target) && (pasted || files.length === 0)) return;
    if (pasted && files.length + text.length + page.length === 0) return;
    event.preventDefault();
    handlers.take({ pasted, files, text, page });
  };
  const options = { signal: until };
  window.addEventListener("dragenter", (event) => carriesDrawing(event.dataTransfer) && over(1), options);
  window.addEventListener("dragleave", (event) => carriesDrawing(event.dataTransfer) && over(-1), options);
  window.addEventListener("dragover", (event) => carriesDrawing(event.dataTransfer) && !takesText(event.target) && event.preventDefault(), options);
  window.addEventListener("drop", (event) => {
    over(-depth);
    take(event, event.dataTransfer);
  }, options);
  window.addEventListener("paste", (event) => take(event, event.clipboardData), options);
}

function carriesDrawing(data: DataTransfer | null): boolean {
  return data !== null && (data.types.includes("Files") || data.types.includes("text/plain"));
}
