/** What a file that arrives is, by type, name and first bytes. */
import { Problem } from "../document/problem.ts";
import { gunzip } from "./link/compress.ts";
import { checkPicture } from "./picture/picture-file.ts";

export type Incoming = { readonly name: string; readonly text: string } | { readonly name: string; readonly picture: Blob };

const mostTextBytes = 32 * 1024 * 1024;

function extensionOf(name: string): string {
  return /\.([a-z0-9]+)$/iu.exec(name)?.[1]?.toLowerCase() ?? "";
}

const textTypes: ReadonlySet<string> = new Set(["svg", "json", "geojson", "txt", "csv", "tsv", "dat", "xy"]);
const pictureTypes: ReadonlySet<string> = new Set(["png", "jpg", "jpeg", "webp", "avif", "gif", "bmp", "tif", "tiff", "heic", "heif"]);

/** What every browser has a decoder for: where it cannot be decoded, it is broken. */
const commonTypes: ReadonlySet<string> = new Set(["png", "jpg", "jpeg", "webp", "gif", "bmp"]);

/**
 * What is in a gzipped file, as `.svgz` is, under its name; any other as it is. @throws Problem where it is broken, or
 * too much.
 */
async function unpacked(file: File): Promise<File> {
  const [first, second] = new Uint8Array(await file.slice(0, 2).arrayBuffer());
  if (first !== 0x1f || second !== 0x8b) return file;
  const name = file.name.replace(/\.svgz$|\.gz$/iu, (end) => (end.length === 5 ? ".svg" : ""));
  try {
    const bytes = await gunzip(new Uint8Array(await file.arrayBuffer()), mostTextBytes);
    return new File([bytes], name, { type: /\.svg$/iu.test(name) ? "image/svg+xml" : "" });
  } catch (error) {
    if (error instanceof RangeError) throw new Problem("svg-big", { field: "bytes", most: mostTextBytes });
    throw new Problem("file-type", { name: shortName(file.name) });
  }
}

/** A picture, or the text of a file that can be drawn. @throws Problem for anything else. */
export async function readIncoming(given: File): Promise<Incoming> {
  const file = await unpacked(given);
  const named = file.name !== "";
  const name = named ? shortName(file.name) : "The pasted file";
  const extension = extensionOf(file.name);
  const isSvg = file.type === "image/svg+xml" || extension === "svg";
  if (!isSvg && (file.type.startsWith("image/") || pictureTypes.has(extension))) {
    const title = named ? name : "Pasted picture";
    await checkPicture(file, title);
    const isCommon = commonTypes.has(extension) || commonTypes.has(file.type.replace("image/", ""));
    if (!isCommon && !(await isReadable(file))) throw new Problem("image-type", { name: title });
    return { name: title, picture: file };
  }
  const isText = isSvg || textTypes.has(extension) || /^text\/|[/+]json$/u.test(file.type);
  if (!isText) throw new Problem("file-type", { name });
  if (file.size > mostTextBytes) throw new Problem("svg-big", { field: "bytes", most: mostTextBytes });
  const text = await file.text();
  // A binary file under a text name is told apart by its first bytes.
  if (text.slice(0, 1000).includes("\u0000")) throw new Problem("file-type", { name });
  return { name, text };
}

/** Whether this browser has a decoder for it. */
async function isReadable(picture: Blob): Promise<boolean> {
  try {
    (await createImageBitmap(picture)).close();
    return true;
  } catch {
    return false;
  }
}

/** A file name as it may be shown: at most 60 characters, and nothing that reorders or hides them. */
function shortName(name: string): string {
  const plain = name.replace(/[\p{Cc}\p{Cf}\p{Zl}\p{Zp}]/gu, "\uFFFD");
  return plain.length <= 60 ? plain : `${plain.slice(0, 40)}…${plain.slice(-16)}`;
}
