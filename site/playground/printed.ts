/** Values as a console shows them, short. */

const MOST = 12;
const DEEPEST = 3;
const isPlain = (name: string): boolean => /^[A-Za-z_$][\w$]*$/.test(name);

function list(values: readonly unknown[], length: number, depth: number): string {
  return `[${values.map((each) => printed(each, depth + 1)).join(", ")}${length > values.length ? `, … ${length - values.length} more` : ""}]`;
}

export function printed(value: unknown, depth = 0): string {
  if (typeof value === "string") return JSON.stringify(value);
  if (typeof value === "function") return `ƒ ${value.name}`;
  if (typeof value === "bigint") return `${value}n`;
  if (typeof value !== "object" || value === null) return String(value);
  if (value instanceof Error) return `${value.name}: ${value.message}`;
  if (ArrayBuffer.isView(value) && !(value instanceof DataView)) {
    const numbers = value as Float64Array;
    return `${value.constructor.name}(${numbers.length}) ${list(Array.from(numbers.subarray(0, MOST)), numbers.length, depth)}`;
  }
  if (Array.isArray(value)) return list(value.slice(0, MOST), value.length, depth);
  const name = Object.prototype.toString.call(value).slice(8, -1);
  const entries = Object.entries(value);
  if (name !== "Object" && entries.length === 0) return "points" in value && ArrayBuffer.isView(value.points) ? `${name} (${(value.points as Float64Array).length} coordinates)` : name;
  if (depth >= DEEPEST) return "{ … }";
  const shown = entries.slice(0, MOST).map(([key, each]) => `${isPlain(key) ? key : JSON.stringify(key)}: ${printed(each, depth + 1)}`);
  return `{ ${[...shown, ...(entries.length > MOST ? ["…"] : [])].join(", ")} }`;
}
