/** The fields of a state that this page knows; what else is in a file belongs to somebody else. */
const stateFields: readonly string[] = ["format", "version", "mode", "view", "curve", "fit", "trace", "surface", "orbit"];

/** The fields that are not this page's: they are carried along and written again as they were. */
export function othersOf(state: object): Record<string, unknown> {
  // As entries, so that a field called __proto__ stays a field.
  return Object.fromEntries(Object.entries(state).filter(([key]) => !stateFields.includes(key)));
}
