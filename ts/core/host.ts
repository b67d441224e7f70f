/**
 * Types of the host, said so that a project that declares no browser, or whose TypeScript is of version 5.0, can read
 * the package's declarations as well.
 */

/** Bytes, in whatever holds them. */
export type Bytes = ArrayBuffer | ArrayBufferView;

/**
 * Bytes that nobody else holds: `Uint8Array<ArrayBuffer>` where typed arrays say what they lie on, `Uint8Array` before
 * TypeScript 5.7.
 */
export type OwnBytes = ReturnType<typeof Uint8Array.of>;

/** Numbers that nobody else holds, in the same way. */
export type OwnFloats = ReturnType<typeof Float64Array.of>;

/** A `WebAssembly.Module`, where the project's libraries know of one. */
export type CompiledModule = typeof globalThis extends { WebAssembly: { Module: { prototype: infer Module } } } ? Module : object;

/** A `URL`, where the project's libraries know of one. */
export type Address = typeof globalThis extends { URL: { prototype: infer Url } } ? Url : { readonly href: string };

/** An `AbortSignal`, where the project's libraries know of one. */
export type Signal = typeof globalThis extends { AbortSignal: { prototype: infer Abort } } ? Abort : { readonly aborted: boolean };

/** A `Path2D`, where the project's libraries know of one. */
export type PathObject = typeof globalThis extends { Path2D: { prototype: infer Path } } ? Path : object;
