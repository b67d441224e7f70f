#!/usr/bin/env node
/** The command line of the package. Status 0; 1 for bad input, 2 for wrong usage, each with one line on standard error. */
import { writeSync } from "node:fs";

import { ExplineError, version } from "expline";

import { Failure, USAGE, statusOf } from "./failure.ts";
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
    case "--help":
    case "-h":
    case "help":
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

/** All of a text, however slowly the other end of a pipe reads; a reader that has gone away is no failure. */
function print(text: string): void {
  const bytes = new TextEncoder().encode(text);
  for (let at = 0; at < bytes.length; ) {
    try {
      at += writeSync(1, bytes, at);
    } catch (error) {
      const { code } = error as { code?: string };
      if (code === "EPIPE") return;
      if (code !== "EAGAIN") throw error;
    }
  }
}

try {
  print(run(process.argv.slice(2)));
} catch (error) {
  if (error instanceof Failure) print(error.done);
  const known = error instanceof Failure || error instanceof ExplineError;
  const line = error instanceof Error ? error.message.replace(/\s+/gu, " ") : String(error);
  process.stderr.write(`expline: ${known ? line : `something went wrong here: ${line}`}\n`);
  process.exitCode = statusOf(error);
}
