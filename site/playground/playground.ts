/** The playground: an editor, what its code prints and draws, and links that hold the code. */
import { EXAMPLES } from "./examples.ts";
import { mountEditor } from "./editor.ts";
import type { Level } from "./messages.ts";
import { showDrawn } from "./preview.ts";
import { Runner } from "./runner.ts";
import { codeOf, fragmentOf } from "./share.ts";

const root = document.documentElement.dataset["root"] ?? "";

const make = <K extends keyof HTMLElementTagNameMap>(name: K, look: string, text = ""): HTMLElementTagNameMap[K] =>
  Object.assign(document.createElement(name), { className: look, textContent: text });

const SAID_FOR = 1500;

async function mount(host: HTMLElement): Promise<void> {
  const bar = make("div", "play-bar");
  const label = make("label", "", "Example");
  const examples = make("select", "");
  examples.append(...EXAMPLES.map(({ name }) => new Option(name)));
  label.append(examples);
  const [run, stop, share] = [make("button", "play-run", "Run"), make("button", "", "Stop"), make("button", "", "Copy link")];
  const status = make("span", "play-status");
  status.setAttribute("role", "status");
  run.title = "Ctrl or ⌘ with Enter";
  run.setAttribute("aria-keyshortcuts", "Control+Enter Meta+Enter");
  stop.disabled = true;
  bar.append(label, run, stop, share, status);
  const [code, drawn, said] = [make("div", "play-code"), make("div", "play-drawn"), make("div", "play-said")];
  said.setAttribute("role", "log");
  said.setAttribute("aria-label", "Console");
  said.tabIndex = 0;
  host.replaceChildren(bar, code, drawn, said);

  const linked = await codeOf(location.hash);
  const runner = new Runner(host, `${root}assets/`);
  const print = (level: Level, text: string): void => {
    said.append(make("pre", `said-${level}`, text));
    said.scrollTop = said.scrollHeight;
  };
  const setRunning = (isRunning: boolean, text: string): void => {
    stop.disabled = !isRunning;
    host.dataset["state"] = isRunning ? "running" : "idle";
    status.textContent = text;
  };
  const start = (): void => {
    said.replaceChildren();
    setRunning(true, "Running …");
    void runner.run(editor.code(), {
      said: print,
      done(all, milliseconds) {
        showDrawn(drawn, all);
        setRunning(false, `Done in ${milliseconds.toFixed(0)} ms.`);
      },
      failed(text) {
        print("error", text);
        setRunning(false, "Failed.");
      },
    });
  };
  const changed = (): void => {
    // The address no longer says what is in the editor.
    if (location.hash !== "") history.replaceState(null, "", location.pathname + location.search);
  };
  const editor = mountEditor(code, linked ?? EXAMPLES[0]?.code ?? "", changed, start);

  run.addEventListener("click", start);
  stop.addEventListener("click", () => {
    runner.stop();
    setRunning(false, "Stopped.");
  });
  examples.addEventListener("change", () => {
    const example = EXAMPLES[examples.selectedIndex];
    if (example === undefined) return;
    editor.setCode(example.code);
    start();
  });
  share.addEventListener("click", async () => {
    const fragment = await fragmentOf(editor.code());
    history.replaceState(null, "", `#${fragment}`);
    const copied = await navigator.clipboard.writeText(location.href).then(() => true, () => false);
    share.textContent = copied ? "Copied" : "It is in the address";
    setTimeout(() => (share.textContent = "Copy link"), SAID_FOR);
  });
  addEventListener("hashchange", async () => {
    const next = await codeOf(location.hash);
    if (next === undefined || next === editor.code()) return;
    const { hash } = location;
    editor.setCode(next);
    history.replaceState(null, "", hash);
    setRunning(false, "From a link: press Run.");
  });
  // What somebody else has written waits for a person; what is our own shows what it does.
  if (linked === undefined) start();
  else setRunning(false, "From a link: press Run.");
}

const host = document.querySelector<HTMLElement>(".play");
if (host !== null) void mount(host);
