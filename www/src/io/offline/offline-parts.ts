/**
 * Who comes back may want the rest of the page without a network, too: modes and dialogs that were never opened. What
 * an earlier version of the page was made of goes.
 */
export async function keepEveryPart(cache: Cache): Promise<void> {
  if ("connection" in navigator && (navigator.connection as { readonly saveData?: boolean }).saveData === true) return;
  const answer = await fetch("./parts.json");
  if (!answer.ok) return;
  const parts = new Set((await answer.json() as string[]).map((name) => new URL(name, document.baseURI).href));
  for (const { url } of await cache.keys()) if (url.includes("/assets/") && !parts.has(url)) await cache.delete(url);
  // One after the other, so that nothing that somebody waits for has to wait.
  for (const part of parts) if ((await cache.match(part)) === undefined) await cache.add(part);
}
