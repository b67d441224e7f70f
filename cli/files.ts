/** Where input comes from and output goes. */
import { writeFileSync } from "node:fs";

import { Failure, INPUT } from "./failure.ts";

/** What a file is called in messages. */
export const sourceName = (file: string): string => (file === "-" ? "standard input" : file);

/** Why a file could not be read. */
export function unreadable(file: string, error: unknown): Failure {
  const code = (error as { code?: string }).code;
  const why = code === "ENOENT" ? "there is no such file" : code === "EISDIR" ? "it is a folder" : `it cannot be read (${code ?? "unknown"})`;
  return new Failure(INPUT, `${sourceName(file)}: ${why}`);
}

/** Writes a text to a file. */
export function writeText(file: string, text: string): void {
  try {
    writeFileSync(file, text);
  } catch (error) {
    throw new Failure(INPUT, `${file}: it cannot be written (${(error as { code?: string }).code ?? "unknown"})`);
  }
}
