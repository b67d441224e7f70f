// What tracers reached that cannot be installed here, on the same pictures and by the same definitions.

const row = (name, values) => {
  const [mean, hausdorff, iou, angle, wiggle, segments, recall, precision, cornerError, kinks, bytes] = values;
  return { name: `${name} ¹`, row: { mean, hausdorff, iou, angle, wiggle, segments, recall, precision, cornerError, kinks, bytes } };
};

const short = (name, [mean, hausdorff, recall, precision, segments]) => ({ name: `${name} ¹`, row: { mean, hausdorff, recall, precision, segments } });

const HALVED = "mkbitmap -s2, potrace 1.16, shift corrected";
const AUTOTRACE = "autotrace 0.40";
const VTRACER = "vtracer 1.0.0-alpha.4 bw, simplify 1";

/** Rows by condition. */
export const RECORDED = {
  c64: [
    short(HALVED, [0.115, 0.85, 0.75, 1, 0.87]),
    short(AUTOTRACE, [0.489, 2.82, 0.58, 0.93, 0.36]),
    short(VTRACER, [0.398, 1.73, 0.69, 0.96, 0.42]),
  ],
  c256: [
    row(HALVED, [0.101, 0.92, 0.9917, 0.48, 0.97, 1.26, 0.912, 0.99, 0.5, 0.5, 1592]),
    row("mkbitmap -s4, potrace 1.16, shift corrected", [0.052, 0.78, 0.9955, 1.19, 2.73, 6.85, 0.812, 0.963, 0.47, 6.9, 5995]),
    row(AUTOTRACE, [0.535, 4.42, 0.9684, 1.67, 0.96, 0.69, 0.639, 0.951, 0.58, 0.2, 1172]),
    row(VTRACER, [0.534, 2.14, 0.9597, 1.48, 0.98, 0.62, 0.677, 0.979, 0.57, 0.4, 958]),
    row("OpenCV 5.0 findContours, approxPolyDP 1", [0.466, 1.4, 0.9624, 2.73, 0.95, 1.67, 0.929, 0.758, 0.83, 49.2, 843]),
    row("marching squares on gray, Douglas–Peucker ¼", [0.063, 0.87, 0.9949, 1.32, 0.96, 3.42, 0.974, 0.728, 0.57, 87, 1693]),
  ],
  c1024: [
    short(HALVED, [0.083, 0.93, 0.95, 1, 1.63]),
    short(AUTOTRACE, [0.979, 12.4, 0.65, 0.98, 1.22]),
    short(VTRACER, [0.574, 3.09, 0.71, 0.98, 1.02]),
  ],
  n256: [
    short(HALVED, [0.102, 1.73, 0.51, 0.96, 4.03]),
    short(AUTOTRACE, [0.561, 4.9, 0.31, 0.84, 0.74]),
    short(VTRACER, [0.569, 2.37, 0.48, 0.25, 1.05]),
  ],
  j256: [
    short(HALVED, [0.094, 0.99, 0.83, 0.99, 1.48]),
    short(AUTOTRACE, [0.539, 4.46, 0.62, 0.95, 0.7]),
    short(VTRACER, [0.536, 2.06, 0.68, 0.74, 0.69]),
  ],
};

/** Centre lines: mean, Hausdorff, recall and precision within a pixel, lines, segments, bytes. */
export const RECORDED_LINES = {
  thick: [
    { name: "autotrace 0.40 --centerline ¹", row: { mean: 0.82, hausdorff: 6.8, recall: 0.67, precision: 0.7, lines: 3.4, segments: 16, bytes: 728 } },
    { name: "scikit-image skeleton ¹", row: { mean: 1.09, hausdorff: 14.1, recall: 0.89, precision: 0.91, lines: 4.9, segments: 746, bytes: 8539 } },
  ],
  thin: [
    { name: "autotrace 0.40 --centerline ¹", row: { mean: 0.62, hausdorff: 4, recall: 0.79, precision: 0.8, lines: 3.3, segments: 16, bytes: 735 } },
    { name: "scikit-image skeleton ¹", row: { mean: 0.32, hausdorff: 5.6, recall: 0.99, precision: 0.99, lines: 5.1, segments: 757, bytes: 8663 } },
  ],
};

/** What we set out to reach, by condition: key and the least or most. */
export const GOALS = {
  c64: { mean: 0.025, hausdorff: 0.45, iou: 0.993, recall: 0.98, precision: 0.97, segments: 0.85 },
  c256: { mean: 0.015, hausdorff: 0.3, iou: 0.998, recall: 0.99, precision: 0.99, cornerError: 0.05, segments: 1, bytes: 900, kinks: 0.22 },
  c1024: { mean: 0.015, hausdorff: 0.3, segments: 1.05, kinks: 0.22 },
  n256: { mean: 0.045, hausdorff: 0.9, recall: 0.97, precision: 0.93, segments: 1.1 },
  j256: { mean: 0.025 },
};

/** Sheets: side in pixels, rounds, and the most milliseconds by tracer. */
export const SHEETS = [
  { side: 512, rounds: 7, goals: [["expline, wasm", 40], ["expline, wasm, not refined", 8]] },
  { side: 2048, rounds: 3, goals: [["expline, wasm", 220], ["expline, wasm, not refined", 60]] },
];
