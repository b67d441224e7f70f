// The kinds of work that the package can do: each is a wasm and an ES module of its own, so that a bundler takes what
// is used.

/**
 * Of each kind: the name of its ES module, the feature of the crate, the name of its bindings and its wasm, the name of
 * the module with the wasm's bytes, the function of the slim package that starts it, what it is for, and how much the
 * compiler may copy, in its units:
 *
 * - `inline`: how large a function may be that is copied to where it is called. 0 in the small ones: functions stay
 *   functions unless they say `#[inline]`, which is a tenth less to download, and hot loops say so. Solvers are hot
 *   loops all over: fitting and tracing are between.
 * - `unroll`: how much a loop may grow that is written out because it is known how often it runs, of 300.
 * - `unswitch`: how large a loop may be that is there twice because a condition in it never changes, of 50.
 *
 * docs/DESIGN.md has what each is worth.
 */
export const KINDS = [
  { name: "core", feature: "wasm", file: "expline", bytes: "wasm-bytes", start: "init", work: "curves, paths", inline: 0, unroll: 200, unswitch: 10 },
  { name: "spline", feature: "wasm-spline", file: "expline_spline", bytes: "spline-bytes", start: "initSpline", work: "any roots", inline: 0, unroll: 150, unswitch: 10 },
  { name: "surface", feature: "wasm-surface", file: "expline_surface", bytes: "surface-bytes", start: "initSurface", work: "surfaces", inline: 0, unroll: 150, unswitch: 20 },
  { name: "fit", feature: "wasm-fit", file: "expline_fit", bytes: "fit-bytes", start: "initFit", work: "fitting", inline: 130, unroll: 200, unswitch: 10 },
  { name: "trace", feature: "wasm-trace", file: "expline_trace", bytes: "trace-bytes", start: "initTrace", work: "tracing", inline: 100, unroll: 150, unswitch: 10 },
];

/**
 * The ES modules that have no wasm: what a pointer does to curves, and reading plain data, which is over curves and
 * surfaces.
 */
export const OVER = ["edit", "json"];

/** Where bindings and the modules with the bytes lie until the face is made of them. */
export const BINDINGS = "build/bindings";
