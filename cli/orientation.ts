/** Which way up a picture is: cameras store it as the sensor had it, and say in Exif how it is to be turned. */
import type { Picture } from "./picture.ts";

const ORIENTATION = 0x0112;

/** The orientation that Exif data tell, 1 to 8; 1, as it is, where they tell none. */
export function orientationIn(exif: Uint8Array): number {
  const view = new DataView(exif.buffer, exif.byteOffset, exif.length);
  const inside = (at: number, length: number): boolean => at + length <= exif.length;
  if (!inside(0, 8)) return 1;
  const little = view.getUint16(0) === 0x4949;
  const directory = view.getUint32(4, little);
  if (!inside(directory, 2)) return 1;
  const count = view.getUint16(directory, little);
  for (let i = 0, at = directory + 2; i < count && inside(at, 12); i += 1, at += 12) {
    const value = view.getUint16(at + 8, little);
    if (view.getUint16(at, little) === ORIENTATION) return value >= 1 && value <= 8 ? value : 1;
  }
  return 1;
}

/** The picture as it is to be seen. */
export function upright(picture: Picture, orientation: number): Picture {
  if (orientation === 1) return picture;
  const [columns, rows] = [picture.width, picture.height];
  // From 5 on rows become columns; two of each four are mirrored one way, two the other.
  const turned = orientation > 4;
  const [width, height] = turned ? [rows, columns] : [columns, rows];
  const fromRight = [2, 3, 7, 8].includes(orientation);
  const fromBottom = [3, 4, 6, 7].includes(orientation);
  const from = new Uint32Array(picture.data.buffer, picture.data.byteOffset, columns * rows);
  const to = new Uint32Array(width * height);
  for (let y = 0, i = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1, i += 1) {
      const [column, row] = turned ? [y, x] : [x, y];
      to[i] = from[(fromBottom ? rows - 1 - row : row) * columns + (fromRight ? columns - 1 - column : column)] ?? 0;
    }
  }
  return { data: new Uint8Array(to.buffer), width, height };
}
