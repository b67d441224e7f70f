import { modes, type Mode } from "../document/document.ts";
import { curveSample, landingSample } from "../document/curve/samples.ts";
import { emptyFit } from "../document/fit/fit-document.ts";
import { emptySurface, noNetPoints } from "../document/surface/surface.ts";
import { emptyTrace } from "../document/trace/trace.ts";
import { loadCurve } from "./curve/edits.ts";
import { defaultSettings } from "./initial-state.ts";
import type { Editor, EditorState, OverlayId } from "./editor.ts";
import { fitView } from "./actions/standard-actions.ts";

/**
 * `#/curve?sample=heart`: the mode, and the sample while it is still the sample. Shared drawings (`#s=…`) are decoded
 * elsewhere.
 */

export interface Route {
  readonly mode: Mode;
  readonly sample: string | null;
}

/** The route in a hash; null for one that is not a route. The empty hash is the landing page. */
export function parseRoute(hash: string): Route | null {
  if (hash === "" || hash === "#" || hash === "#/") return { mode: "curve", sample: null };
  const match = /^#\/([a-z]+)(?:\?(.*))?$/.exec(hash);
  const mode = modes.find((name) => name === match?.[1]);
  if (mode === undefined) return null;
  return { mode, sample: new URLSearchParams(match?.[2] ?? "").get("sample") };
}

export function printRoute({ mode, sample }: Route): string {
  return sample === null ? `#/${mode}` : `#/${mode}?sample=${encodeURIComponent(sample)}`;
}

/** The document as a sample was opened: while it is this very one, the address names the sample. */
let opened: { readonly sample: string; readonly curve: object } | null = null;

/** Opens a curve sample: its drawing, its overlays, a view that shows it. False for a name that is none. */
export function openSample(editor: Editor, id: string): boolean {
  const sample = curveSample(id);
  if (sample === undefined) return false;
  editor.patch({ mode: "curve" });
  // Known before it is there: whoever hears of the change asks for the route at once.
  opened = { sample: id, curve: sample.curve };
  loadCurve(editor, `Open ${sample.title}`, sample.curve);
  const lessons: Partial<Record<OverlayId, boolean>> = Object.fromEntries(sample.overlays.map((overlay) => [overlay, true]));
  const own: OverlayId[] = ["bezier", "comb", "polygon"];
  const reset = Object.fromEntries(own.map((overlay) => [overlay, defaultSettings.overlays[overlay]]));
  editor.setSettings({ overlays: { ...editor.state.value.settings.overlays, ...reset, ...lessons } });
  editor.patch({ view: { zoom: 1, x: 400, y: 300 }, tool: "select", hint: sample.note });
  fitView(editor, 1);
  return true;
}

/** The route that the state is at, in the mode that is shown or another. */
export function routeOf(editor: Editor, mode = editor.state.value.mode): Route {
  const { curve, fit, trace, surface } = editor.state.value;
  switch (mode) {
    case "curve":
      return { mode, sample: opened !== null && curve === opened.curve ? opened.sample : null };
    case "fit":
      return { mode, sample: fit.sample ?? null };
    case "trace":
      return { mode, sample: trace.sample ?? null };
    case "surface":
      return { mode, sample: surface.net.length === 0 ? surface.sample : (editor.modes.get(mode)?.sample?.(editor.state.value) ?? null) };
  }
}

/** Goes where the address says. A sample that is being worked on is not opened over the work. */
export function follow(editor: Editor, route: Route): void {
  const { curve, fit, trace, surface } = editor.state.value;
  let unknown = false;
  if (route.sample !== null) {
    if (route.mode === "curve" && curve.sample !== route.sample) unknown = !openSample(editor, route.sample);
    if (route.mode === "fit" && route.sample !== fit.sample) nameFit(editor, route.sample);
    if (route.mode === "trace" && route.sample !== trace.sample) nameTrace(editor, route.sample);
    if (route.mode === "surface" && route.sample !== surface.sample) nameSurface(editor, route.sample);
  }
  editor.patch({ mode: route.mode });
  if (unknown) editor.notify({ kind: "toast", text: `There is no sample called ${route.sample}.` });
}

/** An empty net is the sample that it names, still to be opened. */
function nameSurface(editor: Editor, sample: string): void {
  editor.surfaceEdits.dispatch("Open sample", () => ({ surface: { ...emptySurface, sample }, chosen: noNetPoints }));
}

/** Its own settings come with the mode. */
function nameTrace(editor: Editor, sample: string): void {
  editor.traceEdits.dispatch("Open sample", () => ({ trace: { ...emptyTrace, sample } }));
}

/** Data without points are the sample that they name, still to be opened. */
function nameFit(editor: Editor, sample: string): void {
  editor.fitEdits.dispatch("Open sample", () => ({ fit: { ...emptyFit, sample } }));
}

/** Keeps address and state together, both ways. Call once, after the first document is there. */
export function connectRoutes(editor: Editor, until: AbortSignal): void {
  /** What was worked on in each mode when another sample was last opened over it. */
  const work: Partial<Pick<EditorState, Mode>> = {};
  const write = (push: boolean): void => {
    const next = printRoute(routeOf(editor));
    if (location.hash === next) return;
    if (push) history.pushState(null, "", next);
    else history.replaceState(null, "", next);
  };
  let following = false;
  let last = routeOf(editor).sample;
  editor.state.subscribe((state, before) => {
    const { mode } = state;
    const { sample } = routeOf(editor);
    const isOther = sample !== null && sample !== before[mode].sample;
    if (isOther && last === null && mode === before.mode) Object.assign(work, { [mode]: before[mode] });
    last = sample;
    if (following || (mode === before.mode && mode !== "surface" && state.curve === before.curve && state.fit.sample === before.fit.sample
      && state.trace.sample === before.trace.sample)) return;
    // Another mode or another sample is a page to come back to; an edit only stops the address from promising the
    // sample.
    write(mode !== before.mode || isOther);
  }, { until });
  window.addEventListener("hashchange", () => {
    const route = parseRoute(location.hash);
    if (route === null) return;
    following = true;
    follow(editor, route);
    const { mode, sample } = route;
    // Back from a sample is back at what it was opened over: one step of the history, as opening it was.
    if (sample === null && mode in work && routeOf(editor).sample !== null) {
      editor.setState({ ...editor.getState(), trace: editor.state.value.trace, [mode]: work[mode] });
      fitView(editor);
    }
    following = false;
    write(false);
  }, { signal: until });
  write(false);
}

/** The first document for an address: the sample it names, or the landing one. */
export function openRoute(editor: Editor, route: Route): void {
  if (route.mode !== "curve" || !openSample(editor, route.sample ?? landingSample)) openSample(editor, landingSample);
  follow(editor, route);
}
