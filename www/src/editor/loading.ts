import type { Editor } from "./editor.ts";
import type { Tool } from "./tool.ts";

/** Says that something is being loaded: the page is not idle before it is there. */
export function whileLoading<T>(editor: Editor, work: Promise<T>): Promise<T> {
  editor.loading.add(work);
  const done = (): unknown => editor.loading.delete(work);
  work.then(done, done);
  return work;
}

/** A tool that is loaded when it first comes up; what the pointer does before it is there is done as soon as it is. */
export function lazyTool(editor: Editor, isUp: () => boolean, load: () => Promise<Tool>): Tool {
  let tool: Tool | null = null;
  let asked = false;
  const waiting: ((loaded: Tool) => void)[] = [];
  editor.state.subscribe(() => {
    if (asked || !isUp()) return;
    asked = true;
    void whileLoading(editor, load().then((loaded) => {
      tool = loaded;
      for (const work of waiting.splice(0)) work(loaded);
    }));
  });
  const soon = (work: (loaded: Tool) => void): void => {
    if (tool === null) waiting.push(work);
    else work(tool);
  };
  return {
    hover: (sample) => soon((loaded) => loaded.hover(sample)),
    press: (sample) => soon((loaded) => loaded.press(sample)),
    drag: (sample) => soon((loaded) => loaded.drag(sample)),
    release: (sample) => soon((loaded) => loaded.release(sample)),
    cancel: () => tool?.cancel() ?? false,
    finish: () => tool?.finish() ?? false,
  };
}
