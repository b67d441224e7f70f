/** The surfaces to start from; their nets are the library's. */
export interface SurfaceSample {
  readonly id: string;
  readonly title: string;
  /** One sentence: what to try. */
  readonly note: string;
}

export const surfaceSamples: readonly SurfaceSample[] = [
  { id: "surf-torus", title: "Torus", note: "An exact torus whose control points lie on it. Drag one: the surface follows through it, and only nearby." },
  { id: "surf-sphere", title: "Sphere", note: "An exact sphere, poles included. Drag a point; Shift holds the drag to the normal." },
  { id: "surf-roman", title: "Roman surface", note: "Steiner's surface, which passes through itself. Its roots include 0, so moving the net moves the surface." },
  { id: "surf-paraboloid", title: "Hyperbolic paraboloid", note: "A saddle, open in both directions. Look at it in zebra stripes." },
  { id: "surf-cylinder", title: "Cylinder", note: "Closed one way, open the other. Raise the level of one direction only." },
  { id: "surf-character", title: "Character", note: "Modelled by hand: no formula draws it. Refine a place and give it a nose." },
];

export function surfaceTitle(id: string): string {
  return surfaceSamples.find((sample) => sample.id === id)?.title ?? "";
}
