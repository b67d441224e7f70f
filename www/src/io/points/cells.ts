/** The cells of a table's lines. */

/** A line of the table, numbered as people count them. */
export interface Row {
  readonly line: number;
  readonly cells: readonly string[];
  /** Whether a line with nothing in it lies above. */
  readonly begins: boolean;
}

/** Which cells of tables stand for a number that is not there. */
const absent = /^(?:|-+|\.+|nan|n\/?a|#n\/a|null|none|nil|missing)$/iu;

export function isAbsent(cell: string | undefined): boolean {
  return cell === undefined || absent.test(cell);
}

/** NaN for what is no number, which to `Number` nothing at all is not. */
export function numberIn(cell: string | undefined): number {
  return cell === undefined || !/\d/u.test(cell) ? NaN : Number(cell);
}

const opening = /^[|([{\s]*/u;
const closing = /[|)\]};,\s]/u;

/**
 * Without the brackets, bars and blanks around it; a tab among them stays, for it has a cell with nothing in it on its
 * other side.
 */
function withoutEnds(line: string): string {
  const start = opening.exec(line)?.[0].length ?? 0;
  let end = line.length;
  while (end > start && closing.test(line.charAt(end - 1))) end -= 1;
  const tabIn = (ends: string): string => (ends.includes("\t") ? "\t" : "");
  return tabIn(line.slice(0, start)) + line.slice(start, end) + tabIn(line.slice(end));
}

/**
 * Beside a semicolon, a tab or a bar a comma is that of a decimal fraction; so it is where blanks part two such
 * fractions.
 */
export function cellsOf(line: string): string[] {
  const bare = withoutEnds(line).replace(/\u2212/gu, "-");
  const parts = /[;\t|]/u.test(bare) ? bare.replaceAll(",", ".").split(/[;\t|]/u)
    : fractions.test(bare) ? bare.replaceAll(",", ".").split(/\s+/u)
      : bare.split(bare.includes(",") ? "," : /\s+/u);
  return parts.map((part) => part.trim().replace(/^(["'])(.*)\1$/u, "$2").replace(/[\u00A0\u202F]/gu, "").trim());
}

/** `1,5 2,25`, and nothing else that it could be. */
const fractions = /^[-+]?\d+,\d+\s+[-+]?\d+(?:,\d+)?$|^[-+]?\d+\s+[-+]?\d+,\d+$/u;
