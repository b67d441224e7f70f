/** Numbers as a program has them. */

/** Twelve digits: far below what a screen or a file shows, and free of rounding noise. */
export function number(value: number): string {
  if (Math.abs(value) < 1e-12) return "0";
  return String(Number(value.toPrecision(12)) + 0);
}

export function pairs(values: readonly (readonly [number, number])[]): string {
  const printed = values.map(([x, y]) => `[${number(x)}, ${number(y)}]`);
  const line = `[${printed.join(", ")}]`;
  if (line.length <= 84) return line;
  const rows: string[] = [];
  for (let i = 0; i < printed.length; i += 4) rows.push(`    ${printed.slice(i, i + 4).join(", ")},`);
  return `[\n${rows.join("\n")}\n  ]`;
}

export function numbers(values: readonly number[]): string {
  return `Float64Array.of(${values.map(number).join(", ")})`;
}
