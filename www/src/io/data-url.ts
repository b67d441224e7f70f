/**
 * Pictures that are copied as text: the address of an image in a style sheet, or what a browser's tools call a data
 * URI.
 */

/**
 * In base64 nothing ends the text but what stands around it; unescaped drawings hold quotation marks of the other kind.
 */
const dataUrl = /^\s*(?:[\w-]+\s*:\s*)?(?:url\(\s*|<img\b[^>]*?\bsrc\s*=)?\s*(["']?)data:(image\/[\w.+-]+)((?:;[\w.+=-]+)*),(.*?)\1\s*(?:\/?>)?[\s);]*$/isu;

/** The file that a text is, or null where it is another text, or says that it is a picture and is none. */
export function fileInText(text: string): File | null {
  if (!/^\s*(?:[\w-]+\s*:\s*)?(?:url\(|<img\b|["']?data:)/iu.test(text.slice(0, 200))) return null;
  const [, , type = "", parameters = "", body = ""] = dataUrl.exec(text) ?? [];
  if (type === "") return null;
  try {
    const content = /;base64$/iu.test(parameters) ? bytesOf(body) : decodeURIComponent(body);
    return new File([content], "", { type: type.toLowerCase() });
  } catch {
    return null;
  }
}

function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const plain = atob(decodeURIComponent(base64).replace(/\s+/gu, ""));
  return Uint8Array.from(plain, (character) => character.charCodeAt(0));
}
