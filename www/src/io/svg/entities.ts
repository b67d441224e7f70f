import { overLimit, SvgFileError, type SvgLimits } from "./limits.ts";

/** `<!ENTITY name "plain text">`: what Illustrator writes for its namespaces. */
const plain = /<!ENTITY\s+([\w.-]+)\s+(?:"([^"<>&%']*)"|'([^'<>&%"]*)')\s*>/gu;

/**
 * The text with the entities of its document type written out. Only such as stand for plain text: none that holds
 * another, names a file or has markup in it, so that nothing multiplies and no element comes out of one.
 */
export function withoutEntities(text: string, doctype: string, limits: SvgLimits): string {
  const values = new Map(Array.from(doctype.matchAll(plain), ([, name = "", double, single]) => [name, double ?? single ?? ""]));
  if (/<!ENTITY/iu.test(doctype.replace(plain, ""))) {
    throw new SvgFileError("E_PARSE_SVG", "svg: a document type that declares more than plain entities is refused", { reason: "doctype" });
  }
  if (values.size === 0) return text;
  let size = text.length;
  return text.replace(/&([\w.-]+);/gu, (reference, name: string) => {
    const value = values.get(name) ?? reference;
    size += value.length - reference.length;
    if (size > limits.maxBytes) throw overLimit("maxBytes", limits.maxBytes, size);
    return value;
  });
}
