/** What the command line says when it cannot do what was asked: one line, and a status. */

/** The call itself was wrong: status 2. */
export const USAGE = 2;
/** The input was bad: status 1. */
export const INPUT = 1;

/** Ends the program with one line on standard error. */
export class Failure extends Error {
  readonly status: typeof USAGE | typeof INPUT;

  constructor(status: typeof USAGE | typeof INPUT, message: string) {
    super(message);
    this.status = status;
  }
}
