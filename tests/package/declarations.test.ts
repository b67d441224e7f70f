// What an editor shows of the package: every name and every member says what it is.

import assert from "node:assert/strict";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { dirname, join } from "node:path";

import ts from "typescript";

import { CONSUMER, runs } from "./snippet.ts";

const DECLARATIONS = join(CONSUMER, "node_modules", "expline", "pkg", "types", "index.d.ts");

/** Everything that the package exports, by the name that it has there. */
function exported(checker: ts.TypeChecker, file: ts.SourceFile): [string, ts.Symbol][] {
  const module = checker.getSymbolAtLocation(file);
  assert.ok(module, "the declarations are a module");
  return checker.getExportsOfModule(module).map((symbol) => [symbol.name, symbol.flags & ts.SymbolFlags.Alias ? checker.getAliasedSymbol(symbol) : symbol]);
}

/** Members that users see: not private names, not what only the package calls. */
function members(symbol: ts.Symbol): ts.Symbol[] {
  const all = [...(symbol.members?.values() ?? []), ...(symbol.exports?.values() ?? [])];
  const hidden = /^(?:prototype$|__(?!constructor)|#|[^\w$])/;
  return all.filter((member) => !hidden.test(member.name) && !member.getJsDocTags().some(({ name }) => name === "internal"));
}

test("every name of the package and every member of it says what it is", () => {
  const program = ts.createProgram([DECLARATIONS], { target: ts.ScriptTarget.ES2022, noLib: true, types: [] });
  const checker = program.getTypeChecker();
  const file = program.getSourceFile(DECLARATIONS);
  assert.ok(file, DECLARATIONS);
  const silent: string[] = [];
  let count = 0;
  for (const [name, symbol] of exported(checker, file)) {
    const own: [string, ts.Symbol][] = [[name, symbol], ...members(symbol).map((member): [string, ts.Symbol] => [`${name}.${member.name}`, member])];
    count += own.length;
    for (const [place, thing] of own) if (thing.getDocumentationComment(checker).length === 0) silent.push(place);
  }
  assert.ok(count > 300, `only ${count} were looked at`);
  assert.deepEqual(silent, []);
});

test("an editor shows what it is doing beside every way to call a function", () => {
  const folder = dirname(DECLARATIONS);
  const silent: string[] = [];
  let overloads = 0;
  for (const name of readdirSync(folder, { recursive: true, encoding: "utf8" }).filter((name) => name.endsWith(".d.ts"))) {
    const file = ts.createSourceFile(name, readFileSync(join(folder, name), "utf8"), ts.ScriptTarget.ES2022, true);
    const visit = (node: ts.Node): void => {
      if (ts.isFunctionDeclaration(node) || ts.isMethodDeclaration(node)) {
        overloads += 1;
        if (ts.getJSDocCommentsAndTags(node).length === 0 && !node.name?.getText().startsWith("[")) silent.push(`${name}: ${node.getText()}`);
      }
      ts.forEachChild(node, visit);
    };
    visit(file);
  }
  assert.ok(overloads > 100, `only ${overloads} were looked at`);
  assert.deepEqual(silent, []);
});

test("every example runs, and prints what it says", async () => {
  const folder = dirname(DECLARATIONS);
  const names = Object.keys((await import("expline")) as Record<string, unknown>).filter((name) => name !== "default");
  const files = readdirSync(folder, { recursive: true, encoding: "utf8" }).filter((name) => name.endsWith(".d.ts"));
  const examples = files.flatMap((name) => [...readFileSync(join(folder, name), "utf8").matchAll(/@example\n\s*\* ```js\n([\s\S]*?)\* ```$/gm)]);
  assert.ok(examples.length >= 12, `only ${examples.length} examples`);
  for (const [i, [, text = ""]] of examples.entries()) {
    const code = text.replace(/^\s*\* /gm, "");
    assert.match(code, /^console\.log\(.*\); \/\/ → .+$/m, "an example that says what comes out");
    runs(`example-${i}`, `import { ${names.join(", ")} } from "expline";\n${code}`);
  }
});

/**
 * What TypeScript 5.0 cannot read: typed arrays that say what they lie on came with 5.7, the part of the library for
 * `using` with 5.2.
 */
function tooNew(file: ts.SourceFile): string[] {
  const found = file.libReferenceDirectives.map(({ fileName }) => `lib ${fileName}`);
  const visit = (node: ts.Node): void => {
    const generic = ts.isTypeReferenceNode(node) && node.typeArguments !== undefined;
    if (generic && /^(?:Big)?(?:Int|Uint|Float)\w*Array$|^DataView$/.test(node.typeName.getText(file))) found.push(node.getText(file));
    ts.forEachChild(node, visit);
  };
  visit(file);
  return found;
}

test("TypeScript from 5.0 on reads the declarations", () => {
  const folder = dirname(DECLARATIONS);
  const files = readdirSync(folder, { recursive: true, encoding: "utf8" }).filter((name) => name.endsWith(".d.ts"));
  assert.ok(files.length > 20, `only ${files.length} were looked at`);
  const found = files.flatMap((name) => {
    const text = readFileSync(join(folder, name), "utf8");
    return tooNew(ts.createSourceFile(name, text, ts.ScriptTarget.ES2022)).map((what) => `${name}: ${what}`);
  });
  assert.deepEqual(found, []);
});

test("a CommonJS file requires the package and has its types, whatever TypeScript knows of Node", () => {
  const file = join(CONSUMER, "require.cts");
  writeFileSync(file, `
    import expline = require("expline");
    import init, { HermiteCurve, type Curve } from "expline";
    import * as slim from "expline/slim";
    import { jointOf } from "expline/edit";
    const circle: Curve = HermiteCurve.ellipse({ center: [0, 0], radii: [1, 1], count: 2 });
    const same: expline.HermiteCurve = new expline.HermiteCurve({ points: [0, 0, 1, 1], tangents: [1, 0, 0, 1] });
    export const all: [Promise<void>, Promise<void>, string, Float64Array, string] = [init(), expline.default(), slim.version, circle.sample(3), jointOf(same, 0)];
    // @ts-expect-error there is no such name
    export const none = expline.HermitCurve;
  `);
  for (const kind of [ts.ModuleKind.Node16, ts.ModuleKind.NodeNext]) {
    const moduleResolution = kind === ts.ModuleKind.Node16 ? ts.ModuleResolutionKind.Node16 : ts.ModuleResolutionKind.NodeNext;
    const options = { module: kind, moduleResolution, esModuleInterop: true, noEmit: true, target: ts.ScriptTarget.ES2022, lib: ["lib.es2022.d.ts"], types: [], strict: true };
    const all = ts.getPreEmitDiagnostics(ts.createProgram([file], options));
    assert.deepEqual(all.map(({ messageText }) => ts.flattenDiagnosticMessageText(messageText, " ")), []);
  }
});

/** What the compiler says of a file that uses the package, with so much of TypeScript's library and nothing else. */
function complaints(code: string, ...lib: string[]): string[] {
  const file = join(dirname(DECLARATIONS), "..", "..", "..", "..", "use.ts");
  writeFileSync(file, code);
  const kind = { module: ts.ModuleKind.ESNext, moduleResolution: ts.ModuleResolutionKind.Bundler, noEmit: true };
  const options = { ...kind, target: ts.ScriptTarget.ES2022, lib: lib.map((part) => `lib.${part}.d.ts`), types: [], strict: true, exactOptionalPropertyTypes: true, noUncheckedIndexedAccess: true };
  const all = ts.getPreEmitDiagnostics(ts.createProgram([file], options));
  return all.map(({ messageText }) => ts.flattenDiagnosticMessageText(messageText, " "));
}

test("the declarations hold where no browser is declared, and the library is of ES2020", () => {
  const code = `
    import init, { ExplineError, ExponentialBSpline, HermiteGenerators, type InitOptions, type SparseFitAllOptions, fitSparseAll } from "expline";
    const options: InitOptions = { wasmUrl: "a.wasm", bytes: undefined, module: undefined };
    const alike: SparseFitAllOptions = { tolerance: 1 };
    const reason = (error: unknown) => (error instanceof ExplineError ? error.cause : undefined);
    export const all = [init(options), fitSparseAll([], alike), reason, new ExponentialBSpline([0]).evaluate([1, 2]), new HermiteGenerators(1).evaluate(0.5)];
    export const classes: (new (...parts: any[]) => Error)[] = [ExplineError];
    // @ts-expect-error errors are made by the package alone
    new ExplineError("hi");
    // @ts-expect-error so they are with whatever the package itself makes them of
    new ExplineError("E_TYPE", "me", "this");
  `;
  for (const lib of ["es2020", "es2022"]) assert.deepEqual(complaints(code, lib), [], lib);
});

test("where a browser is declared, addresses and signals are its own", () => {
  const code = `
    import init, { fitSparse, traceImage } from "expline";
    const { signal } = new AbortController();
    export const all = [init({ wasmUrl: new URL("a.wasm", "https://example.org") }), fitSparse([], { signal }), traceImage(new ImageData(1, 1), { signal })];
    // @ts-expect-error a signal has more to it
    fitSparse([], { signal: { aborted: false } });
  `;
  assert.deepEqual(complaints(code, "es2022", "dom"), []);
});

test("what is read from data of any type may be any curve or surface, and of a type that is known it is just that", () => {
  const code = `
    import { HermiteCurve, type HermiteCurveJSON, TensorSurface, type TensorSurfaceJSON, fromJSON } from "expline";
    declare const surface: TensorSurfaceJSON, either: TensorSurfaceJSON | HermiteCurveJSON, text: string;
    // @ts-expect-error what JSON.parse gives may be of another kind
    const wrong: HermiteCurve = fromJSON(JSON.parse(text));
    const curve: HermiteCurve = fromJSON(JSON.parse(text) as HermiteCurveJSON);
    const same: HermiteCurve = fromJSON(curve.toJSON(), { onWarning: ({ path }) => console.log(path) });
    const found = [fromJSON(JSON.parse(text)), fromJSON(text), fromJSON(either)].filter((thing) => thing instanceof TensorSurface);
    export const all = [wrong, same, fromJSON(surface).net, found.length];
  `;
  assert.deepEqual(complaints(code, "es2022", "dom"), []);
});

test("a curve that is split has a first part, and one to take the place of it", () => {
  const code = `
    import { type HermiteCurve, parsePath } from "expline";
    const curves: HermiteCurve[] = parsePath("M0 0H9");
    const [curve] = parsePath("M0 0H9");
    if (curve !== undefined) curves.splice(0, 1, ...curve.split(0.5));
    export const [first, second]: readonly HermiteCurve[] = curve?.split(0.5) ?? [];
    export const opened: HermiteCurve | undefined = curve?.split(0.5)[0];
    export const length = curve === undefined ? 0 : curve.split(0.5)[0].length();
  `;
  assert.deepEqual(complaints(code, "es2022"), []);
});

test("a matrix is a list as programs have it, and an image is of the kind of what was mapped", () => {
  const code = `
    import { type BSplineCurve, type Curve, type HermiteCurve, InterpolatingCurve, type LocalCurve, type MatrixLike, TensorSurface, parsePath } from "expline";
    declare const list: number[], read: readonly number[], { a, b, c, d, e, f }: DOMMatrix;
    const matrices: MatrixLike[] = [list, read, [a, b, c, d, e, f], new DOMMatrix().toFloat32Array(), new DOMMatrix().toFloat64Array()];
    const curve = new InterpolatingCurve({ points: list, dimension: 3 });
    const images: [InterpolatingCurve, BSplineCurve, LocalCurve, TensorSurface] = [
      curve.transform(list), curve.refine(1).transform(read), curve.refineAt(1).transform(list), TensorSurface.sphere(1).transform(new DOMMatrix().toFloat32Array()),
    ];
    const exact: HermiteCurve | undefined = parsePath("M0 0H9")[0]?.transform(list);
    const items: { curve: Curve }[] = [{ curve }];
    export const all = [matrices, images, exact, items.map((item) => ({ ...item, curve: item.curve.transform(list) })) satisfies typeof items];
    // @ts-expect-error a matrix is a list, not an object
    curve.transform(new DOMMatrix());
  `;
  assert.deepEqual(complaints(code, "es2022", "dom"), []);
});
