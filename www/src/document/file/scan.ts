import { FileError } from "./error.ts";

/**
 * One linear look at the text of a JSON file before it is parsed: how deep it nests (the parser takes a million levels
 * that could never be written again) and whether an object names a key twice (two readers would disagree which counts).
 */
export function checkJson(text: string, maxDepth: number): void {
  const open: (Set<string> | null)[] = [];
  const path: string[] = [];
  for (let i = 0; i < text.length; i += 1) {
    const char = text[i];
    if (char === "{" || char === "[") {
      open.push(char === "{" ? new Set() : null);
      path.push("");
      if (open.length > maxDepth) throw new FileError("E_LIMIT", "$", `nests deeper than ${maxDepth}`, { limit: "maxDepth" });
    } else if (char === "}" || char === "]") {
      open.pop();
      path.pop();
    } else if (char === '"') {
      const end = endOfString(text, i);
      const keys = open.at(-1);
      if (keys instanceof Set && isKey(text, end)) noteKey(text.slice(i, end), keys, path);
      i = end - 1;
    }
  }
}

function endOfString(text: string, start: number): number {
  for (let i = start + 1; i < text.length; i += 1) {
    if (text[i] === "\\") i += 1;
    else if (text[i] === '"') return i + 1;
  }
  return text.length;
}

function isKey(text: string, from: number): boolean {
  let i = from;
  while (i < text.length && " \t\r\n".includes(text[i] ?? "")) i += 1;
  return text[i] === ":";
}

function noteKey(literal: string, keys: Set<string>, path: string[]): void {
  // Escapes spell the same key in other letters; a literal that is no string at all is the parser's to report.
  let key = literal;
  try {
    key = String(JSON.parse(literal));
  } catch {
    return;
  }
  path[path.length - 1] = key;
  if (keys.has(key)) {
    throw new FileError("E_SCHEMA", `$${path.map((step) => (step === "" ? "" : `.${step}`)).join("")}`, "is there twice", { reason: "duplicate-key" });
  }
  keys.add(key);
}
