/** What figures are made of: an SVG drawing, grips that are dragged or moved by keys, sliders, and a line of words. */

export type Mount = (stage: HTMLElement, words: string) => void;
export type Place = readonly [number, number];

const SVG = "http://www.w3.org/2000/svg";

/** An SVG element with attributes. */
export function shape(name: string, attributes: Readonly<Record<string, string | number>> = {}): SVGElement {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  return element;
}

/** The drawing of a figure; `box` is what is seen at least: x, y, width and height. */
export function drawing(stage: HTMLElement, words: string, box: readonly [number, number, number, number]): SVGSVGElement {
  const svg = shape("svg", { viewBox: box.join(" "), role: "group", "aria-label": words }) as SVGSVGElement;
  stage.append(svg);
  return svg;
}

/** A line of the drawing, drawn anew by giving it path data. */
export function line(svg: SVGElement, look: string): (d: string) => void {
  const path = svg.appendChild(shape("path", { class: look, "aria-hidden": "true" }));
  return (d) => path.setAttribute("d", d);
}

/** A polyline through interleaved coordinates, as path data. */
export function polyline(points: ArrayLike<number>, closed = false): string {
  let d = "";
  for (let i = 0; i < points.length; i += 2) d += `${i === 0 ? "M" : "L"}${points[i]?.toFixed(2)} ${points[i + 1]?.toFixed(2)}`;
  return closed && d !== "" ? `${d}Z` : d;
}

/** Where a pointer is, in the unit of the drawing. */
export function placeOf(svg: SVGSVGElement, event: PointerEvent): Place {
  const matrix = svg.getScreenCTM();
  if (matrix === null) return [0, 0];
  const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
  return [x, y];
}

/** The size of a CSS pixel, in the unit of the drawing. */
const pixelOf = (svg: SVGSVGElement): number => 1 / (svg.getScreenCTM()?.a ?? 1);

const MARKS: Readonly<Record<string, (r: number) => SVGElement>> = {
  point: (r) => shape("circle", { r, class: "mark-point" }),
  handle: (r) => shape("circle", { r: 0.9 * r, class: "mark-handle" }),
  vertex: (r) => shape("path", { d: `M0 ${-1.2 * r}L${1.2 * r} 0L0 ${1.2 * r}L${-1.2 * r} 0Z`, class: "mark-vertex" }),
  linear: (r) => shape("rect", { x: -r, y: -r, width: 2 * r, height: 2 * r, class: "mark-linear" }),
  cubic: (r) => shape("circle", { r: 1.1 * r, class: "mark-cubic" }),
  cusp: (r) => shape("path", { d: `M0 ${-1.3 * r}L${1.3 * r} 0L0 ${1.3 * r}L${-1.3 * r} 0Z`, class: "mark-cusp" }),
};

/** Marks that only show something; each call replaces the last ones. */
export function marks(svg: SVGSVGElement): (all: readonly { readonly at: Place; readonly kind: string }[]) => void {
  const group = svg.appendChild(shape("g", { "aria-hidden": "true" }));
  return (all) => {
    const size = 4.5 * pixelOf(svg);
    group.replaceChildren(
      ...all.map(({ at: [x, y], kind }) => {
        const mark = MARKS[kind]?.(1) ?? shape("g");
        mark.setAttribute("transform", `translate(${x} ${y}) scale(${size})`);
        mark.setAttribute("vector-effect", "non-scaling-stroke");
        return mark;
      }),
    );
  };
}

export interface Grip {
  /** Puts it where it belongs now. */
  put(place: Place): void;
  remove(): void;
}

const ARROWS: Readonly<Record<string, Place>> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
/** A step by a key, in pixels, and with Shift. */
const STEP = 4;
const LARGE_STEP = 20;

