/** A picture of a few pixels that the reader paints on, and the curves around its ink. */
import { type ImageLike, traceImage } from "expline";

import { type Mount, type Place, button, choice, controls, drawing, line, marks, placeOf, shape, words } from "./stage.ts";

// shown
const traced = (picture: ImageLike) => {
  const { contours, toSvg } = traceImage(picture); // as ImageData comes from a canvas
  return {
    d: contours.map(({ curve }) => curve.toPathD({ tolerance: 0.02 }).d).join(""),
    corners: contours.flatMap(({ cusps }) => cusps),
    bytes: toSvg().length,
  };
};
// end of shown

const SIZE = 40;
/** Samples of a pixel along each side: what part of it is ink is its shade. */
const FINE = 8;

const isInDisc = (x: number, y: number, [cx, cy]: Place, r: number): boolean => Math.hypot(x - cx, y - cy) < r;

/** A slanted bar. */
function isInBar(x: number, y: number): boolean {
  const [along, across] = [(x - 20) * 0.35 + (y - 20) * 0.94, (x - 20) * 0.94 - (y - 20) * 0.35];
  return Math.abs(along) < 7.5 && Math.abs(across) < 3.2;
}

/** Where there is ink. */
const PICTURES: Readonly<Record<string, (x: number, y: number) => boolean>> = {
  "ring and bar": (x, y) => (isInDisc(x, y, [20, 20], 15) && !isInDisc(x, y, [20, 20], 10.5)) || isInBar(x, y),
  square: (x, y) => x > 9.3 && x < 30.6 && y > 8.7 && y < 29.9,
  moon: (x, y) => isInDisc(x, y, [20, 20], 14.5) && !isInDisc(x, y, [26, 17], 11),
};

function painted(name: string): Uint8ClampedArray {
  const isInk = PICTURES[name] ?? (() => false);
  return Uint8ClampedArray.from({ length: SIZE * SIZE }, (_, i) => {
    let ink = 0;
    for (let k = 0; k < FINE * FINE; k += 1) {
      const [x, y] = [(i % SIZE) + ((k % FINE) + 0.5) / FINE, Math.floor(i / SIZE) + (Math.floor(k / FINE) + 0.5) / FINE];
      if (isInk(x, y)) ink += 1;
    }
    return 255 * (1 - ink / (FINE * FINE));
  });
}

/** A round brush with a soft edge, of ink or of paper; Shift takes the other one. */
function brush(data: Uint8ClampedArray, [x, y]: Place, ink: boolean): void {
  for (let i = 0; i < data.length; i += 1) {
    const covers = Math.min(1, Math.max(0, 2.7 - Math.hypot((i % SIZE) + 0.5 - x, Math.floor(i / SIZE) + 0.5 - y)));
    const shade = data[i] ?? 0;
    data[i] = ink ? Math.min(shade, 255 * (1 - covers)) : Math.max(shade, 255 * covers);
  }
}

/** The pixels as a picture of the drawing. */
function pixels(svg: SVGSVGElement): (data: Uint8ClampedArray) => void {
  const image = svg.appendChild(shape("image", { width: SIZE, height: SIZE, class: "pixels", opacity: 0.45, "aria-hidden": "true" }));
  const canvas = Object.assign(document.createElement("canvas"), { width: SIZE, height: SIZE });
  return (data) => {
    const shades = new ImageData(SIZE, SIZE);
    data.forEach((shade, i) => shades.data.set([shade, shade, shade, 255], 4 * i));
    canvas.getContext("2d")?.putImageData(shades, 0, 0);
    image.setAttribute("href", canvas.toDataURL());
  };
}

export const mount: Mount = (stage, text) => {
  const svg = drawing(stage, text, [-2, -2, SIZE + 4, SIZE + 4]);
  svg.classList.add("drawable");
  const show = pixels(svg);
  const outline = line(svg, "filled");
  const corners = marks(svg);
  const row = controls(stage);
  const name = choice(row, "Picture", Object.keys(PICTURES), () => begin());
  let isInk = true;
  const tool = button(row, "Brush: ink", () => {
    isInk = !isInk;
    tool.textContent = `Brush: ${isInk ? "ink" : "paper"}`;
  });
  const say = words(row);
  let data = painted(name());
  const draw = (): void => {
    const found = traced({ width: SIZE, height: SIZE, data });
    show(data);
    outline(found.d);
    corners(found.corners.map((at) => ({ at, kind: "cusp" })));
    say(`${SIZE} × ${SIZE} pixels, ${found.corners.length} corners, ${found.bytes} bytes of SVG. Paint on it.`);
  };
  const begin = (): void => {
    data = painted(name());
    draw();
  };
  let isPainting = false;
  const paint = (event: PointerEvent): void => {
    brush(data, placeOf(svg, event), isInk !== event.shiftKey);
    draw();
  };
  svg.addEventListener("pointerdown", (event) => {
    svg.setPointerCapture(event.pointerId);
    isPainting = true;
    paint(event);
  });
  svg.addEventListener("pointermove", (event) => isPainting && paint(event));
  for (const end of ["pointerup", "pointercancel"]) svg.addEventListener(end, () => (isPainting = false));
  begin();
};
