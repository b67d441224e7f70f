import { lengthOf, omegaOf, segmentCount, type Contour, type CurveDocument } from "../../document/document.ts";
import { numbers, number, pairs } from "./literals.ts";
import { splineConstruction, splineKind } from "./spline-snippet.ts";

/** Programs that make the present drawing: the bridge from the page to an integration. */
export type SnippetId = "vanilla" | "react" | "vue" | "svelte" | "worker";

export const snippetNames: readonly (readonly [SnippetId, string])[] = [
  ["vanilla", "Vanilla"],
  ["react", "React"],
  ["vue", "Vue"],
  ["svelte", "Svelte"],
  ["worker", "Worker"],
];

const quoted = (name: string): string => `"${name}"`;
const library = quoted("expline");

export interface PrintOptions {
  readonly segments: "arcs" | "cubics" | "polyline";
  readonly tolerance: number;
  readonly decimals: number;
  readonly relative: boolean;
}

/** `new HermiteCurve({ … })` for a contour: drawn handles are a third of the tangents. */
function hermiteConstruction(curve: CurveDocument, contour: Contour): string {
  const segments = segmentCount(contour);
  const { points, closed } = contour;
  const before = (i: number): number => lengthOf(contour, closed ? (i + segments - 1) % segments : Math.max(0, i - 1));
  const after = (i: number): number => lengthOf(contour, Math.min(i, segments - 1));
  const leaving = points.map(({ out }, i) => [(3 * out.dx) / after(i), (3 * out.dy) / after(i)] as const);
  const arriving = points.map((point, i) => [(-3 * point.in.dx) / before(i), (-3 * point.in.dy) / before(i)] as const);
  const differ = arriving.some(([x, y], i) => number(x) !== number(leaving[i]?.[0] ?? 0) || number(y) !== number(leaving[i]?.[1] ?? 0));
  const space = contour.space ?? curve.space;
  const omega = Array.from({ length: segments }, (_, i) => omegaOf(curve, contour, i));
  const one = omega.every((value) => value === omega[0]);
  // What the library takes by itself is for lengths of 1.
  const isDefault = one && contour.omega === undefined && contour.lengths === undefined && curve.omega === "auto";
  const lines = [
    `points: ${pairs(points.map(({ x, y }) => [x, y] as const))},`,
    `tangents: ${pairs(leaving)},`,
    differ ? `tangentsIn: ${pairs(arriving)},` : "",
    closed ? "" : "closed: false,",
    space === "trigonometric" ? "" : `space: "${space}",`,
    isDefault ? "" : `omega: ${one ? number(omega[0] ?? 0) : numbers(omega)},`,
    contour.lengths === undefined ? "" : `lengths: ${numbers(contour.lengths)},`,
  ];
  return `new HermiteCurve({\n${lines.filter((line) => line !== "").map((line) => `  ${line}`).join("\n")}\n})`;
}

function indent(text: string, by: string): string {
  return text.replaceAll("\n", `\n${by}`);
}

/** The library's name for what a contour is. */
function kindOf(contour: Contour): "HermiteCurve" | ReturnType<typeof splineKind> {
  return contour.family === "hermite" ? "HermiteCurve" : splineKind(contour);
}

/** What a drawing is in a program. */
interface Written {
  /** `import { … } from "expline";` */
  readonly imports: string;
  /** `const curves = [ … ];` */
  readonly data: string;
  readonly kinds: readonly ReturnType<typeof kindOf>[];
}

function written(curve: CurveDocument): Written {
  const contours = curve.contours.filter((contour) => contour.points.length > 1);
  const kinds = [...new Set(contours.length === 0 ? ["HermiteCurve" as const] : contours.map(kindOf))].sort();
  const parts = contours.map((contour) => (contour.family === "hermite" ? hermiteConstruction(curve, contour) : splineConstruction(curve, contour)));
  return {
    kinds,
    imports: `import { ${kinds.join(", ")} } from ${library};`,
    data: parts.length === 0 ? "const curves: HermiteCurve[] = [];" : `const curves = [\n${parts.map((part) => `  ${indent(part, "  ")},`).join("\n")}\n];`,
  };
}

function printing({ segments, tolerance, decimals, relative }: PrintOptions): string {
  const parts = [`tolerance: ${number(tolerance)}`, `decimals: ${decimals}`, segments === "cubics" ? "arcs: false" : "", relative ? "relative: true" : ""];
  return `{ ${parts.filter((part) => part !== "").join(", ")} }`;
}

