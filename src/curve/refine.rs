//! More points, same curve: every segment is cut without changing its ω, so that nothing is approximated.
//!
//! The space of a segment depends on ω alone, not on its length. A piece of a segment therefore lies in the very
//! same space, and its end points and end derivatives determine it: cutting is evaluation (D 5.1).

use super::hermite::{HermiteCurve, HermiteOptions};
use super::limits::{LEAST_LENGTH, MOST_OUTPUT_POINTS, MOST_POINTS, too_many, with_room};
use crate::error::{Error, Result};

impl HermiteCurve {
    /// The same curve with `arity` segments in place of each.
    ///
    /// The parameter stays: `refined.evaluate(t)` is `self.evaluate(t)`. ω stays too, lengths shrink.
    ///
    /// # Accuracy
    ///
    /// Values move by less than 1e-15 of the curve's size a level (`tests/editing.rs`).
    ///
    /// # Errors
    ///
    /// An arity of 0; more than 4 million points; pieces shorter than 1e-12 in the parameter.
    pub fn refine(&self, arity: usize) -> Result<Self> {
        if arity == 0 {
            let (least, most) = (1.0, MOST_OUTPUT_POINTS as f64);
            return Err(Error::OutOfRange { argument: "arity", index: None, value: 0.0, least, most });
        }
        let count = self.segment_count().saturating_mul(arity).saturating_add(usize::from(!self.is_closed()));
        if count > MOST_OUTPUT_POINTS.max(self.points().len()) {
            return Err(too_many("arity", "maxOutputPoints", MOST_OUTPUT_POINTS, count));
        }
        let mut parts = Parts::with_room(self, count)?;
        for i in 0..self.segment_count() {
            parts.push_start(self, i);
            let length = self.lengths()[i] / arity as f64;
            for k in 1..arity {
                parts.push_length(self, i, length);
                parts.push_inside(self, i, k as f64 / arity as f64);
            }
            parts.push_length(self, i, length);
        }
        parts.finish(self)
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
            return Ok(self.clone());
        }
        let count = self.points().len() + 1;
        if count > MOST_POINTS {
            return Err(too_many("points", "maxPoints", MOST_POINTS, count));
        }
        let mut parts = Parts::with_room(self, count)?;
        for i in 0..self.segment_count() {
            parts.push_start(self, i);
            if i == at {
                parts.push_length(self, i, first);
                parts.push_inside(self, i, first / length);
                parts.push_length(self, i, last);
            } else {
                parts.push_length(self, i, self.lengths()[i]);
            }
        }
        parts.finish(self)
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
            let reach = segment.basis.kappa() * segment.length;
            let (first, last) = (segment.start, segment.end);
            for p in [first, first + segment.leaving * reach, last - segment.arriving * reach, last] {
                values.extend_from_slice(&[p.x, p.y]);
            }
        }
        values
    }
}

/// A curve that is being put together point by point, segment by segment.
pub(super) struct Parts {
    options: HermiteOptions,
}

impl Parts {
    pub(super) fn with_room(curve: &HermiteCurve, count: usize) -> Result<Self> {
        let options = HermiteOptions {
            points: with_room(count)?,
            tangents: with_room(count)?,
            tangents_in: with_room(count)?,
            closed: curve.is_closed(),
            space: Some(curve.space()),
            omega: with_room(count)?,
            lengths: with_room(count)?,
        };
        Ok(Self { options })
    }

    /// Point i as it is.
    pub(super) fn push_start(&mut self, curve: &HermiteCurve, i: usize) {
        self.options.points.push(curve.points()[i]);
        self.options.tangents.push(curve.tangents()[i]);
        self.options.tangents_in.push(curve.tangents_in()[i]);
    }

    /// A smooth point inside segment i.
    pub(super) fn push_inside(&mut self, curve: &HermiteCurve, i: usize, x: f64) {
        let segment = curve.segment(i);
        let velocity = segment.velocity(x);
        self.options.points.push(segment.position(x));
        self.options.tangents.push(velocity);
        self.options.tangents_in.push(velocity);
    }

    /// The point at x in segment i, as it is if x is 0.
    pub(super) fn push_at(&mut self, curve: &HermiteCurve, i: usize, x: f64) {
        if x == 0.0 { self.push_start(curve, i) } else { self.push_inside(curve, i, x) }
    }

    /// A segment of segment i's ω and of this length.
    pub(super) fn push_length(&mut self, curve: &HermiteCurve, i: usize, length: f64) {
        self.options.omega.push(curve.omega()[i]);
        self.options.lengths.push(length);
    }

    /// Adds the last point of an open curve and makes the curve.
    pub(super) fn finish(mut self, curve: &HermiteCurve) -> Result<HermiteCurve> {
        if !curve.is_closed() {
            self.push_start(curve, curve.points().len() - 1);
        }
        HermiteCurve::new(self.options)
    }

    /// Makes an open curve of what is there; its ends have no other side to arrive from or leave to.
    pub(super) fn finish_open(mut self) -> Result<HermiteCurve> {
        let HermiteOptions { tangents, tangents_in, closed, .. } = &mut self.options;
        *closed = false;
        if let (Some(leaving), Some(arriving)) = (tangents.first(), tangents_in.first_mut()) {
            *arriving = *leaving;
        }
        if let (Some(leaving), Some(arriving)) = (tangents.last_mut(), tangents_in.last()) {
            *leaving = *arriving;
        }
        HermiteCurve::new(self.options)
    }
}
