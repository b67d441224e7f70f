/** Code in the fragment of an address: compressed, so that a page of code is a link; no server ever sees it. */

const NAME = "code=";
/** Longer code than this is not taken out of a link: a few hundred bytes can say a billion. */
const LONGEST = 200_000;

const toText = (bytes: Uint8Array): string => btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
const toBytes = (text: string): Uint8Array<ArrayBuffer> => Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));

/** The fragment that holds the code, without its `#`. */
export async function fragmentOf(code: string): Promise<string> {
  const packed = new Blob([code]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  return NAME + toText(new Uint8Array(await new Response(packed).arrayBuffer()));
}

/** The code that a fragment holds; undefined where it holds none that can be read. */
export async function codeOf(fragment: string): Promise<string | undefined> {
  const text = fragment.replace(/^#/, "");
  if (!text.startsWith(NAME)) return undefined;
  try {
    const reader = new Blob([toBytes(text.slice(NAME.length))]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader();
    const decoder = new TextDecoder("utf-8", { fatal: true });
    let code = "";
    for (let part = await reader.read(); !part.done; part = await reader.read()) {
      code += decoder.decode(part.value, { stream: true });
      if (code.length > LONGEST) return undefined;
    }
    return code + decoder.decode();
  } catch {
    return undefined;
  }
}
