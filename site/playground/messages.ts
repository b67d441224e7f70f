/** What the page, the frame and the worker say to each other. The page checks the form of what it hears. */

/** One thing that is drawn. */
export type Drawn =
  | { readonly kind: "path"; readonly d: string; readonly isWire?: boolean }
  | { readonly kind: "dots"; readonly points: readonly number[]; readonly areKnots?: boolean }
  | { readonly kind: "svg"; readonly text: string };

/** From the page: the code to run, and what runs it. */
export interface Order {
  readonly code: string;
  /** The package as one module. */
  readonly library: string;
  /** The worker's own code. */
  readonly worker: string;
  /** Milliseconds after which it is stopped. */
  readonly limit: number;
}

export type Level = "log" | "warn" | "error";

/** From the worker, through the frame. */
export type Report =
  | { readonly type: "said"; readonly level: Level; readonly text: string }
  | { readonly type: "done"; readonly drawn: readonly Drawn[]; readonly milliseconds: number }
  | { readonly type: "failed"; readonly text: string }
  | { readonly type: "late" };

/** So many lines are shown of what is said, and so many letters of each. */
export const MOST_LINES = 500;
export const LONGEST_LINE = 4000;
