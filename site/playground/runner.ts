/** The page's end of the frame: starts code in it, hears what comes of it, and does away with it where it is silent. */
import { type Drawn, type Level, type Order, LONGEST_LINE, MOST_LINES } from "./messages.ts";

/** What is told of a run; each but `said` ends it. */
export interface Listener {
  said(level: Level, text: string): void;
  done(drawn: readonly Drawn[], milliseconds: number): void;
  failed(text: string): void;
}

export const LIMIT = 10_000;
/** How much later than its own limit a frame may answer. */
const GRACE = 1500;

const isText = (value: unknown): value is string => typeof value === "string";

/** What of a list has the form of something that can be drawn. */
function readDrawn(value: unknown): Drawn[] {
  if (!Array.isArray(value)) return [];
  return value.flatMap((each: unknown): Drawn[] => {
    if (typeof each !== "object" || each === null) return [];
    const { kind, d, points, text, isWire, areKnots } = each as Record<string, unknown>;
    if (kind === "path" && isText(d)) return [{ kind, d, isWire: isWire === true }];
    if (kind === "svg" && isText(text)) return [{ kind, text }];
    if (kind === "dots" && Array.isArray(points)) return [{ kind, points: points.filter((part) => typeof part === "number" && Number.isFinite(part)), areKnots: areKnots === true }];
    return [];
  });
}

export class Runner {
  readonly #assets: string;
  readonly #host: HTMLElement;
  #frame: HTMLIFrameElement | undefined;
  #parts: Promise<{ library: string; worker: string }> | undefined;
  #listener: Listener | undefined;
  #lines = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(host: HTMLElement, assets: string) {
    this.#host = host;
    this.#assets = assets;
    addEventListener("message", ({ data, source }: MessageEvent<unknown>) => {
      if (source === this.#frame?.contentWindow && typeof data === "object" && data !== null) this.#hear(data as Record<string, unknown>);
    });
  }

  /** Runs code; what ran before is ended. */
  async run(code: string, listener: Listener): Promise<void> {
    this.stop();
    this.#listener = listener;
    this.#lines = 0;
    try {
      const [parts, frame] = await Promise.all([this.#loaded(), this.#opened()]);
      if (this.#listener !== listener) return;
      const order: Order = { code, ...parts, limit: LIMIT };
      frame.contentWindow?.postMessage(order, "*");
      this.#timer = setTimeout(() => this.#late(), LIMIT + GRACE);
    } catch (error) {
      if (this.#listener === listener) this.#over()?.failed(String(error));
    }
  }

  /** Ends what runs, if something does; nobody is told. */
  stop(): void {
    if (this.#over() !== undefined) this.#frame?.contentWindow?.postMessage("stop", "*");
  }

  #over(): Listener | undefined {
    clearTimeout(this.#timer);
    const listener = this.#listener;
    this.#listener = undefined;
    return listener;
  }

  #late(): void {
    this.#frame?.remove();
    this.#frame = undefined;
    this.#over()?.failed(`stopped: it took longer than ${LIMIT / 1000} s`);
  }

  #hear(data: Record<string, unknown>): void {
    const { type, level, text, drawn, milliseconds } = data;
    if (type === "said" && isText(text)) {
      this.#lines += 1;
      if (this.#lines <= MOST_LINES + 1) this.#listener?.said(level === "warn" || level === "error" ? level : "log", text.slice(0, LONGEST_LINE));
    } else if (type === "done") this.#over()?.done(readDrawn(drawn), Number(milliseconds));
    else if (type === "failed" && isText(text)) this.#over()?.failed(text.slice(0, LONGEST_LINE));
    else if (type === "late") this.#over()?.failed(`stopped: it took longer than ${LIMIT / 1000} s`);
  }

  #loaded(): Promise<{ library: string; worker: string }> {
    const text = async (name: string): Promise<string> => (await fetch(`${this.#assets}${name}.js`)).text();
    this.#parts ??= Promise.all([text("library"), text("worker")]).then(([library, worker]) => ({ library, worker }));
    this.#parts.catch(() => (this.#parts = undefined));
    return this.#parts;
  }

  /** The frame, which says that it is ready. It has no origin: no storage, no cookies, no way into this page. */
  #opened(): Promise<HTMLIFrameElement> {
    if (this.#frame !== undefined) return Promise.resolve(this.#frame);
    const frame = document.createElement("iframe");
    frame.setAttribute("sandbox", "allow-scripts");
    frame.hidden = true;
    frame.title = "Where the code runs";
    frame.src = `${this.#assets}sandbox.html`;
    return new Promise((resolve) => {
      const ready = ({ data, source }: MessageEvent<{ type?: unknown } | null>): void => {
        if (source !== frame.contentWindow || data?.type !== "ready") return;
        removeEventListener("message", ready);
        this.#frame = frame;
        resolve(frame);
      };
      addEventListener("message", ready);
      this.#host.append(frame);
    });
  }
}
