import type { Browser } from "playwright-core";

/** The path of a Chromium or Chrome: `$CHROMIUM`, else the system's; undefined when there is none. */
export function findChromium(): string | undefined;
/** Finds Chromium or installs it with apt. */
export function ensureChromium(): Promise<string>;
/** A headless Chromium driven by playwright-core. */
export function launch(): Promise<Browser>;
