import type { Setting } from "./artboard.ts";
import type { Contour, DemoState } from "./document.ts";
import type { Problem } from "./problem.ts";

/** What came out of a file, a drop or a paste: contours to draw, or a whole saved state. */
export type Imported =
  | { readonly kind: "json"; readonly state: DemoState; readonly notes: readonly string[] }
  | Setting & {
      readonly kind: "svg" | "path" | "points";
      readonly contours: readonly Contour[];
      /** Things that were read leniently, in words. */
      readonly notes: readonly string[];
      /** Where the text stopped making sense, when only its beginning was read. */
      readonly broken: Problem | null;
    };
