//! One segment's basis: how the two end points and the two end derivatives are weighted along it.
//!
//! Formulas (D 2.1) to (D 2.9). Everything is a combination of Stumpff's functions at the distance from the
//! nearer end, with constants that stay of the size of the cubic's for every frequency; long hyperbolic segments
//! go through decaying exponentials ([`super::stretched`]).

use super::Space;
use super::stretched::Stretched;
use super::weights::Weights;
use crate::numerics::entire::{SERIES_LIMIT, Stumpff, stumpff};

/// The Hermite basis of one segment for one local frequency w = ω·length.
///
/// A segment of parameter length H that starts at P₀ with derivative D₀ and ends at P₁ with derivative D₁ is,
/// with x = (t − t₀)/H in [0, 1],
///
/// ```text
/// r(t) = P₀ + chord(x)·(P₁ − P₀) + leaving(x)·H·D₀ + arriving(x)·H·D₁
/// chord(x) = φ₁(1 − x)        leaving(x) = φ₂(x)        arriving(x) = φ₂(x − 1)
/// ```
///
/// # Domain
///
/// w below 2π in the trigonometric space (there is a pole at 2π), up to 1e4 in the hyperbolic one. A frequency
/// too small to have a square, below about 1e-154, behaves as 0: the cubic.
///
/// # Accuracy
///
/// For w ≤ π and in the hyperbolic space, 4e-16 of the largest value of each weight or derivative; up to
/// w = 6.2 a few 1e-15, and towards 2π the error grows like the weights themselves. No jump anywhere in w or
/// x beyond that. Held by `tests/generator/exactness.rs` against 50 digits.
///
/// # Cost
///
/// Construction and [`Basis::weights`] take no transcendental function for w ≤ π: about 15 ns each.
///
/// # Source
///
/// [CRU15, eq. 5], in the stable form (D 2.5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Basis {
    space: Space,
    frequency: f64,
    /// w², negative in the hyperbolic space.
    square: f64,
    /// chord″(0) = 2c₁/J at h = w/2, with J = c₂ − c₃; 6 for the cubic.
    chord_second: f64,
    /// −chord‴(0) = 4c₀/J; 12 for the cubic.
    chord_third: f64,
    /// −arriving″(0) = (c₂ + c₀c₃)/(c₁J); 2 for the cubic.
    arriving_second: f64,
    /// arriving″(0) − leaving″(0) = 2c₀/c₁; 2 for the cubic.
    even_second: f64,
}

impl Basis {
    /// The basis for local frequency `frequency` = ω·length, in radians per segment; its sign does not matter.
    #[inline(never)]
    pub fn new(space: Space, frequency: f64) -> Self {
        let w = frequency.abs();
        let (frequency, square) = match space {
            Space::Trigonometric => (w, w * w),
            Space::Hyperbolic => (w, -(w * w)),
            Space::Polynomial => (0.0, 0.0),
        };
        if square < -4.0 * SERIES_LIMIT {
            return Self::stretched_constants(frequency, square);
        }
        let Stumpff { c0, c1, c2, c3 } = stumpff(0.25 * square);
        let odd = 2.0 / (c2 - c3);
        let even = 1.0 / c1;
        Self {
            space,
            frequency,
            square,
            chord_second: c1 * odd,
            chord_third: 2.0 * c0 * odd,
            arriving_second: 0.5 * (c2 + c0 * c3) * odd * even,
            even_second: 2.0 * c0 * even,
        }
    }

    /// The same constants where cosh(w/2) may overflow: every one is free of it in the end (D 2.8).
    #[cold]
    fn stretched_constants(frequency: f64, square: f64) -> Self {
        let Stretched { half, tanh, gap, spread, .. } = Stretched::new(frequency);
        Self {
            space: Space::Hyperbolic,
            frequency,
            square,
            chord_second: 2.0 * half * half * tanh / gap,
            chord_third: 4.0 * half * half * half / gap,
            arriving_second: half * (1.0 - spread) / gap,
            even_second: 2.0 * half / tanh,
        }
    }

    /// The space.
    pub fn space(&self) -> Space {
        self.space
    }

    /// The local frequency w = ω·length, in radians per segment, never negative; 0 in the polynomial space.
    #[inline]
    pub fn frequency(&self) -> f64 {
        self.frequency
    }

    /// w², negative in the hyperbolic space: every function r of the basis has r⁗ = −`square`·r″.
    pub fn square(&self) -> f64 {
        self.square
    }

    /// h·cot h for h = w/2, h·coth h in the hyperbolic space; 1 for the cubic.
    pub fn half_cotangent(&self) -> f64 {
        0.5 * self.even_second
    }

    /// The weights at x in [0, 1], or their derivative of order 1, 2 or 3 with respect to x.
    ///
    /// At x = 0 and x = 1 values and first derivatives are the exact zeros and ones of Hermite interpolation.
    #[inline(never)]
    pub fn weights(&self, x: f64, derivative: usize) -> Weights {
        let mirrored = x > 0.5;
        let near = self.near(if mirrored { 1.0 - x } else { x }, derivative);
        if !mirrored {
            return near;
        }
        // Read backwards, chord becomes 1 − chord, leaving −arriving; every derivative changes the sign.
        let Weights { chord, leaving, arriving } = near;
        if derivative % 2 == 1 {
            Weights { chord, leaving: arriving, arriving: leaving }
        } else {
            let whole = if derivative == 0 { 1.0 } else { 0.0 };
            Weights { chord: whole - chord, leaving: -arriving, arriving: -leaving }
        }
    }

    /// The weights at distance r ≤ 1/2 from the start: (D 2.5), whose derivatives (D 2.6) are the same combinations
    /// of functions one index lower.
    fn near(&self, r: f64, derivative: usize) -> Weights {
        let u = self.square * r * r;
        if -u > SERIES_LIMIT {
            return Stretched::new(self.frequency).weights(r, derivative);
        }
        let c = stumpff(u);
        let (first, second) = (r * c.c1, r * r * c.c2);
        let [lead, middle, last] = match derivative {
            0 => [first, second, r * r * r * c.c3],
            1 => [c.c0, first, second],
            2 => [-self.square * first, c.c0, first],
            _ => [-self.square * c.c0, -self.square * first, c.c0],
        };
        let arriving = self.chord_second * last - self.arriving_second * middle;
        Weights {
            chord: self.chord_second * middle - self.chord_third * last,
            leaving: (lead - self.even_second * middle) + arriving,
            arriving,
        }
    }

    /// The refinement of a segment of parameter length `length` at x: two matrices, row by row, that act on the column
    /// (value, derivative) at the start and at the end and sum to the column at x.
    ///
    /// # Source
    ///
    /// [CRU15, eq. 33, 35]; (D 5.1). In the middle the value weights are exactly 1/2, by symmetry.
    pub fn taps(&self, length: f64, x: f64) -> [[f64; 4]; 2] {
        let (value, slope) = (self.weights(x, 0), self.weights(x, 1));
        let chord = if x == 0.5 { 0.5 } else { value.chord };
        [
            [1.0 - chord, length * value.leaving, -slope.chord / length, slope.leaving],
            [chord, length * value.arriving, slope.chord / length, slope.arriving],
        ]
    }

    /// κ = c₃(w²)/c₂(w²): the inner Bézier points lie κ·H·D from the ends. 1/3 for the cubic.
    ///
    /// # Source
    ///
    /// [CRU15, eq. 38], r/(r − p), in the form (D 3.2).
    pub fn kappa(&self) -> f64 {
        self.arriving_second / self.chord_second
    }
}
