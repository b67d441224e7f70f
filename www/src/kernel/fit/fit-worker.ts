/**
 * The worker that fits: one subject at a time, the newest request first, and the chart while there is nothing else to
 * do.
 */
import init, { ExplineError, fitSparseAsync, initFit, SparseFitter, type HermiteCurve, type SparseFit, type SparseFitOptions } from "expline/slim";
import wasmUrl from "expline/expline_bg.wasm?url";
import fitUrl from "expline/expline_fit_bg.wasm?url";
import type { FitAnswer, FitRequest, FitStrength, FitSubject, PlainFit } from "./job.ts";

/** Certified within a drag; what stays on the stage is certified to the library's own default. */
const liveGap = 1e-3;
/** Halvings of the smoothing when a number of knots is asked for: less than half a step of the slider. */
const halvings = 9;

const ready = Promise.all([init({ wasmUrl }), initFit({ wasmUrl: fitUrl })]);

let subject = 0;
let what: FitSubject = { strokes: [], degree: 3, mix: 0.5, corners: true };
let fitters: SparseFitter[] = [];
/** Ends whatever is under way. */
let under = new AbortController();
/** Requests are worked off one after the other; a new one ends the one before. */
let last: Promise<void> = Promise.resolve();

const answer = (message: FitAnswer): void => postMessage(message);

function optionsOf({ degree, mix, corners }: FitSubject, closed: boolean): SparseFitOptions {
  return { degree, corners, closed, ...(typeof degree === "number" ? {} : { mix }) };
}

function open(id: number, next: FitSubject): void {
  for (const fitter of fitters) fitter.dispose();
  fitters = [];
  subject = id;
  what = next;
}

/** Kept for the next step of the slider: a solve begins where the last one ended. */
function liveFitters(): readonly SparseFitter[] {
  if (fitters.length === 0) fitters = what.strokes.map(({ points, closed }) => new SparseFitter(points, { ...optionsOf(what, closed), gap: liveGap }));
  return fitters;
}

/** Is told how much of a piece of work is done, from 0 to 1. */
type Report = (share: number) => void;

const nobody: Report = () => undefined;

/** Digits that a solver gains until it is done; what is done to the knots afterwards has no measure. */
const digits = 8;

async function solve(strength: FitStrength, live: boolean, signal: AbortSignal, report: Report): Promise<SparseFit[]> {
  if (strength.by === "knots") return fewest(strength.knots, signal, report);
  const asked = strength.by === "smoothing" ? { smoothing: strength.smoothing } : { tolerance: strength.tolerance };
  const fits: SparseFit[] = [];
  const warm = live ? liveFitters() : [];
  for (const [i, { points, closed }] of what.strokes.entries()) {
    const onProgress = ({ gap }: { gap: number }): void => report((i + Math.min(1, Math.max(0, -Math.log10(gap) / digits))) / what.strokes.length);
    // From nothing, what stays depends on the values alone and not on the way to them.
    const cold = (): Promise<SparseFit> => fitSparseAsync(points, { ...optionsOf(what, closed), ...asked, signal, onProgress });
    fits.push(await (warm[i]?.solveAsync({ ...asked, signal, onProgress }) ?? cold()));
  }
  return fits;
}

/**
 * The straight and the smooth part of each stroke, before knots are joined to one curve; none where no smoothing was
 * asked for.
 */
async function partsOf(fits: readonly SparseFit[], signal: AbortSignal): Promise<readonly HermiteCurve[][]> {
  const all: HermiteCurve[][] = [];
  for (const [i, { points, closed }] of what.strokes.entries()) {
    const smoothing = what.parts === true ? fits[i]?.smoothing : undefined;
    const { parts } = smoothing === undefined ? { parts: [] } : await fitSparseAsync(points, { ...optionsOf(what, closed), smoothing, finish: "none", signal });
    all.push(parts);
  }
  return all;
}

