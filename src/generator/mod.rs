//! The functions that every curve is a combination of: cardinal Hermite exponential splines, in three spaces.
//!
//! [`Basis`] is one segment's view of them, made for curves; [`HermiteGenerators`] is the pair φ₁, φ₂ on the
//! whole line, with everything that is known about it. Both rest on the same few constants.

mod basis;
mod bernstein;
mod hermite;
mod riesz;
mod stretched;

pub use basis::{Basis, Weights};
#[cfg(all(target_arch = "wasm32", feature = "wasm"))]
pub(crate) use hermite::Table;
pub use hermite::{HermiteGenerators, Pair};
pub use riesz::{Gram, RieszBounds};

/// The space that a Hermite exponential spline is piecewise in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// 1, t, cos ωt, sin ωt: ellipses, sine waves and cycloids are exact.
    Trigonometric,
    /// 1, t, cosh ωt, sinh ωt: hyperbolas and catenaries are exact.
    Hyperbolic,
    /// 1, t, t², t³, the limit ω → 0: parabolas and cubics are exact.
    Polynomial,
}
