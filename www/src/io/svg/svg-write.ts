import type { DemoState, Filling } from "../../document/document.ts";
import type { Box } from "../../document/imported.ts";
import { enlargement } from "../picture/png-size.ts";

/** Text that may stand in XML: markup escaped, and characters that XML has no place for replaced. */
export function escapeXml(text: string): string {
  return text
    // Lone surrogates are outside the ranges too, since the pattern reads whole code points.
    .replace(/[^\t\n\r\u0020-\uD7FF\uE000-\uFFFD\u{10000}-\u{10FFFF}]/gu, "\uFFFD")
    .replace(/[&<>"']/gu, (char) => `&#${char.charCodeAt(0)};`);
}

/** A number with three decimals at most, never in exponent form. */
function plain(value: number): string {
  const fixed = value.toFixed(3).replace(/\.?0+$/u, "");
  return fixed === "-0" ? "0" : fixed;
}

/** A file is read where the page's colours are not known: dark ink for light paper. */
export const inkOfFiles = "#1b1f24";

/** Of a drawing that is not small. */
export const lineWidth = 2;

/** What a viewBox is rounded to: whole units, but for drawings of few. */
function roundingFor(box: Box): number {
  const size = Math.max(box.maxX - box.minX, box.maxY - box.minY);
  return 10 ** Math.max(-3, Math.min(0, Math.floor(Math.log10(size)) - 1));
}

export interface SvgOptions {
  readonly title: string;
  readonly d: string;
  readonly box: Box | null;
  /** Areas of ink, holes left out, in place of lines. */
  readonly filled?: boolean;
  readonly filling?: Filling;
  /** Areas in colours in place of the one path, the lowest first. */
  readonly layers?: readonly { readonly color: string; readonly d: string }[];
}

/** A document with one path, or one for each colour, and a viewBox around it with room for its line. */
export function writeSvg({ title, d, box, filled, filling, layers = [] }: SvgOptions): string {
  const around = box ?? { minX: 0, minY: 0, maxX: 1, maxY: 1 };
  const width = Math.max(0.001, lineWidth / enlargement(around));
  const margin = filled === true || layers.length > 0 ? 0 : width;
  const step = roundingFor(around);
  const [x, y] = [step * Math.floor((around.minX - margin) / step), step * Math.floor((around.minY - margin) / step)];
  const size = [step * Math.ceil((around.maxX + margin) / step) - x, step * Math.ceil((around.maxY + margin) / step) - y].map(plain);
  const lines = `fill="none" stroke="${inkOfFiles}" stroke-width="${plain(width)}" stroke-linejoin="round"`;
  const look = filled === true ? `fill="${inkOfFiles}"${filling === "nonzero" ? "" : ' fill-rule="evenodd"'}` : lines;
  const path = (text: string, how: string): string => (text === "" ? "" : `  <path d="${escapeXml(text)}" ${how}/>\n`);
  const paths = layers.length === 0 ? [path(d, look)] : layers.map((layer) => path(layer.d, `fill="${escapeXml(layer.color)}"`));
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${plain(x)} ${plain(y)} ${size[0]} ${size[1]}" width="${size[0]}" height="${size[1]}">\n`,
    `  <title>${escapeXml(title)}</title>\n`,
    ...paths,
    "</svg>\n",
  ].join("");
}

/** A name for a file of this drawing: the sample it came from, or what it is. */
export function fileStem(state: DemoState): string {
  return state.curve.sample ?? "expline";
}
