import { lengthOf, omegaOf, segmentCount, type Contour, type CurveDocument } from "../../document/document.ts";

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

/** Twelve digits: far below what a screen or a file shows, and free of rounding noise. */
function number(value: number): string {
  if (Math.abs(value) < 1e-12) return "0";
  return String(Number(value.toPrecision(12)) + 0);
}

function pairs(values: readonly (readonly [number, number])[]): string {
  const printed = values.map(([x, y]) => `[${number(x)}, ${number(y)}]`);
  const line = `[${printed.join(", ")}]`;
  if (line.length <= 84) return line;
  const rows: string[] = [];
  for (let i = 0; i < printed.length; i += 4) rows.push(`    ${printed.slice(i, i + 4).join(", ")},`);
  return `[\n${rows.join("\n")}\n  ]`;
}

function numbers(values: readonly number[]): string {
  return `Float64Array.of(${values.map(number).join(", ")})`;
}

/** `new HermiteCurve({ … })` for a contour: drawn handles are a third of the tangents. */
function construction(curve: CurveDocument, contour: Contour): string {
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
  const isDefault = one && contour.omega === undefined && curve.omega === "auto";
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

/** `const curves = [ … ];` */
function curvesOf(curve: CurveDocument, exported = ""): string {
  const parts = curve.contours.filter((contour) => contour.points.length > 1).map((contour) => construction(curve, contour));
  if (parts.length === 0) return `${exported}const curves: HermiteCurve[] = [];`;
  return `${exported}const curves = [\n${parts.map((part) => `  ${indent(part, "  ")},`).join("\n")}\n];`;
}

function printing({ segments, tolerance, decimals, relative }: PrintOptions): string {
  const parts = [`tolerance: ${number(tolerance)}`, `decimals: ${decimals}`, segments === "cubics" ? "arcs: false" : "", relative ? "relative: true" : ""];
  return `{ ${parts.filter((part) => part !== "").join(", ")} }`;
}

export function snippetFor(id: SnippetId, curve: CurveDocument, options: PrintOptions): string {
  const print = `curves.map((curve) => curve.toPathD(${printing(options)}).d).join("")`;
  const data = curvesOf(curve);
  switch (id) {
    case "vanilla":
      return vanilla(data, print);
    case "react":
      return react(data, print);
    case "vue":
      return vue(data, print);
    case "svelte":
      return svelte(data, print);
    case "worker":
      return worker(data, print);
  }
}

function vanilla(data: string, print: string): string {
  return `import { HermiteCurve } from ${library};   // npm i expline; no await, no bundler setup

${data}

// Edit: move a point, add one without changing the shape, ask for the nearest place.
const [first] = curves;
const finer = first?.insert(0.5);
const hit = first?.nearest(400, 140);       // { t, x, y, distance }

// Export: path text, arcs where the curve is an arc; maxError is measured.
const d = ${print};
document.querySelector("path")?.setAttribute("d", d);
`;
}

function react(data: string, print: string): string {
  return `import { useMemo, useState } from ${quoted("react")};
import { HermiteCurve } from ${library};

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

function vue(data: string, print: string): string {
  return `<script setup lang="ts">
import { shallowRef, triggerRef, computed } from ${quoted("vue")};
import { HermiteCurve } from ${library};

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

function svelte(data: string, print: string): string {
  return `<script lang="ts">
  import { HermiteCurve } from ${library};

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

function worker(data: string, print: string): string {
  return `// worker.ts: the same import works in a worker, in Node and on a server
import { HermiteCurve } from ${library};

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

/** Characters from either end of a program that are shown: laying out the megabytes of a very large drawing takes many seconds. */
const shownAtEnds = 50_000;

/** A program as it is shown, with its middle left out where it is very long. */
export function abridged(program: string): string {
  const left = program.length - 2 * shownAtEnds;
  if (left <= 0) return program;
  return `${program.slice(0, shownAtEnds)}\n\n… ${left.toLocaleString("en")} characters are left out here; Copy takes all of it …\n\n${program.slice(-shownAtEnds)}`;
}
