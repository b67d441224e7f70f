import type { PngOptions } from "./picture/png.ts";
import type { PngSize, Subject } from "./picture/png-size.ts";
import type { SvgOptions } from "./svg/svg-write.ts";
import type { DemoState, Space } from "../document/document.ts";
import type { Imported } from "../document/imported.ts";
import type { Kept } from "./keeping/kept.ts";
import { createAutosave } from "./keeping/beginning.ts";
import { copyText, download } from "./download.ts";
import { listenForIncoming } from "./incoming.ts";
import type { Incoming } from "./incoming-file.ts";
import { isShareLink } from "./link/link.ts";
import { hasKept, localStore, rememberTab, tabShows } from "./keeping/store.ts";

/** Everything the panels are handed of this room. What a visit may never need is loaded when it is first asked for. */
export const pageIo = {
  copyText, createAutosave, download, isShareLink, listenForIncoming, rememberTab, tabShows,
  readIncoming: async (file: File): Promise<Incoming> => (await import("./incoming-file.ts")).readIncoming(file),
  fileInText: async (text: string): Promise<File | null> => (await import("./data-url.ts")).fileInText(text),
  hasKept: (): boolean => hasKept(localStore()),
  newestKept: async (own: string | null): Promise<Kept | null> => (await import("./keeping/kept.ts")).newestKept(own),
  readImport: async (text: string, space: Space): Promise<Imported> => (await import("./import.ts")).readImport(text, space),
  shareLink: async (state: DemoState): Promise<{ hash: string; alone: boolean }> => (await import("./link/share.ts")).shareLink(state),
  readShareHash: async (hash: string): Promise<DemoState> => (await import("./link/share.ts")).readShareHash(hash),
  gzippedSize: async (text: string): Promise<number> => (await import("./link/compress.ts")).gzippedSize(text),
  writeSvg: async (options: SvgOptions): Promise<string> => (await import("./svg/svg-write.ts")).writeSvg(options),
  pngSize: async (subject: Subject, scale: number): Promise<PngSize | null> => (await import("./picture/png-size.ts")).pngSize(subject, scale),
  writePng: async (options: PngOptions): Promise<Blob | null> => (await import("./picture/png.ts")).writePng(options),
};
