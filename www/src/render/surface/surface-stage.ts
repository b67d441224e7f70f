import type { EditorState, Editor } from "../../editor/editor.ts";
import type { Frame } from "../../editor/frame.ts";
import type { SolidState } from "../../editor/surface/solid.ts";
import { patchSolid } from "../../editor/surface/surface-edits.ts";
import { extentOf, meshOf, netPoints, type SurfaceMesh } from "../../kernel/surface/surface-mesh.ts";
import type { Palette } from "../palette.ts";
import type { Scene } from "../scene.ts";
import type { Painter } from "../stage.ts";
import { drawNet, drawWireframe } from "./overlay.ts";
import { drawRidges } from "./ridges.ts";
import type { Colours, Picture, Region, ShadedView } from "./shaded-view.ts";

/**
 * The two canvases of the surface: the shaded one beneath, and the ordinary one with the net, or with lines where
 * nothing can shade.
 */

export interface SurfaceStage {
  readonly painter: Painter;
}

/** Frames slower than this, while turning, are answered with a coarser mesh. */
const slowMs = 24;

export async function createSurfaceStage(editor: Editor, frame: Frame, surface: HTMLElement, until: AbortSignal): Promise<SurfaceStage> {
  const stage = new TwoCanvases(editor, frame, surface);
  await stage.load();
  until.addEventListener("abort", () => stage.dispose(), { once: true });
  editor.state.subscribe((state) => stage.show(state), { until, now: true });
  return stage;
}

class TwoCanvases implements SurfaceStage {
  readonly painter: Painter = { clear: true, paint: (scene) => this.#paint(scene) };
  readonly #editor: Editor;
  readonly #frame: Frame;
  readonly #canvas = document.createElement("canvas");
  readonly #noted = document.createElement("p");
  readonly #tessellation = new Tessellation();
  /** Null where nothing can shade. */
  #view: ShadedView | null = null;
  /** The graphics card has taken the view's context away. */
  #gone = false;

  constructor(editor: Editor, frame: Frame, surface: HTMLElement) {
    this.#editor = editor;
    this.#frame = frame;
    this.#canvas.className = "stage-solid";
    this.#canvas.setAttribute("aria-hidden", "true");
    surface.prepend(this.#canvas);
    this.#noted.className = "stage-note";
    this.#noted.dataset["testid"] = "surface-note";
    surface.after(this.#noted);
  }

  async load(): Promise<void> {
    this.#view = await loadShadedView(this.#canvas, (gone) => this.#lost(gone));
    patchSolid(this.#editor, { shaded: this.#view !== null });
  }

  dispose(): void {
    this.#view?.dispose();
  }

  show({ mode }: EditorState): void {
    this.#canvas.hidden = mode !== "surface" || this.#view === null || this.#gone;
    const text = mode === "surface" ? this.#note() : null;
    this.#noted.hidden = text === null;
    if (this.#noted.textContent !== (text ?? "")) this.#noted.textContent = text ?? "";
  }

  /** Why it is drawn in lines; null while it is shaded. */
  #note(): string | null {
    if (this.#view === null) return "Drawn in lines: this browser has no WebGL 2 for shading.";
    return this.#gone ? "Drawn in lines until the graphics card is free again." : null;
  }

  #lost(gone: boolean): void {
    this.#gone = gone;
    patchSolid(this.#editor, { shaded: !gone });
    this.#frame.request();
  }

  #paint(scene: Scene): void {
    const { surface, solid } = scene.state;
    const mesh = meshOf(surface, this.#tessellation.sidesFor(solid, this.#frame.times.at(-1) ?? 0), solid.shade === "curvature");
    if (this.#view === null || this.#gone || mesh === null) drawInLines(scene, mesh);
    else this.#view.draw(pictureOf(scene, mesh));
    drawRidges(scene);
    drawNet(scene);
  }
}

/** While it is turned: fewer triangles, if frames take long; all of them when it rests. */
class Tessellation {
  #coarse = 1;

  sidesFor({ turning, tessellation }: SolidState, frameMs: number): number {
    if (!turning) this.#coarse = 1;
    else if (frameMs > slowMs) this.#coarse = Math.min(4, this.#coarse * 2);
    return Math.max(4, Math.round(tessellation / this.#coarse));
  }
}

async function loadShadedView(canvas: HTMLCanvasElement, lost: (gone: boolean) => void): Promise<ShadedView | null> {
  if (!hasWebGl2()) return null;
  const { createShadedView } = await import("./shaded-view.ts");
  try {
    return createShadedView(canvas, lost);
  } catch {
    return null;
  }
}

function hasWebGl2(): boolean {
  // Asked on a canvas of its own: a refused context would spoil the one that is shown.
  return document.createElement("canvas").getContext("webgl2") !== null;
}

function drawInLines(scene: Scene, mesh: SurfaceMesh | null): void {
  const { context, palette } = scene;
  context.fillStyle = palette.canvas;
  context.fillRect(0, 0, context.canvas.width, context.canvas.height);
  if (mesh !== null) drawWireframe(scene);
}

function pictureOf({ state, palette, ratio }: Scene, mesh: SurfaceMesh): Picture {
  const { surface, solid, stage } = state;
  const { u, v } = surface;
  return {
    mesh, ratio,
    orbit: solid.orbit, shade: palette.forced && solid.shade === "solid" ? "wire" : solid.shade,
    iso: solid.iso, colours: coloursOf(palette), regions: regionsOf(state),
    period: [u?.closed === true ? mesh.size[0] : 0, v?.closed === true ? mesh.size[1] : 0],
    isoStep: 1,
    curvatureScale: 0.4 * extentOf(surface).radius ** 2,
    width: stage.width, height: stage.height,
  };
}

/**
 * Curvature's colours are what it says: they stay where the page's own are the system's, on the grey that they fade to.
 */
const bent = { cool: "#0b57d0", warm: "#b3420b" } as const;

function coloursOf(palette: Palette): Colours {
  return {
    paper: palette.canvas, front: palette.solid, back: palette.solidBack, ink: palette.curve, tint: palette.cusp,
    ...(palette.forced ? bent : { cool: palette.point, warm: palette.linear }),
  };
}

/** The patches that the points of a drag change. */
function regionsOf({ surface, solid }: EditorState): Region[] {
  if (solid.drag === null) return [];
  const [unitU, unitV] = [0.5 ** surface.levelU, 0.5 ** surface.levelV];
  return solid.drag.points.flatMap((ref) => {
    const point = netPoints(surface).find((each) => each.ref.u === ref.u && each.ref.v === ref.v && each.ref.detail === ref.detail);
    if (point === undefined) return [];
    const detail = ref.detail === undefined ? undefined : surface.details?.[ref.detail];
    const reach = (support: number, unit: number, order: number | undefined, level: number | undefined): number =>
      (level === undefined ? support * unit : ((order ?? 3) / 2) * 0.5 ** level);
    const reachU = reach(surface.support[0], unitU, surface.u?.roots.length, detail?.u.level);
    const reachV = reach(surface.support[1], unitV, surface.v?.roots.length, detail?.v.level);
    return [{ from: [point.parameter[0] - reachU, point.parameter[1] - reachV] as const, size: [2 * reachU, 2 * reachV] as const }];
  });
}
