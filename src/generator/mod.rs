//! The functions that every curve is a combination of: cardinal Hermite exponential splines, in three spaces.
//!
//! [`Basis`] is one segment's view of them, made for curves; [`HermiteGenerators`] is the pair φ₁, φ₂ on the
//! whole line, with everything that is known about it. Both rest on the same few constants.
//!
//! For any list of [`Roots`] there is an [`ExponentialBSpline`] and, mostly, an [`Interpolator`] made of it.
//!
//! ```
//! use expline::generator::{HermiteGenerators, Interpolator, Roots, Space};
//!
//! let generators = HermiteGenerators::new(core::f64::consts::FRAC_PI_2, Space::Trigonometric)?;
//! assert_eq!(generators.at(0.0, 0), (1.0, 0.0)); // φ₁ carries the value at a knot …
//! assert_eq!(generators.at(0.0, 1), (0.0, 1.0)); // … and φ₂ the derivative
//!
//! let interpolator = Interpolator::new(&Roots::ellipse(8)?)?; // exact for ellipses of 8 points
//! let sum: f64 = (-3..=3).map(|k| interpolator.at(0.3 - f64::from(k), 0)).sum();
//! assert!((sum - 1.0).abs() < 1e-14, "moving all points moves the curve");
//! # Ok::<(), expline::Error>(())
//! ```

mod basis;
mod bernstein;
mod exponential_b_spline;
mod filters;
mod hermite;
mod interpolator;
mod pairing;
mod pieces;
mod propagation;
mod riesz;
mod root;
mod roots;
mod stretched;
mod weights;

pub use basis::Basis;
pub use exponential_b_spline::ExponentialBSpline;
pub(crate) use filters::affine_refinement_filter;
#[cfg(all(target_arch = "wasm32", feature = "wasm"))]
pub(crate) use hermite::Table;
pub use hermite::{HermiteGenerators, Pair};
pub use interpolator::Interpolator;
pub(crate) use pieces::{PolynomialPieces, recentre};
pub use riesz::{Gram, RieszBounds};
pub use root::Root;
pub use roots::Roots;
pub(crate) use roots::too_fast;
pub use weights::Weights;

/// The space that a Hermite exponential spline is piecewise in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Space {
    /// 1, t, cos ωt, sin ωt: ellipses, sine waves and cycloids are exact.
    Trigonometric,
    /// 1, t, cosh ωt, sinh ωt: hyperbolas and catenaries are exact.
    Hyperbolic,
    /// 1, t, t², t³, the limit ω → 0: parabolas and cubics are exact.
    Polynomial,
}
