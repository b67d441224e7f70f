import { netPoints, trianglesOf } from "../../kernel/surface/surface-mesh.ts";
import { deviationOf } from "../../kernel/surface/surface-truth.ts";
import { formatCount, formatRatio } from "../controls/format.ts";
import type { ModeMetrics } from "../mode/metric.ts";

/** Surface mode's numbers. */
export const surfaceMetrics: ModeMetrics = [
  [
    {
      testid: "m-points", about: "Control points you can drag",
      read({ surface }) {
        const value = netPoints(surface).length;
        return { value, strong: String(value), rest: value === 1 ? "control point" : "control points" };
      },
    },
    {
      testid: "m-patches", about: "Patches of the net at this level",
      read({ surface }) {
        return { value: surface.patches, strong: String(surface.patches), rest: formatCount(surface.patches, "patch", "patches").replace(/^\d+ /u, "") };
      },
    },
  ],
  [
    {
      testid: "m-error", about: "Largest distance from the exact shape, over 129 × 129 points",
      read({ surface }) {
        const value = surface.net.length === 0 ? undefined : deviationOf(surface);
        return value === undefined ? null : { value, lead: "from the exact shape", strong: formatRatio(value) };
      },
      slow: true,
    },
  ],
  [
    {
      testid: "m-triangles", about: "Triangles drawn; fewer while orbiting if frames are slow",
      read({ surface, solid }) {
        const value = surface.net.length === 0 ? 0 : trianglesOf(surface, solid.tessellation);
        return { value, strong: String(value), rest: "triangles" };
      },
    },
  ],
];
