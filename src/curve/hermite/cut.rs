//! Cutting curves apart, exactly: a part of a segment lies in the segment's own space.

use super::refine::Parts;
use super::{HermiteCurve, HermiteOptions};
use crate::error::{Error, Result};
use crate::limits::{LEAST_LENGTH, MOST_POINTS, too_many};

impl HermiteCurve {
    /// The curve cut open at t.
    ///
    /// A closed curve gives one open curve that starts and ends at t. An open one gives its two parts, or itself
    /// alone where t is one of its ends (within 1e-12 in the parameter).
    ///
    /// # Errors
    ///
    /// t not finite, or outside the domain of an open curve.
    pub fn split(&self, t: f64) -> Result<Vec<Self>> {
        let (start, end) = self.domain();
        let at = self.snapped(self.locate(t)?);
        let mut parts = Vec::new();
        if self.is_closed() {
            parts.push(self.part(at, at, true)?);
        } else if t - start < LEAST_LENGTH || end - t < LEAST_LENGTH {
            parts.push(self.remade()?);
        } else {
            parts.push(self.part((0, 0.0), at, false)?);
            parts.push(self.part(at, (self.segment_count(), 0.0), false)?);
        }
        Ok(parts)
    }

    /// The part from t0 to t1 as an open curve, with its own parameter from 0.
    ///
    /// On a closed curve it runs forward from t0 to the next place where t is t1, all the way round when both
    /// are the same place.
    ///
    /// # Errors
    ///
    /// A parameter that is not finite or outside the domain of an open curve; t1 less than 1e-12 beyond t0, on an open
    /// curve also before it.
    pub fn trim(&self, t0: f64, t1: f64) -> Result<Self> {
        let place = |t, name| match self.locate(t) {
            Ok(place) => Ok(self.snapped(place)),
            Err(error) => Err(error.about(name)),
        };
        let (from, to) = (place(t0, "t0")?, place(t1, "t1")?);
        let around = self.is_closed() && (from.0 > to.0 || (from.0 == to.0 && from.1 >= to.1));
        let empty = if self.is_closed() {
            !around && from.0 == to.0 && (to.1 - from.1) * self.lengths()[from.0] < LEAST_LENGTH
        } else {
            t1 - t0 < LEAST_LENGTH || from == to
        };
        if empty {
            return Err(Error::degenerate("t1", None, "it must lie beyond t0"));
        }
        self.part(from, to, around)
    }

    /// Moves a place that is next to a knot onto it, so that no part is too short; x is below 1 afterwards.
    fn snapped(&self, (i, x): (usize, f64)) -> (usize, f64) {
        let length = self.lengths()[i];
        if x * length < LEAST_LENGTH {
            (i, 0.0)
        } else if (1.0 - x) * length < LEAST_LENGTH {
            (if self.is_closed() { self.next(i) } else { i + 1 }, 0.0)
        } else {
            (i, x)
        }
    }

    /// The open curve between two places, across the start of a closed curve if `around`.
    fn part(&self, from: (usize, f64), to: (usize, f64), around: bool) -> Result<Self> {
        let segments = self.segment_count();
        // In laps: segment indices run on past the last one.
        let last = to.0 + if around { segments } else { 0 };
        let count = last - from.0 + 2;
        if count > MOST_POINTS {
            return Err(too_many("points", "maxPoints", MOST_POINTS, count));
        }
        let mut parts = Parts::new(self, count)?;
        for lap in from.0..=last {
            let i = if lap >= segments { lap - segments } else { lap };
            let start = if lap == from.0 { from.1 } else { 0.0 };
            let end = if lap == last { to.1 } else { 1.0 };
            if start < end {
                parts.push(i, start, self.lengths()[i] * (end - start));
            }
        }
        parts.push_point(to.0, to.1);
        // The ends have no other side to arrive from or leave to.
        let HermiteOptions { tangents, tangents_in, closed, .. } = &mut parts.data;
        let end = tangents.len() - 1;
        (*closed, tangents_in[0], tangents[end]) = (false, tangents[0], tangents_in[end]);
        Self::new(parts.data)
    }
}
