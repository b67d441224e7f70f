//! One segment's basis: how the two end points and the two end derivatives are weighted along it.

use super::Space;
use crate::numerics::entire::{sinc, sine_cosine_gap, sine_remainder, versine};

/// Weights of one place on a segment; see [`Basis::weights`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights {
    /// Weight of the chord, end − start.
    pub chord: f64,
    /// Weight of the length times the derivative that leaves the start.
    pub leaving: f64,
    /// Weight of the length times the derivative that arrives at the end.
    pub arriving: f64,
}

/// The Hermite basis of one segment for one local frequency w = ω·length.
///
/// A segment of parameter length H that starts at P₀ with derivative D₀ and ends at P₁ with derivative D₁ is,
/// with x = (t − t₀)/H in [0, 1],
///
/// ```text
/// r(t) = P₀ + chord(x)·(P₁ − P₀) + leaving(x)·H·D₀ + arriving(x)·H·D₁
/// ```
///
/// with chord(x) = g₁(1 − x), leaving(x) = g₂(x), arriving(x) = −g₂(1 − x).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Basis {
    space: Space,
    frequency: f64,
    sinc_half: f64,
    cos_half: f64,
    gap_half: f64,
    remainder: f64,
    versine: f64,
}

impl Basis {
    /// The basis for local frequency `frequency` = ω·length, in radians per segment.
    pub fn new(space: Space, frequency: f64) -> Self {
        let w = if space == Space::Polynomial { 0.0 } else { frequency.abs() };
        let h = 0.5 * w;
        Self {
            space,
            frequency: w,
            sinc_half: sinc(h),
            cos_half: libm::cos(h),
            gap_half: sine_cosine_gap(h),
            remainder: sine_remainder(w),
            versine: versine(w),
        }
    }

    /// The space.
    pub fn space(&self) -> Space {
        self.space
    }

    /// The local frequency w = ω·length, in radians per segment, never negative.
    pub fn frequency(&self) -> f64 {
        self.frequency
    }

    /// κ(w) = S(w)/V(w): the inner generalised Bézier points of a segment lie κ·length·derivative from its ends.
    ///
    /// 1/3 for cubics, 1/2 at w = π, infinite at 2π.
    pub fn kappa(&self) -> f64 {
        self.remainder / self.versine
    }

    /// The weights at x in [0, 1], or their first or second derivative with respect to x.
    pub fn weights(&self, x: f64, derivative: usize) -> Weights {
        let z = 1.0 - x;
        match derivative {
            0 => Weights { chord: self.g1(z, x), leaving: self.g2(x, z), arriving: -self.g2(z, x) },
            1 => Weights { chord: self.chord1(x, z), leaving: self.slope(x, z), arriving: self.slope(z, x) },
            _ => Weights { chord: self.chord2(x), leaving: self.bend(x), arriving: -self.bend(z) },
        }
    }

    fn g1(&self, x: f64, z: f64) -> f64 {
        if x >= 0.5 { self.tail(z) } else { 1.0 - self.tail(x) }
    }

    fn tail(&self, z: f64) -> f64 {
        let t = self.frequency * z;
        4.0 * z * z * (self.sinc_half * versine(t) * 0.5 - z * self.cos_half * sine_remainder(t))
            / self.gap_half
    }

    fn g2(&self, x: f64, z: f64) -> f64 {
        let h = 0.5 * self.frequency;
        if x > 0.5 {
            let t = self.frequency * z;
            return 4.0 * z * z * (self.remainder * versine(t) - z * self.versine * sine_remainder(t))
                / (self.sinc_half * self.gap_half);
        }
        let u = 1.0 - 2.0 * x;
        let (mut power, mut sigma, mut sum, mut k) = (1.0 / 6.0, 1.0, 0.0, 0.0);
        while k < 16.0 {
            sum += power * sigma;
            power *= -h * h / ((2.0 * k + 4.0) * (2.0 * k + 5.0));
            sigma = 1.0 + u * u * sigma;
            k += 1.0;
        }
        x * z * (sinc(h * x) * sinc(h * z) / (2.0 * self.sinc_half) + u * sum / self.gap_half)
    }

    fn chord1(&self, x: f64, z: f64) -> f64 {
        let h = 0.5 * self.frequency;
        2.0 * x * z * sinc(h * x) * sinc(h * z) / self.gap_half
    }

    fn slope(&self, x: f64, z: f64) -> f64 {
        let h = 0.5 * self.frequency;
        z * sinc(h * z) * (libm::cos(h * x) / self.sinc_half - x * sinc(h * x) / self.gap_half)
    }

    fn chord2(&self, x: f64) -> f64 {
        let y = x - 0.5;
        -4.0 * y * sinc(self.frequency * y) / self.gap_half
    }

    fn bend(&self, x: f64) -> f64 {
        let y = x - 0.5;
        -libm::cos(self.frequency * y) / self.sinc_half + 2.0 * y * sinc(self.frequency * y) / self.gap_half
    }
}
