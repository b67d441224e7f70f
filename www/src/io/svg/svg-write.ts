import type { PaintedPath } from "../../document/paint-layers.ts";
import type { Filling, Line } from "../../document/document.ts";
import type { Artboard, Box } from "../../document/artboard.ts";
import { decimalsIn, unitIn } from "../../document/unit.ts";
import { enlargement, lineWidth, roomFor, sheetIn, type Subject } from "../picture/png-size.ts";

/** Text that may stand in XML: markup escaped, and characters that XML has no place for replaced. */
export function escapeXml(text: string): string {
  return text
    // Lone surrogates are outside the ranges too, since the pattern reads whole code points.
    .replace(/[^\t\n\r\u0020-\uD7FF\uE000-\uFFFD\u{10000}-\u{10FFFF}]/gu, "\uFFFD")
    .replace(/[&<>"']/gu, (char) => `&#${char.charCodeAt(0)};`);
}

/** A number with so many decimals at most, never in exponent form. */
function plain(value: number, decimals = 3): string {
  const fixed = value.toFixed(decimals).replace(/\.?0+$/u, "");
  return fixed === "-0" ? "0" : fixed;
}

/** A file is read where the page's colours are not known: dark ink for light paper. */
export const inkOfFiles = "#1b1f24";

/** What a viewBox is rounded to: whole units, but for drawings of few. */
function roundingFor(box: Box): number {
  const size = Math.max(box.maxX - box.minX, box.maxY - box.minY);
  return 10 ** Math.max(-12, Math.min(0, Math.floor(Math.log10(size)) - 1));
}

export interface SvgOptions extends Subject {
  readonly title: string;
  readonly d: string;
  readonly filling?: Filling;
}

/**
 * The artboard; what reaches out of it, and what has none, is rounded outwards: an artboard moves as little as can be.
 */
function viewBoxOf({ minX, minY, maxX, maxY }: Box, board: Artboard | undefined, margin: number, decimals: number): [number, number, number, number] {
  const step = Math.max(10 ** -decimals, roundingFor({ minX, minY, maxX, maxY }) / (board === undefined ? 1 : 10));
  const side = (value: number, ofBoard: number | undefined, way: "floor" | "ceil"): number =>
    value === ofBoard ? value : step * Math[way]((value + (way === "ceil" ? margin : -margin)) / step);
  const [x, y] = [side(minX, board?.x, "floor"), side(minY, board?.y, "floor")];
  const right = side(maxX, board && board.x + board.width, "ceil");
  const bottom = side(maxY, board && board.y + board.height, "ceil");
  return [x, y, right - x, bottom - y];
}

/** The attributes of what an area is filled with, or a line is drawn with. */
function paintedWith(part: "fill" | "stroke", color: string): string {
  const solid = escapeXml(color.slice(0, 7));
  return color.length === 9 ? `${part}="${solid}" ${part}-opacity="${plain(Number.parseInt(color.slice(7), 16) / 255)}"` : `${part}="${solid}"`;
}

function lineOf({ width, color = inkOfFiles, cap, join, dashes, dashOffset }: Line): string {
  const short = (value: number): number => Number(value.toPrecision(6));
  const looks = { linecap: cap, linejoin: join, dasharray: dashes?.map(short).join(" "), dashoffset: dashOffset && short(dashOffset) };
  const written = Object.entries(looks).map(([name, value]) => (value === undefined ? "" : ` stroke-${name}="${value}"`));
  return `${paintedWith("stroke", color)} stroke-width="${short(width)}"${written.join("")}`;
}

/** A document with one path, or one for each colour, and a viewBox around it with room for its line. */
export function writeSvg(options: SvgOptions): string {
  const { title, d, artboard, filling, filled = false, layers = [] } = options;
  const around = options.box ?? { minX: 0, minY: 0, maxX: 1, maxY: 1 };
  const sheet = sheetIn(options);
  const decimals = decimalsIn(unitIn(sheet?.frame ?? around), 3);
  const thin = Number(plain(Math.max(10 ** -decimals, lineWidth / (sheet?.enlarged ?? enlargement(around))), decimals));
  const viewBox = viewBoxOf(sheet?.frame ?? around, artboard, sheet !== null ? 0 : roomFor(options, thin), decimals).map((each) => plain(each, decimals));
  const area = (color = inkOfFiles): string => `${paintedWith("fill", color)}${filling === "nonzero" ? "" : ' fill-rule="evenodd"'}`;
  const path = ({ d: text, isLine, color, line }: PaintedPath): string => {
    const stroke = line ?? (isLine === true ? { width: thin, join: "round" as const } : undefined);
    const how = [isLine === true ? 'fill="none"' : area(color), ...(stroke === undefined ? [] : [lineOf(stroke)])];
    return text === "" ? "" : `  <path d="${escapeXml(text)}" ${how.join(" ")}/>\n`;
  };
  const paths = (layers.length > 0 ? layers : [{ d, isLine: !filled }]).map(path);
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${viewBox.join(" ")}" width="${viewBox[2]}" height="${viewBox[3]}">\n`,
    `  <title>${escapeXml(title)}</title>\n`,
    ...paths,
    "</svg>\n",
  ].join("");
}
