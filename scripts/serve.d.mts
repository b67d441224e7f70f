/** The demo's Content Security Policy. */
export const POLICY: string;
/**
 * Serves a folder on this machine; `policy` is the Content Security Policy of its pages, "" for none, and `beside` has
 * other folders, by the name below which they are served.
 */
export function serve(folder: string, options?: { port?: number; policy?: string; beside?: Record<string, string> }): Promise<{ url: string; close: () => Promise<void> }>;
