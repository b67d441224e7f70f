/** The demo's Content Security Policy. */
export const POLICY: string;
/** Serves a folder on this machine; `policy` is the Content Security Policy of its pages, "" for none. */
export function serve(folder: string, options?: { port?: number; policy?: string }): Promise<{ url: string; close: () => Promise<void> }>;
