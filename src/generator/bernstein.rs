//! The Bernstein basis of one segment: the form in which a segment lies in the hull of its control points.

use super::Basis;
use crate::numerics::entire::{SERIES_LIMIT, stumpff};

impl Basis {
    /// The four Bernstein functions b₀ … b₃ at x in [0, 1], or their derivative of the given order, up to 3.
    ///
    /// They are not negative and sum to 1; a segment is b₀P₀ + b₁(P₀ + κ·H·D₀) + b₂(P₁ − κ·H·D₁) + b₃P₁ with
    /// κ = [`Basis::kappa`].
    ///
    /// # Accuracy
    ///
    /// 1e-15 of the largest value (`tests/generator/exactness.rs`).
    ///
    /// # Source
    ///
    /// [CRU15, eq. 36] in the form (D 3.1).
    #[inline(never)]
    pub fn bernstein(&self, x: f64, derivative: usize) -> [f64; 4] {
        let weights = self.weights(x, derivative);
        let kappa = self.kappa();
        let z = 1.0 - x;
        let (first, last) = (self.last_bernstein(z, x, derivative), self.last_bernstein(x, z, derivative));
        // b₀ is the mirror image of b₃: every derivative changes the sign.
        let first = if derivative % 2 == 1 { -first } else { first };
        [first, weights.leaving / kappa, -weights.arriving / kappa, last]
    }

    /// b₃(x) = x³c₃(w²x²)/c₃(w²) for z = 1 − x: all of it vanishes at 0 but the third derivative.
    #[inline(never)]
    fn last_bernstein(&self, x: f64, z: f64, derivative: usize) -> f64 {
        let square = self.square();
        if square < -4.0 * SERIES_LIMIT {
            return stretched_last(self.frequency(), x, z, derivative);
        }
        let at = stumpff(square * x * x);
        let value = match derivative {
            0 => x * x * x * at.c3,
            1 => x * x * at.c2,
            2 => x * at.c1,
            _ => at.c0,
        };
        value / stumpff(square).c3
    }
}

/// The same where sinh w may overflow: numerator and denominator times 2e^{−w} (D 3.3).
#[cold]
fn stretched_last(w: f64, x: f64, z: f64, derivative: usize) -> f64 {
    let (t, tail) = (w * x, libm::exp(-w));
    // z and not 1 − x: a rounding of 1e-16 there is one of 1e-12 in the exponent.
    let scale = libm::exp(-w * z) / ((1.0 - tail * tail) - 2.0 * w * tail);
    let fall = libm::exp(-t);
    // Numerators t³c₃, t²c₂, tc₁ and c₀ at −t², times 2e^{−t}.
    let at = if t * t <= SERIES_LIMIT {
        let c = stumpff(-t * t);
        [t * t * t * c.c3, t * t * c.c2, t * c.c1, c.c0].map(|c| 2.0 * fall * c)
    } else {
        let square = fall * fall;
        [1.0 - square - 2.0 * t * fall, 1.0 + square - 2.0 * fall, 1.0 - square, 1.0 + square]
    };
    let mut value = scale * at[derivative.min(3)];
    for _ in 0..derivative.min(3) {
        value *= w;
    }
    value
}
