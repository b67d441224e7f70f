// A static file server on this machine only, with the headers that the demo is promised to work under.

import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { basename, extname, join, normalize, sep } from "node:path";
import { gzipSync } from "node:zlib";

const TYPES = {
  ".css": "text/css; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".ico": "image/x-icon",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json; charset=utf-8",
  ".mjs": "text/javascript; charset=utf-8",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".txt": "text/plain; charset=utf-8",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json",
};

/** The demo's Content Security Policy; `data:` and `blob:` are for pictures only. */
export const POLICY =
  "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' data: blob:; worker-src 'self'";

const FIRST_PORT = 4173;
const PORTS_TRIED = 50;

/** What the playground runs other people's code in has no origin, even where it is opened by itself. */
const SANDBOX = { file: "sandbox.html", policy: "sandbox allow-scripts; frame-ancestors 'self'" };

/** The file of an address: below `beside`'s names in their folders, otherwise in `folder`. */
function fileOf(folder, beside, url) {
  const path = decodeURIComponent(new URL(url, "http://localhost").pathname);
  const name = Object.keys(beside).find((each) => path.startsWith(`/${each}/`));
  const [from, rest] = name === undefined ? [folder, path] : [beside[name], path.slice(name.length + 1)];
  const file = normalize(join(from, rest.endsWith("/") ? `${rest}index.html` : rest));
  return file.startsWith(from + sep) ? file : undefined;
}

/** What was compressed before, by file: a page of a test asks for the same as the one before it. */
const compressed = new Map();

function gzipped(file, body) {
  const known = compressed.get(file);
  if (known?.body.equals(body)) return known.gzip;
  const gzip = gzipSync(body);
  compressed.set(file, { body, gzip });
  return gzip;
}

async function answer({ folder, beside, policy }, request, response) {
  if (request.method !== "GET" && request.method !== "HEAD") {
    response.writeHead(405, { Allow: "GET, HEAD" }).end();
    return;
  }
  const name = Object.keys(beside).find((each) => request.url === `/${each}`);
  if (name !== undefined) {
    response.writeHead(308, { Location: `/${name}/` }).end();
    return;
  }
  let body;
  let file;
  try {
    file = fileOf(folder, beside, request.url);
    body = await readFile(file);
  } catch {
    response.writeHead(404, { "Content-Type": "text/plain; charset=utf-8" }).end("not found\n");
    return;
  }
  const type = TYPES[extname(file)] ?? "application/octet-stream";
  const headers = { "Content-Type": type, "Cache-Control": "no-cache", "X-Content-Type-Options": "nosniff", Vary: "Accept-Encoding" };
  if (policy && type.startsWith("text/html")) headers["Content-Security-Policy"] = basename(file) === SANDBOX.file ? SANDBOX.policy : policy;
  if (/\bgzip\b/.test(request.headers["accept-encoding"] ?? "") && !/^image\/png/.test(type)) {
    headers["Content-Encoding"] = "gzip";
    body = gzipped(file, body);
  }
  headers["Content-Length"] = body.length;
  response.writeHead(200, headers).end(request.method === "HEAD" ? undefined : body);
}

/**
 * Serves a folder and gives back its address and a way to stop. `port` 0 is any free one; otherwise the first free
 * one from `port` on. `beside` has other folders that are served with it, by the name below which they are.
 */
export async function serve(folder, { port = FIRST_PORT, policy = POLICY, beside = {} } = {}) {
  const server = createServer((request, response) => void answer({ folder, beside, policy }, request, response));
  const listen = (candidate) =>
    new Promise((resolve, reject) => {
      server.once("error", reject).listen(candidate, "127.0.0.1", () => {
        server.off("error", reject);
        resolve(server.address().port);
      });
    });
  let bound;
  for (let i = 0; bound === undefined; i++) {
    try {
      bound = await listen(port === 0 ? 0 : port + i);
    } catch (error) {
      if (error.code !== "EADDRINUSE" || i >= PORTS_TRIED) throw error;
    }
  }
  const close = () => new Promise((resolve) => (server.closeAllConnections(), server.close(resolve)));
  return { url: `http://localhost:${bound}/`, close };
}
