//! The problem of a sparse fit: its laws, its optimum, and the proof that it was reached.

#[path = "../support/mod.rs"]
mod support;

mod conditioning;
mod coordinates;
mod gridless;
mod laws;
mod limits;
mod numbers;
mod optima;
mod paper;
mod spaces;
