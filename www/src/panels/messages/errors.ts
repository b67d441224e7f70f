import { Problem, type ProblemDetails, type ProblemId } from "../../document/problem.ts";

type Say = (d: ProblemDetails) => string;

/** Messages that the page may need at any moment; those of files come with the file (`file-errors.ts`). */
export type NearProblem = "number" | "share-bad" | "storage" | "engine";
export type FarProblem = Exclude<ProblemId, NearProblem>;

/** The catalogue of messages: what happened, why, what to do. The id stands in `data-error`. */
export const nearMessages: Readonly<Record<NearProblem, Say>> = {
  number: (d) => `Enter a number from ${d.least ?? 0} to ${d.most ?? 0}.${d.kept === undefined || d.kept === "" ? "" : ` Kept: ${d.kept}.`}`,
  "share-bad": () => "The link could not be read. The default sample is shown.",
  storage: () => "This browser cannot save your drawing. Download the JSON to keep it.",
  engine: (d) => `The engine stopped (${d.code ?? "unknown"}). Your drawing is safe; the engine was restarted.`,
};

export function errorText(id: NearProblem, details: ProblemDetails = {}): string {
  return nearMessages[id](details);
}

/**
 * Anything that was thrown, as a problem that can be shown; a library error that no catalogue entry fits is the
 * engine's.
 */
export function asProblem(error: unknown): Problem {
  if (error instanceof Problem) return error;
  const code = error instanceof Error && "code" in error ? String(error.code) : "unknown";
  // All browsers speak of a module when one that is imported does not come; an engine that does not come has a code.
  const isMissing = code === "E_INIT" || (error instanceof TypeError && error.message.includes("module"));
  return isMissing ? new Problem("part-missing") : new Problem("engine", { code });
}
