import { emptyCurve, nothingSelected } from "../document/document.ts";
import { emptyFit } from "../document/fit/fit-document.ts";
import { emptySurface, noNetPoints } from "../document/surface/surface.ts";
import { emptyTrace } from "../document/trace/trace.ts";
import type { EditorState, Settings } from "./editor.ts";
import { initialFitView, noFitRun } from "./fit/fit-state.ts";
import { nothingSketched } from "./sketch.ts";
import { startSolid } from "./surface/solid.ts";
import { initialTraceView, noTraceRun } from "./trace/trace-state.ts";

/** Settings as somebody finds them who never changed one. */
export const defaultSettings: Settings = {
  overlays: { handles: true, polygon: false, knots: false, comb: false, subdivision: false, weights: false, fill: true, bezier: false, grid: false },
  combScale: 1,
  subdivisionSteps: 0,
  snap: true,
  gridStep: 10,
  scrollPans: false,
  singleKeys: true,
  moveByClicks: false,
  penPans: true,
};

/** The state before anything was opened. */
export const initialState: EditorState = {
  mode: "curve",
  tool: "select",
  view: { zoom: 1, x: 400, y: 300 },
  curve: emptyCurve,
  fit: emptyFit,
  fitView: initialFitView,
  fitRun: noFitRun,
  trace: emptyTrace,
  traceView: initialTraceView,
  traceRun: noTraceRun,
  traceProgress: null,
  fitProgress: 0,
  incoming: null,
  surface: emptySurface,
  chosen: noNetPoints,
  solid: startSolid,
  selection: nothingSelected,
  hover: { kind: "empty" },
  settings: defaultSettings,
  drag: null,
  sketch: nothingSketched,
  modifiers: { shift: false, alt: false, mod: false },
  space: false,
  stage: { left: 0, top: 0, width: 800, height: 600 },
  hint: "",
  keyboard: false,
  touch: false,
  cursor: "default",
  originalOnly: false,
  engine: { status: "booting" },
  canUndo: false,
  canRedo: false,
  undoName: null,
  redoName: null,
};
