/** The address of the engine beside the page, as the bundler names it. */
declare module "expline/expline_bg.wasm?url" {
  const url: string;
  export default url;
}

/** The same of the engine of surfaces. */
declare module "expline/expline_surface_bg.wasm?url" {
  const url: string;
  export default url;
}

/** The same of the engine that fits. */
declare module "expline/expline_fit_bg.wasm?url" {
  const url: string;
  export default url;
}

/** The same of the engine that traces. */
declare module "expline/expline_trace_bg.wasm?url" {
  const url: string;
  export default url;
}

/** The same of the engine of curves of any roots. */
declare module "expline/expline_spline_bg.wasm?url" {
  const url: string;
  export default url;
}
