/** What the address of a shared drawing begins with. */
export const linkPrefix = "#s=";

export function isShareLink(hash: string): boolean {
  return hash.startsWith(linkPrefix);
}
