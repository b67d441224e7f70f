/** What the command line says when it cannot do what was asked: one line, and a status. */
import { ExplineError } from "expline";

/** The call itself was wrong: status 2. */
export const USAGE = 2;
/** The input was bad: status 1. */
export const INPUT = 1;

/** Ends the program with one line on standard error. */
export class Failure extends Error {
  readonly status: typeof USAGE | typeof INPUT;
  /** What was done nevertheless, for standard output. */
  readonly done: string;

  constructor(status: typeof USAGE | typeof INPUT, message: string, done = "") {
    super(message);
    this.status = status;
    this.done = done;
  }
}

/** An option out of range is a matter of the call; whatever is wrong with the points, of the input. */
export function statusOf(error: unknown): number {
  if (error instanceof Failure) return error.status;
  const ofOptions = error instanceof ExplineError && error.arg !== "points" && error.arg !== "image";
  return ofOptions && ["E_TYPE", "E_RANGE", "E_LENGTH", "E_NOT_FINITE"].includes(error.code) ? USAGE : INPUT;
}
