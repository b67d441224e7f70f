//! Generators: exponential B-splines, interpolators and the Hermite basis, against 50 digits and what is printed.

#[path = "../support/mod.rs"]
mod support;

mod b_splines;
mod exactness;
mod interpolators;
mod properties;
mod published;
mod published_interpolators;
mod stability;
