import assert from "node:assert/strict";
import { test } from "node:test";
import * as library from "expline/slim";
import type { Contour } from "../src/document/document.ts";
import { createEditor } from "../src/editor/create-editor.ts";
import { refineCurveHere, setFamily, setOrder, setOmega } from "../src/editor/curve/family-edits.ts";
import { insertAt } from "../src/editor/curve/contour-edits.ts";
import { setSpace } from "../src/editor/curve/edits.ts";
import { setLevel } from "../src/editor/curve/level-edits.ts";
import { chooseNet, openSurfaceSample, placeNet, refineHere, setSurfaceLevels } from "../src/editor/surface/surface-edits.ts";
import { fitSample } from "../src/document/fit/fit-samples.ts";
import { opened } from "../src/editor/fit/fit-edits.ts";
import { subjectOf } from "../src/editor/fit/fit-question.ts";
import type { FitOutcome } from "../src/kernel/fit/outcome.ts";
import { meshPoints } from "../src/kernel/surface/surface.ts";
import { snippetFor, snippetNames } from "../src/panels/code/snippets.ts";
import { fitProgram } from "../src/panels/fit/fit-program.ts";
import { surfaceProgram } from "../src/panels/surface/surface-program.ts";
import { Hand, handOf, longContour } from "./harness.ts";

const options = { segments: "arcs", tolerance: 0.02, decimals: 3, relative: false } as const;

type Curve = library.Curve & { setPoint(i: number, x: number, y: number): void };

/** Runs a program as somebody would who has installed the package, and gives back one of its values. */
function run(program: string, value: string): unknown {
  const imports = /^import \{ ([^}]*) \} from "expline";.*$/mu.exec(program);
  assert.ok(imports, program);
  const names = (imports[1] ?? "").split(", ");
  for (const name of names) assert.ok(name in library, `the package has ${name}`);
  const path = { setAttribute: (_: string, d: string): void => assert.match(d, /^$|^M[^a-df-zA-DF-Z]/u) };
  const page = { querySelector: () => path };
  const made = new Function("library", "document", `const { ${names.join(", ")} } = library;\n${program.replace(imports[0], "")}\nreturn ${value};`);
  return made(library, page);
}

/** The program's curves go the ways of those on the stage, to what twelve printed digits leave. */
function assertReproduced(hand: Hand, what: string): void {
  const curves = run(snippetFor("vanilla", hand.curve, options), "curves") as Curve[];
  const contours = hand.curve.contours.filter(({ points }) => points.length > 1);
  assert.equal(curves.length, contours.length, what);
  contours.forEach((contour, c) => {
    const [own, made] = [hand.sample(500, hand.curve.contours.indexOf(contour)), curves[c]?.sample(500)];
    assert.ok(made);
    own.forEach((value, i) => assert.ok(Math.abs(value - (made[i] ?? NaN)) <= 1e-7, `${what}: sample ${i >> 1} of contour ${c}: ${made[i]} for ${value}`));
  });
}

const choose = (hand: Hand, index: number, contour = 0): void => hand.editor.patch({ selection: { points: [{ contour, index }], handle: null } });

test("the program of every sample makes the sample's curves", () => {
  for (const id of ["circle-2", "ellipse", "circle-8", "cycloid", "sine", "hyperbola", "heart", "blob-16", "glyph", "net-64"]) assertReproduced(new Hand(id), id);
});

test("the program makes curves with what was changed of them: space, frequency, level, a point more", () => {
  const worked: Readonly<Record<string, (hand: Hand) => unknown>> = {
    hyperbolic: ({ editor }) => setSpace(editor, "hyperbolic"),
    polynomial: ({ editor }) => setSpace(editor, "polynomial"),
    frequency: ({ editor }) => setOmega(editor, editor.state.value.selection, 1.25),
    level: ({ editor }) => setLevel(editor, 2),
    inserted: ({ editor }) => insertAt(editor, 0, 0.37),
    "level, then inserted": ({ editor }) => { setLevel(editor, 1); insertAt(editor, 0, 0.2); },
  };
  for (const sample of ["circle-8", "heart", "sine"]) {
    for (const [name, work] of Object.entries(worked)) {
      const hand = new Hand(sample);
      work(hand);
      assertReproduced(hand, `${sample}, ${name}`);
    }
  }
});

