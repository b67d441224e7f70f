/** The wasm module and its one living instance: started at the first call, replaced when it dies. */
import type { InitOutput } from "../build/bindings/expline.js";
import { version as builtVersion } from "../build/bindings/version.js";
import { wasmAddress, wasmBytes } from "../build/bindings/wasm-bytes.js";
import { options as checkOptions } from "./arguments.js";
import { ExplineError, shown, wrong } from "./error.js";

/** The version of the package. */
export const version: string = builtVersion;

/** The functions of the wasm that the package calls. @internal */
export type Kernel = InitOutput;

/** Where the engine comes from, if not from the package itself. */
export interface InitOptions {
  /** Where the .wasm file is. */
  wasmUrl?: string | URL;
  /** The bytes of the .wasm file. */
  bytes?: BufferSource;
  /** The compiled module, for instance one that another worker sent. */
  module?: WebAssembly.Module;
}

/** How many curves an instance keeps at once. @internal */
export const SLOTS = 16;

/** One instance, with what is known about its memory and about which curves it holds. @internal */
export class Instance {
  readonly kernel: Kernel;
  /** Place of the record of scalar results, in numbers. */
  readonly record: number;
  /** Which curve lies in each slot; 0 for none. */
  readonly ids: number[] = new Array<number>(SLOTS).fill(0);
  /** When each slot was last used, in calls. */
  readonly used: number[] = new Array<number>(SLOTS).fill(0);
  /** Points of all curves that were loaded since the slots were emptied. */
  points = 0;
  /** Place of the input, in numbers, and how many fit there. */
  input = 0;
  capacity = 0;
  #floats: Float64Array;

  constructor(kernel: Kernel) {
    this.kernel = kernel;
    this.record = kernel.record_address() / 8;
    this.#floats = new Float64Array(kernel.memory.buffer);
  }

