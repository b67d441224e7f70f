import { emptyHistory, record, stepBack, stepForward, type History } from "../../document/history.ts";

/**
 * Undo and redo of a mode: one entry per gesture, values and selection together. `Also` is what may change in the same
 * step as the drawing.
 */
export interface Timeline<M, Also = never> {
  /**
   * Applies a change: one entry, joined to the last when both belong to one quick run; part of the gesture if one is
   * open.
   */
  dispatch(name: string, change: (now: M) => M, run?: string): void;
  /** Sets what is there without an entry: nothing that anybody did. */
  settle(moment: M): void;
  /** Opens a gesture: everything until `commit` is one entry. */
  begin(name: string): void;
  /**
   * Applies the change to the state at `begin`, so that a drag is always evaluated from its start; nothing once it was
   * taken back.
   */
  preview(change: (start: M) => M, also?: Also): void;
  commit(): void;
  /**
   * Changes what is there without an entry: a value that follows from others (a slider that shows what a target led
   * to).
   */
  amend(change: (now: M) => M): void;
  /** Back to the state at `begin`; no entry. */
  bail(): void;
  readonly inGesture: boolean;
  /** What was there when the open gesture began. */
  readonly origin: M;
  undo(): void;
  redo(): void;
  /** A new document: nothing before it can be brought back. */
  forget(): void;
  readonly past: string | null;
  readonly future: string | null;
}

export interface TimelineOptions<M, Also = never> {
  read(): M;
  write(moment: M, also?: Also): void;
  /** Whether two moments hold the same drawing, whatever is selected. */
  same(a: M, b: M): boolean;
  /** What can be undone has changed, or a gesture is over that changed nothing. */
  changed(): void;
  /** Milliseconds, for joining runs. */
  now(): number;
}

export function createTimeline<M, Also = never>({ read, write, same, changed, now }: TimelineOptions<M, Also>): Timeline<M, Also> {
  let history: History<M> = emptyHistory();
  let gesture: { readonly name: string; readonly start: M } | null = null;

  function travel(step: typeof stepBack<M>): void {
    // Undo during a drag takes back the drag and nothing else.
    if (gesture !== null) return timeline.bail();
    const taken = step(history);
    if (taken === null) return;
    history = taken.history;
    write(taken.moment);
    changed();
  }

  function put(name: string, before: M, after: M, run: string | undefined): void {
    history = record(history, { name, before, after, run, time: now() });
    changed();
  }

  const timeline: Timeline<M, Also> = {
    get inGesture() {
      return gesture !== null;
    },
    get origin() {
      return gesture?.start ?? read();
    },
    get past() {
      return history.past.at(-1)?.name ?? null;
    },
    get future() {
      return history.future.at(-1)?.name ?? null;
    },
    dispatch(name, change, run) {
      const before = read();
      const after = change(before);
      if (same(before, after)) return;
      write(after);
      if (gesture === null) put(name, before, after, run);
    },
    settle: write,
    begin(name) {
      if (gesture !== null) timeline.commit();
      gesture = { name, start: read() };
    },
    preview(change, also) {
      if (gesture !== null) write(change(gesture.start), also);
    },
    commit() {
      if (gesture === null) return;
      const { name, start } = gesture;
      gesture = null;
      if (same(start, read())) changed();
      else put(name, start, read(), undefined);
    },
    amend(change) {
      write(change(read()));
    },
    bail() {
      if (gesture === null) return;
      const { start } = gesture;
      gesture = null;
      write(start);
    },
    undo() {
      travel(stepBack);
    },
    redo() {
      travel(stepForward);
    },
    forget() {
      gesture = null;
      history = emptyHistory();
      changed();
    },
  };
  return timeline;
}
