import type { CurveDocument, Selection } from "./document.ts";

/** A change of the curve document: its name for the history, and a pure function. */
export interface Command {
  /** Said in Undo's tooltip: "Move point", "Frequency". */
  readonly name: string;
  apply(curve: CurveDocument): CurveDocument;
  /** The selection after the change; absent: as it was, less what is gone. */
  readonly select?: Selection | ((after: CurveDocument) => Selection);
  /** Commands of the same run less than 600 ms apart become one entry (a run of nudges, of typed digits). */
  readonly run?: string;
}
