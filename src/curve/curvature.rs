//! How strongly a curve bends.

use super::HermiteCurve;
use super::piece::{Jet, Piece};
use crate::error::Result;
use crate::numerics::plane::{cross, norm};

/// Speeds below this share of the largest a segment could have are roundings of zero.
const ZERO_SPEED: f64 = 1e-15;

impl HermiteCurve {
    /// The signed curvature at t; `None` where the speed is zero and the curve has no direction.
    ///
    /// ```text
    /// κ = (r′ × r″) / |r′|³
    /// ```
    ///
    /// Positive where the curve turns from the x axis towards the y axis: to the left in a y-up world, clockwise on
    /// a screen whose y points down. At a point where two segments meet it is that of the segment that leaves.
    ///
    /// # Accuracy
    ///
    /// A few roundings where the speed is of the size of the tangents, 1/speed³ times that near a cusp. A speed below
    /// 1e-15 of the segment's tangents and chord cannot be told from zero and counts as zero.
    ///
    /// # Errors
    ///
    /// `t` not finite, or outside the domain of an open curve.
    pub fn curvature(&self, t: f64) -> Result<Option<f64>> {
        let (i, x) = self.locate(t)?;
        let segment = self.segment(i);
        let scale = norm(segment.end - segment.start)
            + (norm(segment.leaving) + norm(segment.arriving)) * segment.length;
        let mut jet = Piece::new(&segment).jet(x - 0.5);
        if x == 0.0 {
            jet.first = segment.leaving * segment.length;
        } else if x == 1.0 {
            jet.first = segment.arriving * segment.length;
        }
        Ok(curvature_of(&jet, ZERO_SPEED * scale))
    }
}

fn curvature_of(jet: &Jet, least_speed: f64) -> Option<f64> {
    let speed = norm(jet.first);
    if speed <= least_speed {
        return None;
    }
    let direction = jet.first / speed;
    let bend = cross(direction, jet.second / speed) / speed;
    if bend.is_finite() { Some(bend) } else { None }
}
