import { isChosen, sameNetPoint, type SurfaceDocument } from "../../document/surface/surface.ts";
import { facesAway } from "../../editor/surface/surface-edits.ts";
import { projector, type Projected } from "../../editor/surface/orbit.ts";
import { meshOf, netPoints, type ShownPoint, type SurfaceMesh } from "../../kernel/surface/surface-mesh.ts";
import { diamond, disc, drawFocus, halo } from "../markers.ts";
import type { Palette } from "../palette.ts";
import { inScreen, type Scene } from "../scene.ts";

/**
 * What lies over the surface: the net, its points, the axis of a drag; and the surface itself in lines, where nothing
 * shades it.
 */

export function drawNet(scene: Scene): void {
  const { state } = scene;
  const { surface, solid } = state;
  if (surface.net.length === 0) return;
  const project = projector(solid.orbit, state.stage);
  const points = netPoints(surface).map((point) => ({ point, at: project(point.at), away: facesAway(solid.orbit, point) }));
  if (solid.net) drawEdges(scene, surface, points);
  if (solid.drag !== null) drawAxis(scene, points);
  if (!solid.handles) return;
  // Those behind first, so that those in front lie over them.
  for (const entry of [...points].sort((a, b) => Number(b.away) - Number(a.away) || b.at.depth - a.at.depth)) drawHandle(scene, entry);
}

interface Placed {
  readonly point: ShownPoint;
  readonly at: Projected;
  readonly away: boolean;
}

/** Lines between neighbours of the net and of each detail; faint where the surface turns away. */
function drawEdges(scene: Scene, surface: SurfaceDocument, points: readonly Placed[]): void {
  const context = inScreen(scene);
  const nets = new Map<number, Map<string, Placed>>();
  for (const entry of points) {
    const which = entry.point.ref.detail ?? -1;
    const net = nets.get(which) ?? new Map<string, Placed>();
    nets.set(which, net);
    net.set(`${entry.point.ref.u},${entry.point.ref.v}`, entry);
  }
  const [near, far] = [new Path2D(), new Path2D()];
  for (const [which, net] of nets) {
    const base = which < 0;
    const [rows, cols] = base ? [surface.u?.count ?? 0, surface.v?.count ?? 0] : [Infinity, Infinity];
    for (const entry of net.values()) {
      const { u, v } = entry.point.ref;
      const nextU = base && surface.u?.closed === true ? (u + 1) % rows : u + 1;
      const nextV = base && surface.v?.closed === true ? (v + 1) % cols : v + 1;
      for (const other of [net.get(`${nextU},${v}`), net.get(`${u},${nextV}`), ...spokes(surface, net, entry)]) {
        if (other === undefined || other.at.depth <= 0 || entry.at.depth <= 0) continue;
        const isFaint = (entry.away && other.away) || entry.point.beyond === true || other.point.beyond === true;
        addLine(isFaint ? far : near, entry.at, other.at);
      }
    }
  }
  strokeBoth(context, scene.palette.point, [far, 0.16], [near, 0.7]);
}

function addLine(path: Path2D, from: Projected, to: Projected): void {
  path.moveTo(from.x, from.y);
  path.lineTo(to.x, to.y);
}

/** Lines of one colour, faint ones below. */
function strokeBoth(context: CanvasRenderingContext2D, color: string, ...paths: readonly (readonly [path: Path2D, alpha: number])[]): void {
  context.strokeStyle = color;
  context.lineWidth = 1;
  for (const [path, alpha] of paths) {
    context.globalAlpha = alpha;
    context.stroke(path);
  }
  context.globalAlpha = 1;
}

/** A pole is shown once, and joined to every point of the row beside it. */
function spokes(surface: SurfaceDocument, net: ReadonlyMap<string, Placed>, { point: { ref } }: Placed): Placed[] {
  if (ref.detail !== undefined || surface.u === undefined || surface.v === undefined) return [];
  const row = (v: number): Placed[] => Array.from({ length: surface.u?.count ?? 0 }, (_, u) => net.get(`${u},${v}`)).filter((each) => each !== undefined);
  const column = (u: number): Placed[] => Array.from({ length: surface.v?.count ?? 0 }, (_, v) => net.get(`${u},${v}`)).filter((each) => each !== undefined);
  if (surface.u.closed && ref.u === 0 && row(ref.v).length === 1) return [...row(ref.v - 1), ...row(ref.v + 1)];
  if (surface.v.closed && ref.v === 0 && column(ref.u).length === 1) return [...column(ref.u - 1), ...column(ref.u + 1)];
  return [];
}

const axisLength = 2000;

