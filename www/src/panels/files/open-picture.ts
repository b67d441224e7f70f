import { keepPicture } from "../../kernel/trace/pictures.ts";
import type { Shell } from "../shell.ts";

/** Hands a picture to Trace, which is loaded if it is not there yet. */
export function openPicture({ editor }: Shell, name: string, content: Blob): void {
  const key = keepPicture(content);
  if (editor.state.value.mode !== "trace") editor.actions.run("mode-trace");
  editor.patch({ incoming: { name, source: { kind: "file", key, content } } });
}
