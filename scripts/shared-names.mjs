// What the modules of the package export for each other only, under the short names that it has inside: the long ones
// are for those who read the sources. They would be in every module that imports them, too.

const EXPORTS = /export\{([^{}]*)\};\s*$/;
const IMPORTS = /import\{([^{}]*)\}from"\.\/([^"]*)"/g;

/** The names in a list, as [what it has, what it is called from here on]. */
const pairsIn = (list) => list.split(",").map((each) => [...each.split(" as "), each].slice(0, 2));
const listOf = (pairs) => pairs.map(([from, to]) => (from === to ? from : `${from} as ${to}`)).join(",");

/** What a module exports, as [name inside, name outside]. */
const exportsOf = (code) => pairsIn(EXPORTS.exec(code)?.[1] ?? "");

/** The names that an entry passes on. */
export function namesOf(entry) {
  return new Set(exportsOf(entry).map(([, name]) => name));
}

/** Modules by their files, minified, with what is not among the names offered to everybody called as it is inside. */
export function withSharedNames(modules, offered) {
  const shortened = new Map();
  for (const [file, code] of modules) {
    const shared = exportsOf(code).filter(([, name]) => !offered.has(name));
    shortened.set(file, new Map(shared.map(([inside, name]) => [name, inside])));
  }
  const short = (file, name) => shortened.get(file)?.get(name) ?? name;
  const renamed = [...modules].map(([file, code]) => {
    const exported = exportsOf(code).map(([inside, name]) => [inside, short(file, name)]);
    if (new Set(exported.map(([, name]) => name)).size < exported.length) throw new Error(`${file}: two exports would have one name`);
    const imported = code.replace(IMPORTS, (_, list, from) => `import{${listOf(pairsIn(list).map(([name, inside]) => [short(from, name), inside]))}}from"./${from}"`);
    return [file, imported.replace(EXPORTS, () => `export{${listOf(exported)}};\n`)];
  });
  return new Map(renamed);
}
