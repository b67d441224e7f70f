/**
 * A value that tells its listeners when it changes. Sixty lines instead of a framework.
 *
 * A listener may set it, too: everybody hears of one value after the other, in the order in which they were set.
 */
export interface Readable<T> {
  readonly value: T;
  /** Calls `listener` on every change until `until` aborts; with `now`, also at once. */
  subscribe(listener: (value: T, before: T) => void, options?: { until?: AbortSignal; now?: boolean }): void;
}

export interface Signal<T> extends Readable<T> {
  set(value: T): void;
}

export function createSignal<T>(initial: T): Signal<T> {
  let current = initial;
  const listeners = new Set<(value: T, before: T) => void>();
  const untold: (readonly [value: T, before: T])[] = [];
  let telling = false;

  function tellAll(): void {
    telling = true;
    try {
      for (let next = untold.shift(); next !== undefined; next = untold.shift()) {
        // A copy, so that a listener may subscribe or leave while it is being told.
        for (const listener of [...listeners]) listener(...next);
      }
    } finally {
      telling = false;
      untold.length = 0;
    }
  }

  return {
    get value() {
      return current;
    },
    set(value: T) {
      if (Object.is(value, current)) return;
      untold.push([value, current]);
      current = value;
      if (!telling) tellAll();
    },
    subscribe(listener, options = {}) {
      if (options.until?.aborted === true) return;
      listeners.add(listener);
      options.until?.addEventListener("abort", () => listeners.delete(listener), { once: true });
      if (options.now === true) listener(current, current);
    },
  };
}