export function snippetFor(id: SnippetId, curve: CurveDocument, options: PrintOptions): string {
  const print = `curves.map((curve) => curve.toPathD(${printing(options)}).d).join("")`;
  return programs[id](written(curve), print);
}

const programs: Readonly<Record<SnippetId, (drawing: Written, print: string) => string>> = { vanilla, react, vue, svelte, worker };

/** More points of the same curve, in the words of what it is; what is said must hold for all curves of the drawing. */
function finer(kinds: Written["kinds"]): string {
  if (kinds.length > 1) return "";
  const say = (call: string): string => `const finer = first?.${call};\n`;
  switch (kinds[0]) {
    case "InterpolatingCurve":
      return say("refine(1)");
    case "BSplineCurve":
      return say("refine(2)");
    case "LocalCurve":
      return say("refineAt(0.5)");
    default:
      return say("insert(0.5)");
  }
}

function vanilla({ imports, data, kinds }: Written, print: string): string {
  return `${imports}   // npm i expline; no await, no bundler setup

${data}

// Edit: more points of the same shape, the nearest place; first?.setPoint(0, x, y) moves a point.
const [first] = curves;
${finer(kinds)}const hit = first?.nearest(400, 140);       // { t, x, y, distance }

// Export: path text, arcs where the curve is an arc; maxError is measured.
const d = ${print};
document.querySelector("path")?.setAttribute("d", d);
`;
}

function react({ imports, data }: Written, print: string): string {
  return `import { useMemo, useState } from ${quoted("react")};
${imports}

${data}

export function Drawing() {
  const [drag, setDrag] = useState<{ x: number; y: number } | null>(null);
  const d = useMemo(() => {
    if (drag !== null) curves[0]?.setPoint(0, drag.x, drag.y);
    return ${print};
  }, [drag]);
  return (
    <svg viewBox="0 0 800 600" onPointerMove={(e) => e.buttons === 1 && setDrag({ x: e.nativeEvent.offsetX, y: e.nativeEvent.offsetY })}>
      <path d={d} fill="none" stroke="currentColor" strokeWidth={2} />
    </svg>
  );
}
`;
}

function vue({ imports, data }: Written, print: string): string {
  return `<script setup lang="ts">
import { shallowRef, triggerRef, computed } from ${quoted("vue")};
${imports}

${data}

const model = shallowRef(curves);
const d = computed(() => model.value && ${print});
function move(event: PointerEvent) {
  if (event.buttons !== 1) return;
  curves[0]?.setPoint(0, event.offsetX, event.offsetY);
  triggerRef(model);
}
</script>

<template>
  <svg viewBox="0 0 800 600" @pointermove="move">
    <path :d="d" fill="none" stroke="currentColor" stroke-width="2" />
  </svg>
</template>
`;
}

function svelte({ imports, data }: Written, print: string): string {
  return `<script lang="ts">
  ${imports}

  ${indent(data, "  ")}

  const path = () => ${print};
  let d = $state(path());
  function move(event: PointerEvent) {
    if (event.buttons !== 1) return;
    curves[0]?.setPoint(0, event.offsetX, event.offsetY);
    d = path();
  }
</script>

<svg viewBox="0 0 800 600" onpointermove={move}>
  <path {d} fill="none" stroke="currentColor" stroke-width="2" />
</svg>
`;
}

function worker({ imports, data }: Written, print: string): string {
  return `// worker.ts: the same import works in a worker, in Node and on a server
${imports}

${data}

self.onmessage = () => {
  const d = ${print};
  const points = curves[0]?.sample(1000);   // Float64Array x0, y0, x1, y1, …
  self.postMessage({ d, points }, points === undefined ? [] : [points.buffer]);
};

// page.ts
// const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
// worker.onmessage = (event) => document.querySelector("path")?.setAttribute("d", event.data.d);
// worker.postMessage("draw");
`;
}

/**
 * Characters from either end of a program that are shown: laying out the megabytes of a very large drawing takes many
 * seconds.
 */
const shownAtEnds = 50_000;
/** Longer programs are shown in part. */
export const mostShown = 2 * shownAtEnds;

/** A program as it is shown, with its middle left out where it is very long. */
export function abridged(program: string): string {
  const left = program.length - mostShown;
  if (left <= 0) return program;
  return `${program.slice(0, shownAtEnds)}\n\n… ${left.toLocaleString("en")} characters are left out here; Copy takes all of it …\n\n${program.slice(-shownAtEnds)}`;
}
