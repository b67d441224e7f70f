/** Points as tables and programs have them. */
import { beginsAsList, readList } from "./list.ts";
import type { Strokes } from "./stroke.ts";
import { beginsAsTable, readTable } from "./table.ts";

export { mostPoints } from "./stroke.ts";
export { beginsAsList, beginsAsTable };

export function readPoints(text: string): Strokes {
  const bare = text.replace(/^\uFEFF/u, "");
  return beginsAsList(bare.trimStart().slice(0, 2000)) ? readList(bare) : readTable(bare);
}
