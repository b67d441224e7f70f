/** Where input comes from and output goes. */
import { closeSync, mkdirSync, openSync, readSync, statSync, writeFileSync, writeSync } from "node:fs";

import { Failure, INPUT, USAGE } from "./failure.ts";

/** What a file is called in messages. */
export const sourceName = (file: string): string => (file === "-" ? "standard input" : file || '""');

const codeOf = (error: unknown): string => (error as { code?: string }).code ?? "unknown";

/** Why a file could not be read. */
function unreadable(file: string, error: unknown): Failure {
  const code = codeOf(error);
  const why = code === "ENOENT" ? "there is no such file" : code === "EISDIR" ? "it is a folder" : `it cannot be read (${code})`;
  return new Failure(INPUT, `${sourceName(file)}: ${why}`);
}

const OBSTACLES: Readonly<Record<string, string>> = {
  EACCES: "that is not allowed",
  EEXIST: "a file has that name",
  EISDIR: "it is a folder",
  ENOENT: "there is no such folder",
  ENOSPC: "no space is left",
  ENOTDIR: "what should be a folder is a file",
  EROFS: "that is not allowed",
};

function unwritable(file: string, error: unknown): Failure {
  const code = codeOf(error);
  return new Failure(INPUT, `${file || '""'}: it cannot be written (${OBSTACLES[code] ?? code})`);
}

/** Asks again for as long as the other end of a pipe is not ready, and lets it have the processor meanwhile. */
function patiently(call: () => number): number {
  for (;;) {
    try {
      return call();
    } catch (error) {
      // How Windows says that a pipe has been closed.
      if (codeOf(error) === "EOF") return 0;
      if (codeOf(error) !== "EAGAIN") throw error;
      Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 5);
    }
  }
}

/** All that there is to read, however slowly the other end writes. Some files never end. */
function readAll(from: number, file: string, megabytes: number): Uint8Array {
  const parts: Uint8Array[] = [];
  for (let size = 0; ; ) {
    const part = new Uint8Array(1 << 18);
    const length = patiently(() => readSync(from, part));
    if (length === 0) return Buffer.concat(parts);
    parts.push(part.slice(0, length));
    size += length;
    if (size > megabytes * 1e6) throw new Failure(INPUT, `${sourceName(file)}: it is larger than ${megabytes} MB`);
  }
}

/** The bytes of a file, or of standard input for `-`; more than so many megabytes could not be worked on. */
export function readBytes(file: string, megabytes: number): Uint8Array {
  try {
    if (file === "-") return readAll(0, file, megabytes);
    const from = openSync(file, "r");
    try {
      return readAll(from, file, megabytes);
    } finally {
      closeSync(from);
    }
  } catch (error) {
    throw error instanceof Failure ? error : unreadable(file, error);
  }
}

/** All of a text to standard output, however slowly the other end reads; a reader that has gone away is no failure. */
export function print(text: string): void {
  const bytes = new TextEncoder().encode(text);
  try {
    for (let at = 0; at < bytes.length; ) at += patiently(() => writeSync(1, bytes, at));
  } catch (error) {
    if (codeOf(error) !== "EPIPE") throw unwritable("standard output", error);
  }
}

/** Writes a text to a file. */
export function writeText(file: string, text: string): void {
  try {
    writeFileSync(file, text);
  } catch (error) {
    throw unwritable(file, error);
  }
}

/** What lies at a path; undefined where nothing does, or nothing that can be looked at. */
function found(path: string): { readonly folder: boolean; readonly identity: string | undefined } | undefined {
  try {
    const state = statSync(path, { bigint: true });
    return { folder: state.isDirectory(), identity: state.isFile() ? `${state.dev}:${state.ino}` : undefined };
  } catch {
    return undefined;
  }
}

export const isFolder = (path: string): boolean => found(path)?.folder === true;

/** Whether something other than a folder lies there. */
export const isFile = (path: string): boolean => found(path)?.folder === false;

/** Refuses, before anything is done, to write over a file that is read, whatever it is called there. */
export function keepInputs(inputs: readonly string[], outputs: readonly (string | undefined)[]): void {
  const kept = new Set(inputs.flatMap((file) => (file === "-" ? [] : (found(file)?.identity ?? []))));
  for (const path of outputs) {
    const identity = path === undefined ? undefined : found(path)?.identity;
    if (identity !== undefined && kept.has(identity)) throw new Failure(USAGE, `${path}: it is read, and would be written over; name another file for the result`);
  }
}

/** Makes a folder where there is none. */
export function makeFolder(path: string): void {
  try {
    mkdirSync(path, { recursive: true });
  } catch (error) {
    throw unwritable(path, error);
  }
}
