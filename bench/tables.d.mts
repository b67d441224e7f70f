/** One row of a run: what was measured, and every contestant's least and median time in nanoseconds. */
export interface Row {
  readonly title: string;
  readonly unit: string;
  readonly results: readonly { readonly name: string; readonly least: number; readonly median: number; readonly note: string }[];
}
/** A run of the bench that was kept. */
export interface Recorded {
  readonly machine: string;
  readonly cores: number;
  readonly node: string;
  readonly rounds: number;
  readonly rows: readonly Row[];
}
/** A text with the tables between its two marks; undefined where there are no marks. */
export function inserted(text: string, recorded: Recorded): string | undefined;
