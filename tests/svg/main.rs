//! Path data in and out.

#[path = "../support/mod.rs"]
mod support;

mod arcs;
mod parse;
mod print;
mod text;