test("the program of a contour through its points has no tangents: as it is, smoother, open, finer, and finer in one place", () => {
  const worked: Readonly<Record<string, (hand: Hand) => unknown>> = {
    "as it is": () => undefined,
    "of 4 roots": ({ editor }) => setOrder(editor, 4),
    "of 5 roots": ({ editor }) => setOrder(editor, 5),
    "hyperbolic": ({ editor }) => setSpace(editor, "hyperbolic"),
    "finer": ({ editor }) => setLevel(editor, 2),
    "finer in one place": (hand) => {
      choose(hand, 3);
      refineCurveHere(hand.editor);
      choose(hand, (hand.curve.contours[0]?.points.length ?? 0) - 2);
      hand.run("nudge-right");
    },
  };
  for (const sample of ["blob-16", "sine"]) {
    for (const [name, work] of Object.entries(worked)) {
      const hand = new Hand(sample);
      setFamily(hand.editor, "interpolating");
      work(hand);
      assertReproduced(hand, `${sample}, ${name}`);
      for (const [id] of snippetNames) assert.doesNotMatch(snippetFor(id, hand.curve, options), /HermiteCurve|tangents/u);
    }
  }
});

test("of a drawing with curves of several kinds the program has each as what it is", () => {
  const [blob, circle] = [new Hand("blob-16"), new Hand("circle-8")];
  const both: Contour[] = [...blob.curve.contours, ...circle.curve.contours, longContour(300)];
  const hand = handOf(both);
  assertReproduced(hand, "three contours");
  assert.match(snippetFor("worker", hand.curve, options), /^import \{ HermiteCurve, InterpolatingCurve \} from "expline";$/mu);
});

test("the program of a surface makes it, whatever was done to it", () => {
  const mesh = 33;
  for (const sample of ["surf-sphere", "surf-torus", "surf-roman", "surf-paraboloid", "surf-cylinder", "surf-character"]) {
    for (const work of ["none", "levels", "moved", "refined"]) {
      let time = 0;
      const editor = createEditor(() => (time += 1000));
      editor.patch({ mode: "surface" });
      openSurfaceSample(editor, sample);
      if (work === "levels") setSurfaceLevels(editor, 1, 0);
      chooseNet(editor, [{ u: 1, v: 2 }]);
      if (work === "refined") refineHere(editor);
      if (work !== "none") placeNet(editor, 0, 0.37);
      const made = run(surfaceProgram(editor.state.value), "surface") as library.TensorSurface;
      const own = meshPoints(editor.state.value.surface, mesh, mesh);
      // Twelve printed digits of coordinates of a few units.
      made.mesh(mesh, mesh).positions.forEach((value, i) => assert.ok(Math.abs(value - (own[i] ?? NaN)) <= 1e-10, `${sample}, ${work}: ${value} for ${own[i]}`));
    }
  }
});

test("the program of a fit asks for what the page asks for, whatever is chosen", async () => {
  await library.initFit();
  const sample = fitSample("fit-roundrect");
  assert.ok(sample);
  const plain = opened(sample);
  for (const model of ["linear", "cubic", "hybrid"] as const) {
    for (const corners of [true, false]) {
      for (const target of ["off", "error", "knots"] as const) {
        const fit = { ...plain, model, corners, target, mix: 30, targetError: 4, targetKnots: 6 };
        const subject = subjectOf(fit, false);
        const [stroke] = subject?.strokes ?? [];
        assert.ok(subject && stroke);
        const { degree, mix } = subject;
        // For a number of knots the page looks for a smoothing, which lies between the steps of the slider.
        const found = 0.361328125;
        const asked = target === "error" ? { tolerance: fit.targetError } : { smoothing: target === "knots" ? found : fit.smoothing / 100 };
        const page = library.fitSparse(stroke.points, { degree, corners, closed: stroke.closed, ...(typeof degree === "number" ? {} : { mix }), ...asked });
        const { state } = createEditor(() => 0);
        const program = fitProgram({ ...state.value, fit, fitRun: { ...state.value.fitRun, outcome: { smoothing: 100 * found } as FitOutcome } });
        const fetched = program.replace(/await \(await fetch\("points\.json"\)\)\.json\(\)/u, JSON.stringify([...stroke.points]));
        const made = run(fetched.replace(/^console\.log.*$/mu, ""), "fit") as library.SparseFit;
        assert.deepEqual(Array.from(made.curve.sample(200)), Array.from(page.curve.sample(200)), `${model}, ${corners ? "" : "no "}corners, ${target}`);
      }
    }
  }
});
