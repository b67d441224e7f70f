//! Where a curve leaves the way of its points, and the way back. (D 13.16)

use super::free_knots::Located;
use super::spline::{Distances, Pull, Spline, on_piece};
use crate::fit::report::{size_of, weight};
use crate::numerics::order::sort_by_number;
use crate::numerics::{Point, Vector};

/// In so many parts a piece is looked at from where it starts to where it ends.
const LOOKS: usize = 8;
/// Steps that pull a curve back.
const MOST_STEPS: usize = 4;

/// How far from the way of the points a curve may be, in standard deviations of the noise.
pub(super) const WIDEST: f64 = 4.0;
/// What is no farther from that way than such a part of the drawing does no harm.
const HARMLESS: f64 = 0.1;

/// How far a curve may be of which the sum of squares is all that is known: so many times what its own points are off
/// on average, such a part of the drawing, and of the distances of the points around. (D 13.16)
const OFF: f64 = 2.0;
const SWING: f64 = 0.02;
const SHARE: f64 = 0.25;

/// How far from the lines between points a curve may be: so much, and this share of the distances of the points around,
/// for so far off a corner between two of them may be.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leash {
    pub(super) slack: f64,
    pub(super) share: f64,
}

impl Leash {
    /// The widest, for points that are noisy by so much.
    pub(super) fn wide(data: &Located, noise: f64) -> Self {
        Self { slack: WIDEST * noise + HARMLESS * size_of(&data.points), share: 1.0 }
    }
}

impl Spline {
    /// A piece on which a curve that is off its points by this sum of squares swings away from them: few points do not
    /// hold it between them.
    pub(in crate::fit) fn wild_piece(&self, data: &Located, squares: f64) -> Option<usize> {
        let slack = OFF * (squares / weight(data)).sqrt() + SWING * size_of(&data.points);
        self.strays(data, Leash { slack, share: SHARE })
    }

    /// A piece on which the curve leaves the way of the points. O(M log M).
    pub(super) fn strays(&self, data: &Located, leash: Leash) -> Option<usize> {
        self.stray_places(data, leash).first().map(|pull| pull.piece)
    }

    /// Pulls the curve back to the way of the points where it leaves it; answers how far the points are then, or
    /// nothing where it still does.
    pub(super) fn pulled_back(&mut self, data: &mut Located, leash: Leash) -> Option<Distances> {
        let mut distances = self.project(data, 2);
        for _ in 0..MOST_STEPS {
            let pulls = self.stray_places(data, leash);
            if pulls.is_empty() {
                return Some(distances);
            }
            self.tighten_held(data, &pulls);
            distances = self.project(data, 2);
        }
        self.strays(data, leash).is_none().then_some(distances)
    }

    /// Places on which the curve leaves the way of the points, and the ways back.
    fn stray_places(&self, data: &Located, leash: Leash) -> Vec<Pull> {
        let way = Way::of(data, self.space.breaks.closed);
        let (pieces, end) = (self.pieces(), self.space.breaks.end);
        let (mut found, mut i) = (Vec::new(), 0);
        for (s, span) in self.space.spans.iter().enumerate() {
            for look in 0..=LOOKS {
                let u = 2.0 * look as f64 / LOOKS as f64 - 1.0;
                let t = span.middle + span.half * u;
                let t = if way.closed && t >= end { t - end } else { t };
                if !way.reaches(t) {
                    continue;
                }
                i = way.before(t, i);
                let (back, apart) = way.back(on_piece(&pieces[s], u), i);
                if back.norm() > leash.slack + leash.share * apart {
                    found.push(Pull { piece: s, u, back });
                }
            }
        }
        found
    }
}

/// The points in the order of their parameters.
struct Way<'a> {
    data: &'a Located,
    order: Vec<usize>,
    closed: bool,
}

impl<'a> Way<'a> {
    fn of(data: &'a Located, closed: bool) -> Self {
        let mut order: Vec<usize> = (0..data.points.len()).collect();
        sort_by_number(&mut order, &|&i| data.parameters[i]);
        Self { data, order, closed }
    }

    fn parameter(&self, i: usize) -> f64 {
        self.data.parameters[self.order[i]]
    }

    /// Whether there are points on both sides: beyond the feet an open curve ends.
    fn reaches(&self, t: f64) -> bool {
        self.closed || (t >= self.parameter(0) && t <= self.parameter(self.order.len() - 1))
    }

    /// The last point before t, or the first one; `from` was before the last t.
    fn before(&self, t: f64, from: usize) -> usize {
        let mut i = if self.parameter(from) > t { 0 } else { from };
        while i + 1 < self.order.len() && self.parameter(i + 1) <= t {
            i += 1;
        }
        i
    }

    /// The point `k` after the one two before i.
    fn around(&self, i: usize, k: usize) -> Point {
        let (j, count) = (i + k, self.order.len());
        let j = if self.closed { (j + count - 2) % count } else { j.saturating_sub(2).min(count - 1) };
        self.data.points[self.order[j]]
    }

    /// The way from a place between points i and i + 1 to the lines between those around, and how far apart these are.
    /// Across a gap that is wider than the others a curve may swing as far as it is wide.
    fn back(&self, place: Point, i: usize) -> (Vector, f64) {
        let (mut nearest, mut apart) = (Vector::repeat(f64::INFINITY), 0.0_f64);
        for k in [0, 1, 3, 4, 2] {
            let (from, to) = (self.around(i, k), self.around(i, k + 1));
            let back = way_to_line(place, from, to);
            if back.norm_squared() < nearest.norm_squared() {
                nearest = back;
            }
            let gap = (to - from).norm();
            apart = if k == 2 && gap > 2.0 * apart { 2.0 * gap } else { apart.max(gap) };
        }
        (nearest, apart)
    }
}

/// The way from a point to the line between two.
fn way_to_line(point: Point, from: Point, to: Point) -> Vector {
    let (way, along) = (from - point, to - from);
    let square = along.norm_squared();
    let part = if square > 0.0 { (-way.dot(&along) / square).clamp(0.0, 1.0) } else { 0.0 };
    way + along * part
}
