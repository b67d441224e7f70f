/** The wasm modules and the one living instance of each: started at the first call, replaced when it dies. */
import type { InitOutput } from "../../build/bindings/expline.js";
import { version as builtVersion } from "../../build/bindings/version.js";
import { wasmAddress, wasmBytes } from "../../build/bindings/wasm-bytes.js";
import { classOf, options as checkOptions } from "./arguments.js";
import { ExplineError, wrong } from "./error.js";
import type { Address, Bytes, CompiledModule } from "./host.js";

/** The version of the package. */
export const version: string = builtVersion;

/** The functions of the core's wasm that the package calls. @internal */
export type Kernel = InitOutput;

/** The functions that every wasm of the package has. @internal */
export type AnyKernel = Pick<Kernel, "memory" | "record_address" | "input_address" | "text_address" | "kernel_version">;

/** What every wasm that holds curves can do with them. @internal */
export type CurveKernel = AnyKernel &
  Pick<
    Kernel,
    | "area"
    | "bounds"
    | "centroid"
    | "curvature"
    | "evaluate_many"
    | "evaluate_one"
    | "flatten"
    | "forget"
    | "length"
    | "nearest"
    | "nearest_many"
    | "parameter_at_length"
    | "sample"
    | "sample_by_length"
    | "to_cubics"
  >;

/** Where an engine comes from, if not from the package itself. */
export interface InitOptions {
  /** Where the .wasm file is. */
  wasmUrl?: string | Address | undefined;
  /** The bytes of the .wasm file. */
  bytes?: Bytes | undefined;
  /** The compiled module, for instance one that another worker sent. */
  module?: CompiledModule | undefined;
}

/** Where an engine comes from that starts at once. */
export type InitSyncOptions = { bytes: Bytes; module?: undefined } | { bytes?: undefined; module: CompiledModule };

/** How many curves an instance keeps at once. @internal */
export const SLOTS = 16;

/** One instance, with what is known about its memory and about which curves it holds. @internal */
export class Instance<K extends AnyKernel = Kernel> {
  readonly kernel: K;
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

