import { Problem } from "../../document/problem.ts";
import { keepPicture } from "../../kernel/trace/pictures.ts";
import type { Shell } from "../shell.ts";

/** Pictures that were brought in so far: a small one may be decoded before a large one that came earlier. */
let brought = 0;

/**
 * Hands a picture to Trace, which is loaded if it is not there yet. One that is none takes nobody away from what they
 * work on. @throws Problem
 */
export async function openPicture({ editor }: Pick<Shell, "editor">, name: string, content: Blob): Promise<void> {
  brought += 1;
  const own = brought;
  const { trace: instead } = editor.state.value;
  if (editor.state.value.mode !== "trace") await checkDecodes(name, content);
  if (own !== brought) return;
  // Before it is on its way: what is said of it, or of files beside it, may come sooner than the picture does.
  editor.notify({ kind: "well" });
  const key = keepPicture(content);
  if (editor.state.value.mode !== "trace") editor.actions.run("mode-trace");
  editor.patch({ incoming: { name, source: { kind: "file", key, content }, instead } });
}

async function checkDecodes(name: string, content: Blob): Promise<void> {
  try {
    (await createImageBitmap(content)).close();
  } catch {
    throw new Problem("image-broken", { name });
  }
}
