//! One piece of a curve, in its own parameter x in [0, 1].

use crate::generator::{Basis, Weights};
use crate::numerics::{Point, Vector};

/// A segment: two end points, the derivative that leaves the first and the one that arrives at the second.
///
/// Derivatives are with respect to the curve's parameter t; `length` is the segment's share of t.
#[derive(Clone, Copy, Debug)]
pub struct Segment<'a> {
    /// Where it starts.
    pub start: Point,
    /// Where it ends.
    pub end: Point,
    /// dr/dt leaving the start.
    pub leaving: Vector,
    /// dr/dt arriving at the end.
    pub arriving: Vector,
    /// Parameter length H.
    pub length: f64,
    /// The basis for w = ω·H.
    pub basis: &'a Basis,
}

impl Segment<'_> {
    /// The point at x in [0, 1].
    #[inline]
    pub fn position(&self, x: f64) -> Point {
        self.derivative(x, 0)
    }

    /// The first derivative at x with respect to t.
    #[inline]
    pub fn velocity(&self, x: f64) -> Vector {
        self.derivative(x, 1)
    }

    /// The second derivative at x with respect to t.
    #[inline]
    pub fn acceleration(&self, x: f64) -> Vector {
        self.derivative(x, 2)
    }

    /// The point (order 0) or a derivative with respect to t (order 1, 2 or 3; there is no higher one here) at x.
    #[inline(never)]
    pub fn derivative(&self, x: f64, order: usize) -> Vector {
        let value = self.combine(&self.basis.weights(x, order));
        if order == 0 {
            return self.start + value;
        }
        let divisor = (1..order).fold(self.length, |product, _| product * self.length);
        value / divisor
    }

    /// The inner generalised Bézier points: on the end tangents, P₀ + κ·H·D₀ and P₁ − κ·H·D₁ with κ = κ(ω·H).
    #[inline]
    pub(super) fn inner_points(&self) -> [Point; 2] {
        let reach = self.basis.kappa() * self.length;
        [self.start + self.leaving * reach, self.end - self.arriving * reach]
    }

    /// Chord and end derivatives with these weights: a value or a derivative with respect to x.
    pub(super) fn combine(&self, weights: &Weights) -> Vector {
        (self.end - self.start) * weights.chord
            + (self.leaving * weights.leaving + self.arriving * weights.arriving) * self.length
    }
}
