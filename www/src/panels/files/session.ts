import type { EditorState } from "../../editor/editor.ts";
import { sayMissing } from "../../editor/loading.ts";
import { follow, parseRoute } from "../../editor/route.ts";
import { h } from "../controls/dom.ts";
import { icon } from "../controls/icons.ts";
import { errorText } from "../messages/errors.ts";
import type { Shell } from "../shell.ts";

/**
 * What the page opens with beside a route: a shared link, or the last session of this browser. It is on its way at
 * once, so that nothing else is shown before it, and worked on; what comes back puts it on the stage.
 */
export async function comingSession(shell: Shell, address: string): Promise<() => void> {
  const { io, until } = shell;
  const openLink = (link: string, fresh: boolean): Promise<Opening> => reopen(shell, "The link", ({ linked }) => linked(shell, link, fresh));
  window.addEventListener("hashchange", () => io.isShareLink(window.location.hash) && void openLink(window.location.hash, false).then((open) => open?.()), { signal: until });
  const route = parseRoute(address);
  // Who loads the page again, or comes back to it, wants what this tab showed; who follows a link to a sample wants the
  // sample.
  const [visit] = performance.getEntriesByType("navigation");
  const own = visit instanceof PerformanceNavigationTiming && visit.type !== "navigate" ? io.tabShows() : null;
  const link = [address, own ?? ""].find(io.isShareLink);
  let open: Opening;
  if (link !== undefined) open = await openLink(link, true);
  else if ((own !== null || route?.sample === null) && io.hasKept()) {
    open = await reopen(shell, "Your last session", ({ kept }) => kept(shell, own, route !== null && /^#\/./u.test(address) ? route.mode : null));
  }
  return () => {
    open?.();
    if (own !== null && route !== null) follow(shell.editor, route);
    startKeeping(shell);
  };
}

type Opening = (() => void) | undefined;

/** Without the part of the page that opens what it showed before the page is there all the same. */
async function reopen({ editor }: Shell, what: string, work: (reopening: typeof import("./reopening.ts")) => Promise<Opening>): Promise<Opening> {
  try {
    return await work(await import("./reopening.ts"));
  } catch (error) {
    sayMissing(editor, what, error);
    return undefined;
  }
}

function startKeeping(shell: Shell): void {
  const { editor, io, regions, until } = shell;
  const warning = h("button", {
    class: "metric not-kept",
    type: "button",
    testid: "error",
    "data-error": "storage",
    title: errorText("storage"),
    click: () => editor.actions.run("save-json"),
  }, icon("warn"), "Not saved: download JSON");
  const keeping = io.createAutosave({
    read: () => editor.getState(),
    busy: () => editor.inGesture,
    abandon: editor.undo,
    failing: (failed) => (failed ? regions.status.append(warning) : warning.remove()),
    until,
  });
  // A drag changes the curve first and the history when it ends; only what the history knows is worth keeping.
  const partsOf = ({ curve, surface, fit, trace, traceRun, mode }: EditorState): readonly unknown[] => [curve, surface, fit, trace, traceRun.outcome, mode];
  let seen = partsOf(editor.state.value);
  let worked = false;
  editor.state.subscribe((state) => {
    const now = partsOf(state);
    worked ||= state.canUndo || state.canRedo;
    if (!worked || now.every((part, i) => part === seen[i])) return;
    seen = now;
    keeping.touch();
  }, { until });
}
