//! The functions that every curve is a combination of.

mod basis;
mod stretched;

pub use basis::{Basis, Weights};

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
