//! Four even entire functions, cos √u and what is left of cos and sin after their first terms.
//!
//! ```text
//! c₀(u) = cos √u               c₂(u) = (1 − cos √u) / u
//! c₁(u) = sin √u / √u          c₃(u) = (√u − sin √u) / √u³
//! ```
//!
//! They are Stumpff's functions \[Stu59\], cₙ(u) = Σₖ (−u)ᵏ/(2k+n)!. For u < 0 the same sums are hyperbolic,
//! at u = 0 they are 1, 1, 1/2, 1/6: one formulation for the trigonometric, the hyperbolic and the polynomial
//! space, in which nothing jumps and nothing is divided by a small number.

mod series;

pub use self::series::{SERIES_LIMIT, series};
use super::angle::sin_cos;

/// The values c₀ … c₃ of Stumpff's functions at one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stumpff {
    /// cos √u.
    pub c0: f64,
    /// sin √u / √u.
    pub c1: f64,
    /// (1 − cos √u) / u.
    pub c2: f64,
    /// (√u − sin √u) / √u³.
    pub c3: f64,
}

/// All four functions at u.
///
/// # Accuracy
///
/// A few 1e-16, relative for c₂ and c₃, and relative to 1 for c₀ and c₁ between 0 and (2π)². Below
/// u = −500 000 the hyperbolic functions overflow to infinity.
#[inline(never)]
pub fn stumpff(u: f64) -> Stumpff {
    if u.abs() <= SERIES_LIMIT {
        let (c2, c3) = series(u);
        return Stumpff { c0: 1.0 - u * c2, c1: 1.0 - u * c3, c2, c3 };
    }
    beyond_series(u)
}

#[cold]
#[inline(never)]
fn beyond_series(u: f64) -> Stumpff {
    let t = u.abs().sqrt();
    if u > 0.0 {
        let (sine, cosine) = sin_cos(t);
        let versine = if cosine < 0.5 {
            1.0 - cosine
        } else {
            // Around 2π the difference loses digits; the square of the half angle's sine does not.
            let half = sin_cos(0.5 * t).0;
            2.0 * half * half
        };
        Stumpff { c0: cosine, c1: sine / t, c2: versine / u, c3: (t - sine) / (u * t) }
    } else {
        let (up, down) = (0.5 * libm::exp(t), 0.5 * libm::exp(-t));
        let sine = up - down;
        Stumpff { c0: up + down, c1: sine / t, c2: (up + down - 1.0) / -u, c3: (sine - t) / (-u * t) }
    }
}
