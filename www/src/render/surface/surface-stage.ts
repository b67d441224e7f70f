import type { EditorState, Editor } from "../../editor/editor.ts";
import type { Frame } from "../../editor/frame.ts";
import { patchSolid } from "../../editor/surface/surface-edits.ts";
import { extentOf, meshOf, netPoints } from "../../kernel/surface/surface-mesh.ts";
import type { Palette } from "../palette.ts";
import type { Painter } from "../stage.ts";
import { drawNet, drawWireframe } from "./overlay.ts";
import { drawRidges } from "./ridges.ts";
import type { Colours, Region, ShadedView } from "./shaded-view.ts";

/** The two canvases of the surface: the shaded one beneath, and the ordinary one with the net, or with lines where nothing can shade. */

export interface SurfaceStage {
  readonly painter: Painter;
  /** Why it is drawn in lines; null while it is shaded. */
  readonly note: () => string | null;
}

/** Frames slower than this, while turning, are answered with a coarser mesh. */
const slowMs = 24;

export async function createSurfaceStage(editor: Editor, frame: Frame, surface: HTMLElement, until: AbortSignal): Promise<SurfaceStage> {
  const canvas = document.createElement("canvas");
  canvas.className = "stage-solid";
  canvas.setAttribute("aria-hidden", "true");
  surface.prepend(canvas);
  const noted = document.createElement("p");
  noted.className = "stage-note";
  noted.dataset["testid"] = "surface-note";
  surface.after(noted);
  let view: ShadedView | null = null;
  let gone = false;
  let coarse = 1;

  const lost = (now: boolean): void => {
    gone = now;
    patchSolid(editor, { shaded: !now });
    frame.request();
  };
  if (await hasWebGl2()) {
    const { createShadedView } = await import("./shaded-view.ts");
    try {
      view = createShadedView(canvas, lost);
    } catch {
      view = null;
    }
  }
  patchSolid(editor, { shaded: view !== null });
  until.addEventListener("abort", () => view?.dispose(), { once: true });
  const note = (): string | null => {
    if (view === null) return "Drawn in lines: this browser has no WebGL 2 to shade the surface with.";
    return gone ? "Drawn in lines until the graphics card is free again." : null;
  };

  /** While it is turned: fewer triangles, if frames take long; all of them when it rests. */
  function sidesFor({ solid }: EditorState): number {
    if (!solid.turning) coarse = 1;
    else if ((frame.times.at(-1) ?? 0) > slowMs) coarse = Math.min(4, coarse * 2);
    return Math.max(4, Math.round(solid.tessellation / coarse));
  }

  function show(state: EditorState): void {
    const shaded = state.mode === "surface" && view !== null && !gone;
    canvas.hidden = !shaded;
    const text = state.mode === "surface" ? note() : null;
    noted.hidden = text === null;
    if (noted.textContent !== (text ?? "")) noted.textContent = text ?? "";
  }
  editor.state.subscribe(show, { until, now: true });

  return {
    note,
    painter: {
      clear: true,
      paint(scene) {
        const { state, palette, ratio } = scene;
        const mesh = meshOf(state.surface, sidesFor(state), state.solid.shade === "curvature");
        if (view === null || gone || mesh === null) {
          const { context } = scene;
          context.fillStyle = palette.canvas;
          context.fillRect(0, 0, context.canvas.width, context.canvas.height);
          if (mesh !== null) drawWireframe(scene);
        } else {
          const { solid, stage } = state;
          const { u, v } = state.surface;
          view.draw({
            mesh, ratio,
            orbit: solid.orbit, shade: palette.forced && solid.shade === "solid" ? "wire" : solid.shade,
            iso: solid.iso, colours: coloursOf(palette), regions: regionsOf(state),
            period: [u?.closed === true ? mesh.size[0] : 0, v?.closed === true ? mesh.size[1] : 0],
            isoStep: 1,
            curvatureScale: 0.4 * extentOf(state.surface).radius ** 2,
            width: stage.width, height: stage.height,
          });
        }
        drawRidges(scene);
        drawNet(scene);
      },
    },
  };
}

async function hasWebGl2(): Promise<boolean> {
  // Asked on a canvas of its own: a refused context would spoil the one that is shown.
  return document.createElement("canvas").getContext("webgl2") !== null;
}

/** Curvature's colours are what it says: they stay where the page's own are the system's, on the grey that they fade to. */
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
