// The memories of all engines that a test starts: imported before the first call.

/** In the order of their start. Pages only ever become more. */
export const memories: WebAssembly.Memory[] = [];

const { Instance } = WebAssembly;
WebAssembly.Instance = class extends Instance {
  constructor(module: WebAssembly.Module, imports?: WebAssembly.Imports) {
    super(module, imports);
    memories.push(this.exports["memory"] as WebAssembly.Memory);
  }
};

/** Bytes of all of them together. */
export const bytesOfEngines = (): number => memories.reduce((sum, { buffer }) => sum + buffer.byteLength, 0);
