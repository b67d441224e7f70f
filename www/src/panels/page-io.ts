import type { Artboard, Box } from "../document/artboard.ts";
import type { PaintedPath } from "../document/paint-layers.ts";
import type { DemoState, Filling, Space } from "../document/document.ts";
import type { Imported } from "../document/imported.ts";

/**
 * What the panels ask of the room that talks to files, links and the clipboard. They are handed it, so that panels know
 * nothing of how a file is read and can be shown without any of it.
 */
export interface PageIo {
  readImport(text: string, space: Space): Promise<Imported>;
  readIncoming(file: File): Promise<{ readonly name: string; readonly text: string } | { readonly name: string; readonly picture: Blob }>;
  /** A picture that is copied as a text, `data:image/…`. */
  fileInText(text: string): Promise<File | null>;
  listenForIncoming(handlers: IncomingHandlers, until: AbortSignal): void;
  isShareLink(hash: string): boolean;
  shareLink(state: DemoState): Promise<{ readonly hash: string; readonly alone: boolean }>;
  readShareHash(hash: string): Promise<DemoState>;
  gzippedSize(text: string): Promise<number>;
  writeSvg(options: FileLook & { title: string; d: string; box: Box | null }): Promise<string>;
  pngSize(subject: FileLook & { box: Box | null }, scale: number): Promise<{ readonly width: number; readonly height: number } | null>;
  writePng(options: FileLook & { d: string; box: Box | null; scale: number; paper: string | null; stage?: { ink?: string; fill: string } }): Promise<Blob | null>;
  download(name: string, content: Blob): void;
  copyText(text: string | Promise<string>): Promise<boolean>;
  createAutosave(options: {
    read(): DemoState;
    busy(): boolean;
    abandon(): void;
    failing(failed: boolean): void;
    until: AbortSignal;
  }): { touch(): void };
  /** What this tab showed before it was loaded again: a session, or a link. */
  tabShows(): string | null;
  rememberTab(what: string): void;
  /** Whether there may be anything that was kept. */
  hasKept(): boolean;
  /** Of a session, if it is still kept, else of all. */
  newestKept(own: string | null): Promise<{ readonly state: DemoState; readonly damaged?: { readonly text: string; forget(): Promise<void> } } | null>;
}

/** How a drawing looks in a file. */
export interface FileLook {
  /** Areas of ink, holes left out, in place of lines. */
  readonly filled?: boolean;
  readonly filling?: Filling;
  readonly artboard?: Artboard;
  /** In place of the one path, the lowest first. */
  readonly layers?: readonly PaintedPath[];
}

export interface IncomingHandlers {
  takesText(target: EventTarget | null): boolean;
  take(brought: Brought): void;
  dragging(over: boolean): void;
}

/** What was pasted or dropped. */
export interface Brought {
  readonly pasted: boolean;
  readonly files: readonly File[];
  readonly text: string;
  /** The part of a page that some programs copy. */
  readonly page: string;
}
