import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

/** The drawing of who may import whom, read from the imports themselves. */
const allowed: Readonly<Record<string, readonly string[]>> = {
  document: [],
  kernel: ["document"],
  editor: ["document", "kernel"],
  tools: ["document", "editor"],
  render: ["document", "editor", "kernel"],
  panels: ["document", "editor", "kernel"],
  io: ["document", "kernel"],
};

/** The rooms of the panels: a file beside them (what all are handed; what puts them together) is none. */
const allowedInPanels: Readonly<Record<string, readonly string[]>> = {
  messages: [],
  controls: ["messages"],
  shell: [],
  stage: ["controls", "shell"],
  mode: ["controls", "shell"],
  code: ["messages", "controls", "shell"],
  files: ["messages", "controls", "shell"],
  curve: ["controls", "shell", "mode"],
  fit: ["controls", "shell", "mode"],
  surface: ["controls", "shell", "mode"],
  trace: ["controls", "shell", "mode", "files"],
  dialogs: ["messages", "controls", "shell", "code", "curve", "files"],
  page: ["controls", "shell", "mode", "code", "curve"],
};

const source = "www/src";

function filesUnder(folder: string, ending: string): string[] {
  return readdirSync(folder, { recursive: true, encoding: "utf8" })
    .filter((name) => name.endsWith(ending))
    .map((name) => join(folder, name));
}

function roomOf(file: string): string {
  const [room, inner] = file.slice(source.length + 1).split("/");
  return inner === undefined ? "main" : (room ?? "");
}

