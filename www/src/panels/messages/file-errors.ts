import { stateVersion } from "../../document/document.ts";
import type { ProblemDetails, ProblemId } from "../../document/problem.ts";
import { nearMessages, type FarProblem } from "./errors.ts";

/** Of a file without paths, what outlines could be made of. */
const insteadOfPaths: Readonly<Record<string, string>> = {
  text: " Convert its text to outlines first.",
  picture: " Its picture can be traced: drop it here as a PNG or JPEG.",
};

/** What can be wrong with something that was brought in, in words. */
const farMessages: Readonly<Record<FarProblem, (d: ProblemDetails) => string>> = {
  "image-type": (d) => `That file is not a picture this browser can read (${d.name ?? "no name"}). Try PNG, JPEG, WebP or SVG.`,
  "image-broken": (d) => `${d.name ?? "The picture"} could not be decoded. It may be incomplete.${d.kept === undefined ? "" : " The previous picture is kept."}`,
  "image-big": (d) => (d.width === undefined
    ? `${d.name ?? "The picture"} is ${((d.kilobytes ?? 0) / 1000).toFixed(1)} MB; the limit is 25 MB. Scale it down and try again.`
    : `${d.name ?? "The picture"} is ${d.width} × ${d.height ?? 0}; the limit is 40 MP. Scale it down and try again.`),
  "image-blank": (d) => `This browser returned no pixels for ${d.name ?? "the picture"}. Choose a smaller work size and try again.`,
  "file-type": (d) => `${d.name ?? "That file"} is not a file this page can read. Try a picture, SVG, a path, an expline JSON file, or points as x,y rows.`,
  "files-left": (d) => `${d.count === 1 ? "1 file was" : `${d.count ?? 0} files were`} not opened: one picture at a time, and at most ${d.most ?? 0} files.`,
  "svg-broken": (d) => (d.line === undefined
    ? "The SVG could not be read: this is not an SVG document."
    : `The SVG could not be read: line ${d.line}, column ${d.column ?? 1}.`),
  "svg-entities": () => "The SVG could not be read: it declares entities other than plain text. Save it as plain SVG and try again.",
  "svg-big": (d) => `The SVG is too large to read here (${d.field ?? "size"}: the limit is ${d.most ?? 0}). Simplify it and try again.`,
  "svg-range": () => "The SVG has coordinates beyond 1 000 000 000. Scale it down and try again.",
  "svg-nopath": (d) => `This SVG has no path, circle, ellipse, line or polygon.${insteadOfPaths[d.field ?? ""] ?? ""}`,
  "d-broken": (d) =>
    `The path stops making sense at character ${d.at ?? 0}${d.excerpt === "" ? ", where it ends" : `: “${d.excerpt ?? ""}”`}. Everything before it was read.`,
  "d-range": () => "The path has coordinates beyond 1 000 000 000. Scale it down and try again.",
  "d-big": () => "The path is too large to read here. Simplify it and try again.",
  "points-rows": (d) => `Line ${d.line ?? 1} is not two numbers. Write one point per line, such as 120,80.`,
  "points-list": () => "This list of points, or JSON, breaks off: a bracket, a comma or a quotation mark is missing or too many.",
  "points-few": (d) => `A curve needs at least 2 different points; there are ${d.count ?? 0}.`,
  "points-big": (d) => `The file has more than ${d.most ?? 0} points. Remove some and try again.`,
  "json-version": (d) => `This file was made by a newer version (${d.version ?? "?"}). This page reads up to ${stateVersion}.`,
  "json-broken": (d) => `Not an expline file: ${d.field ?? "it is not JSON"}.`,
  "json-big": (d) => `The file is too large to open: ${d.field ?? "it"}.`,
  "paste-unknown": () => "There is nothing here to draw. Paste an SVG (in drawing programs: Copy as SVG), a path, points as x,y rows, or an expline file.",
  "share-long": (d) => `The drawing is too large for a link (${d.kilobytes ?? 0} KB). Download the JSON instead.`,
  "part-missing": () => "The part of the page that does this could not be loaded. Check the connection, then try again.",
};

/** The message for any problem. */
export function problemText(id: ProblemId, details: ProblemDetails = {}): string {
  return { ...nearMessages, ...farMessages }[id](details);
}
