import type { Editor, EditorState } from "./editor.ts";
import type { Tool } from "./tool.ts";

/** Says that something is being loaded: the page is not idle before it is there. */
export function whileLoading<T>(editor: Editor, work: Promise<T>): Promise<T> {
  editor.loading.add(work);
  const done = (): unknown => editor.loading.delete(work);
  work.then(done, done);
  return work;
}

/** Work with what is loaded when it is first wanted: done as soon as it is there, and at once from then on. */
export interface OnDemand<T> {
  (editor: Editor, work: (loaded: T) => void): void;
  /** Loads it before it is wanted. */
  load(): Promise<T>;
}

export function onDemand<T>(load: () => Promise<T>): OnDemand<T> {
  let loaded: T | null = null;
  const arrive = (): Promise<T> => load().then((it) => (loaded = it));
  const work = (editor: Editor, run: (loaded: T) => void): void => {
    if (loaded === null) void whileLoading(editor, arrive().then(run));
    else run(loaded);
  };
  return Object.assign(work, { load: arrive });
}

/** What is loaded when it is first wanted; null until it is there. */
export function late<T>(editor: Editor, wanted: (state: EditorState) => boolean, load: () => Promise<T>, arrived: (loaded: T) => void = () => undefined): () => T | null {
  let loaded: T | null = null;
  let asked = false;
  editor.state.subscribe((state) => {
    if (asked || !wanted(state)) return;
    asked = true;
    void whileLoading(editor, load().then((it) => {
      loaded = it;
      arrived(it);
    }));
  }, { now: true });
  return () => loaded;
}

/** A tool that is loaded when it first comes up; what the pointer does before it is there is done as soon as it is. */
export function lazyTool(editor: Editor, isUp: () => boolean, load: () => Promise<Tool>): Tool {
  const waiting: ((loaded: Tool) => void)[] = [];
  const there = late(editor, isUp, load, (loaded) => {
    for (const work of waiting.splice(0)) work(loaded);
  });
  const soon = (work: (loaded: Tool) => void): void => {
    const tool = there();
    if (tool === null) waiting.push(work);
    else work(tool);
  };
  return {
    hover: (sample) => soon((loaded) => loaded.hover(sample)),
    press: (sample) => soon((loaded) => loaded.press(sample)),
    drag: (sample) => soon((loaded) => loaded.drag(sample)),
    release: (sample) => soon((loaded) => loaded.release(sample)),
    cancel: () => there()?.cancel() ?? false,
    finish: () => there()?.finish() ?? false,
  };
}
