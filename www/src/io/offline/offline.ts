/** The next visit may be without a network. */

/** The name of the cache that `public/offline.js` answers from. */
const kept = "expline";

/**
 * Asks the browser to keep the page as it was loaded. Nothing waits for it, and where it is not possible (a private
 * window, no secure origin, no room) the page is simply not there without a network.
 */
export async function keepForOffline(): Promise<void> {
  if (!window.isSecureContext || !("serviceWorker" in navigator)) return;
  const returning = navigator.serviceWorker.controller !== null;
  try {
    await navigator.serviceWorker.register("./offline.js");
    await navigator.serviceWorker.ready;
    const loaded = performance.getEntriesByType("resource").map(({ name }) => name);
    // The browser's own errands, as the icon, are not among what was loaded.
    const named = [...document.querySelectorAll("link")].map(({ href }) => href);
    const own = [location.href, ...loaded, ...named].map((address) => new URL(address)).filter(({ origin }) => origin === location.origin);
    const addresses = new Set(own.map(({ origin, pathname }) => origin + pathname));
    const cache = await caches.open(kept);
    // What was just loaded comes from the browser's own cache.
    await cache.addAll([...addresses].map((address) => new Request(address, { cache: "force-cache" })));
    if (returning && navigator.onLine) await (await import("./offline-parts.ts")).keepEveryPart(cache);
  } catch {
    // Not kept.
  }
}
