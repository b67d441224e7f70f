//! Fits: what may be asked for, and what comes out.

#[path = "../support/mod.rs"]
mod support;

mod data;
mod detail;
mod door;
mod places;
mod sparsity;
mod tolerance;
mod way;