  /** The memory, as it is now: growing takes the old view away. */
  get floats(): Float64Array {
    if (this.#floats.length === 0) this.#floats = new Float64Array(this.kernel.memory.buffer);
    return this.#floats;
  }
}

let module: WebAssembly.Module | undefined;
let current: Instance | undefined;
let starting: Promise<void> | undefined;

/** The living instance; compiles and starts one where there is none. @internal */
export function engine(): Instance {
  return current ?? (current = instantiate((module ??= compile(inlined()))));
}

/** Takes the instance out of service after anything but a clear answer came out of it. @internal */
export function retire(op: string, cause: unknown): ExplineError {
  current = undefined;
  const what = "the engine stopped and is replaced at the next call; no curve is lost";
  return new ExplineError("E_INTERNAL", op, what, { fatal: true, cause });
}

function initError(reason: string, what: string, cause?: unknown): ExplineError {
  return new ExplineError("E_INIT", "init", what, { reason, cause });
}

/** WebAssembly itself, or a clear word that it is missing. */
function wasm(): typeof WebAssembly {
  if (typeof WebAssembly !== "object") throw initError("unsupported", "WebAssembly is missing here");
  return WebAssembly;
}

/** What a failed compilation means. */
function compileError(cause: unknown): ExplineError {
  const text = String(cause);
  if (/unsafe-eval|security policy|embedder/i.test(text)) {
    return initError("csp", "the page's content security policy lacks 'wasm-unsafe-eval'", cause);
  }
  return initError("compile", "these bytes are not a module that can be compiled here", cause);
}

/** The bytes that are inside the package. */
function inlined(): BufferSource {
  wasm();
  try {
    return wasmBytes();
  } catch (cause) {
    // Where the page forbids wasm, the decoder is the first to notice.
    throw cause instanceof ExplineError ? cause : compileError(cause);
  }
}

function compile(bytes: BufferSource): WebAssembly.Module {
  const { Module } = wasm();
  try {
    return new Module(bytes);
  } catch (cause) {
    throw compileError(cause);
  }
}

/** Three numbers of the version in one, as the kernel gives it. */
function versionNumber(): number {
  const [major = 0, minor = 0, patch = 0] = version.split(/[.-]/).map(Number);
  return 1e6 * major + 1e3 * minor + patch;
}

function instantiate(from: WebAssembly.Module): Instance {
  const { Instance: Start, Module } = wasm();
  let kernel: Kernel;
  try {
    const imports: Record<string, Record<string, () => void>> = {};
    for (const { module: room, name } of Module.imports(from)) (imports[room] ??= {})[name] = () => undefined;
    kernel = new Start(from, imports).exports as unknown as Kernel;
  } catch (cause) {
    throw cause instanceof RangeError
      ? initError("memory", "there is no memory for the engine", cause)
      : compileError(cause);
  }
  const found = typeof kernel.kernel_version === "function" ? kernel.kernel_version() : undefined;
  if (found !== versionNumber()) {
    throw initError("version", `the module is not that of expline ${version}`);
  }
  return new Instance(kernel);
}

/**
 * Loads the engine early, or from elsewhere. Not needed before the first call: without it the wasm inside the package is
 * compiled when it is first used.
 *
 * Calls while one is under way share it; once an engine is there, further calls change nothing. A failure is not kept:
 * the next call tries again.
 *
 * @throws {ExplineError} E_INIT with `reason` csp, network, mime, compile, version, memory or unsupported.
 */
export default function init(options?: InitOptions): Promise<void> {
  if (module !== undefined && current !== undefined) return Promise.resolve();
  starting ??= start(options).finally(() => {
    starting = undefined;
  });
  return starting;
}

async function start(given: unknown): Promise<void> {
  const { wasmUrl, bytes, module: ready } = checkOptions("init", given, ["wasmUrl", "bytes", "module"]);
  let next: WebAssembly.Module;
  if (ready !== undefined) next = asModule(ready);
  else if (wasmUrl !== undefined) next = await fetched(wasmUrl);
  else if (bytes === undefined && wasmAddress !== undefined) next = await fetched(wasmAddress());
  else next = await compiled(bytes === undefined ? inlined() : asBytes(bytes));
  adopt(next);
}

/** Starts the engine from bytes or from a module, without waiting; changes nothing where one runs already. */
export function initSync(options: { bytes: BufferSource } | { module: WebAssembly.Module }): void {
  const { bytes, module: ready } = checkOptions("initSync", options, ["bytes", "module"]);
  if (current !== undefined) return;
  if (ready === undefined && bytes === undefined) throw wrong("E_TYPE", "initSync", "bytes", bytes, "BufferSource");
  adopt(ready === undefined ? compile(asBytes(bytes)) : asModule(ready));
}

function adopt(next: WebAssembly.Module): void {
  if (current !== undefined) return;
  current = instantiate(next);
  module = next;
}

function asModule(value: unknown): WebAssembly.Module {
  if (!(value instanceof wasm().Module)) throw wrong("E_TYPE", "init", "module", value, "WebAssembly.Module");
  return value;
}

function asBytes(value: unknown): BufferSource {
  if (value instanceof ArrayBuffer || ArrayBuffer.isView(value)) return value as BufferSource;
  throw wrong("E_TYPE", "init", "bytes", value, "BufferSource");
}

async function compiled(bytes: BufferSource): Promise<WebAssembly.Module> {
  const { compile: begin } = wasm();
  try {
    return await begin.call(WebAssembly, bytes);
  } catch (cause) {
    throw compileError(cause);
  }
}

async function fetched(url: unknown): Promise<WebAssembly.Module> {
  if (typeof url !== "string" && !(url instanceof URL)) throw wrong("E_TYPE", "init", "wasmUrl", url, "string or URL");
  const bytes = await read(String(url));
  const magic = new Uint8Array(bytes, 0, Math.min(4, bytes.byteLength));
  if (String.fromCharCode(...magic) !== "\0asm") {
    throw initError("mime", `what ${shown(String(url))} answers is not WebAssembly`);
  }
  return compiled(bytes);
}

/** The part of Node that reads files; it is asked for only when a file: address is given. */
interface Files {
  readFile(path: URL): Promise<Uint8Array<ArrayBuffer>>;
}

async function read(url: string): Promise<ArrayBuffer> {
  try {
    if (url.startsWith("file:")) {
      const host = globalThis as { process?: { getBuiltinModule?: (name: string) => Files | undefined } };
      const file = await host.process?.getBuiltinModule?.("node:fs/promises")?.readFile(new URL(url));
      if (file !== undefined) return file.slice().buffer;
    }
    const answer = await fetch(url);
    if (!answer.ok) throw new Error(`HTTP status ${answer.status}`);
    return await answer.arrayBuffer();
  } catch (cause) {
    throw initError("network", `${shown(url)} could not be read`, cause);
  }
}
