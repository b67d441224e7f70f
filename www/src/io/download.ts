/** Hands a file to the browser's downloads; its address is taken back once the download has started. */
export function download(name: string, content: Blob): void {
  const url = URL.createObjectURL(content);
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/**
 * Puts text on the clipboard, or what a promise of it brings; false where the browser does not allow it. Asked in the
 * turn of the press: Safari forgets a press as soon as a part of the page is being loaded.
 */
export async function copyText(text: string | Promise<string>): Promise<boolean> {
  try {
    const { clipboard } = navigator;
    if (typeof text === "string") await clipboard.writeText(text);
    else await clipboard.write([new ClipboardItem({ "text/plain": text.then((there) => new Blob([there], { type: "text/plain" })) })]);
    return true;
  } catch {
    return false;
  }
}
