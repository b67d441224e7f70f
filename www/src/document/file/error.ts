export type FileErrorCode = "E_PARSE_JSON" | "E_SCHEMA" | "E_NOT_FINITE" | "E_RANGE" | "E_LIMIT" | "E_UNSUPPORTED";

/** Why a file was not read: the code, and the place in it as in `$.curve.contours[0].points[2].x`. */
export class FileError extends Error {
  override readonly name = "FileError";
  constructor(
    readonly code: FileErrorCode,
    readonly path: string,
    what: string,
    readonly detail: { readonly limit?: string; readonly reason?: string; readonly version?: number } = {},
  ) {
    super(`${path} ${what} [${code}]`);
  }
}
