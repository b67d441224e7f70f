/** Options of the command line: `--name value`, `--name=value`, `--name`, `-o value`. */
import { Failure, USAGE } from "./failure.ts";

/** What a command takes: whether an option has a value, and what it is for. */
export interface Flag {
  readonly value?: string;
  readonly short?: string;
  readonly about: string;
}

export interface Given {
  readonly operands: readonly string[];
  /** The value of an option; an empty text for one that takes none. */
  readonly values: ReadonlyMap<string, string>;
}

/** Reads the words after the command. A lone `-` is an operand, and after `--` everything is. */
export function readFlags(words: readonly string[], flags: Readonly<Record<string, Flag>>): Given {
  const operands: string[] = [];
  const values = new Map<string, string>();
  const list = [...words];
  for (let word = list.shift(); word !== undefined; word = list.shift()) {
    if (word === "--") {
      operands.push(...list.splice(0));
    } else if (word === "-" || !word.startsWith("-")) {
      operands.push(word);
    } else {
      const [written = "", ...rest] = word.split("=");
      const name = nameOf(written, flags);
      const flag = flags[name];
      if (values.has(name)) throw new Failure(USAGE, `--${name} is given twice`);
      if (flag?.value === undefined) {
        if (rest.length > 0) throw new Failure(USAGE, `--${name} takes no value`);
        values.set(name, "");
      } else {
        const value = rest.length > 0 ? rest.join("=") : list.shift();
        if (value === undefined) throw new Failure(USAGE, `--${name} needs a value: ${flag.value}`);
        values.set(name, value);
      }
    }
  }
  return { operands, values };
}

function nameOf(written: string, flags: Readonly<Record<string, Flag>>): string {
  const name = written.startsWith("--") ? written.slice(2) : Object.keys(flags).find((each) => flags[each]?.short === written.slice(1));
  if (name === undefined || !Object.hasOwn(flags, name)) throw new Failure(USAGE, `there is no option ${written.slice(0, 40)}; --help lists them`);
  return name;
}

/** A number from an option, or undefined where it is not given. */
export function numberOf({ values }: Given, name: string): number | undefined {
  const text = values.get(name);
  if (text === undefined) return undefined;
  return plainNumber(text, `--${name}`);
}

/** One number, or two with a comma between them. */
export function oneOrTwo({ values }: Given, name: string): number | [number, number] | undefined {
  const text = values.get(name);
  if (text === undefined) return undefined;
  const [first = 0, second, ...more] = text.split(",").map((part) => plainNumber(part, `--${name}`));
  if (more.length > 0) throw new Failure(USAGE, `--${name} is one number, or two with a comma between them`);
  return second === undefined ? first : [first, second];
}

function plainNumber(text: string, name: string): number {
  const value = text.trim() === "" ? Number.NaN : Number(text);
  if (!Number.isFinite(value)) throw new Failure(USAGE, `${name} is ${JSON.stringify(text.slice(0, 40))}; expected a number`);
  return value;
}

/** The lines of a command's options, aligned. */
export function describeFlags(flags: Readonly<Record<string, Flag>>): string {
  const rows = Object.entries(flags).map(([name, { value, short, about }]) => {
    const long = `--${name}${value === undefined ? "" : ` ${value}`}`;
    return [short === undefined ? `    ${long}` : `-${short}, ${long}`, about] as const;
  });
  const width = Math.max(...rows.map(([left]) => left.length));
  return rows.map(([left, about]) => `  ${left.padEnd(width)}  ${about}`).join("\n");
}
