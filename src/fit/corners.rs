//! Corners that few points of an open way show: turns that the points on either side do not lead to.

use super::noise::cross;
use super::outline::steps;
use super::samples::Samples;
use crate::numerics::order::sort_by_number;
use crate::numerics::{Point, Vector};

/// A corner turns by so much more, in radians, than points do in the mean, and than so many times what the turns on
/// either side lead to.
const LED: f64 = 2.0;
const MORE: f64 = 0.9;
/// Sides that meet farther off than so many steps do not meet.
const FAR: f64 = 1.5;
/// What makes π of the first terms of the angle's series where a way turns round.
const TURNED_ROUND: f64 = 5.143e-3;

/// A corner, the last point before it and the first one after it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) place: Point,
    pub(super) last: usize,
    pub(super) next: usize,
}

/// What an open way turns by at its inner points, how long it is around each, and how much it bends there: the one by
/// the other.
struct Turns {
    by: Vec<f64>,
    lengths: Vec<f64>,
    bends: Vec<f64>,
    /// The mean of their sizes.
    mean: f64,
}

/// Points from one on, as many as are where a corner is, and by how much more they turn than a curve would.
struct Seen {
    first: usize,
    points: usize,
    excess: f64,
}

impl Seen {
    fn overlaps(&self, other: &Self) -> bool {
        self.first < other.first + other.points && other.first < self.first + self.points
    }
}

impl Turns {
    fn of(steps: &[Vector]) -> Self {
        let lengths: Vec<f64> = steps.iter().map(|step| step.norm()).collect();
        let by: Vec<f64> = steps.windows(2).map(|pair| turn(pair[0], pair[1])).collect();
        let lengths: Vec<f64> = lengths.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
        let bends: Vec<f64> = by.iter().zip(&lengths).map(|(turn, length)| turn / length).collect();
        let mean = bends.iter().map(|bend| bend.abs()).sum::<f64>() / bends.len() as f64;
        Self { by, lengths, bends, mean }
    }

    /// What the bends of two points lead to in a direction, the nearer one first: as much as there, or growing as it
    /// did.
    fn led(&self, near: Option<usize>, far: Option<usize>, sign: f64) -> f64 {
        let bend = |m: Option<usize>| m.and_then(|m| self.bends.get(m)).map(|bend| (bend * sign).max(0.0));
        let last = bend(near).unwrap_or(0.0);
        last + (last - bend(far).unwrap_or(last)).max(0.0)
    }

    /// By how much more so many points turn than a curve would there.
    fn seen(&self, first: usize, points: usize) -> Option<Seen> {
        let (inside, sign) = (first..first + points, self.by[first].signum());
        if self.by[inside.clone()].iter().any(|turn| turn * sign <= 0.0) {
            return None;
        }
        let sides =
            [[first.checked_sub(1), first.checked_sub(2)], [Some(first + points), Some(first + points + 1)]];
        let led = sides.map(|[near, far]| self.led(near, far, sign));
        // A curve that bends is seen to bend at more than one point.
        let back =
            |near: Option<usize>| near.and_then(|m| self.bends.get(m)).is_none_or(|bend| bend * sign < 0.0);
        let alone = points == 1 && sides.iter().all(|[near, _]| back(*near));
        let usual = if alone { 0.0 } else { self.mean };
        let bend = usual.max(LED * led[0].max(led[1]));
        let excess: f64 = inside.map(|m| self.by[m].abs() - bend * self.lengths[m]).sum();
        (excess > MORE).then_some(Seen { first, points, excess })
    }
}

/// The corners of an open way, in order. A corner is at a point or between two. O(M²).
pub(super) fn corners(samples: &Samples) -> Vec<Corner> {
    let steps = steps(samples);
    let turns = Turns::of(&steps);
    let count = turns.by.len();
    let all = (1..=2).flat_map(|points| (0..(count + 1).saturating_sub(points)).map(move |m| (m, points)));
    let mut seen: Vec<Seen> = all.filter_map(|(m, points)| turns.seen(m, points)).collect();
    sort_by_number(&mut seen, &|one| -one.excess);
    let mut kept: Vec<Seen> = Vec::new();
    for one in seen {
        if kept.iter().all(|other| !one.overlaps(other)) {
            kept.push(one);
        }
    }
    sort_by_number(&mut kept, &|one| one.first as f64);
    let corner = |one: &Seen| {
        let m = one.first + 1;
        if one.points == 1 {
            return Corner { place: samples.points[m], last: m - 1, next: m + 1 };
        }
        let place = meeting(samples.points[m], [steps[m - 1], steps[m], steps[m + 1]]);
        Corner { place, last: m, next: m + 1 }
    };
    kept.iter().map(corner).collect()
}

/// Where the way before a step and the way after it meet, the step beginning here; its middle where they do not.
fn meeting(from: Point, [before, step, after]: [Vector; 3]) -> Point {
    let along = cross(step, after) / cross(before, after);
    let way = before * along;
    if along > 0.0 && way.norm() < FAR * step.norm() { from + way } else { from + step * 0.5 }
}

/// What a way turns by from one step to the next, to the left or to the right, within 3 %: from the distance of two
/// directions.
fn turn(before: Vector, after: Vector) -> f64 {
    let apart = after / after.norm() - before / before.norm();
    let square = apart.norm_squared();
    let size = square.sqrt() * (1.0 + square * (1.0 / 24.0 + square * (3.0 / 640.0 + square * TURNED_ROUND)));
    if cross(before, after) < 0.0 { -size } else { size }
}
