// What happens to pictures: blur, noise, JPEG.

/** Numbers in [0, 1), the same every time. */
export function random(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 48271) >>> 0) % 2147483647;
    return state / 2147483647;
  };
}

const byte = (value) => Math.max(0, Math.min(255, Math.round(value)));

function blurred({ width, height, pixels }, sigma) {
  const reach = Math.ceil(4 * sigma);
  const weights = Array.from({ length: 2 * reach + 1 }, (_, i) => Math.exp(-0.5 * ((i - reach) / sigma) ** 2));
  const total = weights.reduce((a, b) => a + b);
  const pass = (from, dx, dy) =>
    Float64Array.from(from, (_, at) => {
      const [x, y] = [at % width, Math.floor(at / width)];
      return weights.reduce((sum, weight, i) => {
        const column = Math.max(0, Math.min(width - 1, x + dx * (i - reach)));
        const row = Math.max(0, Math.min(height - 1, y + dy * (i - reach)));
        return sum + (weight / total) * from[row * width + column];
      }, 0);
    });
  return pass(pass(pixels, 1, 0), 0, 1);
}

/** Blurred by a Gaussian of σ pixels, then with normal noise of a deviation in shades. */
export function noisy(picture, sigma, deviation, seed) {
  const next = random(seed);
  const normal = () => Math.sqrt(-2 * Math.log(1 - next())) * Math.cos(2 * Math.PI * next());
  return { ...picture, pixels: Uint8Array.from(blurred(picture, sigma), (value) => byte(value + deviation * normal())) };
}

/** The quantisation of luminance that the JPEG standard suggests (T.81, table K.1). */
const SUGGESTED = [
  16, 11, 10, 16, 24, 40, 51, 61, 12, 12, 14, 19, 26, 58, 60, 55, 14, 13, 16, 24, 40, 57, 69, 56, 14, 17, 22, 29, 51, 87, 80, 62,
  18, 22, 37, 56, 68, 109, 103, 77, 24, 35, 55, 64, 81, 104, 113, 92, 49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98, 112, 100, 103, 99,
];

const COSINES = Array.from({ length: 64 }, (_, i) => (i < 8 ? Math.SQRT1_2 : 1) * 0.5 * Math.cos(((2 * (i % 8) + 1) * Math.floor(i / 8) * Math.PI) / 16));

/** One block of 8 × 8 to frequencies, or back. */
function transformed(block, back) {
  const cosine = (i, j) => (back ? COSINES[8 * j + i] : COSINES[8 * i + j]);
  const rows = block.map((_, at) => COSINES.slice(0, 8).reduce((sum, _c, k) => sum + cosine(at % 8, k) * block[at - (at % 8) + k], 0));
  return rows.map((_, at) => COSINES.slice(0, 8).reduce((sum, _c, k) => sum + cosine(Math.floor(at / 8), k) * rows[8 * k + (at % 8)], 0));
}

/** What JPEG of a quality leaves of a gray picture whose sides are multiples of 8. */
export function compressed(picture, quality) {
  const scale = quality < 50 ? 5000 / quality : 200 - 2 * quality;
  const steps = SUGGESTED.map((step) => Math.max(1, Math.floor((step * scale + 50) / 100)));
  const { width, height } = picture;
  const pixels = new Uint8Array(width * height);
  for (let row = 0; row < height; row += 8) {
    for (let column = 0; column < width; column += 8) {
      const place = (at) => (row + Math.floor(at / 8)) * width + column + (at % 8);
      const block = steps.map((_, at) => picture.pixels[place(at)] - 128);
      const kept = transformed(block, false).map((value, at) => Math.round(value / steps[at]) * steps[at]);
      transformed(kept, true).forEach((value, at) => (pixels[place(at)] = byte(value + 128)));
    }
  }
  return { ...picture, pixels };
}
