/** The surfaces to start from; their nets are the library's. */
export interface SurfaceSample {
  readonly id: string;
  readonly title: string;
  /** One sentence: what to try. */
  readonly note: string;
}

export const surfaceSamples: readonly SurfaceSample[] = [
  { id: "surf-torus", title: "Torus", note: "An exact torus with its control points on the surface. Drag one: only the area around it changes." },
  { id: "surf-sphere", title: "Sphere", note: "An exact sphere, poles included. Drag a point; Shift keeps it on the normal." },
  { id: "surf-roman", title: "Roman surface", note: "Steiner's surface, which intersects itself. Move the net and the surface moves with it." },
  { id: "surf-paraboloid", title: "Hyperbolic paraboloid", note: "A saddle, open in both directions. Try the zebra shading." },
  { id: "surf-cylinder", title: "Cylinder", note: "Closed one way, open the other. Try raising the level in one direction only." },
  { id: "surf-character", title: "Character", note: "Modelled by hand, without a formula. Refine an area and give it a nose." },
];

export function surfaceTitle(id: string): string {
  return surfaceSamples.find((sample) => sample.id === id)?.title ?? "";
}
