import { createDesk } from "../../worker-desk.ts";
import type { SplineShape } from "../spline-shape.ts";

/** What is measured of a curve as a whole. */
export interface WholeMeasures {
  readonly length: number;
  readonly area: number;
  readonly bytes: number;
}

let waiting: { resolve(measures: WholeMeasures): void; reject(error: Error): void } | null = null;

/** The worker is gone when it has answered: who waits for one number a minute needs none in between. */
const desk = createDesk<SplineShape, WholeMeasures | string>(() => new Worker(new URL("./measure-worker.ts", import.meta.url), { type: "module" }), {
  receive(answer) {
    if (typeof answer === "string") return end((asked) => asked.reject(new Error(answer)));
    end((asked) => asked.resolve(answer));
  },
  died: (_, message) => end((asked) => asked.reject(new Error(message))),
});

function end(settle: (asked: NonNullable<typeof waiting>) => void): void {
  const asked = waiting;
  waiting = null;
  desk.dismiss();
  if (asked !== null) settle(asked);
}

/**
 * Measures a curve where nothing waits for it. What is under way is of a drawing that is no longer there, and is
 * dropped.
 */
export function measureInWorker(shape: SplineShape): Promise<WholeMeasures> {
  desk.dismiss();
  return new Promise((resolve, reject) => {
    waiting = { resolve, reject };
    desk.post(shape);
  });
}
