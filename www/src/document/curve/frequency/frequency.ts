import { omegaOf, segmentCount, type Contour, type CurveDocument, type Selection } from "../../document.ts";
import type { Command } from "../commands.ts";
import { rootsOf } from "../roots.ts";
import { chosenSegments } from "./segments.ts";
import { withPinnedOmega } from "../whole/rearranging.ts";

/**
 * Gives the chosen segments a frequency; what is not chosen keeps its own. With nothing chosen, or everything, it is
 * the document's, for contours that come later, too: what contours had of their own is dropped.
 */
export function setOmega(selection: Selection, omega: number | "auto", run?: string): Command {
  return {
    name: "Frequency",
    apply(curve) {
      const chosen = curve.contours.map((contour, c) => chosenSegments(contour, c, selection));
      if (curve.contours.every((contour, c) => chosen[c]?.length === segmentCount(contour))) return everywhere(curve, omega);
      return { ...curve, contours: curve.contours.map((contour, c) => withFrequency(curve, contour, new Set(chosen[c]), omega)) };
    },
    ...(run === undefined ? {} : { run }),
  };
}

function everywhere(curve: CurveDocument, omega: number | "auto"): CurveDocument {
  // A grid says what its roots are; elsewhere they are a frequency of the contour's own.
  const contours = curve.contours.map(({ omega: _own, ...contour }) => (contour.grid === undefined ? withoutRoots(contour) : contour));
  return { ...curve, omega, contours };
}

function withoutRoots({ roots: _own, ...contour }: Contour): Contour {
  return contour;
}

function withFrequency(curve: CurveDocument, contour: Contour, segments: ReadonlySet<number>, omega: number | "auto"): Contour {
  if (segments.size === 0 || contour.grid !== undefined || contour.places !== undefined) return contour;
  const { omega: _own, ...plain } = withoutRoots(contour);
  if (segments.size === segmentCount(contour) && omega === curve.omega) return plain;
  const asked = { ...curve, omega };
  if (contour.family === "interpolating") return { ...plain, roots: rootsOf(asked, plain) };
  const before = withPinnedOmega(curve, contour).omega ?? [];
  return { ...contour, omega: before.map((own, segment) => (segments.has(segment) ? omegaOf(asked, plain, segment) : own)) };
}
