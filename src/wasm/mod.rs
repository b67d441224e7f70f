//! The only room that knows JavaScript: plain functions of numbers over a handful of resident curves.
//!
//! No class and no pointer to a curve ever reaches JavaScript. A curve is *loaded* into one of the numbered slots
//! of [`kernel`], where it is only a cache: the face (`ts/`) owns the data, remembers which of its curves lies in
//! which slot, and loads it again when it was evicted, edited, or when the instance was replaced after a trap.
//!
//! Every exported function returns the count of numbers (or bytes) that it left in the output buffer, or
//! [`kernel::FAILED`], with the error's fields in the result record. Nothing here computes, and nothing here
//! formats: messages are made in the face.
//!
//! The package has several modules, each with an instance and a memory of its own: feature `wasm` exports Hermite
//! curves and path data, feature `wasm-spline` curves of any roots, feature `wasm-surface` surfaces, feature `wasm-fit`
//! fitting, feature `wasm-trace` tracing. [`kernel`] and [`numbers`] are in all of them, what measures curves in the
//! two for curves.

#![allow(unreachable_pub, reason = "exported functions are public to JavaScript, not to Rust")]

#[cfg(feature = "wasm")]
mod curve;
#[cfg(any(feature = "wasm", feature = "wasm-spline", feature = "wasm-fit", feature = "wasm-trace"))]
mod describe;
#[cfg(feature = "wasm-spline")]
mod exponential;
#[cfg(feature = "wasm-fit")]
mod fit;
#[cfg(feature = "wasm")]
mod generators;
mod heap;
mod kernel;
#[cfg(any(feature = "wasm", feature = "wasm-spline"))]
mod measure;
mod numbers;
#[cfg(feature = "wasm-trace")]
mod picture;
#[cfg(feature = "wasm-spline")]
mod prepared;
#[cfg(feature = "wasm-trace")]
mod profile;
#[cfg(any(feature = "wasm-spline", feature = "wasm-surface"))]
mod roots;
#[cfg(any(feature = "wasm", feature = "wasm-spline"))]
mod sample;
#[cfg(any(feature = "wasm-fit", feature = "wasm-trace"))]
mod sections;
#[cfg(feature = "wasm-spline")]
mod spline;
#[cfg(feature = "wasm-surface")]
mod surface;
#[cfg(feature = "wasm")]
mod svg;
#[cfg(feature = "wasm-trace")]
mod trace;
