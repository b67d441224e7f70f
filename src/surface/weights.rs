//! What points weigh on an interval of the grid, as polynomials.

use crate::error::Result;
use crate::generator::{ExponentialBSpline, Interpolator, Roots};
use crate::limits::filled;

/// The pieces of a generator that an interval meets, one point's after the other.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct IntervalWeights {
    /// How many points weigh on an interval.
    pub(super) width: usize,
    /// Pieces of an interval: an interpolator has a knot in the middle of each.
    halves: usize,
    /// Coefficients of a piece.
    length: usize,
    /// `halves` × `width` × `length` coefficients, ascending powers of the distance from the piece's middle.
    pieces: Vec<f64>,
}

impl IntervalWeights {
    /// Two pieces an interval, 2(n₀ − 1) points on each.
    pub(super) fn of_interpolator(roots: &Roots) -> Result<Self> {
        let interpolator = Interpolator::new(roots)?;
        let order = roots.order() as i64;
        let width = 2 * (roots.order() - 1);
        let length = interpolator.half_piece(0).len();
        let mut pieces = filled(0.0, 2 * width * length)?;
        let mut rest = pieces.chunks_exact_mut(length);
        for half in 0..2 {
            for w in 0..width as i64 {
                if let Some(piece) = rest.next() {
                    piece.copy_from_slice(interpolator.half_piece((2 * (order - 2 - w) + half) as isize));
                }
            }
        }
        Ok(Self { width, halves: 2, length, pieces })
    }

    /// One piece an interval, n₀ points on it; divided by what they sum to where constants are reproduced, so that
    /// control points move with the surface.
    pub(super) fn of_b_spline(roots: &Roots, level: u32) -> Result<Self> {
        let fine = roots.divided(f64::from(1_u32 << level));
        let (spline, integral) = (ExponentialBSpline::new(&fine)?, fine.integral());
        let width = roots.order();
        let length = spline.piece(0).len();
        let mut pieces = filled(0.0, width * length)?;
        for (w, piece) in pieces.chunks_exact_mut(length).enumerate() {
            for (coefficient, of_spline) in piece.iter_mut().zip(spline.piece(width - 1 - w)) {
                *coefficient = of_spline / integral;
            }
        }
        Ok(Self { width, halves: 1, length, pieces })
    }

    /// Which piece of an interval a place on it from 0 to 1 is on, and how far from the piece's middle.
    #[inline]
    pub(super) fn half(&self, place: f64) -> (usize, f64) {
        if self.halves == 1 {
            return (0, place - 0.5);
        }
        let half = usize::from(place >= 0.5);
        (half, place - if half == 0 { 0.25 } else { 0.75 })
    }

    /// The weights at a place, or a derivative, times `scale`.
    #[inline]
    pub(super) fn fill(&self, half: usize, x: f64, derivative: usize, scale: f64, out: &mut [f64]) {
        let pieces = self.pieces[half * self.width * self.length..].chunks_exact(self.length);
        for (weight, piece) in out.iter_mut().zip(pieces).take(self.width) {
            *weight = scale * horner(piece, derivative, x);
        }
    }
}

/// A derivative of Σ cₙxⁿ.
fn horner(coefficients: &[f64], derivative: usize, x: f64) -> f64 {
    let mut value = 0.0;
    // Lower powers vanish.
    for (n, c) in coefficients.iter().enumerate().skip(derivative).rev() {
        let falling = (0..derivative).fold(1.0, |f, i| f * (n - i) as f64);
        value = value * x + c * falling;
    }
    value
}
