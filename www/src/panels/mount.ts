import type { Mode } from "../document/document.ts";
import { takesText } from "../editor/actions/keymap.ts";
import type { Editor } from "../editor/editor.ts";
import type { Frame } from "../editor/frame.ts";
import { sayMissing, whenLoaded } from "../editor/loading.ts";
import { mountEmptyCurve } from "./curve/empty-curve.ts";
import { registerFileActions } from "./file-actions.ts";
import { comingSession } from "./files/session.ts";
import type { ModeMetrics } from "./mode/metric.ts";
import type { ModePanel } from "./mode/panel-parts.ts";
import type { PageIo } from "./page-io.ts";
import { mountHeader } from "./page/header.ts";
import { retryStyles } from "./page/missed-styles.ts";
import { mountPanel } from "./page/panel.ts";
import { mountRail } from "./page/rail.ts";
import { mountStatusBar } from "./page/status-bar.ts";
import { mountTheme } from "./page/theme.ts";
import type { Regions, Shell } from "./shell.ts";
import { mountBoot, type Wait } from "./stage/boot.ts";
import { mountContextMenu } from "./stage/context-menu.ts";
import { mountToasts } from "./stage/toasts.ts";

export interface PanelsOptions {
  readonly editor: Editor;
  readonly regions: Regions;
  readonly io: PageIo;
  readonly frame: Frame;
  /** Ends every listener of the panels. */
  readonly until: AbortSignal;
}

export interface Panels {
  /**
   * What the page was called with beside a route: a shared link, or the last session. Once it is there, and the engine
   * runs, it can be opened.
   */
  readonly session: Promise<() => void>;
  /** Puts in the panel and the numbers of a mode that was loaded. */
  addMode(mode: Mode, parts: { readonly panel: ModePanel; readonly metrics: ModeMetrics }): void;
  readonly shell: Shell;
  readonly wait: Wait;
}

/** Everything around the stage. */
export function mountPanels({ editor, regions, io, frame, until }: PanelsOptions): Panels {
  const shell: Shell = { editor, regions, io, until, toasts: mountToasts(regions.stage, editor), frame, samples: new Map() };
  // Routes rewrite the address; what it was when the page was opened is what counts.
  const address = window.location.hash;
  const theme = mountTheme(until);
  registerFileActions(shell);
  mountHeader(shell, theme);
  mountRail(shell);
  const statusBar = mountStatusBar(shell);
  const host = mountPanel(shell, statusBar.metrics);
  mountEmptyCurve(shell);
  const wait = mountBoot(shell);
  mountContextMenu(shell);
  retryStyles(editor, until);
  // What is loaded when it is first asked for may be out of reach by then.
  window.addEventListener("vite:preloadError", ({ payload }: Event & { payload?: unknown }) => sayMissing(editor, "This part of the page", payload), { signal: until });
  io.listenForIncoming({
    takesText,
    take: (brought) => whenLoaded(editor, import("./files/file-work.ts"), ({ receive }) => receive(shell, brought)),
    dragging: (over) => regions.stage.toggleAttribute("data-drop", over),
  }, until);
  return {
    shell,
    wait,
    session: comingSession(shell, address),
    addMode(mode, parts) {
      host.put(mode, parts.panel);
      statusBar.put(mode, parts.metrics);
    },
  };
}
