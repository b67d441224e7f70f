// Pictures that nothing was tuned on, drawn here: logos, and shapes of our own whose parameters are drawn by lot.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

import svgpath from "svgpath";

import { compressed, noisy, random } from "./degrade.mjs";
import { cleaned } from "./outline.mjs";
import { Raster } from "./raster.mjs";
import { segments } from "./svg.mjs";

const require = createRequire(import.meta.url);

/** Icons of simple-icons (CC0-1.0) whose contours do not overlap, taken by lot. */
const ICONS = [
  "dedge", "bambulab", "sitecore", "pinterest", "akiflow", "wattpad", "thumbtack", "hyper", "openjdk", "ndi", "privateinternetaccess",
  "honor", "flat", "velog", "justeat", "macos", "tldraw", "boehringeringelheim", "google", "gunicorn", "stackbit", "wikibooks", "tidb",
  "kodular", "notion", "applenews", "trillertv", "immich",
];

/** The contours of path data in a box of so many units, in the unit square; ellipses as cubics, counted as drawn. */
function outlined(id, d, box, margin = 0.06) {
  const { contours, arcs } = segments(svgpath(d).abs().unshort());
  const closed = cleaned(contours, 1e-4 * box);
  const place = (v) => margin + ((1 - 2 * margin) * v) / box;
  return { id, segments: closed.reduce((sum, c) => sum + c.length, 0) - arcs, contours: closed.map((c) => c.map((p) => p.map(place))) };
}

export function icon(name) {
  const text = readFileSync(require.resolve(`simple-icons/icons/${name}.svg`), "utf8");
  return outlined(`icon-${name}`, / d="([^"]+)"/.exec(text)[1], 24);
}

const polygon = (count, x, y, radius, turn = 0) =>
  `M${Array.from({ length: count }, (_, i) => {
    const [angle, r] = [turn + (2 * Math.PI * i) / count, radius(i)];
    return `${x + r * Math.cos(angle)} ${y + r * Math.sin(angle)}`;
  }).join("L")}Z`;

/** An ellipse as two arcs; `sweep` 0 for a hole. */
const oval = (x, y, rx, ry, turn, sweep = 1) => {
  const [dx, dy] = [rx * Math.cos((turn * Math.PI) / 180), rx * Math.sin((turn * Math.PI) / 180)];
  const arc = (toX, toY) => `A${rx} ${ry} ${turn} 0 ${sweep} ${toX} ${toY}`;
  return `M${x - dx} ${y - dy}${arc(x + dx, y + dy)}${arc(x - dx, y - dy)}Z`;
};

/** Two shapes of each kind; `among(a, b)` is a number between them by lot. */
const KINDS = {
  gear: (among) => {
    const teeth = Math.round(among(7, 13));
    return polygon(4 * teeth, 50, 50, (i) => (i % 4 < 2 ? 46 : 36), among(0, 1)) + oval(50, 50, 14, 14, 0, 0);
  },
  blob: (among) => {
    const knots = Array.from({ length: 7 }, (_, i) => [i * ((2 * Math.PI) / 7), among(22, 46)]);
    const at = ([angle, r]) => [50 + r * Math.cos(angle), 50 + r * Math.sin(angle)];
    const handle = (i, side) => {
      const [x, y] = at(knots[i % 7]);
      const [before, after] = [at(knots[(i + 6) % 7]), at(knots[(i + 1) % 7])];
      return [x + (side * (after[0] - before[0])) / 6, y + (side * (after[1] - before[1])) / 6];
    };
    return `M${at(knots[0])}${knots.map((_, i) => `C${handle(i, 1)} ${handle(i + 1, -1)} ${at(knots[(i + 1) % 7])}`).join("")}Z`;
  },
  cross: (among) => {
    const [w, h] = [among(5, 14), among(25, 45)];
    const corners = [[-w, -h], [w, -h], [w, -w], [h, -w], [h, w], [w, w], [w, h], [-w, h], [-w, w], [-h, w], [-h, -w], [-w, -w]];
    const angle = among(0, 0.8);
    return `M${corners.map(([x, y]) => `${50 + x * Math.cos(angle) - y * Math.sin(angle)} ${50 + x * Math.sin(angle) + y * Math.cos(angle)}`).join("L")}Z`;
  },
  moon: (among) => {
    const [r, inner, half] = [among(26, 34), among(30, 60), among(20, 25)];
    return `M68 ${50 - half}A${r} ${r} 0 1 0 68 ${50 + half}A${inner} ${inner} 0 0 1 68 ${50 - half}Z`;
  },
  rings: (among) => {
    const turn = among(0, 180);
    return [46, among(38, 42), among(24, 32), among(14, 18)].map((r, i) => oval(50, 50, r, r * 0.8, turn, 1 - (i % 2))).join("");
  },
  window: (among) => {
    const [w, r, gap] = [44, among(4, 16), among(3, 6)];
    const frame = `M${50 - w + r} ${50 - w}H${50 + w - r}A${r} ${r} 0 0 1 ${50 + w} ${50 - w + r}V${50 + w - r}A${r} ${r} 0 0 1 ${50 + w - r} ${50 + w}H${50 - w + r}A${r} ${r} 0 0 1 ${50 - w} ${50 + w - r}V${50 - w + r}A${r} ${r} 0 0 1 ${50 - w + r} ${50 - w}Z`;
    const pane = (x, y) => `M${x} ${y}V${y + 32}H${x + 32}V${y}Z`;
    return frame + [50 - gap / 2 - 32, 50 + gap / 2].flatMap((x) => [50 - gap / 2 - 32, 50 + gap / 2].map((y) => pane(x, y))).join("");
  },
};

/** How pictures come about, by the first letter of their condition. */
const MAKE = {
  c: drawn,
  s: (shape, size) => sampled(shape, size, 4),
  b: twoShades,
  n: (shape, size, seed) => noisy(drawn(shape, size), 1, 16, seed),
  j: (shape, size) => compressed(drawn(shape, size), 40),
};

const inked = (size, coverage) => ({ width: size, height: size, pixels: Uint8Array.from(coverage, (c) => Math.round(255 * (1 - c))) });

/** A shape's picture with exact coverage. */
export function drawn(shape, size) {
  return inked(size, new Raster(size, size).add(shape.contours, size).coverage());
}

/**
 * A shape's picture from so many rows of so many samples in each pixel; with four it is as browsers and many programs
 * draw it.
 */
function sampled(shape, size, rows) {
  const fine = rows * size;
  const samples = new Raster(fine, fine).add(shape.contours, fine).coverage();
  const hits = new Float64Array(size * size);
  samples.forEach((c, i) => (hits[Math.floor(i / fine / rows) * size + Math.floor((i % fine) / rows)] += c >= 0.5 ? 1 / rows ** 2 : 0));
  return inked(size, hits);
}

/** A shape's picture of two shades: scanned at one bit, or drawn without grey at the edges. */
export function twoShades(shape, size) {
  return sampled(shape, size, 1);
}

export function unseen() {
  const next = random(2026);
  const among = (least, most) => least + (most - least) * next();
  const own = Object.entries(KINDS).flatMap(([kind, make]) => [1, 2].map((n) => outlined(`${kind}-${n}`, make(among), 100, 0)));
  const shapes = [...ICONS.map(icon), ...own];
  const picture = (shape, condition) => MAKE[condition[0]](shape, Number(condition.slice(1)), 1 + shapes.indexOf(shape));
  return { conditions: ["c64", "c256", "c1024", "s64", "s256", "b64", "b256", "n256", "j256"], shapes, picture };
}