/** Something that is dragged, or moved by the arrow keys. `moved` is told where to. */
export function grip(svg: SVGSVGElement, kind: string, name: string, moved: (place: Place) => void): Grip {
  let [x, y]: Place = [0, 0];
  const group = shape("g", { class: "grip", tabindex: 0, role: "button", "aria-roledescription": "movable point" });
  const reach = shape("circle", { r: 14, class: "reach" });
  group.append(reach, MARKS[kind]?.(4.5) ?? shape("g"));
  svg.append(group);
  const put = (place: Place): void => {
    [x, y] = place;
    group.setAttribute("transform", `translate(${x} ${y}) scale(${pixelOf(svg)})`);
    group.setAttribute("aria-label", `${name}, x ${Math.round(x)}, y ${Math.round(y)}. Arrow keys move it.`);
  };
  let offset: Place | undefined;
  // A finger that drags it does not scroll the page: a group has no box on which `touch-action` would say so.
  group.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
  group.addEventListener("pointerdown", (event) => {
    const at = placeOf(svg, event);
    offset = [x - at[0], y - at[1]];
    group.setPointerCapture(event.pointerId);
    group.focus({ preventScroll: true });
    event.preventDefault();
  });
  group.addEventListener("pointermove", (event) => {
    if (offset === undefined) return;
    const at = placeOf(svg, event);
    moved([at[0] + offset[0], at[1] + offset[1]]);
  });
  for (const end of ["pointerup", "pointercancel"]) group.addEventListener(end, () => (offset = undefined));
  group.addEventListener("keydown", (event) => {
    const way = ARROWS[(event as KeyboardEvent).key];
    if (way === undefined) return;
    const step = ((event as KeyboardEvent).shiftKey ? LARGE_STEP : STEP) * pixelOf(svg);
    moved([x + way[0] * step, y + way[1] * step]);
    event.preventDefault();
  });
  new ResizeObserver(() => put([x, y])).observe(svg);
  return { put, remove: () => group.remove() };
}

/** The row of controls below a drawing. */
export function controls(stage: HTMLElement): HTMLElement {
  const row = document.createElement("div");
  row.className = "controls";
  stage.append(row);
  return row;
}

/** A slider with its name and value; gives back how to ask for the value. */
export function slider(row: HTMLElement, name: string, range: { min: number; max: number; step: number; value: number }, changed: () => void, said: (value: number) => string = String): () => number {
  const label = document.createElement("label");
  const input = Object.assign(document.createElement("input"), { type: "range" });
  for (const [key, value] of Object.entries(range)) input.setAttribute(key, String(value));
  const output = document.createElement("output");
  const tell = (): void => {
    output.textContent = said(input.valueAsNumber);
    input.setAttribute("aria-valuetext", output.textContent);
  };
  input.addEventListener("input", () => {
    tell();
    changed();
  });
  tell();
  label.append(name, input, output);
  row.append(label);
  return () => input.valueAsNumber;
}

/** One of a few words; gives back how to ask for it. */
export function choice<T extends string>(row: HTMLElement, name: string, all: readonly T[], changed: () => void = () => undefined): () => T {
  const label = document.createElement("label");
  const select = document.createElement("select");
  select.append(...all.map((each) => new Option(each)));
  select.addEventListener("change", changed);
  label.append(name, select);
  row.append(label);
  return () => select.value as T;
}

export function button(row: HTMLElement, name: string, pressed: () => void): HTMLButtonElement {
  const element = Object.assign(document.createElement("button"), { type: "button", textContent: name });
  element.addEventListener("click", pressed);
  row.append(element);
  return element;
}

const CALM = 400;

/** A line of words about what is seen; told to those who do not see it once it has come to rest. */
export function words(row: HTMLElement): (text: string) => void {
  const seen = Object.assign(document.createElement("span"), { className: "said" });
  const heard = Object.assign(document.createElement("span"), { className: "visually-hidden" });
  seen.setAttribute("aria-hidden", "true");
  heard.setAttribute("role", "status");
  row.append(seen, heard);
  let timer: ReturnType<typeof setTimeout> | undefined;
  return (text) => {
    seen.textContent = text;
    clearTimeout(timer);
    timer = setTimeout(() => (heard.textContent = text), CALM);
  };
}
