/** Numbers as the page prints them. Never localised: a point is a point in every file and field. */

/** An error or deviation: `3e-16` below 1e-4, else two significant digits. */
export function formatDeviation(value: number): string {
  if (value === 0) return "0";
  if (Math.abs(value) < 1e-4) return value.toExponential(0).replace("e-0", "e-");
  return String(Number(value.toPrecision(2)));
}

/** A relative error against a shape, with one more digit where it compares two numbers. */
export function formatRatio(value: number): string {
  return Math.abs(value) < 1e-12 ? formatDeviation(value) : value === 0 ? "0" : value.toExponential(1);
}

export function formatBytes(bytes: number): string {
  if (bytes < 1000) return `${bytes} B`;
  return bytes < 999_500 ? `${Number((bytes / 1000).toPrecision(3))} kB` : `${Number((bytes / 1e6).toPrecision(3))} MB`;
}

/** A length or area in document units: as many digits as the eye can use. */
export function formatMeasure(value: number): string {
  const size = Math.abs(value);
  if (size >= 1e6) return value.toExponential(3);
  if (size >= 1000) return String(Math.round(value));
  return String(Number(value.toPrecision(4)));
}

/** A coordinate in a field: two decimals, and no −0.00. */
export function formatCoordinate(value: number): string {
  return (Math.round(value * 100) / 100 + 0).toFixed(2);
}

export function formatCount(count: number, one: string, many = `${one}s`): string {
  return `${count} ${count === 1 ? one : many}`;
}

/**
 * A number as people type it: a decimal comma counts, anything else that is not a plain decimal does not. Returns null
 * for what is no number or outside the range.
 */
export function parseTyped(text: string, least: number, most: number): number | null {
  const plain = text.trim().replace(/^([-+]?\d*),(\d+)$/u, "$1.$2").replace(/^\u2212/u, "-");
  if (!/^[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?$/iu.test(plain)) return null;
  const value = Number(plain);
  return Number.isFinite(value) && value >= least && value <= most ? value + 0 : null;
}

/** What is left, as a loss: "−93 %", with a digit more where 100 would be said of what is not all. */
export function formatChange(left: number): string {
  const less = 100 * (1 - left);
  return `−${less > 99 && less < 100 ? Math.min(99.9, Number(less.toFixed(1))) : Math.round(less)} %`;
}
