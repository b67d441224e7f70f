/** Where input comes from and output goes. */
import { mkdirSync, statSync, writeFileSync } from "node:fs";

import { Failure, INPUT } from "./failure.ts";

/** What a file is called in messages. */
export const sourceName = (file: string): string => (file === "-" ? "standard input" : file);

/** Why a file could not be read. */
export function unreadable(file: string, error: unknown): Failure {
  const code = (error as { code?: string }).code;
  const why = code === "ENOENT" ? "there is no such file" : code === "EISDIR" ? "it is a folder" : `it cannot be read (${code ?? "unknown"})`;
  return new Failure(INPUT, `${sourceName(file)}: ${why}`);
}

function unwritable(file: string, error: unknown): Failure {
  return new Failure(INPUT, `${file}: it cannot be written (${(error as { code?: string }).code ?? "unknown"})`);
}

/** Writes a text to a file. */
export function writeText(file: string, text: string): void {
  try {
    writeFileSync(file, text);
  } catch (error) {
    throw unwritable(file, error);
  }
}

export function isFolder(path: string): boolean {
  return statSync(path, { throwIfNoEntry: false })?.isDirectory() === true;
}

/** Makes a folder where there is none. */
export function makeFolder(path: string): void {
  try {
    mkdirSync(path, { recursive: true });
  } catch (error) {
    throw unwritable(path, error);
  }
}
