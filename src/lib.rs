//! Exact circles, on-curve editing, kept corners: splines for web vector editors.

pub mod curve;
pub mod error;
pub mod generator;
mod limits;
pub mod numerics;
pub mod refine;
pub mod svg;

#[cfg(all(target_arch = "wasm32", feature = "wasm"))]
mod wasm;

pub use curve::{HermiteCurve, HermiteOptions};
pub use error::{Error, Result};
pub use generator::Space;
