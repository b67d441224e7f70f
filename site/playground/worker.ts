/** Runs the code of an order as a module, sends on what it prints, and draws what its default export is. */
import { drawnOf } from "./drawn.ts";
import { printed } from "./printed.ts";
import { type Level, type Report, LONGEST_LINE, MOST_LINES } from "./messages.ts";

const tell = (report: Report): void => postMessage(report);

let lines = 0;
const LEVELS: Readonly<Record<string, Level>> = { log: "log", info: "log", debug: "log", table: "log", warn: "warn", error: "error" };
for (const [name, level] of Object.entries(LEVELS)) {
  Object.assign(console, {
    [name]: (...all: unknown[]) => {
      lines += 1;
      if (lines > MOST_LINES + 1) return;
      tell({ type: "said", level, text: lines > MOST_LINES ? "…" : all.map((each) => (typeof each === "string" ? each : printed(each))).join(" ").slice(0, LONGEST_LINE) });
    },
  });
}

const moduleOf = (text: string): string => URL.createObjectURL(new Blob([text], { type: "text/javascript" }));

/** What went wrong, with its line where the browser says it. */
function said(error: unknown, address: string): string {
  if (!(error instanceof Error)) return `thrown: ${printed(error)}`;
  const { code } = error as { code?: unknown };
  const [, line] = new RegExp(`${address}:(\\d+)`).exec(error.stack ?? "") ?? [];
  return `${typeof code === "string" ? code : error.name}: ${error.message}${line === undefined ? "" : ` (line ${line})`}`;
}

addEventListener("message", async ({ data: { code, library } }: MessageEvent<{ code: string; library: string }>) => {
  const packageModule = moduleOf(library);
  // The names by which the package is imported are the only ones that lead anywhere.
  const address = moduleOf(code.replace(/(\b(?:from|import)\s*\(?\s*)(["'])expline(?:\/slim|\/edit)?\2/g, `$1$2${packageModule}$2`));
  const start = performance.now();
  try {
    const { default: value } = (await import(/* @vite-ignore */ address)) as { default?: unknown };
    const drawn = drawnOf(await value);
    tell({ type: "done", drawn, milliseconds: performance.now() - start });
  } catch (error) {
    tell({ type: "failed", text: said(error, address) });
  }
});
