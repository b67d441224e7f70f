//! The smallest upright box around a curve.

use super::piece::Piece;
use super::{HermiteCurve, Segment};
use crate::numerics::Vector;
use crate::numerics::roots::bracketed_root;

/// An upright box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Smallest x.
    pub min_x: f64,
    /// Smallest y.
    pub min_y: f64,
    /// Largest x.
    pub max_x: f64,
    /// Largest y.
    pub max_y: f64,
}

impl Bounds {
    /// The larger of width and height.
    pub fn extent(&self) -> f64 {
        (self.max_x - self.min_x).max(self.max_y - self.min_y)
    }

    fn empty() -> Self {
        let far = f64::INFINITY;
        Self { min_x: far, min_y: far, max_x: -far, max_y: -far }
    }

    fn include(&mut self, p: Vector) {
        // Comparisons instead of `min`: nothing here is not a number, and one instruction is enough.
        self.min_x = if p.x < self.min_x { p.x } else { self.min_x };
        self.max_x = if p.x > self.max_x { p.x } else { self.max_x };
        self.min_y = if p.y < self.min_y { p.y } else { self.min_y };
        self.max_y = if p.y > self.max_y { p.y } else { self.max_y };
    }

    fn holds(&self, axis: usize, value: f64) -> bool {
        if axis == 0 {
            value >= self.min_x && value <= self.max_x
        } else {
            value >= self.min_y && value <= self.max_y
        }
    }
}

impl HermiteCurve {
    /// The smallest upright box that holds the curve: the exact extrema, not those of a control polygon.
    ///
    /// The generalised Bézier points of a segment hold it in their hull, so a segment whose hull lies in the box of
    /// what was already seen is passed over. Of the others every zero of each coordinate's derivative is found: between
    /// the zeros of the second derivative, which are known in closed form, the first is monotone.
    ///
    /// # Accuracy
    ///
    /// A few roundings of the largest coordinate; extrema are insensitive to errors of their parameter.
    ///
    /// # Cost
    ///
    /// O(segments), no allocation.
    pub fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::empty();
        for &p in self.points() {
            bounds.include(p);
        }
        for segment in self.segments() {
            include_segment(&mut bounds, &segment);
        }
        bounds
    }

    /// A box around the generalised Bézier points, which hold the curve in their hull.
    pub(crate) fn hull(&self) -> Bounds {
        let mut bounds = Bounds::empty();
        for segment in self.segments() {
            let reach = segment.length * segment.basis.kappa();
            bounds.include(segment.start);
            bounds.include(segment.start + segment.leaving * reach);
            bounds.include(segment.end - segment.arriving * reach);
            bounds.include(segment.end);
        }
        bounds
    }
}

fn include_segment(bounds: &mut Bounds, segment: &Segment<'_>) {
    let reach = segment.length * segment.basis.kappa();
    let (first, second) = (segment.start + segment.leaving * reach, segment.end - segment.arriving * reach);
    for axis in 0..2 {
        if !(bounds.holds(axis, first[axis]) && bounds.holds(axis, second[axis])) {
            let piece = Piece::new(segment);
            stationary(&piece, axis, &mut |y| bounds.include(piece.position(y)));
        }
    }
}

/// Calls `found` with every y in (−1/2, 1/2) where one coordinate of the piece turns.
#[inline(never)]
pub(crate) fn stationary(piece: &Piece, axis: usize, found: &mut dyn FnMut(f64)) {
    if piece.is_cubic() {
        let [_, b, p, q] = piece.coefficients();
        let (b, p, q) = (b[axis], p[axis], q[axis]);
        let discriminant = p * p - 2.0 * q * b;
        if discriminant > 0.0 {
            let s = -(p + discriminant.sqrt().copysign(p));
            for y in [s / q, 2.0 * b / s] {
                if y > -0.5 && y < 0.5 {
                    found(y);
                }
            }
        }
        return;
    }
    let [one, two] = piece.inflections(axis);
    let (one, two) = (one.unwrap_or(0.5), two.unwrap_or(0.5));
    let mut lo = -0.5;
    let mut at_lo = piece.jet(lo).first[axis];
    for hi in [one.min(two), one.max(two), 0.5] {
        let at_hi = piece.jet(hi).first[axis];
        if hi > lo && at_lo * at_hi < 0.0 {
            found(bracketed_root(lo, hi, at_lo < 0.0, 0.5 * (lo + hi), &mut |y| {
                let jet = piece.jet(y);
                (jet.first[axis], jet.second[axis])
            }));
        }
        (lo, at_lo) = (hi, at_hi);
    }
}
