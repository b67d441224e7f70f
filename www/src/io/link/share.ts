/**
 * Links: the state after `#s=`, as base64url of raw deflate of JSON. Nothing leaves the page, and a server never sees
 * it.
 */
import { emptyCurve, type DemoState } from "../../document/document.ts";
import { parseState } from "../../document/file/file.ts";
import { emptyFit } from "../../document/fit/fit.ts";
import { Problem } from "../../document/problem.ts";
import { emptySurface } from "../../document/surface/surface.ts";
import { emptyTrace, isEmptyTrace } from "../../document/trace/trace.ts";
import { deflate, inflate } from "./compress.ts";
import { isShareLink, linkPrefix } from "./link.ts";

const mostLinkBytes = 32 * 1024;
const mostUnpackedBytes = 8 * 1024 * 1024;

/** The parts of a state that say something: what is at its default comes back by itself. */
function worthSharing(state: DemoState): object {
  const { fit, trace, surface, ...rest } = state;
  // The points of a sample are made anew from its name, its noise and its seed.
  const short = fit.sample === undefined ? fit : { ...fit, data: [], starts: [] };
  // One that was emptied is not the sample that Fit begins with.
  const isOwn = fit.data.length > 0 || fit.sample === undefined;
  return { ...rest, ...(isOwn ? { fit: short } : {}), ...(isEmptyTrace(trace) ? {} : { trace }), ...(surface.net.length > 0 ? { surface } : {}) };
}

/** What is in the mode that is shown, and the others as they are before anybody has been there. */
function shownAlone(state: DemoState): DemoState {
  return { ...state, curve: emptyCurve, fit: emptyFit, trace: emptyTrace, surface: emptySurface, [state.mode]: state[state.mode] };
}

async function packed(state: DemoState): Promise<string> {
  return linkPrefix + toBase64Url(await deflate(new TextEncoder().encode(JSON.stringify(worthSharing(state)))));
}

/** @throws Problem `share-long` when the link would not fit everywhere. */
export async function shareHash(state: DemoState): Promise<string> {
  const hash = await packed(state);
  if (hash.length > mostLinkBytes) throw new Problem("share-long", { kilobytes: Math.ceil(hash.length / 1024) });
  return hash;
}

/**
 * The link to everything; where that is too much, to what is in the mode that is shown.
 *
 * @throws Problem `share-long` when even that would not fit everywhere.
 */
export async function shareLink(state: DemoState): Promise<{ readonly hash: string; readonly alone: boolean }> {
  const hash = await packed(state);
  if (hash.length <= mostLinkBytes) return { hash, alone: false };
  return { hash: await shareHash(shownAlone(state)), alone: true };
}

/** @throws Problem `share-bad` for whatever is wrong with it. */
export async function readShareHash(hash: string): Promise<DemoState> {
  try {
    if (!isShareLink(hash) || hash.length > 4 * mostLinkBytes) throw new RangeError("no link of this page");
    const text = await inflate(fromBase64Url(hash.slice(linkPrefix.length)), mostUnpackedBytes);
    return parseState(new TextDecoder("utf-8", { fatal: true }).decode(text)).state;
  } catch {
    throw new Problem("share-bad");
  }
}

function toBase64Url(bytes: Uint8Array): string {
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/u, "");
}

function fromBase64Url(text: string): Uint8Array<ArrayBuffer> {
  if (!/^[A-Za-z0-9_-]+$/u.test(text)) throw new RangeError("not base64url");
  const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(binary, (char) => char.charCodeAt(0));
}
