import type { Editor, EditorState, Notice } from "./editor.ts";
import type { Tool } from "./tool.ts";

/** Says that something is being loaded: the page is not idle before it is there. */
export function whileLoading<T>(editor: Editor, work: Promise<T>): Promise<T> {
  editor.loading.add(work);
  const done = (): unknown => editor.loading.delete(work);
  work.then(done, done);
  return work;
}

/** Does something with what is on its way; the page is not idle before it is done. */
export function whenLoaded<T>(editor: Editor, coming: Promise<T>, run: (loaded: T) => unknown): void {
  const sayThere = askedFor(editor);
  void whileLoading(editor, coming.then((loaded) => {
    sayThere();
    return run(loaded);
  }, (error: unknown) => sayMissing(editor, "This feature", error)));
}

/** Work with what is loaded when it is first wanted: done as soon as it is there, and at once from then on. */
export interface OnDemand<T> {
  (editor: Editor, work: (loaded: T) => void): void;
  /** Loads it before it is wanted. */
  load(): Promise<T>;
}

/** What users were told last of something that did not come. */
const lacking = new WeakMap<Editor, Notice>();

/** Says that something did not come. */
export function sayMissing(editor: Editor, what: string, error: unknown): void {
  const text = error instanceof Error ? error.message : String(error);
  const notice: Notice = { kind: "error", id: "part-missing", text: `${what} could not be loaded (${text}). Check the connection, then try again.` };
  lacking.set(editor, notice);
  editor.notify(notice);
}

/**
 * To be called once what is asked for now has come: what had been said by now of something that did not is over then.
 * What is said while it is on its way stands; that this came says nothing of it.
 */
export function askedFor(editor: Editor): () => void {
  const said = lacking.get(editor);
  return () => {
    if (said === lacking.get(editor) && lacking.delete(editor)) editor.notify({ kind: "well", of: "part-missing" });
  };
}

export function onDemand<T>(load: () => Promise<T>): OnDemand<T> {
  let loaded: T | null = null;
  let coming: Promise<T> | null = null;
  const arrive = (): Promise<T> => (coming ??= load().then((it) => (loaded = it)).finally(() => (coming = null)));
  const work = (editor: Editor, run: (loaded: T) => void): void => {
    if (loaded === null) whenLoaded(editor, arrive(), run);
    else run(loaded);
  };
  return Object.assign(work, { load: arrive });
}

/** What is loaded when it is first wanted. */
export interface Late<T> {
  /** Null until it is there. */
  (): T | null;
  /** Whether it is on its way. */
  readonly coming: boolean;
}

/** What did not come is asked for again when it is wanted anew, not with every change until then. */
export function late<T>(editor: Editor, wanted: (state: EditorState) => boolean, load: () => Promise<T>, arrived: (loaded: T) => void = () => undefined): Late<T> {
  let loaded: T | null = null;
  let [coming, refused] = [false, false];
  editor.state.subscribe((state) => {
    if (!wanted(state)) refused = false;
    else if (loaded === null && !coming && !refused) {
      coming = true;
      const sayThere = askedFor(editor);
      void whileLoading(editor, load().then((it) => {
        [loaded, coming] = [it, false];
        sayThere();
        arrived(it);
      }, (error: unknown) => {
        [coming, refused] = [false, true];
        sayMissing(editor, "This feature", error);
      }));
    }
  }, { now: true });
  return Object.defineProperty(() => loaded, "coming", { get: () => coming }) as Late<T>;
}

/** A tool that is loaded when it first comes up; what the pointer does before it is there is done as soon as it is. */
export function lazyTool(editor: Editor, isUp: (state: EditorState) => boolean, load: () => Promise<Tool>): Tool {
  let waiting: ((loaded: Tool) => void)[] = [];
  let passing: Parameters<Tool["hover"]>[0] | null = null;
  const there = late(editor, isUp, load, (loaded) => {
    if (passing !== null) loaded.hover(passing);
    for (const work of waiting.splice(0)) work(loaded);
  });
  const soon = (work: (loaded: Tool) => void): void => {
    const tool = there();
    if (tool !== null) return work(tool);
    // What was done before something that never came is not done later, out of the blue.
    waiting = there.coming ? [...waiting, work] : [];
  };
  return {
    hover(sample) {
      // Of where the pointer passed by, only the last place is of use later.
      passing = sample;
      there()?.hover(sample);
    },
    press: (sample) => soon((loaded) => loaded.press(sample)),
    drag: (sample) => soon((loaded) => loaded.drag(sample)),
    release: (sample) => soon((loaded) => loaded.release(sample)),
    cancel: () => there()?.cancel() ?? false,
    finish: () => there()?.finish() ?? false,
  };
}
