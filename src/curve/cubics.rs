//! Cubic Bézier curves near a curve.

use super::length::check_tolerance;
use super::limits::{MOST_OUTPUT_POINTS, too_many};
use super::piece::Piece;
use super::{HermiteCurve, Segment};
use crate::error::Result;
use crate::numerics::Point;

/// Halvings of a segment after which a piece is taken as it is.
const MOST_HALVINGS: usize = 24;

/// Cubic Bézier curves near a curve; see [`HermiteCurve::to_cubics`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cubics {
    /// Eight numbers for each cubic: start, two handles, end. Each starts where the one before ends.
    pub path: Vec<f64>,
    /// The proved bound of the distance between the path and the curve, both ways.
    pub deviation: f64,
    /// For every segment of the curve, how many cubics precede it.
    pub first: Vec<u32>,
}

impl HermiteCurve {
    /// Cubic Bézier curves within `tolerance` of the curve.
    ///
    /// Cubic segments and straight lines are converted exactly; control points stay ends of pieces.
    ///
    /// # Accuracy
    ///
    /// `deviation` bounds the distance both ways. A tolerance below 1e-9 of the extent is raised to that.
    ///
    /// # Errors
    ///
    /// `tolerance` not finite or not positive; more than 4 000 000 points.
    pub fn to_cubics(&self, tolerance: f64) -> Result<Cubics> {
        check_tolerance(tolerance)?;
        let tolerance = self.least_tolerance(tolerance);
        let mut cubics = Cubics::default();
        let mut pieces = Vec::new();
        for segment in self.segments() {
            cubics.first.push((cubics.path.len() / 8) as u32);
            pieces.clear();
            cubics.deviation = cubics.deviation.max(segment_cubics(&segment, tolerance, &mut pieces));
            if cubics.path.len() / 2 + 4 * pieces.len() > 4 * MOST_OUTPUT_POINTS {
                let needed = cubics.path.len() / 2 + 4 * pieces.len();
                return Err(too_many("tolerance", "maxOutputPoints", MOST_OUTPUT_POINTS, needed));
            }
            cubics.path.extend(pieces.iter().flatten().flat_map(|p| [p.x, p.y]));
        }
        Ok(cubics)
    }
}

/// Appends the cubic Bézier curves of one segment and returns the proved bound of their distance from it.
pub fn segment_cubics(segment: &Segment<'_>, tolerance: f64, out: &mut Vec<[Point; 4]>) -> f64 {
    let piece = Piece::new(segment);
    let reach = segment.length / 3.0;
    if piece.is_cubic() {
        let (first, second) =
            (segment.start + segment.leaving * reach, segment.end - segment.arriving * reach);
        out.push([segment.start, first, second, segment.end]);
        return 0.0;
    }
    let begin = out.len();
    let mut deviation: f64 = 0.0;
    let mut stack = [(0.0, 0.0); MOST_HALVINGS + 1];
    stack[0] = (-0.5, 0.5);
    let mut open = 1;
    while open > 0 {
        open -= 1;
        let (lo, hi) = stack[open];
        let width = hi - lo;
        let bound = piece.cubic_gap(lo, hi);
        if bound > tolerance && open + 2 <= stack.len() {
            let middle = 0.5 * (lo + hi);
            stack[open] = (middle, hi);
            stack[open + 1] = (lo, middle);
            open += 2;
            continue;
        }
        let (from, to) = (piece.jet(lo), piece.jet(hi));
        let third = width / 3.0;
        out.push([
            from.position,
            from.position + from.first * third,
            to.position - to.first * third,
            to.position,
        ]);
        deviation = deviation.max(bound);
    }
    if let Some(cubic) = out.get_mut(begin) {
        cubic[0] = segment.start;
    }
    if let Some(cubic) = out.last_mut() {
        cubic[3] = segment.end;
    }
    deviation
}
