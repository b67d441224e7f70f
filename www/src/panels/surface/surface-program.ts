import type { EditorState } from "../../editor/editor.ts";
import type { Detail, NetDirection, Root } from "../../document/surface/surface.ts";

/** The program that makes the present surface: the bridge from the page to an integration. */

/** The name stands in a text that is shown; it is no import of the page. */
const library = JSON.stringify("expline");

/** Twelve digits, free of rounding noise. */
function number(value: number): string {
  return Math.abs(value) < 1e-12 ? "0" : String(Number(value.toPrecision(12)));
}

function root({ re, im }: Root): string {
  return im === 0 ? number(re) : `{ re: ${number(re)}, im: ${number(im)} }`;
}

function direction({ roots, count, closed }: NetDirection, level: number): string {
  return `{ roots: [${roots.map(root).join(", ")}], count: ${count}, closed: ${closed}${level === 0 ? "" : `, level: ${level}`} }`;
}

function patch({ u, v, displacements }: Detail): string {
  const part = ({ level, first, count }: Detail["u"]): string => `{ level: ${level}, first: ${first}, count: ${count} }`;
  return `    { u: ${part(u)}, v: ${part(v)}, displacements: Float64Array.of(${displacements.map(number).join(", ")}) },`;
}

export function surfaceProgram({ surface: { net, u, v, levelU, levelV, details = [] } }: EditorState): string {
  if (u === undefined || v === undefined) return "// Open a sample.";
  const points = net.map(({ x, y, z }) => `${number(x)}, ${number(y)}, ${number(z)}`);
  const lines = Array.from({ length: Math.ceil(points.length / 3) }, (_, i) => `    ${points.slice(3 * i, 3 * i + 3).join(",  ")},`);
  const patches = details.length === 0 ? "" : `\n  patches: [\n${details.map(patch).join("\n")}\n  ],`;
  return `import { TensorSurface } from ${library};

const surface = new TensorSurface({
  net: Float64Array.of(   // x, y, z of each point, row by row
${lines.join("\n")}
  ),
  u: ${direction(u, levelU)},
  v: ${direction(v, levelV)},${patches}
});

// Draw: vertices, normals and triangles as WebGL takes them.
const mesh = surface.mesh(129, 129);
const { positions, normals, indices } = mesh;

// Edit: move a point, and make anew only what it changes.
// surface.setPoint(0, 0, x, y, z);
// const { rows, cols } = surface.remesh(mesh, 0, 0);
`;
}
