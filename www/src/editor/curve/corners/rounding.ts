import { replaceContour, type Command } from "../../../document/curve/commands.ts";
import { isLine, segmentsAt } from "../../../document/curve/corners/corners.ts";
import { sharpened, type Rearranged } from "../../../document/curve/corners/fillets.ts";
import type { Contour, CurveDocument, PointRef } from "../../../document/document.ts";
import { decimalsIn } from "../../../document/unit.ts";
import { rounded, type Refusal } from "../../../kernel/curve/rounding/rounded.ts";
import { unitOf } from "../../../kernel/unit.ts";
import type { Editor, EditorState } from "../../editor.ts";
import { chosenCorners, radiiOf, remember, type ChosenCorners, type Rounding } from "./chosen.ts";
import { refuse } from "../edits.ts";

/** Corners rounded by arcs of circles, made sharp again, or given another radius. */

const reasons: Readonly<Record<Refusal, string>> = {
  space: "Arcs are trigonometric, and this contour has hyperbolic curves",
  sharp: "The sides of this corner lie on each other, and no circle fits between them",
  room: "No circle fits between the sides of this corner",
};

interface Done {
  readonly index: number;
  readonly contour: Contour;
  readonly points: readonly PointRef[];
  readonly radii: readonly number[];
  readonly refused: readonly Refusal[];
}

/** The contour with corners in place of its chosen arcs, and all chosen corners. */
function sharp(curve: CurveDocument, { contour, sharp: corners, arcs, rounding }: ChosenCorners): Pick<Rounding, "base" | "corners"> {
  if (rounding !== null) return rounding;
  const given = curve.contours[contour];
  if (given === undefined) return { base: { family: "hermite", closed: false, points: [] }, corners: [] };
  if (arcs.size === 0) return { base: given, corners };
  const { contour: base, made, stayed } = sharpened(curve, given, new Set(arcs.keys()));
  const kept = corners.flatMap((index) => stayed.get(index) ?? []);
  return { base, corners: [...kept, ...[...made.values()].map(([index]) => index)] };
}

function withRadius(curve: CurveDocument, chosen: ChosenCorners, radius: number): Done {
  const { base, corners } = sharp(curve, chosen);
  const unchanged: Rearranged = { contour: base, made: new Map(), stayed: new Map(corners.map((index) => [index, index])) };
  const result = radius > 0 ? rounded(curve, base, corners, radius) : { ...unchanged, radii: new Map<number, number>(), refused: new Map<number, Refusal>() };
  const made = corners.map((index) => result.made.get(index) ?? [result.stayed.get(index) ?? 0, result.stayed.get(index) ?? 0] as const);
  const radii = corners.map((index) => result.radii.get(index) ?? 0);
  const { contour } = result;
  if (result.made.size > 0) remember(contour, { base, corners, radii, made });
  const indices = chosen.isWhole ? contour.points.map((_, index) => index) : [...new Set(made.flat())];
  return {
    index: chosen.contour, contour, radii,
    points: indices.map((index) => ({ contour: chosen.contour, index })),
    refused: [...result.refused.values()],
  };
}

function commandOf(done: readonly Done[], radius: number): Command {
  return {
    name: radius > 0 ? "Round corners" : "Sharpen corners",
    apply: (document) => done.reduce((now, { index, contour }) => replaceContour(now, index, contour), document),
    select: { points: done.flatMap(({ points }) => points), handle: null },
  };
}

/** The chosen corners of a state with this radius, as far as there is room; in words, the largest that came of it. */
export function roundingOf(state: EditorState, radius: number): { readonly command: Command; readonly says: string } {
  const done = chosenCorners(state).map((each) => withRadius(state.curve, each, radius));
  return { command: commandOf(done, radius), says: `radius ${printedRadius(Math.max(0, ...done.flatMap(({ radii }) => radii)), unitOf(state.curve))}` };
}

function printedRadius(radius: number, unit: number): string {
  return String(Number(radius.toFixed(decimalsIn(unit, 2))));
}

/** Each is looked for in some milliseconds: more would stop the page. */
const mostBetweenCurves = 500;

