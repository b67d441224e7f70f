//! The crate as Rust programs meet it: nothing panics, and the types do what programs expect.

#[path = "../support/mod.rs"]
mod support;

mod fits;
mod numbers;
mod traits;
