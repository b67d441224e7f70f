//! Subdivision: the polygons that converge to the curve.

use super::HermiteCurve;
use crate::curve::Segment;
use crate::error::{Error, Result};
use crate::generator::Basis;
use crate::limits::{MOST_LEVELS, MOST_OUTPUT_POINTS, check, with_room};
use crate::numerics::plane::append;
use crate::numerics::{Point, Vector};

/// Which subdivision scheme.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Scheme {
    /// The interpolating vector scheme: the polygon's points are points of the curve.
    Hermite,
    /// The approximating scalar scheme: the polygon's points are the inner generalised Bézier points of the
    /// refined curve, at the level's own frequency. An open curve keeps its end points.
    Scalar,
}

impl HermiteCurve {
    /// The polygon after `levels` steps of a subdivision scheme of this arity, x and y in turn.
    ///
    /// Level 0 is the points themselves (Hermite), or the inner Bézier points (scalar). The steps of either scheme
    /// reproduce the curve's space, so the polygon of level j is known in closed form, and that is what is
    /// evaluated: no error builds up from level to level. [`crate::refine`] has the schemes as recursions.
    ///
    /// # Domain
    ///
    /// `levels` up to 24, `arity` from 1 (which changes nothing), any lengths and frequencies of the segments.
    ///
    /// # Errors
    ///
    /// Out of range: more levels, arity 0. Limit exceeded: more than 4 million points.
    ///
    /// # Source
    ///
    /// [CRU15, eq. 34 and 40–42] with the frequency of each level.
    pub fn subdivide(&self, levels: usize, arity: usize, scheme: Scheme) -> Result<Vec<f64>> {
        check("levels", None, levels as f64, 0.0, MOST_LEVELS as f64)?;
        check("arity", None, arity as f64, 1.0, MOST_OUTPUT_POINTS as f64)?;
        let pieces = (0..levels).fold(1.0, |pieces, _| pieces * arity as f64);
        let scalar = scheme == Scheme::Scalar;
        let nodes = pieces * self.segment_count() as f64 + if self.is_closed() { 0.0 } else { 1.0 };
        let (needed, most) = (if scalar { 2.0 * nodes } else { nodes }, MOST_OUTPUT_POINTS as f64);
        if needed > most {
            return Err(Error::limit("levels", "maxOutputPoints", MOST_OUTPUT_POINTS, needed));
        }
        let mut polygon = with_room(2 * needed as usize)?;
        let last = self.segment_count() - 1;
        let mut before = if self.is_closed() { reach(&self.nth_segment(last), pieces) } else { 0.0 };
        for i in 0..self.segment_count() {
            let segment = self.nth_segment(i);
            let after = reach(&segment, pieces);
            push(
                &mut polygon,
                scalar,
                segment.start,
                self.tangents_in()[i] * before,
                segment.leaving * after,
            );
            for k in 1..pieces as usize {
                let x = k as f64 / pieces;
                let step = segment.velocity(x) * after;
                push(&mut polygon, scalar, segment.position(x), step, step);
            }
            before = after;
        }
        if !self.is_closed() {
            let segment = self.nth_segment(last);
            push(&mut polygon, scalar, segment.end, segment.arriving * before, Vector::zeros());
        }
        Ok(polygon)
    }
}

/// A point, or the control points before and after it.
#[inline(never)]
fn push(polygon: &mut Vec<f64>, scalar: bool, point: Point, arriving: Vector, leaving: Vector) {
    append(polygon, if scalar { point - arriving } else { point });
    if scalar {
        append(polygon, point + leaving);
    }
}

/// κ·H of a piece of the segment.
#[inline(never)]
fn reach(segment: &Segment, pieces: f64) -> f64 {
    let kappa = Basis::new(segment.basis.space(), segment.basis.frequency() / pieces).kappa();
    kappa * segment.length / pieces
}
