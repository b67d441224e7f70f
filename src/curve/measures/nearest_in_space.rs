//! The nearest point of a curve in space, piece by piece.

use super::bounds::hull;
use super::search::{Near, Question, Slopes, Stiffness, search};
use crate::curve::pieces::{Pieces, space_piece};
use crate::curve::space_piece::{SpacePiece, Triple, along, dot, norm};
use crate::numerics::Point;

/// The point of a curve in space that is nearest to a place.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SpaceNearest {
    /// Its parameter.
    pub t: f64,
    /// The point.
    pub point: [f64; 3],
    /// Its distance.
    pub distance: f64,
}

/// A piece as seen from a place.
struct View<'a> {
    piece: &'a SpacePiece,
    place: Triple,
}

impl Near for View<'_> {
    fn slopes(&self, y: f64) -> Slopes {
        let [position, first, second, third] = self.piece.jet(y);
        let e = along(&position, &self.place, -1.0);
        Slopes {
            square: dot(&e, &e),
            first: dot(&e, &first),
            second: dot(&first, &first) + dot(&e, &second),
            third: 3.0 * dot(&first, &second) + dot(&e, &third),
        }
    }

    fn stiffness(&self, lo: f64, hi: f64) -> Stiffness {
        let [_, first, second, third] = self.piece.jet(0.5 * (lo + hi));
        let (half, fourth) = (0.5 * (hi - lo), self.piece.fourth(0.5));
        let jolt = norm(&third) + half * fourth;
        let fastest = norm(&first) + half * (norm(&second) + half * jolt);
        Stiffness { constant: 4.0 * fastest * jolt, slope: fourth, reach: fastest * (hi - lo) }
    }
}

pub(crate) fn nearest_in_space(curve: &dyn Pieces, place: Triple) -> SpaceNearest {
    let far = norm(&place);
    let slack = hull(curve).tie() + 4.0 * f64::EPSILON * far;
    if !far.is_finite() {
        return SpaceNearest { t: 0.0, point: place, distance: f64::INFINITY };
    }
    let mut question = Question::new(Point::zeros(), slack);
    for i in 0..curve.piece_count() {
        search(&View { piece: &space_piece(curve, i), place }, i, &mut question, -0.5, 0.5);
    }
    let (i, y) = question.found();
    let i = i.min(curve.piece_count() - 1);
    let (from, to) = (curve.knot(i), curve.knot(i + 1));
    let point = space_piece(curve, i).position(y);
    let distance = norm(&along(&point, &place, -1.0));
    SpaceNearest { t: (from + (y + 0.5) * (to - from)).min(to), point, distance }
}
