import { readFile } from "node:fs/promises";
import type { Demo } from "./page.ts";

/** Drawings through the page: in by its Import, out as a file, and what a browser makes of that. */

export async function opened(demo: Demo, text: string): Promise<void> {
  await demo.byId("btn-import").click();
  await demo.byId("import-text").fill(text);
  await demo.byId("import-apply").click();
  await demo.byId("import-dialog").waitFor({ state: "detached" });
  await demo.idle();
}

export async function saved(demo: Demo, id: string): Promise<Buffer> {
  const [file] = await Promise.all([demo.page.waitForEvent("download"), demo.byId(id).click()]);
  return readFile(await file.path());
}

export const cells = 120;

/** Red, green, blue and opacity, up to 255, of each of 120 × 120 cells of a picture. */
export async function cellsOf(demo: Demo, type: string, bytes: Buffer): Promise<[number, number, number, number][]> {
  const flat = await demo.page.evaluate(async ([mime, content, side]) => {
    const image = new Image();
    image.src = `data:${mime};base64,${content}`;
    await image.decode();
    const canvas = Object.assign(document.createElement("canvas"), { width: side, height: side });
    const context = canvas.getContext("2d");
    context?.drawImage(image, 0, 0, side, side);
    return Array.from(context?.getImageData(0, 0, side, side).data ?? []);
  }, [type, bytes.toString("base64"), cells] as const);
  return Array.from({ length: cells * cells }, (_, i) => [flat[4 * i] ?? 0, flat[4 * i + 1] ?? 0, flat[4 * i + 2] ?? 0, flat[4 * i + 3] ?? 0]);
}
