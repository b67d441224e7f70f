import { firstTraceSample, traceSample } from "../../document/trace/trace-samples.ts";
import { traceDefaults, type TraceDocument } from "../../document/trace/trace.ts";
import { dropPicture } from "../../kernel/trace/pictures.ts";
import { ProbeError } from "../../kernel/trace/probes.ts";
import type { TraceClient } from "../../kernel/trace/trace-client.ts";
import type { Editor } from "../editor.ts";
import { openedSample, openPicture, showBox } from "./trace-edits.ts";
import type { Incoming } from "./trace-state.ts";

/** What is opened without a command of Trace: a picture that is brought in, a sample that an address names. */

/** Says that a picture could not be opened; the page has the words. */
export type Refuse = (name: string, code: string) => void;

/** A sample that is only named gets its own settings; a name that is none is said and forgotten. */
export function ensureSample(editor: Editor): void {
  const { trace } = editor.state.value;
  if (trace.sample === undefined) return;
  const sample = traceSample(trace.sample);
  if (sample === undefined) {
    editor.notify({ kind: "toast", text: `There is no sample called ${trace.sample}.` });
    return editor.traceEdits.amend(() => ({ trace: openedSample(firstTraceSample) }));
  }
  // An address names it and nothing else; a shared link and a file have settings.
  if (trace.settings !== traceDefaults) return;
  editor.traceEdits.amend(({ trace: named }) => ({ trace: { ...named, settings: openedSample(sample).settings } }));
  showBox(editor, sample);
  editor.patch({ hint: sample.note });
}

/** Pictures that were brought in so far: a small one may be looked at before a large one that came earlier. */
let brought = 0;

/** Whether both are of the same picture. Who has opened another meanwhile wants that one. */
function isOf(a: TraceDocument, b: TraceDocument): boolean {
  return a.sample === b.sample && a.picture === b.picture && a.kept === b.kept;
}

export async function openIncoming(editor: Editor, client: TraceClient, refuse: Refuse, { name, source, instead }: Incoming): Promise<void> {
  editor.patch({ incoming: null });
  brought += 1;
  const own = brought;
  try {
    const [width, height] = await client.probe(source);
    if (own !== brought || !isOf(editor.state.value.trace, instead)) return dropPicture(source.key);
    openPicture(editor, { name, width, height, key: source.key });
    editor.notify({ kind: "announce", text: `${name} opened, ${width} by ${height} pixels` });
  } catch (error) {
    dropPicture(source.key);
    // Another was brought after it, and nothing is said of what that one took the place of.
    if (own === brought) refuse(name, error instanceof ProbeError ? error.code : "");
  }
}
