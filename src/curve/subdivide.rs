//! Subdivision: the polygons that converge to the curve.

use super::hermite::HermiteCurve;
use super::limits::{MOST_OUTPUT_POINTS, with_room};
use crate::error::{Error, Result};
use crate::generator::Basis;

/// The most levels of one subdivision.
const MOST_LEVELS: usize = 24;

/// Which subdivision scheme.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
        check_range("levels", levels, 0, MOST_LEVELS)?;
        check_range("arity", arity, 1, MOST_OUTPUT_POINTS)?;
        let (pieces, needed) = self.output(levels, arity, scheme);
        if needed > MOST_OUTPUT_POINTS as f64 {
            let most = MOST_OUTPUT_POINTS as f64;
            return Err(Error::LimitExceeded { argument: "levels", limit: "maxOutputPoints", most, needed });
        }
        let mut polygon = with_room(2 * needed as usize)?;
        for i in 0..self.segment_count() {
            match scheme {
                Scheme::Hermite => self.push_points(i, pieces, &mut polygon),
                Scheme::Scalar => self.push_inner(i, pieces, &mut polygon),
            }
        }
        let (last, end) = (self.segment_count() - 1, self.points().len() - 1);
        if !self.is_closed() {
            let (point, arriving) = (self.points()[end], self.tangents_in()[end]);
            if scheme == Scheme::Scalar {
                polygon.extend_from_slice((point - arriving * self.reach(last, pieces)).as_slice());
            }
            polygon.extend_from_slice(point.as_slice());
        }
        Ok(polygon)
    }

    /// Pieces a segment, and points in all (as a number that cannot overflow).
    fn output(&self, levels: usize, arity: usize, scheme: Scheme) -> (usize, f64) {
        let pieces = (0..levels).fold(1.0, |pieces, _| pieces * arity as f64);
        let (each, ends) = if scheme == Scheme::Scalar { (2.0, 2.0) } else { (1.0, 1.0) };
        let ends = if self.is_closed() { 0.0 } else { ends };
        (pieces as usize, each * pieces * self.segment_count() as f64 + ends)
    }

    fn push_points(&self, i: usize, pieces: usize, polygon: &mut Vec<f64>) {
        let segment = self.segment(i);
        for k in 0..pieces {
            polygon.extend_from_slice(segment.position(k as f64 / pieces as f64).as_slice());
        }
    }

    /// Before and after every node of segment i, its start included: P − κ·H·D and P + κ·H·D.
    fn push_inner(&self, i: usize, pieces: usize, polygon: &mut Vec<f64>) {
        let segment = self.segment(i);
        let reach = self.reach(i, pieces);
        let before = match i.checked_sub(1) {
            Some(before) => self.reach(before, pieces),
            None if self.is_closed() => self.reach(self.segment_count() - 1, pieces),
            None => 0.0,
        };
        polygon.extend_from_slice((segment.start - self.tangents_in()[i] * before).as_slice());
        polygon.extend_from_slice((segment.start + segment.leaving * reach).as_slice());
        for k in 1..pieces {
            let x = k as f64 / pieces as f64;
            let (point, step) = (segment.position(x), segment.velocity(x) * reach);
            polygon.extend_from_slice((point - step).as_slice());
            polygon.extend_from_slice((point + step).as_slice());
        }
    }

    /// κ·H of a piece of segment i.
    fn reach(&self, i: usize, pieces: usize) -> f64 {
        let segment = self.segment(i);
        let share = 1.0 / pieces as f64;
        Basis::new(segment.basis.space(), segment.basis.frequency() * share).kappa() * segment.length * share
    }
}

fn check_range(argument: &'static str, value: usize, least: usize, most: usize) -> Result<()> {
    if (least..=most).contains(&value) {
        return Ok(());
    }
    let (value, least, most) = (value as f64, least as f64, most as f64);
    Err(Error::OutOfRange { argument, index: None, value, least, most })
}
