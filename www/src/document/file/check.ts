import { FileError } from "./error.ts";

/**
 * A value read from a file, and where it stood. Every reader below says what it wants and throws when it is not that.
 */
export interface Found {
  readonly value: unknown;
  readonly path: string;
}

export const maxCoordinate = 1e9;

export function wrong(found: Found, wanted: string): FileError {
  const missing = found.value === undefined;
  return new FileError("E_SCHEMA", found.path, missing ? "is missing" : `is not ${wanted}`);
}

export function asObject(found: Found): Record<string, unknown> {
  const { value } = found;
  if (typeof value !== "object" || value === null || Array.isArray(value)) throw wrong(found, "an object");
  return value as Record<string, unknown>;
}

/** A field of an object; only its own, so that nothing inherited can pass for data. */
export function field(found: Found, name: string): Found {
  const object = asObject(found);
  return { value: Object.hasOwn(object, name) ? object[name] : undefined, path: `${found.path}.${name}` };
}

/** A field that may be left out. */
export function optional<T>(found: Found, name: string, read: (found: Found) => T): T | undefined {
  const inner = field(found, name);
  return inner.value === undefined ? undefined : read(inner);
}

export function asNumber(found: Found, least = -maxCoordinate, most = maxCoordinate): number {
  const { value, path } = found;
  if (typeof value !== "number") throw wrong(found, "a number");
  if (!Number.isFinite(value)) throw new FileError("E_NOT_FINITE", path, "is not a finite number");
  if (value < least || value > most) throw new FileError("E_RANGE", path, `is outside ${least} … ${most}`);
  // −0 is 0 once, here, so that what is written again is what was read.
  return value + 0;
}

export function asWhole(found: Found, least: number, most: number): number {
  const value = asNumber(found, least, most);
  if (!Number.isInteger(value)) throw wrong(found, "a whole number");
  return value;
}

export function asBoolean(found: Found): boolean {
  if (typeof found.value !== "boolean") throw wrong(found, "true or false");
  return found.value;
}

export function oneOf<T extends string>(found: Found, choices: readonly T[]): T {
  const choice = choices.find((each) => each === found.value);
  if (choice === undefined) throw wrong(found, `one of ${choices.join(", ")}`);
  return choice;
}

/** The id of a sample: a word of ours, never text to be shown. */
export function asSampleId(found: Found): string {
  if (typeof found.value !== "string" || !/^[a-z0-9-]{1,40}$/u.test(found.value)) throw wrong(found, "the id of a sample");
  return found.value;
}

export function asArray<T>(found: Found, read: (found: Found) => T, max: number, limit: string): T[] {
  const { value, path } = found;
  if (!Array.isArray(value)) throw wrong(found, "an array");
  if (value.length > max) throw new FileError("E_LIMIT", path, `has more than ${max} entries`, { limit });
  return value.map((item: unknown, i) => read({ value: item, path: `${path}[${i}]` }));
}

/** Leaves absent what is absent: an optional field is never written as undefined. */
export function defined<T extends object>(parts: T): { [K in keyof T]?: Exclude<T[K], undefined> } {
  return Object.fromEntries(Object.entries(parts).filter(([, value]) => value !== undefined)) as { [K in keyof T]?: Exclude<T[K], undefined> };
}
