//! More points, same curve: every segment is cut without changing its ω, so that nothing is approximated.
//!
//! The space of a segment depends on ω alone, not on its length. A piece of a segment therefore lies in the very
//! same space, and its end points and end derivatives determine it: cutting is evaluation (D 5.1).

use super::{HermiteCurve, HermiteOptions};
use crate::error::Result;
use crate::limits::{LEAST_LENGTH, MOST_OUTPUT_POINTS, MOST_POINTS, check, too_many, with_room};
use crate::numerics::Vector;
use crate::numerics::plane::append;

impl HermiteCurve {
    /// The same curve with `arity` segments in place of each.
    ///
    /// The parameter stays: `refined.evaluate(t)` is `self.evaluate(t)`. ω stays too, lengths shrink.
    ///
    /// # Accuracy
    ///
    /// Values move by less than 1e-15 of the curve's size a level (`tests/curve/editing.rs`). The domain stays what it
    /// was to the last bit where the arity is a power of two, else within one rounding.
    ///
    /// # Errors
    ///
    /// An arity of 0; more than 4 million points; pieces shorter than 1e-12 in the parameter.
    pub fn refine(&self, arity: usize) -> Result<Self> {
        check("arity", None, arity as f64, 1.0, MOST_OUTPUT_POINTS as f64)?;
        let count = self.segment_count().saturating_mul(arity).saturating_add(usize::from(!self.is_closed()));
        if count > MOST_OUTPUT_POINTS.max(self.points().len()) {
            return Err(too_many("arity", "maxOutputPoints", MOST_OUTPUT_POINTS, count));
        }
        let mut parts = Parts::new(self, count)?;
        for i in 0..self.segment_count() {
            let length = self.lengths()[i] / arity as f64;
            for k in 0..arity {
                parts.push(i, k as f64 / arity as f64, length);
            }
        }
        parts.finish()
    }

    /// The same curve with one more point, at parameter t.
    ///
    /// The domain stays what it was to the last bit; the new point is within a rounding of t.
    /// At a point that is there already (within 1e-12 in the parameter) the curve comes back unchanged.
    ///
    /// # Errors
    ///
    /// t not finite, or outside the domain of an open curve; more than 16 777 216 points.
    pub fn insert(&self, t: f64) -> Result<Self> {
        let (at, x) = self.locate(t)?;
        let length = self.lengths()[at];
        // The longer piece is rounded; what is left of the length is then exact, and so is their sum.
        let (first, last) = if x < 0.5 {
            let last = length * (1.0 - x);
            (length - last, last)
        } else {
            (length * x, length - length * x)
        };
        if first < LEAST_LENGTH || last < LEAST_LENGTH {
            return self.remade();
        }
        let count = self.points().len() + 1;
        if count > MOST_POINTS {
            return Err(too_many("points", "maxPoints", MOST_POINTS, count));
        }
        let mut parts = Parts::new(self, count)?;
        for i in 0..self.segment_count() {
            if i == at {
                parts.push(i, 0.0, first);
                parts.push(i, first / length, last);
            } else {
                parts.push(i, 0.0, self.lengths()[i]);
            }
        }
        parts.finish()
    }

    /// Four generalised Bézier points for every segment, eight numbers each: the two ends and, on the end
    /// tangents, P₀ + κ·H·D₀ and P₁ − κ·H·D₁ with κ = κ(ω·H).
    ///
    /// The segment lies in their convex hull (trigonometric: for ωH ≤ 2π).
    ///
    /// # Source
    ///
    /// [CRU15, eq. 36–38]; κ is 1/3 for cubics, where these are the Bézier points.
    pub fn bezier_points(&self) -> Vec<f64> {
        let mut values = Vec::with_capacity(8 * self.segment_count());
        for segment in self.segments() {
            let [first, second] = segment.inner_points();
            for p in [segment.start, first, second, segment.end] {
                append(&mut values, p);
            }
        }
        values
    }
}

/// Out of line: three lists grow at every point.
#[inline(never)]
fn add(list: &mut Vec<Vector>, vector: Vector) {
    list.push(vector);
}

/// A curve that is being put together from parts of the segments of another.
pub(super) struct Parts<'a> {
    curve: &'a HermiteCurve,
    pub(super) data: HermiteOptions,
}

impl<'a> Parts<'a> {
    /// Room for `count` points.
    pub(super) fn new(curve: &'a HermiteCurve, count: usize) -> Result<Self> {
        let (closed, space) = (curve.is_closed(), Some(curve.space()));
        let mut data = HermiteOptions { closed, space, ..HermiteOptions::default() };
        for list in [&mut data.points, &mut data.tangents, &mut data.tangents_in] {
            *list = with_room(count)?;
        }
        for list in [&mut data.omega, &mut data.lengths] {
            *list = with_room(count)?;
        }
        Ok(Self { curve, data })
    }

    /// The point at x of segment i: the one that is there at x = 0, a smooth one elsewhere.
    #[inline(never)]
    pub(super) fn push_point(&mut self, i: usize, x: f64) {
        let (point, leaving, arriving) = if x == 0.0 {
            let i = if i == self.curve.points().len() { 0 } else { i };
            (self.curve.points()[i], self.curve.tangents()[i], self.curve.tangents_in()[i])
        } else {
            let segment = self.curve.nth_segment(i);
            let velocity = segment.velocity(x);
            (segment.position(x), velocity, velocity)
        };
        add(&mut self.data.points, point);
        add(&mut self.data.tangents, leaving);
        add(&mut self.data.tangents_in, arriving);
    }

    /// The part of segment i that starts at x and has this length.
    pub(super) fn push(&mut self, i: usize, x: f64, length: f64) {
        self.push_point(i, x);
        self.data.omega.push(self.curve.omega()[i]);
        self.data.lengths.push(length);
    }

    /// The curve, with the last point of an open one.
    fn finish(mut self) -> Result<HermiteCurve> {
        if !self.data.closed {
            self.push_point(self.curve.segment_count(), 0.0);
        }
        HermiteCurve::new(self.data)
    }
}
