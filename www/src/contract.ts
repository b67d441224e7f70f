import type { DemoState } from "./document/document.ts";
import { toPage, toScreen } from "./editor/pointer/camera.ts";
import type { Editor } from "./editor/editor.ts";
import type { Frame } from "./editor/frame.ts";
import { engineVersion } from "./kernel/engine.ts";
import { measureCurve } from "./kernel/curve/measuring/measure.ts";
import { samplePoints, subdivided } from "./kernel/curve/samples.ts";

/** What the page offers to testers: small, read-mostly, in every build. */

type Pair = [number, number];

export interface ExplineDemo {
  /** Semver of the library. */
  readonly version: string;
  /** The engine runs and the first frame is painted. */
  readonly ready: Promise<void>;
  /** No pending job, no dirty frame. */
  idle(): Promise<void>;
  getState(): DemoState;
  setState(state: DemoState): Promise<void>;
  /** Points at uniform parameter in document units: closed i/n of the way round, open i/(n − 1). */
  sample(count: number, contour?: number): Pair[];
  /** The first contour's polygon after so many subdivision steps. */
  subdivision(steps: number): Pair[];
  mesh(rows?: number, cols?: number): { positions: number[]; rows: number; cols: number };
  /** CSS pixels in the window. */
  toScreen(x: number, y: number): { x: number; y: number };
  toDoc(x: number, y: number): { x: number; y: number };
  stats(): { frameMs: number[]; lastJobMs: number; wasmBytes: number; bezierError?: number; modelError?: number };
  /** Takes the page apart, and gives back what puts it together anew. */
  unmount(): { mount(): ExplineDemo };
}

declare global {
  interface Window {
    explineDemo: ExplineDemo;
  }
  /** Size of the engine's WebAssembly, written in by the build. */
  const __WASM_BYTES__: number;
}

function pairs(points: Float64Array): Pair[] {
  return Array.from({ length: points.length / 2 }, (_, i) => [points[2 * i] ?? 0, points[2 * i + 1] ?? 0]);
}

/** What modes that are loaded later add to the contract. */
export interface ContractParts {
  /** The surface's points on a uniform parameter grid. */
  mesh?: (rows: number, cols: number) => Float64Array;
  /** Resolves when no mode is being loaded. */
  settled?: () => Promise<void>;
  fit?: ModeContract;
  trace?: ModeContract;
}

/** What a mode that computes in a worker adds. */
export interface ModeContract {
  /** Points of an outcome's stroke or outline at uniform parameters; null while there is none. */
  sample(count: number, contour: number): Float64Array | null;
  result(): object | null;
  lastJobMs(): number;
  /** Resolves when nothing is under way. */
  working(): Promise<void>;
}

export interface ContractOptions {
  readonly parts: ContractParts;
  readonly editor: Editor;
  readonly frame: Frame;
  readonly ready: Promise<void>;
  unmount: ExplineDemo["unmount"];
  /** Checks a state from outside; throws when it is none. */
  readState(value: unknown): Promise<DemoState>;
}

function withResult<T extends object>(document: T, mode: ModeContract | undefined): T {
  const result = mode?.result() ?? null;
  return result === null ? document : { ...document, result };
}

export function createContract({ editor, frame, ready, readState, parts, unmount }: ContractOptions): ExplineDemo {
  const working = async (): Promise<void> => {
    await parts.fit?.working();
    await parts.trace?.working();
  };
  return {
    version: engineVersion,
    ready,
    unmount,
    async idle() {
      await ready;
      // What has come may ask for more.
      while (editor.loading.size > 0) await Promise.allSettled(editor.loading);
      await parts.settled?.();
      await working();
      await frame.idle();
    },
    getState() {
      const { fit, trace, ...state } = structuredClone(editor.getState());
      return { ...state, fit: withResult(fit, parts.fit), trace: withResult(trace, parts.trace) };
    },
    async setState(state) {
      editor.setState(await readState(structuredClone(state)));
      await parts.settled?.();
      await working();
      await frame.idle();
    },
    sample(count, contour = 0) {
      const { curve, mode } = editor.state.value;
      const own = mode === "fit" || mode === "trace" ? parts[mode]?.sample(count, contour) : undefined;
      if (own !== undefined) return pairs(own ?? new Float64Array(0));
      const shape = curve.contours[contour];
      return shape === undefined ? [] : pairs(samplePoints(curve, shape, count));
    },
    subdivision(steps) {
      const { curve } = editor.state.value;
      const shape = curve.contours[0];
      return shape === undefined ? [] : pairs(subdivided(curve, shape, steps));
    },
    mesh(rows = 65, cols = 65) {
      return { positions: Array.from(parts.mesh?.(rows, cols) ?? []), rows, cols };
    },
    toScreen(x, y) {
      const { view, stage } = editor.state.value;
      const at = toScreen(view, stage, { x, y });
      return { x: at.x + stage.left, y: at.y + stage.top };
    },
    toDoc(x, y) {
      const { view, stage } = editor.state.value;
      const { x: px, y: py } = toPage(view, stage, { x: x - stage.left, y: y - stage.top });
      return { x: px, y: py };
    },
    stats() {
      const { bezierError, modelError } = measureCurve(editor.state.value.curve);
      return {
        frameMs: [...frame.times],
        lastJobMs: parts[editor.state.value.mode === "trace" ? "trace" : "fit"]?.lastJobMs() ?? 0,
        wasmBytes: __WASM_BYTES__,
        ...(bezierError === undefined ? {} : { bezierError }),
        ...(modelError === undefined ? {} : { modelError }),
      };
    },
  };
}
