//! Refinement: one curve or surface on many grids, everywhere or where it is wanted.

#[path = "../support/mod.rs"]
mod support;

mod exponential;
mod hermite;
mod local;
