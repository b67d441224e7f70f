/**
 * The frame's own code: it starts a worker for each order and ends it when it is done, late or no longer wanted. The
 * worker is what runs the code, so that a loop without an end leaves this frame and the page as they are.
 */
import type { Order, Report } from "./messages.ts";

let worker: Worker | undefined;
let address = "";
let timer: ReturnType<typeof setTimeout> | undefined;

function end(): void {
  worker?.terminate();
  worker = undefined;
  URL.revokeObjectURL(address);
  clearTimeout(timer);
}

const tell = (report: Report): void => parent.postMessage(report, "*");

function start({ code, library, worker: program, limit }: Order): void {
  end();
  address = URL.createObjectURL(new Blob([program], { type: "text/javascript" }));
  // A classic one: without an origin, Chromium starts no worker that is a module. It can still import modules.
  worker = new Worker(address);
  timer = setTimeout(() => {
    end();
    tell({ type: "late" });
  }, limit);
  worker.addEventListener("message", ({ data }: MessageEvent<Report>) => {
    if (data.type !== "said") end();
    tell(data);
  });
  worker.addEventListener("error", (event) => {
    end();
    tell({ type: "failed", text: event.message || "the code could not be started" });
  });
  worker.postMessage({ code, library });
}

// Only without an origin, and only for the page around it: wherever else this file is opened, it does nothing.
if (self.origin === "null" && parent !== window) {
  addEventListener("message", ({ data, source }: MessageEvent<Order | "stop">) => {
    if (source !== parent) return;
    if (data === "stop") end();
    else start(data);
  });
  parent.postMessage({ type: "ready" }, "*");
}
