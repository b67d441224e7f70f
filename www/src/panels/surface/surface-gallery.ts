import { surfaceSamples } from "../../document/surface/surface-samples.ts";
import type { SurfaceDocument } from "../../document/surface/surface.ts";
import { fittingDistance, projector } from "../../editor/surface/orbit.ts";
import { startOrbit } from "../../editor/surface/solid.ts";
import { openSurfaceSample } from "../../editor/surface/surface-edits.ts";
import { extentOf, meshOf } from "../../kernel/surface/surface-mesh.ts";
import { surfaceSample } from "../../kernel/surface/surface.ts";
import { h, svg } from "../controls/dom.ts";
import type { Shell } from "../shell.ts";

const frame = { left: 0, top: 0, width: 300, height: 200 };
const sides = 4;

/** A surface in lines, seen as it is seen first. */
export function surfaceThumbnail(surface: SurfaceDocument): SVGSVGElement {
  const extent = extentOf(surface);
  const project = projector({ ...startOrbit, target: extent.center, distance: fittingDistance(extent, frame) }, frame);
  const mesh = meshOf(surface, sides, false);
  const picture = svg("svg", { class: "thumbnail", viewBox: `0 0 ${frame.width} ${frame.height}`, "aria-hidden": "true" });
  if (mesh === null) return picture;
  const { rows, cols, positions } = mesh;
  const at = (i: number, j: number): string => {
    const k = 3 * (i * cols + j);
    const { x, y } = project([positions[k] ?? 0, positions[k + 1] ?? 0, positions[k + 2] ?? 0]);
    return `${x.toFixed(1)} ${y.toFixed(1)}`;
  };
  const line = (points: readonly string[]): string => `M${points.join("L")}`;
  const across = Array.from({ length: rows }, (_, i) => i).filter((i) => i % 2 === 0).map((i) => line(Array.from({ length: cols }, (_, j) => at(i, j))));
  const along = Array.from({ length: cols }, (_, j) => j).filter((j) => j % 2 === 0).map((j) => line(Array.from({ length: rows }, (_, i) => at(i, j))));
  picture.append(svg("path", { class: "thumbnail-mesh", d: [...across, ...along].join("") }));
  return picture;
}

/** The gallery of surfaces. */
export function surfaceCards(shell: Shell, close: () => void): HTMLElement[] {
  const present = shell.editor.state.value.surface.sample;
  return surfaceSamples.flatMap(({ id, title, note }) => {
    const surface = surfaceSample(id);
    if (surface === null) return [];
    const choose = (): void => {
      close();
      openSurfaceSample(shell.editor, id);
    };
    return [h("button", { class: "sample", type: "button", testid: `sample-${id}`, "aria-current": id === present ? "true" : null, click: choose },
      surfaceThumbnail(surface), h("span", { class: "sample-title" }, title), h("span", { class: "sample-note quiet" }, note))];
  });
}
