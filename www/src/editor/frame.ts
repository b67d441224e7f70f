/**
 * One frame loop for the page. It runs only when something asked for a frame, and sleeps otherwise: an idle page makes
 * no animation frames at all.
 */

export interface Frame {
  /** Asks for a frame; asking twice before it comes is asking once. */
  request(): void;
  /**
   * Runs in every frame: all that takes in input, then all that paints what came of it. One that throws stops nothing
   * but itself.
   */
  add(phase: "input" | "paint", task: () => void): void;
  /** Resolves when no frame is wanted. */
  idle(): Promise<void>;
  /** Script and drawing time of the latest frames, milliseconds, oldest first. */
  readonly times: readonly number[];
}

const keptTimes = 240;

/** Says that a task failed as a page says it of a listener: the others are called all the same. */
const reported = (error: unknown): void => queueMicrotask(() => {
  throw error;
});

export function createFrame(schedule: (callback: () => void) => void, now: () => number, failed: (error: unknown) => void = reported): Frame {
  const tasks: Record<"input" | "paint", (() => void)[]> = { input: [], paint: [] };
  const times: number[] = [];
  let waiting: (() => void)[] = [];
  let wanted = false;

  function runAll(phase: "input" | "paint"): void {
    for (const task of tasks[phase]) {
      try {
        task();
      } catch (error) {
        failed(error);
      }
    }
  }

  function run(): void {
    const start = now();
    // What input changes is painted in this very frame, so requests made until here are met.
    runAll("input");
    wanted = false;
    runAll("paint");
    times.push(now() - start);
    if (times.length > keptTimes) times.shift();
    if (wanted) return;
    const settled = waiting;
    waiting = [];
    for (const resolve of settled) resolve();
  }

  return {
    times,
    request() {
      if (wanted) return;
      wanted = true;
      schedule(run);
    },
    add(phase, task) {
      tasks[phase].push(task);
    },
    idle() {
      return wanted ? new Promise((resolve) => waiting.push(resolve)) : Promise.resolve();
    },
  };
}
