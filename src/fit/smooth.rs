//! Few points of a smooth curve: how the way turns at them tells that none is a corner.

use super::outline::steps;
use super::samples::Samples;

/// Of so many points at least that is told, and more tell where their corners are.
const LEAST: usize = 9;
const FEWER: usize = 64;
/// How many of a hundred points turn more, or less, than both of their neighbours, at most: where noise is seen in
/// turns three of four do, and at least every other one of a polygon.
const CALM: usize = 45;
/// A corner turns by what half a point does in the mean more than the points do where it is, and by so many times what
/// is to be expected from those beside it: by more the fewer they are, for these say less.
const SEEN: f64 = 0.5;
const SUDDEN: f64 = 2.0;
const UNSURE: f64 = 20.0;
/// Of so many points on a corner may lie between two as well: of fewer those beside a narrow tip look alike.
const BETWEEN: usize = 16;
/// Differences that are such a part of the largest turn are rounding.
const EQUAL: f64 = 1e-6;

/// Whether few points are those of a closed curve without corners: turns seldom grow and shrink in turn, towards the
/// tip of a narrow bend they grow from one to the next, and a corner comes suddenly from both sides. O(M).
#[inline(never)]
pub(super) fn is_smooth(samples: &Samples) -> bool {
    let count = samples.points.len();
    if !samples.closed || !(LEAST..FEWER).contains(&count) {
        return false;
    }
    let turns = turns(samples);
    let most = if count < BETWEEN { 1 } else { 2 };
    is_calm(&turns) && !(1..=most).any(|points| (0..count).any(|m| is_corner(&turns, m, points)))
}

/// The tangents of half of what a closed way turns by at each of its points, to the left or to the right.
fn turns(samples: &Samples) -> Vec<f64> {
    let steps = steps(samples);
    let turn = |m: usize| {
        let (before, after) = (steps[(m + steps.len() - 1) % steps.len()], steps[m]);
        let lengths = before.norm() * after.norm();
        (before.x * after.y - before.y * after.x) / (lengths + before.dot(&after)).max(EQUAL * lengths)
    };
    (0..steps.len()).map(turn).collect()
}

/// Whether turns grow and shrink in turn no more often than those of a curve do.
fn is_calm(turns: &[f64]) -> bool {
    let count = turns.len();
    let least = EQUAL * turns.iter().fold(0.0_f64, |most, turn| most.max(turn.abs()));
    let (mut last, mut changes) = (0.0, 0);
    // The first time round tells whether they grow where the second begins.
    for m in 0..2 * count {
        let growth = turns[(m + 1) % count] - turns[m % count];
        if growth.abs() > least {
            changes += usize::from(m >= count && growth * last < 0.0);
            last = growth;
        }
    }
    100 * changes <= CALM * count
}

/// Whether so many points from m on are where a corner is.
#[inline(never)]
fn is_corner(turns: &[f64], m: usize, points: usize) -> bool {
    let count = turns.len();
    let by = |k: usize| turns[(m + k) % count] * turns[m].signum();
    let mean = turns.iter().map(|turn| turn.abs()).sum::<f64>() / count as f64;
    let last = points - 1;
    let turn = by(0) + by(last);
    // What turns on one side lead to, or the nearest of them.
    let (mut least, sudden) = ((1.0 + SEEN / points as f64) * mean, SUDDEN + UNSURE / count as f64);
    for [near, far] in [[points, points + 1], [count - 1, count - 2]] {
        let [near, far] = [by(near).max(0.0), by(far).max(0.0)];
        least = least.max(sudden * if far > 0.0 { near.max(near * near / far) } else { near });
    }
    by(last) > 0.0 && turn > 2.0 * least
}
