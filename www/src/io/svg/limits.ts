/** What an SVG file may cost before it is refused. Everything is checked before the browser's parser sees the text. */
export interface SvgLimits {
  readonly maxBytes: number;
  readonly maxNodes: number;
  readonly maxDepth: number;
  readonly maxAttributes: number;
  readonly maxUseExpansion: number;
  readonly maxCommands: number;
}

export const svgLimits: SvgLimits = {
  maxBytes: 5 * 1024 * 1024,
  maxNodes: 100_000,
  maxDepth: 64,
  maxAttributes: 256,
  maxUseExpansion: 100_000,
  maxCommands: 200_000,
};

/** The largest coordinate, and so the largest entry of a transform, that the engine takes. */
export const maxCoordinate = 1e9;

export type SvgErrorCode = "E_PARSE_SVG" | "E_LIMIT" | "E_RANGE";

interface SvgErrorDetail {
  readonly line?: number;
  readonly column?: number;
  readonly reason?: "doctype" | "root" | "markup";
  readonly limit?: keyof SvgLimits;
  readonly max?: number;
  readonly actual?: number;
}

/** Why an SVG document was not read. Its text is made by us alone: never a piece of the file. */
export class SvgFileError extends Error {
  override readonly name = "SvgFileError";
  constructor(
    readonly code: SvgErrorCode,
    message: string,
    readonly detail: SvgErrorDetail = {},
  ) {
    super(`${message} [${code}]`);
  }
}

export function overLimit(limit: keyof SvgLimits, max: number, actual: number): SvgFileError {
  return new SvgFileError("E_LIMIT", `svg: ${limit} is ${max}`, { limit, max, actual });
}

export type SvgWarningCode =
  | "W_CYCLE"
  | "W_BAD_TRANSFORM"
  | "W_BAD_VIEWBOX"
  | "W_BAD_LENGTH"
  | "W_UNIT"
  | "W_ODD_POINTS"
  | "W_STYLE"
  | "W_GRADIENT"
  | "W_DASHES"
  | "W_STYLE_TRANSFORM"
  | "W_TEXT"
  | "W_PICTURE"
  | "W_CLIP"
  | "W_NO_TARGET";

/** Something in the file that was skipped or read leniently; told to the user, never fatal. */
export interface SvgWarning {
  readonly code: SvgWarningCode;
  readonly element: string;
}
