import { createContract } from "./contract.ts";
import { createEditor } from "./editor/create-editor.ts";
import { listenToStage } from "./editor/dom-input.ts";
import { createFrame } from "./editor/frame.ts";
import { createPointerInput } from "./editor/pointer-input.ts";
import { connectRoutes, openRoute, parseRoute } from "./editor/route.ts";
import { registerStandardActions } from "./editor/standard-actions.ts";
import { startEngine } from "./kernel/engine.ts";
import { createProxies } from "./render/proxies.ts";
import { createStage } from "./render/stage.ts";
import { mountHint, mountLive, mountZoomBox } from "./render/stage-parts.ts";
import { createTools } from "./tools/tools.ts";

/** Puts the page together: the editor, the stage, the panels, and the first document. */

function part(name: string): HTMLElement {
  const element = document.querySelector<HTMLElement>(`[data-part="${name}"]`);
  if (element === null) throw new Error(`index.html has no part named ${name}`);
  return element;
}

const until = new AbortController().signal;
const editor = createEditor(() => performance.now());
const frame = createFrame((callback) => requestAnimationFrame(callback), () => performance.now());
const surface = part("surface");
const canvas = part("canvas");

registerStandardActions(editor);
const input = createPointerInput(editor, createTools(editor));
listenToStage({ editor, input, frame, surface, until, leaveStage: () => surface.blur() });
if (canvas instanceof HTMLCanvasElement) createStage(editor, frame, surface, canvas, until);
createProxies(editor, frame, surface, part("proxies"), until);
mountHint(editor, part("hint"), until);
mountZoomBox(editor, part("zoom"), until);
mountLive(editor, part("live"), part("summary"), until);

async function boot(): Promise<void> {
  const failure = await startEngine();
  if (failure !== null) {
    editor.patch({ engine: { status: "failed", ...failure } });
    return;
  }
  editor.patch({ engine: { status: "ready" } });
  openRoute(editor, parseRoute(location.hash) ?? { mode: "curve", sample: null });
  editor.setState(editor.getState(), { fresh: true });
  connectRoutes(editor, until);
  await frame.idle();
}

window.explineDemo = createContract({ editor, frame, ready: boot(), readState: (value) => value as never });