function betweenCurves(curve: CurveDocument, chosen: readonly ChosenCorners[]): number {
  return chosen.reduce((sum, { contour, sharp: corners, rounding }) => {
    const [base, list] = rounding === null ? [curve.contours[contour], corners] : [rounding.base, rounding.corners];
    const isBetween = (index: number): boolean => base !== undefined && segmentsAt(base, index).some((segment) => segment !== null && !isLine(base, segment));
    return sum + list.filter(isBetween).length;
  }, 0);
}

const isSame = (a: number, b: number): boolean => Math.abs(a - b) <= 1e-12 * Math.max(a, b);

/**
 * Gives all chosen corners this radius, or the largest that there is room for; 0 makes them sharp. A run of typed steps
 * is one entry of the history.
 */
export function roundCorners(editor: Editor, radius: number, run?: string, chosen = chosenCorners(editor.state.value)): void {
  const { curve } = editor.state.value;
  if (chosen.length === 0) return refuse(editor, "Select a corner: a point where the direction changes.");
  if (!(radius >= 0)) return;
  if (betweenCurves(curve, chosen) > mostBetweenCurves) return refuse(editor, `Select at most ${mostBetweenCurves} corners between curves at once.`);
  const done = chosen.map((each) => withRadius(curve, each, radius));
  const [radii, refused] = [done.flatMap((each) => each.radii), done.flatMap((each) => each.refused)];
  const before = radiiOf(chosen);
  if (radius > 0 && refused.length === radii.length) return refuse(editor, `${reasons[refused[0] ?? "room"]}.`);
  const isNew = radii.length !== before.length || !radii.every((each, i) => isSame(each, before[i] ?? 0));
  if (isNew) {
    const command = commandOf(done, radius);
    editor.dispatch(run === undefined ? command : { ...command, run: `${run} ${done.map(({ index }) => index).join(",")}` });
  }
  const text = radius > 0 ? `${saying(radii.filter((each) => each > 0), radius, unitOf(curve))}${left(refused)}` : `${counted(radii.length)} sharp.`;
  editor.patch({ hint: text });
  editor.notify({ kind: "announce", text });
}

function counted(count: number): string {
  return count === 1 ? "Corner" : `${count} corners`;
}

/** What was done, and where it is less than was asked for. */
function saying(radii: readonly number[], asked: number, unit: number): string {
  const printed = (radius: number): string => printedRadius(radius, unit);
  const [least, most] = [Math.min(...radii), Math.max(...radii)];
  const limited = radii.filter((radius) => radius < asked && !isSame(radius, asked)).length;
  const which = isSame(least, most) ? `radius ${printed(most)}` : `radii from ${printed(least)} to ${printed(most)}`;
  const room = limited === 0 ? "" : limited === radii.length ? "; there is no room for more" : `; ${limited} of them ${limited === 1 ? "has" : "have"} no room for ${printed(asked)}`;
  return `${counted(radii.length)} rounded, ${which}${room}.`;
}

function left(refused: readonly Refusal[]): string {
  const [first] = refused;
  if (first === undefined) return "";
  return ` ${refused.length === 1 ? "1 corner stays" : `${refused.length} corners stay`} sharp: ${reasons[first].replace(/^[A-Z]/u, (letter) => letter.toLowerCase()).replaceAll("this", "its")}.`;
}

/** The largest of 1, 2 and 5 times a power of ten that is no more than half of what there is room for. */
function usualRadius(curve: CurveDocument, chosen: readonly ChosenCorners[]): number {
  const radii = chosen.flatMap((each) => withRadius(curve, each, Infinity).radii).filter((radius) => radius > 0);
  if (radii.length === 0) return 0;
  const most = Math.min(...radii) / 2;
  const ten = 10 ** Math.floor(Math.log10(most));
  return ten * ([5, 2].find((times) => times * ten <= most) ?? 1);
}

/** What the key and the menu do: corners that are sharp get a radius that suits them all; what is round stays. */
export function roundChosen(editor: Editor): void {
  const chosen = chosenCorners(editor.state.value);
  const sharpOnes = chosen.filter(({ sharp: corners }) => corners.length > 0).map((each) => ({ ...each, arcs: new Map<number, number>(), rounding: null }));
  if (chosen.length > 0 && sharpOnes.length === 0) return refuse(editor, "These corners are round. Change their radius under Selected.");
  // Where no circle fits at all, any radius says why.
  roundCorners(editor, usualRadius(editor.state.value.curve, sharpOnes) || 1, undefined, sharpOnes);
}
