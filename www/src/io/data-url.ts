/** A picture within a style or a page: `data:image/svg+xml,…`, in base64 or percent-encoded, alone or in `url("…")`. */
const dataUrl = /^(?:[\w-]+\s*:\s*)?(?:url\(\s*)?["']?data:image\/svg\+xml([^,]*),(.*?)["']?\s*\)?\s*;?$/su;

/** The SVG text of a data URL; any other text, and what cannot be decoded, as it is. */
export function withoutDataUrl(text: string): string {
  const [, how = "", content] = dataUrl.exec(text.trim()) ?? [];
  if (content === undefined) return text;
  try {
    const plain = decodeURIComponent(content);
    return /;\s*base64$/iu.test(how) ? new TextDecoder().decode(Uint8Array.from(atob(plain), (char) => char.charCodeAt(0))) : plain;
  } catch {
    return text;
  }
}
