/** Cascade layers: of ordinary rules those of a later layer win, of important ones those of an earlier. */

export interface Layer {
  readonly inner: Map<string, Layer>;
  /** Its place among all layers, once all are known. */
  rank: number;
}

/** What is in no layer: every other layer is inside it. */
export function outermost(): Layer {
  return { inner: new Map(), rank: 0 };
}

/** Nobody writes longer names than this. */
const mostParts = 16;

/**
 * The layer of a name, such as `base.forms`, inside another, and new if there was none; one without a name is never met
 * again.
 */
export function layerIn(outer: Layer, name: string): Layer {
  const parts = name === "" ? [` ${outer.inner.size}`] : name.split(".", mostParts);
  return parts.reduce((layer, part) => {
    const known = layer.inner.get(part) ?? outermost();
    layer.inner.set(part, known);
    return known;
  }, outer);
}

/** Layers in the order in which they were first named; a layer's own rules come after those of the layers in it. */
export function rankLayers(layer: Layer, from = 0): number {
  let next = from;
  for (const inner of layer.inner.values()) next = rankLayers(inner, next);
  layer.rank = next;
  return next + 1;
}
