import { onDemand } from "../loading.ts";

/** The edits that come when they are first wanted. */

/** What changes the points of a contour, or renews it as a whole. */
export const renewing = onDemand(() => import("./contour-edits.ts"));
/** What goes up and down the levels. */
export const levelling = onDemand(() => import("./level-edits.ts"));
/** Ellipses and rectangles. */
export const shaping = onDemand(() => import("./adding/shapes.ts"));
/** The frame around whole contours, what selects them, and what turns and stretches. */
export const framing = onDemand(() => import("./framing.ts"));
/** Corners that become round. */
export const rounding = onDemand(() => import("./corners/rounding.ts"));
