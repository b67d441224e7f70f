import assert from "node:assert/strict";
import { after, before, type TestContext } from "node:test";
import type { Browser, BrowserContextOptions, Page } from "playwright-core";
import { launch } from "../../scripts/browser.mjs";

/** The documentation in a real browser. */

export const SITE_URL = process.env["SITE_URL"] ?? "";

/** A page, and what it complained about or asked of another host. */
export interface Opened {
  readonly page: Page;
  readonly complaints: string[];
}

/** One browser for a test file. Call at its top level. */
export function useSite(): (t: TestContext, path?: string, options?: BrowserContextOptions) => Promise<Opened> {
  let browser: Browser | undefined;
  before(async () => {
    browser = await launch();
  });
  after(async () => {
    await browser?.close();
  });
  return async (t, path = "", options = {}) => {
    assert.ok(browser !== undefined && SITE_URL !== "", "the browser is started and SITE_URL names the served site");
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, deviceScaleFactor: 1, reducedMotion: "reduce", ...options });
    t.after(() => context.close());
    const page = await context.newPage();
    const complaints: string[] = [];
    page.on("console", (message) => message.type() === "error" && complaints.push(`${message.text()} ${message.location().url}`));
    page.on("pageerror", (error) => complaints.push(String(error)));
    page.on("request", (request) => {
      const url = new URL(request.url());
      if (url.origin !== new URL(SITE_URL).origin && !/^(?:blob|data):$/.test(url.protocol)) complaints.push(`asks ${url.href}`);
    });
    await page.goto(SITE_URL + path);
    return { page, complaints };
  };
}

/** All pages that links lead to from the first one, by their paths: what they name by `id`, their links, their text. */
export async function crawled(): Promise<{ pages: Map<string, { ids: Set<string>; links: string[]; html: string }>; lost: string[] }> {
  const pages = new Map<string, { ids: Set<string>; links: string[]; html: string }>();
  const lost: string[] = [];
  const open = ["index.html"];
  const seen = new Set(open);
  for (let path = open.pop(); path !== undefined; path = open.pop()) {
    const response = await fetch(SITE_URL + path);
    if (!response.ok) {
      lost.push(path);
      continue;
    }
    const html = await response.text();
    const hrefs = [...html.matchAll(/<a [^>]*?href="([^"]+)"/g)].map(([, href = ""]) => href.replaceAll("&amp;", "&"));
    const links = hrefs.filter((href) => !/^https?:/.test(href)).map((href) => new URL(href, SITE_URL + path).href);
    pages.set(path, { ids: new Set([...html.matchAll(/ id="([^"]+)"/g)].map(([, id = ""]) => id)), links, html });
    for (const link of links) {
      if (!link.startsWith(SITE_URL)) continue;
      const next = link.slice(SITE_URL.length).replace(/#.*/, "") || "index.html";
      if (!seen.has(next) && /\.html$/.test(next)) open.push(next);
      seen.add(next);
    }
  }
  return { pages, lost };
}
