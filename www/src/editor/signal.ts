/** A value that tells its listeners when it changes. Sixty lines instead of a framework. */
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
  return {
    get value() {
      return current;
    },
    set(value: T) {
      if (Object.is(value, current)) return;
      const before = current;
      current = value;
      // A copy, so that a listener may subscribe or leave while it is being told.
      for (const listener of [...listeners]) listener(value, before);
    },
    subscribe(listener, options = {}) {
      if (options.until?.aborted === true) return;
      listeners.add(listener);
      options.until?.addEventListener("abort", () => listeners.delete(listener), { once: true });
      if (options.now === true) listener(current, current);
    },
  };
}
