//! Traces of pictures of several colours.

#[path = "../support/mod.rs"]
mod support;

mod blended;
mod compressed;
mod layers;
mod light;
mod ruled;
mod shared;
mod small;
mod sprites;
mod translucent;
