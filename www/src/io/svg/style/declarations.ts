/** The last value of each property of a `style` attribute. */
export function declarations(element: Element): ReadonlyMap<string, string> {
  const style = element.getAttribute("style") ?? "";
  return new Map(style.split(";").flatMap((each): [string, string][] => {
    const colon = each.indexOf(":");
    return colon < 0 ? [] : [[each.slice(0, colon).trim().toLowerCase(), each.slice(colon + 1).replace(/!\s*important\s*$/iu, "").trim()]];
  }));
}
