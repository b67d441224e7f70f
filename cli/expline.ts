#!/usr/bin/env node
/**
 * The command line of the package. Status 0; 1 for bad input, 2 for wrong usage, each with one line on standard error.
 */
import { ExplineError, version } from "expline";

import { Failure, USAGE, statusOf } from "./failure.ts";
import { print } from "./files.ts";
import { fit } from "./fit.ts";
import { trace } from "./trace.ts";

const HELP = `expline ${version}: few curves from noisy points and from pictures

Usage: expline COMMAND [options]

  fit POINTS        the sparsest curve through points in rows of x and y, as SVG
  trace PICTURE...  the outlines of PNG and JPEG pictures, as SVG
  --help            this text; expline COMMAND --help says more
  --version         the version

Status: 0 done, 1 bad input, 2 wrong usage.
`;

const COMMANDS: Readonly<Record<string, (words: readonly string[]) => string>> = { fit, trace };

function run([command, ...words]: readonly string[]): string {
  switch (command) {
    case "help":
      if (words[0] !== undefined) return run([words[0], "--help"]);
      return HELP;
    case "--help":
    case "-h":
      return HELP;
    case "--version":
      return `${version}\n`;
    case undefined:
      throw new Failure(USAGE, "a command is missing; expline --help lists them");
  }
  if (!Object.hasOwn(COMMANDS, command)) {
    throw new Failure(USAGE, `there is no command ${JSON.stringify(command.slice(0, 40))}; expline --help lists them`);
  }
  return COMMANDS[command]?.(words) ?? "";
}

/** Runs and prints; gives back what went wrong. What was done in spite of a failure is printed all the same. */
function failureOf(words: readonly string[]): unknown {
  let failure: unknown;
  let text = "";
  try {
    text = run(words);
  } catch (error) {
    failure = error;
    if (error instanceof Failure) text = error.done;
  }
  try {
    print(text);
  } catch (error) {
    failure ??= error;
  }
  return failure;
}

const failure = failureOf(process.argv.slice(2));
if (failure !== undefined) {
  const known = failure instanceof Failure || failure instanceof ExplineError;
  const line = failure instanceof Error ? failure.message.replace(/\s+/gu, " ") : String(failure);
  process.stderr.write(`expline: ${known ? line : `something went wrong here: ${line}`}\n`);
  process.exitCode = statusOf(failure);
}