  constructor(kernel: K) {
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

/** One wasm of the package: where it comes from, compiled and living. @internal */
export interface Engine<K extends AnyKernel = Kernel> {
  /** Name of the function that starts it. */
  readonly op: string;
  /** A function that its wasm has and the others have not. */
  readonly mark: string;
  /** The bytes inside the package, for the operation that is waiting for them. */
  readonly bytes: (op: string) => Uint8Array<ArrayBuffer>;
  /** Where the file lies beside the slim package. */
  readonly address: (() => URL) | undefined;
  module?: WebAssembly.Module | undefined;
  current?: Instance<K> | undefined;
  starting?: Promise<void> | undefined;
}

/** The engine of curves. @internal */
export const core: Engine = { op: "init", mark: "load", bytes: wasmBytes, address: wasmAddress };

/** The living instance; compiles and starts one where there is none, for the operation `by`. @internal */
export function instanceOf<K extends AnyKernel>(engine: Engine<K>, by: string = engine.op): Instance<K> {
  return engine.current ?? (engine.current = instantiate(engine, (engine.module ??= compile(engine.op, inlined(engine, by)))));
}

/** Takes the instance out of service after anything but a clear answer came out of it. @internal */
export function retire(engine: { current?: unknown }, op: string, cause: unknown): ExplineError {
  engine.current = undefined;
  const what = "the engine stopped and is replaced at the next call; no curve is lost";
  return new ExplineError("E_INTERNAL", op, what, { fatal: true, cause });
}

function initError(op: string, reason: string, what: string, cause?: unknown): ExplineError {
  return new ExplineError("E_INIT", op, what, { reason, cause });
}

/** WebAssembly itself, or a clear word that it is missing. */
function wasm(op: string): typeof WebAssembly {
  if (typeof WebAssembly !== "object") throw initError(op, "unsupported", "WebAssembly is missing here");
  return WebAssembly;
}

/** What a failed compilation means. */
function compileError(op: string, cause: unknown): ExplineError {
  const text = String(cause);
  if (/unsafe-eval|security policy|embedder/i.test(text)) {
    return initError(op, "csp", "the page's content security policy lacks 'wasm-unsafe-eval'", cause);
  }
  return initError(op, "compile", "these bytes are not a module that can be compiled here", cause);
}

/** The bytes that are inside the package. */
function inlined({ op, bytes }: Pick<Engine, "op" | "bytes">, by: string): BufferSource {
  wasm(op);
  try {
    return bytes(by);
  } catch (cause) {
    // Where the page forbids wasm, the decoder is the first to notice.
    throw cause instanceof ExplineError ? cause : compileError(op, cause);
  }
}

function compile(op: string, bytes: BufferSource): WebAssembly.Module {
  const { Module } = wasm(op);
  try {
    return new Module(bytes);
  } catch (cause) {
    throw compileError(op, cause);
  }
}

/** Three numbers of the version in one, as the kernel gives it. */
function versionNumber(): number {
  const [major = 0, minor = 0, patch = 0] = version.split(/[.-]/).map(Number);
  return 1e6 * major + 1e3 * minor + patch;
}

function instantiate<K extends AnyKernel>({ op, mark }: Engine<K>, from: WebAssembly.Module): Instance<K> {
  const { Instance: Start, Module } = wasm(op);
  let kernel: K;
  try {
    const imports: Record<string, Record<string, () => void>> = {};
    for (const { module: room, name } of Module.imports(from)) (imports[room] ??= {})[name] = () => undefined;
    kernel = new Start(from, imports).exports as unknown as K;
  } catch (cause) {
    throw cause instanceof RangeError
      ? initError(op, "memory", "there is no memory for the engine", cause)
      : compileError(op, cause);
  }
  const found = mark in kernel && typeof kernel.kernel_version === "function" ? kernel.kernel_version() : undefined;
  if (found !== versionNumber()) {
    throw initError(op, "version", `the module is not that of expline ${version}`);
  }
  return new Instance(kernel);
}

/**
 * Loads the engine early, or from elsewhere. Not needed before the first call: without it the wasm inside the package
 * is compiled when it is first used.
 *
 * Calls while one is under way share it; once an engine is there, further calls change nothing. A failure is not kept:
 * the next call tries again.
 *
 * @throws {ExplineError} E_INIT with `reason` csp, network, mime, compile, version, memory or unsupported.
 */
export default function init(options?: InitOptions): Promise<void> {
  return begin(core, options);
}

/** What `init` does, for any engine. @internal */
export function begin<K extends AnyKernel>(engine: Engine<K>, options: unknown): Promise<void> {
  return (engine.starting ??= start(engine, options).finally(() => {
    engine.starting = undefined;
  }));
}

async function start<K extends AnyKernel>(engine: Engine<K>, given: unknown): Promise<void> {
  const { op, address } = engine;
  // Checked where an engine runs, too: whether a call is wrong does not depend on what came before it.
  const { wasmUrl, bytes, module: ready } = checkOptions(op, given, ["wasmUrl", "bytes", "module"]);
  if (engine.module !== undefined && engine.current !== undefined) return;
  let next: WebAssembly.Module;
  if (ready !== undefined) next = asModule(op, ready);
  // An instance has died: its module is as good as it was.
  else if (given === undefined && engine.module !== undefined) next = engine.module;
  else if (wasmUrl !== undefined) next = await fetched(op, wasmUrl);
  else if (bytes === undefined && address !== undefined) next = await fetched(op, address());
  else next = await compiled(op, bytes === undefined ? inlined(engine, op) : asBytes(op, bytes));
  adopt(engine, next);
}

/** Starts the engine from bytes or from a module, without waiting; changes nothing where one runs already. */
export function initSync(options: InitSyncOptions): void {
  beginSync(core, "initSync", options);
}

/** What `initSync` does, for any engine. @internal */
export function beginSync<K extends AnyKernel>(engine: Engine<K>, op: string, options: unknown): void {
  const { bytes, module: ready } = checkOptions(op, options, ["bytes", "module"]);
  if (engine.current !== undefined) return;
  if (ready === undefined && bytes === undefined) throw wrong("E_TYPE", op, "bytes", bytes, "BufferSource");
  adopt(engine, ready === undefined ? compile(op, asBytes(op, bytes)) : asModule(op, ready));
}

function adopt<K extends AnyKernel>(engine: Engine<K>, next: WebAssembly.Module): void {
  if (engine.current !== undefined) return;
  engine.current = instantiate(engine, next);
  engine.module = next;
}

function asModule(op: string, value: unknown): WebAssembly.Module {
  if (classOf(value) !== "WebAssembly.Module") throw wrong("E_TYPE", op, "module", value, "WebAssembly.Module");
  return value as WebAssembly.Module;
}

function asBytes(op: string, value: unknown): BufferSource {
  if (classOf(value) === "ArrayBuffer" || ArrayBuffer.isView(value)) return value as BufferSource;
  throw wrong("E_TYPE", op, "bytes", value, "BufferSource");
}

async function compiled(op: string, bytes: BufferSource): Promise<WebAssembly.Module> {
  const { compile: begin } = wasm(op);
  try {
    return await begin.call(WebAssembly, bytes);
  } catch (cause) {
    throw compileError(op, cause);
  }
}

async function fetched(op: string, url: unknown): Promise<WebAssembly.Module> {
  // The URL of a test runner's page and that of Node are of different classes.
  const address = (url as { readonly href?: unknown } | null)?.href ?? url;
  if (typeof address !== "string") throw wrong("E_TYPE", op, "wasmUrl", url, "string or URL");
  const bytes = await read(op, address);
  const magic = new Uint8Array(bytes, 0, Math.min(4, bytes.byteLength));
  if (String.fromCharCode(...magic) !== "\0asm") {
    throw initError(op, "mime", `what "${address.slice(0, 200)}" answers is not WebAssembly`);
  }
  return compiled(op, bytes);
}

/** The part of Node that reads files; it is asked for only when a file: address is given. */
interface Files {
  readFile(path: URL): Promise<Uint8Array<ArrayBuffer>>;
}

async function read(op: string, url: string): Promise<ArrayBuffer> {
  try {
    if (url.startsWith("file:")) {
      const host = globalThis as { process?: { getBuiltinModule?: (name: string) => Files | undefined } };
      const file = await host.process?.getBuiltinModule?.("node:fs/promises")?.readFile(new URL(url));
      if (file !== undefined) return file.slice().buffer;
    }
    const answer = await fetch(url);
    if (!answer.ok) throw new Error(`HTTP ${answer.status}`);
    return await answer.arrayBuffer();
  } catch (cause) {
    throw initError(op, "network", `"${url.slice(0, 200)}" could not be read (${(cause as Error).message}); wasmUrl may say where it is`, cause);
  }
}
