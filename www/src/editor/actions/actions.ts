import type { Action, ActionRegistry, Editor } from "../editor.ts";

/** One definition of each action: toolbar, menus, keys and help all read this list. */
export function createActions(editor: Editor): ActionRegistry {
  const byId = new Map<string, Action>();
  return {
    register(action) {
      byId.set(action.id, action);
    },
    get(id) {
      return byId.get(id);
    },
    all() {
      return [...byId.values()];
    },
    run(id) {
      const action = byId.get(id);
      if (action === undefined || action.enabled?.(editor.state.value) === false) return false;
      action.run(editor);
      return true;
    },
  };
}