function importsOf(file: string): string[] {
  // The page shows code as well: what stands in a template is a text, not an import.
  const code = readFileSync(file, "utf8").replace(/`(?:\\.|[^`\\])*`/gs, "``");
  return [...code.matchAll(/(?:(?:from|import)\s+|import\()"([^"]+)"/g)].map((match) => match[1] ?? "");
}

test("rooms import only what the drawing allows", () => {
  const strays: string[] = [];
  for (const file of filesUnder(source, ".ts")) {
    const room = roomOf(file);
    if (room === "main") continue;
    const rooms = allowed[room];
    assert.ok(rooms !== undefined, `${file} is in a room that the drawing does not have`);
    for (const name of importsOf(file).filter((each) => each.startsWith(".") && !each.endsWith(".css"))) {
      const target = roomOf(join(file, "..", name));
      if (target !== room && !rooms.includes(target)) strays.push(`${file}: ${room} -> ${target}`);
    }
  }
  assert.deepEqual(strays, []);
});

test("inside the panels, a mode's room knows no other mode's, and the page around the stage no file", () => {
  const panels = join(source, "panels");
  const innerRoomOf = (file: string): string | undefined => {
    const [room, inner] = file.slice(panels.length + 1).split("/");
    if (inner !== undefined) return room;
    return room === "shell.ts" || room === "page-io.ts" ? "shell" : undefined;
  };
  const strays: string[] = [];
  for (const file of filesUnder(panels, ".ts")) {
    const room = innerRoomOf(file);
    if (room === undefined) continue;
    const rooms = allowedInPanels[room];
    assert.ok(rooms !== undefined, `${file} is in a room that the drawing does not have`);
    for (const name of importsOf(file)) {
      const target = join(file, "..", name);
      if (!target.startsWith(`${panels}/`)) continue;
      const other = innerRoomOf(target) ?? target;
      if (other !== room && !rooms.includes(other)) strays.push(`${file}: ${room} -> ${other}`);
    }
  }
  assert.deepEqual(strays, []);
});

/**
 * What is left of files and their imports when those are taken away from which nothing leads on, one after the other.
 */
function inCircles(arrows: ReadonlyMap<string, readonly string[]>): string[] {
  let left = new Map(arrows);
  for (;;) {
    const further = new Map([...left].filter(([, targets]) => targets.some((target) => left.has(target))));
    if (further.size === left.size) return [...left.keys()];
    left = further;
  }
}

test("no files import each other, by whatever way round, neither the demo's nor the package's nor the documentation's", () => {
  for (const folder of [source, "ts", "site"]) {
    const files = filesUnder(folder, ".ts");
    const near = (file: string): string[] => importsOf(file).filter((name) => name.startsWith("."));
    // The package names its files as they will be called.
    const path = (file: string, name: string): string => join(file, "..", name).replace(/\.js$/, ".ts");
    const arrows = new Map(files.map((file) => [file, near(file).map((name) => path(file, name))]));
    assert.ok([...arrows.values()].flat().some((target) => arrows.has(target)), `imports of ${folder} were found`);
    assert.deepEqual(inCircles(arrows), [], "files that lead into a circle");
  }
  assert.deepEqual(inCircles(new Map([["a", ["b"]], ["b", ["c"]], ["c", ["b"]], ["d", ["e"]]])), ["a", "b", "c"], "a planted circle");
});

/** The one file that draws in three dimensions, loaded with Surface mode alone. */
const shaded = join(source, "render", "surface", "shaded-view.ts");

test("only the kernel imports the library, only the shaded view the 3-D library, and nothing imports another package", () => {
  const strays: string[] = [];
  for (const file of filesUnder(source, ".ts")) {
    for (const name of importsOf(file)) {
      if (name.startsWith(".") || (/^expline(?:\/|$)/.test(name) && roomOf(file) === "kernel")) continue;
      if (name === "three" && file === shaded) continue;
      strays.push(`${file}: ${name}`);
    }
  }
  assert.deepEqual(strays, []);
});

/** The documentation's own code: what its rooms may import of each other, and which packages. */
const siteAllowed: Readonly<Record<string, { readonly rooms: readonly string[]; readonly packages: RegExp }>> = {
  page: { rooms: ["figures"], packages: /^minisearch$/ },
  figures: { rooms: [], packages: /^expline$/ },
  playground: { rooms: ["figures"], packages: /^(?:expline$|@codemirror\/|@lezer\/)/ },
};

test("the documentation's figures know the package by its name alone, and nothing else of the clone", () => {
  const strays: string[] = [];
  const roomOfSite = (file: string): string => /^site\/(figures|playground)\//.exec(file)?.[1] ?? "page";
  for (const file of filesUnder("site", ".ts")) {
    const { rooms, packages } = siteAllowed[roomOfSite(file)] ?? { rooms: [], packages: /^$/ };
    for (const name of importsOf(file)) {
      const target = join(file, "..", name);
      const room = roomOfSite(target);
      const isAllowed = name.startsWith(".") ? target.startsWith("site/") && (room === roomOfSite(file) || rooms.includes(room)) : packages.test(name);
      if (!isAllowed) strays.push(`${file}: ${name}`);
    }
  }
  assert.deepEqual(strays, []);
  const styles = filesUnder("site/styles", ".css").map((file) => readFileSync(file, "utf8")).join("\n");
  assert.doesNotMatch(styles, /#[0-9a-f]{3,8}\b(?![^{]*\{)|\b(?:rgb|hsl|oklch)a?\(/i, "colours are tokens");
});

test("every custom property that a style sheet uses is set by one, or by the program", () => {
  const styles = filesUnder(join(source, "styles"), ".css").map((file) => readFileSync(file, "utf8")).join("\n");
  const program = filesUnder(source, ".ts").map((file) => readFileSync(file, "utf8")).join("\n");
  const used = new Set([...styles.matchAll(/var\((--[\w-]+)/gu)].map(([, name = ""]) => name));
  const isSet = (name: string): boolean => new RegExp(`${name}:`, "u").test(styles) || program.includes(`"${name}"`);
  assert.deepEqual([...used].filter((name) => !isSet(name)), []);
});

test("only tokens.css holds literal colours", () => {
  const strays = filesUnder(join(source, "styles"), ".css")
    .filter((file) => !file.endsWith("tokens.css"))
    .flatMap((file) => (/#[0-9a-f]{3,8}\b|\b(?:rgb|hsl|oklch)a?\(/i.test(readFileSync(file, "utf8")) ? [file] : []));
  assert.deepEqual(strays, []);
});

test("files stay short enough to be read at one sitting", () => {
  const longest = 400;
  const long = [...filesUnder(source, ".ts"), ...filesUnder(source, ".css")]
    .map((file) => ({ file, lines: readFileSync(file, "utf8").split("\n").length }))
    .filter(({ lines }) => lines > longest);
  assert.deepEqual(long, []);
});

test("folders hold few enough files to be seen at one look", () => {
  const most = 12;
  const count = new Map<string, number>();
  for (const file of filesUnder(source, ".ts")) count.set(join(file, ".."), (count.get(join(file, "..")) ?? 0) + 1);
  assert.deepEqual([...count].filter(([, files]) => files > most), []);
});

test("the page has no inline script, style or event handler, so that its Content Security Policy can forbid them", () => {
  const page = readFileSync("www/index.html", "utf8");
  assert.doesNotMatch(page, /\sstyle=|<style|\son\w+=/);
  assert.doesNotMatch(page, /<script(?![^>]*\ssrc=)/);
});
