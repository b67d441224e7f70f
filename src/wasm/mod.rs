//! The only room that knows JavaScript: plain functions of numbers over a handful of resident curves.
//!
//! No class and no pointer to a curve ever reaches JavaScript. A curve is *loaded* into one of the numbered slots
//! of [`kernel`], where it is only a cache: the face (`ts/`) owns the data, remembers which of its curves lies in
//! which slot, and loads it again when it was evicted, edited, or when the instance was replaced after a trap.
//!
//! Every exported function returns the count of numbers (or bytes) that it left in the output buffer, or
//! [`kernel::FAILED`], with the error's fields in the result record. Nothing here computes, and nothing here
//! formats: messages are made in the face.

#![allow(unreachable_pub, reason = "exported functions are public to JavaScript, not to Rust")]

mod curve;
mod generators;
mod heap;
mod kernel;
mod measure;
mod sample;
mod svg;