/** A drag that is held to an axis shows it, through the point that is dragged. */
function drawAxis(scene: Scene, points: readonly Placed[]): void {
  const { drag, orbit } = scene.state.solid;
  const [first] = drag?.points ?? [];
  const placed = first === undefined ? undefined : points.find(({ point }) => sameNetPoint(point.ref, first));
  if (drag === null || placed === undefined || drag.axis === "view") return;
  const { at, normal } = placed.point;
  const way = drag.axis === "normal" ? normal : ([drag.axis === "x" ? 1 : 0, drag.axis === "y" ? 1 : 0, drag.axis === "z" ? 1 : 0] as const);
  const small = orbit.distance * 1e-3;
  const ahead = projector(orbit, scene.state.stage)([at[0] + way[0] * small, at[1] + way[1] * small, at[2] + way[2] * small]);
  const [dx, dy] = [ahead.x - placed.at.x, ahead.y - placed.at.y];
  const size = Math.hypot(dx, dy);
  if (size < 1e-6) return;
  const context = inScreen(scene);
  context.strokeStyle = scene.palette.cusp;
  context.lineWidth = 1;
  context.setLineDash([6, 4]);
  context.beginPath();
  context.moveTo(placed.at.x - (dx / size) * axisLength, placed.at.y - (dy / size) * axisLength);
  context.lineTo(placed.at.x + (dx / size) * axisLength, placed.at.y + (dy / size) * axisLength);
  context.stroke();
  context.setLineDash([]);
}

function drawHandle(scene: Scene, { point, at, away }: Placed): void {
  const { state, palette, focused } = scene;
  if (at.depth <= 0) return;
  const context = inScreen(scene);
  const selected = isChosen(state.chosen, point.ref);
  const hovered = state.solid.hover !== null && sameNetPoint(state.solid.hover, point.ref);
  const last = state.chosen.at(-1);
  const ringed = focused && state.keyboard && last !== undefined && sameNetPoint(last, point.ref);
  const crowded = netPoints(state.surface).length > 300;
  const behind = away && !selected && !hovered;
  const radius = (crowded || behind || point.beyond === true ? 3 : point.ref.detail === undefined ? 4.5 : 3.75) + (selected ? 1 : 0);
  // On the surface: a disc, as everywhere; near it: a diamond.
  const shape = (size: number): void => (point.on ? disc(context, at, size) : diamond(context, at, size * 1.25));
  const color = point.ref.detail === undefined ? palette.point : palette.handle;
  context.globalAlpha = (away || point.beyond === true) && !selected && !hovered ? 0.55 : 1;
  if (hovered) halo(context, color, () => shape(radius + 5));
  if (behind) ring(context, shape, radius, color);
  else fillShape(context, shape, radius, away, color, palette);
  if (selected) {
    shape(radius + 3.5);
    context.strokeStyle = color;
    context.lineWidth = 1.5;
    context.stroke();
  }
  if (ringed) drawFocus(context, at, radius + 5, palette);
  context.globalAlpha = 1;
}

/** Behind the surface: there, and no more than that. */
function ring(context: CanvasRenderingContext2D, shape: (size: number) => void, radius: number, color: string): void {
  shape(radius);
  context.strokeStyle = color;
  context.lineWidth = 1;
  context.stroke();
}

/** Hollow where the surface turns away from the eye. */
function fillShape(context: CanvasRenderingContext2D, shape: (size: number) => void, radius: number, hollow: boolean, color: string, palette: Palette): void {
  shape(radius + 1.5);
  context.fillStyle = palette.canvas;
  context.fill();
  shape(hollow ? radius - 0.75 : radius);
  if (hollow) {
    context.strokeStyle = color;
    context.lineWidth = 1.5;
    context.stroke();
  } else {
    context.fillStyle = color;
    context.fill();
  }
}

/** Iso-lines of a patch, and straight pieces of one between two of them. */
const linesPerUnit = 2;

/** The surface as iso-lines on the ordinary canvas: the far side is fainter. */
export function drawWireframe(scene: Scene): void {
  const { state, palette } = scene;
  const mesh = meshOf(state.surface, Math.min(12, state.solid.tessellation), false);
  if (mesh === null) return;
  const project = projector(state.solid.orbit, state.stage);
  const context = inScreen(scene);
  const places = Array.from({ length: mesh.rows * mesh.cols }, (_, i) => placeOf(mesh, i, project, state.solid.orbit));
  const [near, far] = [new Path2D(), new Path2D()];
  const edge = (a: number, b: number): void => {
    const [from, to] = [places[a], places[b]];
    if (from === undefined || to === undefined) return;
    addLine(from.away && to.away ? far : near, from.at, to.at);
  };
  const [everyRow, everyCol] = [stride(mesh.rows, mesh.size[0]), stride(mesh.cols, mesh.size[1])];
  for (let i = 0; i < mesh.rows; i += 1) {
    for (let j = 0; j < mesh.cols; j += 1) {
      if (i % everyRow === 0 && j + 1 < mesh.cols) edge(i * mesh.cols + j, i * mesh.cols + j + 1);
      if (j % everyCol === 0 && i + 1 < mesh.rows) edge(i * mesh.cols + j, (i + 1) * mesh.cols + j);
    }
  }
  strokeBoth(context, palette.curve, [far, 0.2], [near, 0.8]);
}

function stride(count: number, length: number): number {
  return Math.max(1, Math.round((count - 1) / Math.max(1, length * linesPerUnit)));
}

function placeOf(mesh: SurfaceMesh, i: number, project: ReturnType<typeof projector>, orbit: Scene["state"]["solid"]["orbit"]): { at: Projected; away: boolean } {
  const vector = (list: Float32Array): readonly [number, number, number] => [list[3 * i] ?? 0, list[3 * i + 1] ?? 0, list[3 * i + 2] ?? 0];
  const at = vector(mesh.positions);
  return { at: project(at), away: facesAway(orbit, { at, normal: vector(mesh.normals), ref: { u: 0, v: 0 }, parameter: [0, 0], on: true }) };
}
