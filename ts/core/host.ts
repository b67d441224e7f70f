/** Types of the host, said so that a project that declares no browser can read the package's declarations as well. */

/** Bytes, in whatever holds them. */
export type Bytes = ArrayBuffer | ArrayBufferView;

/** A `WebAssembly.Module`, where the project's libraries know of one. */
export type CompiledModule = typeof globalThis extends { WebAssembly: { Module: { prototype: infer Module } } } ? Module : object;

/** A `Path2D`, where the project's libraries know of one. */
export type PathObject = typeof globalThis extends { Path2D: { prototype: infer Path } } ? Path : object;
