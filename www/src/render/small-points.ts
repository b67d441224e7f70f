import type { Kind } from "../document/document.ts";
import type { ScreenPoint } from "../editor/pointer/camera.ts";
import { thinned } from "../kernel/paths/polylines.ts";
import type { Palette } from "./palette.ts";
import { addVertices } from "./scene.ts";

/** Very many points: without halo and half as large, so that the curve can still be seen, and drawn all at once. */
export interface SmallPoints {
  add(at: ScreenPoint, kind: Kind, chosen: boolean): void;
  draw(context: CanvasRenderingContext2D, palette: Palette): void;
  /** Discs and diamonds that are drawn, and places along lines that stand for discs. */
  readonly drawn: number;
}

const discRadius = 2.5;
const diamondRadius = 3.5;
/** Chosen ones are larger: there are too many for rings. */
const larger = 1.5;
/** CSS pixels between discs that look like a line along them, and by how much that line may miss them. */
const apart = 1;
const missed = 0.1;
/**
 * Marks in a path: browsers fill ten thousand in a hundred paths in a third of the time that one path of them takes.
 */
const marksInPath = 100;

/** Paths for very many marks, of which none shows through another. */
interface Marks {
  readonly paths: readonly Path2D[];
  /** The path that the next mark goes to. */
  next(): Path2D;
}

function marksIn(path: () => Path2D): Marks {
  const paths: Path2D[] = [];
  let [last, count] = [path(), 0];
  paths.push(last);
  return {
    paths,
    next() {
      if (count >= marksInPath) {
        [last, count] = [path(), 0];
        paths.push(last);
      }
      count += 1;
      return last;
    },
  };
}

export function createSmallPoints(path: () => Path2D = () => new Path2D()): SmallPoints {
  const discs = { plain: marksIn(path), chosen: marksIn(path) };
  const lines = { plain: path(), chosen: path() };
  const diamonds = marksIn(path);
  const cells = new Set<number>();
  let run: number[] = [];
  let chosenRun = false;
  let drawn = 0;

  /** A run of discs that run into one another is a line as wide as they are. */
  function endRun(): void {
    const [x = 0, y = 0] = run;
    const name = chosenRun ? "chosen" : "plain";
    if (run.length === 2) {
      const radius = discRadius + (chosenRun ? larger : 0);
      const disc = discs[name].next();
      disc.moveTo(x + radius, y);
      disc.arc(x, y, radius, 0, 2 * Math.PI);
      drawn += 1;
    } else if (run.length > 2) {
      const vertices = thinned(Float64Array.from(run), missed);
      lines[name].moveTo(x, y);
      addVertices(lines[name], vertices);
      drawn += vertices.length / 2;
    }
    run = [];
  }

  function addDisc({ x, y }: ScreenPoint, chosen: boolean): void {
    if (chosen !== chosenRun || Math.hypot(x - (run.at(-2) ?? Infinity), y - (run.at(-1) ?? Infinity)) > apart) endRun();
    chosenRun = chosen;
    run.push(x, y);
  }

  function addDiamond({ x, y }: ScreenPoint, chosen: boolean): void {
    // Of those at the same pixel one is seen.
    const cell = (Math.floor(x) * 2 ** 20 + Math.floor(y)) * 2 + (chosen ? 1 : 0);
    if (cells.has(cell)) return;
    cells.add(cell);
    const radius = diamondRadius + (chosen ? larger : 0);
    const diamond = diamonds.next();
    diamond.moveTo(x, y - radius);
    diamond.lineTo(x + radius, y);
    diamond.lineTo(x, y + radius);
    // Filled, it needs no closing, for which a browser looks through all of the path.
    diamond.lineTo(x - radius, y);
    drawn += 1;
  }

  return {
    get drawn() {
      endRun();
      return drawn;
    },
    add(at, kind, chosen) {
      if (kind === "cusp") addDiamond(at, chosen);
      else addDisc(at, chosen);
    },
    draw(context, palette) {
      endRun();
      context.fillStyle = context.strokeStyle = palette.point;
      context.lineCap = context.lineJoin = "round";
      for (const name of ["plain", "chosen"] as const) {
        for (const disc of discs[name].paths) context.fill(disc);
        context.lineWidth = 2 * (discRadius + (name === "chosen" ? larger : 0));
        context.stroke(lines[name]);
      }
      context.lineCap = "butt";
      context.fillStyle = palette.cusp;
      for (const diamond of diamonds.paths) context.fill(diamond);
    },
  };
}
