import type { PictureSource } from "./job.ts";

/**
 * Pictures that were brought in, in the memory of this page: a file's content stays with the browser until it is looked
 * at.
 */
const contents = new Map<string, Blob>();
let serial = 0;

/** Keeps a picture; its key is good until the page is left. */
export function keepPicture(content: Blob): string {
  serial += 1;
  const key = `picture-${serial}`;
  contents.set(key, content);
  return key;
}

export function pictureOf(key: string): PictureSource | null {
  const content = contents.get(key);
  return content === undefined ? null : { kind: "file", key, content };
}

/** Lets go of a picture that turned out to be none. */
export function dropPicture(key: string): void {
  contents.delete(key);
}
