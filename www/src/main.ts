import { createContract, type ContractParts, type ExplineDemo } from "./contract.ts";
import { createEditor } from "./editor/create-editor.ts";
import { listenToStage } from "./editor/pointer/dom-input.ts";
import { createFrame } from "./editor/frame.ts";
import { createPointerInput } from "./editor/pointer/pointer-input.ts";
import { connectRoutes, openRoute, parseRoute } from "./editor/route.ts";
import { registerStandardActions } from "./editor/actions/standard-actions.ts";
import { keepForOffline } from "./io/offline/offline.ts";
import { loadModes, type ModeParts } from "./modes.ts";
import { pageIo } from "./io/page-io.ts";
import { startEngine } from "./kernel/engine.ts";
import { mountPanels } from "./panels/mount.ts";
import { keepFocus } from "./panels/page/focus.ts";
import { mountZoomBox } from "./panels/stage/zoom-box.ts";
import { createProxies } from "./render/proxies.ts";
import { createStage } from "./render/stage.ts";
import { mountHint, mountLabel, mountLive } from "./render/stage-parts.ts";
import { createTools } from "./tools/tools.ts";

/** Puts the page together: the editor, the stage, the panels, and the first document. */

function find(kind: "part" | "region", name: string): HTMLElement {
  const element = document.querySelector<HTMLElement>(`[data-${kind}="${name}"]`);
  if (element === null) throw new Error(`index.html has no ${kind} named ${name}`);
  return element;
}

const part = (name: string): HTMLElement => find("part", name);
const region = (name: string): HTMLElement => find("region", name);

/** The page as index.html has it, before anything is added. */
const pristine = document.body.querySelector(".app")?.cloneNode(true);

/** What listens, waits or works ends with the signal; what was drawn goes with its elements. */
function unmount(life: AbortController): { mount(): ExplineDemo } {
  life.abort();
  for (const element of [...document.body.children]) if (element.localName !== "script") element.remove();
  if (pristine !== undefined) document.body.prepend(pristine.cloneNode(true));
  return { mount };
}

function mount(): ExplineDemo {
  const life = new AbortController();
  const until = life.signal;
  const editor = createEditor(() => performance.now());
  const frame = createFrame((callback) => requestAnimationFrame(() => until.aborted || callback()), () => performance.now());
  const surface = part("surface");
  const canvas = part("canvas");

  const leaveStage = (): void => {
    const { activeElement } = document;
    if (activeElement instanceof HTMLElement && surface.contains(activeElement)) activeElement.blur();
  };

  registerStandardActions(editor);
  const input = createPointerInput(editor, createTools(editor, until));
  listenToStage({ editor, input, frame, surface, until, leaveStage });
  if (!(canvas instanceof HTMLCanvasElement)) throw new Error("index.html has no canvas");
  const stage = createStage(editor, frame, surface, canvas, until);
  createProxies(editor, frame, surface, part("proxies"), until);
  mountLabel(editor, surface, until);
  mountHint(editor, part("hint"), until);
  mountZoomBox(editor, part("zoom"), until);
  mountLive(editor, part("live"), part("summary"), until);

  const regions = { header: region("header"), rail: region("rail"), panel: region("panel"), status: region("status"), stage: region("stage") };
  const panels = mountPanels({ editor, regions, io: pageIo, frame, until });
  keepFocus(frame, surface, until);
  const parts: ContractParts = {};

  async function boot(): Promise<void> {
    const failure = await startEngine();
    if (failure !== null) {
      editor.patch({ engine: { status: "failed", ...failure } });
      return;
    }
    panels.wait("Opening your drawing…");
    const openSession = await panels.session;
    if (until.aborted) return;
    editor.patch({ engine: { status: "ready" } });
    openRoute(editor, parseRoute(location.hash) ?? { mode: "curve", sample: null });
    editor.setState(editor.getState(), { fresh: true });
    connectRoutes(editor, until);
    openSession();
    const shared: ModeParts = { editor, frame, stage, surface, proxies: part("proxies"), panels, contract: parts, until };
    parts.settled = loadModes(editor, {
      fit: async () => (await import("./fit-mode.ts")).mountFitMode(shared),
      trace: async () => (await import("./trace-mode.ts")).mountTraceMode(shared),
      surface: async () => (await import("./surface-mode.ts")).mountSurfaceMode(shared),
    }, panels.wait, until).settled;
    await parts.settled();
    await frame.idle();
  }

  return (window.explineDemo = createContract({
    editor, frame, ready: boot(), parts, unmount: () => unmount(life),
    readState: async (value) => (await import("./document/file/file.ts")).readState(value),
  }));
}

void mount().ready.then(keepForOffline);
