import type { PaintedPath } from "../../document/paint-layers.ts";
import { lineStyle, setDashes } from "../../document/painted.ts";
import type { Filling, Line } from "../../document/document.ts";
import { inkOfFiles } from "../svg/svg-write.ts";
import { lineWidth, pictureOf, pngSize, type Subject } from "./png-size.ts";

export interface PngOptions extends Subject {
  readonly d: string;
  readonly scale: number;
  /** Colour under the drawing; null leaves it transparent. */
  readonly paper: string | null;
  /**
   * A drawing as the stage shows it, in ink for any paper where it is on none. Without, it looks as its SVG does: ink
   * or lines, or `layers`.
   */
  readonly stage?: { readonly ink?: string; readonly fill: string };
  readonly filling?: Filling;
}

/** One path, and how it is drawn. */
export interface PngPath {
  readonly d: string;
  readonly fill?: { readonly color: string; readonly alpha: number; readonly rule: CanvasFillRule };
  readonly stroke?: string;
  /** How it is stroked; absent: with a thin line. */
  readonly line?: Line;
}

/** What is drawn, from the lowest up. */
export function pngPaths({ d, stage, filled, filling, layers = [] }: PngOptions): PngPath[] {
  const rule = filling === "nonzero" ? filling : "evenodd";
  if (stage !== undefined) return [{ d, ...(filling === "none" ? {} : { fill: { color: stage.fill, alpha: 0.08, rule } }), stroke: stage.ink ?? inkOfFiles }];
  const area = (of: string, color = inkOfFiles): PngPath => ({ d: of, fill: { color, alpha: 1, rule } });
  const painted = ({ d: of, isLine, line, color }: PaintedPath): PngPath => ({
    ...(isLine === true ? { d: of, stroke: inkOfFiles } : area(of, color)),
    ...(line === undefined ? {} : { line, stroke: line.color ?? inkOfFiles }),
  });
  return (layers.length > 0 ? layers : [{ d, isLine: filled !== true }]).map(painted);
}

export async function writePng(options: PngOptions): Promise<Blob | null> {
  const [size, picture] = [pngSize(options, options.scale), pictureOf(options)];
  if (size === null || picture === null) return null;
  const canvas = document.createElement("canvas");
  canvas.width = size.width;
  canvas.height = size.height;
  const context = canvas.getContext("2d");
  if (context === null) return null;
  if (options.paper !== null) {
    context.fillStyle = options.paper;
    context.fillRect(0, 0, size.width, size.height);
  }
  const scale = options.scale * picture.enlarged;
  context.setTransform(scale, 0, 0, scale, -scale * picture.frame.minX, -scale * picture.frame.minY);
  for (const path of pngPaths(options)) draw(context, path, lineWidth / picture.enlarged);
  return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
}

function draw(context: CanvasRenderingContext2D, { d, fill, stroke, line }: PngPath, thin: number): void {
  const path = new Path2D(d);
  if (fill !== undefined) {
    context.globalAlpha = fill.alpha;
    context.fillStyle = fill.color;
    context.fill(path, fill.rule);
    context.globalAlpha = 1;
  }
  if (stroke === undefined) return;
  context.strokeStyle = stroke;
  const look = line ?? { width: thin, join: "round" as const };
  Object.assign(context, lineStyle(look));
  setDashes(context, look, context.getTransform().a);
  context.stroke(path);
}