const knotsOf = (fits: readonly SparseFit[]): number => fits.reduce((sum, { knots }) => sum + new Set(knots.map(({ t }) => t)).size, 0);

/** The least smoothing whose fit has at most so many knots; the strongest there is if none has. */
async function fewest(most: number, signal: AbortSignal, report: Report): Promise<SparseFit[]> {
  let [low, high] = [0, 1];
  let best: SparseFit[] | undefined;
  for (let i = 0; i < halvings; i += 1) {
    const middle = (low + high) / 2;
    const fits = await solve({ by: "smoothing", smoothing: middle }, false, signal, (share) => report((i + share) / halvings));
    if (knotsOf(fits) <= most) [high, best] = [middle, fits];
    else low = middle;
  }
  return best ?? solve({ by: "smoothing", smoothing: 1 }, false, signal, nobody);
}

function plain({ curve, knots, parameters, rms, maxError, lambda, smoothing, gap, status }: SparseFit, parts: readonly HermiteCurve[]): PlainFit {
  const shown = { curve: curve.toJSON(), parts: parts.map((part) => part.toJSON()), knots, parameters, rms, maxError, lambda, gap, status };
  return smoothing === undefined ? shown : { ...shown, smoothing };
}

/** Says how far a fit has come, in whole percents that never go back. */
function progressOf(id: number): Report {
  let most = 0;
  return (share) => {
    const value = Math.floor(100 * share) / 100;
    if (value <= most) return;
    most = value;
    answer({ kind: "progress", subject, id, value });
  };
}

async function fit(request: Extract<FitRequest, { kind: "fit" }>, signal: AbortSignal): Promise<void> {
  const start = performance.now();
  const fits = await solve(request.strength, request.live, signal, progressOf(request.id));
  const parts = await partsOf(fits, signal);
  answer({ kind: "fitted", subject, id: request.id, fits: fits.map((each, i) => plain(each, parts[i] ?? [])), ms: performance.now() - start });
}

async function chart(at: readonly number[], signal: AbortSignal): Promise<void> {
  // From strong to weak, as those are the quickest; each is what the slider gives there, which fits within a drag only
  // come near.
  for (const smoothing of [...at].sort((a, b) => b - a)) {
    const fits = await solve({ by: "smoothing", smoothing: smoothing / 100 }, false, signal, nobody);
    const sizes = what.strokes.map(({ points }) => points.length / 2);
    const squares = fits.reduce((sum, { rms }, i) => sum + rms ** 2 * (sizes[i] ?? 0), 0);
    answer({ kind: "chart", subject, smoothing, knots: knotsOf(fits), rms: Math.sqrt(squares / Math.max(1, sizes.reduce((sum, size) => sum + size, 0))) });
  }
}

function work(request: FitRequest, signal: AbortSignal): void | Promise<void> {
  switch (request.kind) {
    case "subject":
      return open(request.subject, request.what);
    case "fit":
      return fit(request, signal);
    case "chart":
      return signal.aborted || request.subject !== subject ? undefined : chart(request.at, signal);
    case "stop":
      return undefined;
  }
}

/**
 * What failed is said of a fit. A chart that was interrupted is asked for again; whatever else goes wrong, the next fit
 * will say.
 */
function refuse(request: FitRequest, error: unknown): void {
  if (request.kind !== "fit") return;
  const { id } = request;
  const code = error instanceof ExplineError ? error.code : "";
  answer(code === "E_CANCELLED" ? { kind: "stopped", subject, id } : { kind: "failed", subject, id, code, message: String(error) });
}

async function answered(request: FitRequest, signal: AbortSignal): Promise<void> {
  try {
    await ready;
    await work(request, signal);
  } catch (error) {
    refuse(request, error);
  }
}

onmessage = (event: MessageEvent<FitRequest>) => {
  under.abort();
  under = new AbortController();
  const { signal } = under;
  last = last.then(() => answered(event.data, signal));
};
