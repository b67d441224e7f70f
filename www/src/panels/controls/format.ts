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

/** A coordinate in a field: two decimals but of tiny drawings, and no −0.00. */
export function formatCoordinate(value: number, decimals = 2): string {
  return (Number(value.toFixed(decimals)) + 0).toFixed(decimals);
}

export function formatCount(count: number, one: string, many = `${one}s`): string {
  return `${count} ${count === 1 ? one : many}`;
}

const plainNumber = "[-+]?(?:\\d+[.,]?\\d*|[.,]\\d+)(?:e[-+]?\\d+)?";
const sum = new RegExp(`^${plainNumber}(?:[-+*/]${plainNumber})*(?:px|°)?$`, "iu");
const step = new RegExp(`([-+*/]?)(${plainNumber})`, "giu");

/**
 * A number as people type it, or a sum as they add to one that stands there ("240.00+10", "100/3"): a decimal comma
 * counts, and so does the unit. Returns null for what is no number or outside the range.
 */
export function parseTyped(text: string, least: number, most: number): number | null {
  const plain = text.trim().replace(/\u2212/gu, "-").replace(/\s*([-+*/])\s*/gu, "$1");
  if (!sum.test(plain)) return null;
  let [before, term] = [0, 0];
  for (const [, sign, digits = ""] of plain.matchAll(step)) {
    const number = Number(digits.replace(",", "."));
    if (sign === "*") term *= number;
    else if (sign === "/") term /= number;
    else [before, term] = [before + term, sign === "-" ? -number : number];
  }
  const value = before + term;
  return Number.isFinite(value) && value >= least && value <= most ? value + 0 : null;
}

/** What is left, as a loss: "−93 %", with a digit more where 100 would be said of what is not all. */
export function formatChange(left: number): string {
  const less = 100 * (1 - left);
  return `−${less > 99 && less < 100 ? Math.min(99.9, Number(less.toFixed(1))) : Math.round(less)} %`;
}
