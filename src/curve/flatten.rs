//! A polyline near a curve.

use super::HermiteCurve;
use super::length::check_tolerance;
use super::limits::{MOST_OUTPUT_POINTS, too_many, with_room};
use super::piece::Piece;
use crate::error::Result;

/// Tolerances below this share of the extent are raised to it.
pub(crate) const LEAST_TOLERANCE: f64 = 1e-9;

impl HermiteCurve {
    /// A polyline within `tolerance` of the curve, and the bound of its distance that was proved.
    ///
    /// The points are on the curve, every control point is one of them, and they are interleaved x, y. A closed curve's
    /// first point is not repeated at the end: the last edge of the polyline closes it.
    ///
    /// # Accuracy
    ///
    /// Both ways: no point of the curve is farther than the bound from the polyline, and no point of the polyline
    /// farther from the curve. A tolerance below 1e-9 of the extent is raised to that; the bound says so.
    ///
    /// # Errors
    ///
    /// `tolerance` not finite or not positive; more than 4 000 000 points.
    pub fn flatten(&self, tolerance: f64) -> Result<(Vec<f64>, f64)> {
        check_tolerance(tolerance)?;
        let tolerance = tolerance.max(LEAST_TOLERANCE * self.bounds().extent()).max(f64::MIN_POSITIVE);
        let mut counts = with_room(self.segment_count())?;
        let (mut total, mut deviation) = (1_usize, 0.0_f64);
        for segment in self.segments() {
            let bend = Piece::new(&segment).bend(-0.5, 0.5);
            let count = (bend / (8.0 * tolerance)).sqrt().ceil().max(1.0);
            deviation = deviation.max(bend / (8.0 * count * count));
            counts.push(count as usize);
            total = total.saturating_add(count as usize);
        }
        if total > MOST_OUTPUT_POINTS {
            return Err(too_many("tolerance", "maxOutputPoints", MOST_OUTPUT_POINTS, total));
        }
        let mut out = with_room(2 * total)?;
        for (segment, &count) in self.segments().zip(&counts) {
            out.extend([segment.start.x, segment.start.y]);
            let piece = Piece::new(&segment);
            for k in 1..count {
                let p = piece.position(k as f64 / count as f64 - 0.5);
                out.extend([p.x, p.y]);
            }
        }
        if !self.is_closed()
            && let Some(last) = self.points().last()
        {
            out.extend([last.x, last.y]);
        }
        Ok((out, deviation))
    }
}
