//! How far apart a few segments are, by foot points: for small edits, not for whole drawings.

use super::Segment;
use crate::numerics::Point;

/// Places on every segment from which the distance is measured, and among which a foot point is looked for.
const PLACES: usize = 96;

/// The larger of the two directed distances.
pub(super) fn two_way_deviation(first: &[Segment], second: &[Segment]) -> f64 {
    deviation(first, second).max(deviation(second, first))
}

/// The largest distance of a place on `from` to the nearest place on `to`.
pub(super) fn deviation(from: &[Segment], to: &[Segment]) -> f64 {
    let lattice: Vec<Vec<Point>> = to.iter().map(places).collect();
    from.iter().flat_map(places).map(|target| distance(target, to, &lattice)).fold(0.0, f64::max)
}

fn places(segment: &Segment) -> Vec<Point> {
    (0..=PLACES).map(|k| segment.position(place(k))).collect()
}

fn place(k: usize) -> f64 {
    k as f64 / PLACES as f64
}

fn distance(target: Point, to: &[Segment], lattice: &[Vec<Point>]) -> f64 {
    let mut nearest = f64::INFINITY;
    for (segment, points) in to.iter().zip(lattice) {
        let squares = points.iter().map(|point| (point - target).norm_squared());
        let (mut best, mut least) = (0, f64::INFINITY);
        for (k, square) in squares.enumerate() {
            if square < least {
                (best, least) = (k, square);
            }
        }
        let mut x = place(best);
        for _ in 0..4 {
            x = segment.foot(target, x);
        }
        let foot = (segment.position(x) - target).norm();
        nearest = nearest.min(foot).min(least.sqrt());
    }
    nearest
}

impl Segment<'_> {
    /// One step of Newton's method from x towards the foot of the perpendicular from `target`.
    pub(super) fn foot(&self, target: Point, x: f64) -> f64 {
        let offset = self.position(x) - target;
        let (velocity, acceleration) = (self.velocity(x), self.acceleration(x));
        let square = velocity.norm_squared();
        // Where the curve bends away, the step of a straight line is the safe one.
        let curved = square + offset.dot(&acceleration);
        let slope = if curved > 0.25 * square { curved } else { square };
        if slope == 0.0 {
            return x;
        }
        (x - offset.dot(&velocity) / (slope * self.length)).clamp(0.0, 1.0)
    }
}
