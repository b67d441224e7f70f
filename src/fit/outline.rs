//! Points on the sides of an outline: one that has its sides by their ends only is to be followed there as well.

use super::knots::free_knots::Located;
use super::samples::{PER_POINT, Samples};
use crate::error::Result;
use crate::limits;
use crate::numerics::Vector;
use crate::numerics::order::median;

/// The middle one of so many steps tells how long steps are there: of a side, with five others beside it at most.
const AROUND: usize = 13;
/// A step that is so many times as long, and so many standard deviations of the noise more, is a side.
const FAR: f64 = 4.0;
const SCATTERED: f64 = 5.0;
/// Into how many pieces a side is cut at most, and how many points more than there were that makes in all, at most.
const MOST: usize = 64;
const SPARE: usize = 1000;
/// A step with a corner at both of its ends is a side as well, where it is so many times as long as points are off.
const CLEAR: f64 = 8.0;
/// The cosine of what a corner turns by at least, 50°: seven points of a circle turn by more, and are a polygon.
pub(super) const SHARP: f64 = 0.642_787_609_686_539_3;
/// The cosine of what a side may turn by where it has a point on it: roundings.
const STRAIGHT: f64 = 1.0 - 1e-12;
/// A search needs so many pieces of a side between corners to see that they are corners.
const PIECES: usize = 8;
/// Of so many points corners are looked for.
pub(super) const MOST_CORNERED: usize = 500;

/// Samples with points along their sides as well.
pub(super) struct Outline {
    pub(super) samples: Samples,
    /// The numbers that the samples themselves have there.
    pub(super) own: Vec<u32>,
    /// Whether there are sides between corners among them.
    pub(super) cornered: bool,
}

/// The samples with points along their sides as well, as far apart as those around; `None` where no step is far longer
/// than those around, and none is a side between corners, for which it is said how far `off` points may be. O(M).
///
/// # Errors
///
/// `OutOfMemory` where there is no room for a fit of so many points.
pub(super) fn filled(samples: &Samples, noise: f64, off: Option<f64>) -> Result<Option<Outline>> {
    let count = samples.points.len();
    let steps = steps(samples);
    let mut pieces = pieces(&steps, samples.closed, noise);
    let mut cornered = false;
    if let Some(off) = off.filter(|_| count <= MOST_CORNERED) {
        for m in between_corners(&steps, samples.closed, off) {
            (cornered, pieces[m]) = (true, pieces[m].max(PIECES));
        }
    }
    let sides = pieces.iter().filter(|pieces| **pieces > 1).count();
    if sides == 0 {
        return Ok(None);
    }
    let most = ((count + SPARE) / sides).clamp(if cornered { PIECES } else { 1 }, MOST);
    limits::probe((count + sides * most).saturating_mul(PER_POINT))?;
    let (mut points, mut weights, mut own) = (Vec::new(), Vec::new(), Vec::new());
    for m in 0..count {
        own.push(points.len() as u32);
        points.push(samples.points[m]);
        weights.push(samples.weights[m]);
        // A side counts for as much as the lesser one of its ends.
        let weight = samples.weights[m].min(samples.weights[(m + 1) % count]);
        for k in 1..pieces.get(m).map_or(1, |pieces| most.min(*pieces)) {
            points.push(samples.points[m] + steps[m] * (k as f64 / most.min(pieces[m]) as f64));
            weights.push(weight);
        }
    }
    Ok(Some(Outline { samples: Samples { points, weights, ..samples.clone() }, own, cornered }))
}

/// Parameters, evenly from each point to the next, where others were put between those with these numbers; the last
/// side of a closed outline ends at `end`. One step is 1 again on average: answers how many times as many of them there
/// are.
pub(super) fn between(parameters: &mut Vec<f64>, end: &mut f64, own: &[u32], count: usize) -> f64 {
    let last = own.len() - 1;
    let more = count as f64 / own.len() as f64;
    *end *= more;
    let mut spread = Vec::with_capacity(count);
    for (m, from) in own.iter().enumerate() {
        let to = own.get(m + 1).map_or(count, |to| *to as usize);
        let ends = [parameters[m] * more, if m < last { parameters[m + 1] * more } else { *end }];
        let steps = to - *from as usize;
        spread.extend((0..steps).map(|k| ends[0] + (ends[1] - ends[0]) * (k as f64 / steps as f64)));
    }
    *parameters = spread;
    more
}

/// The way from each point to the next.
#[inline(never)]
pub(super) fn steps(samples: &Samples) -> Vec<Vector> {
    let count = samples.points.len();
    let last = if samples.closed { count } else { count - 1 };
    (0..last).map(|m| samples.points[(m + 1) % count] - samples.points[m]).collect()
}

/// How many of the steps around go into each step where it is a side, else 1.
fn pieces(steps: &[Vector], closed: bool, noise: f64) -> Vec<usize> {
    let count = steps.len();
    let mut pieces = vec![1; count];
    if count < AROUND {
        return pieces;
    }
    let mut around = [0.0; AROUND];
    for m in 0..count {
        let before =
            if closed { m + count - AROUND / 2 } else { m.saturating_sub(AROUND / 2).min(count - AROUND) };
        for (i, length) in around.iter_mut().enumerate() {
            *length = steps[(before + i) % count].norm();
        }
        let (usual, length) = (median(&mut around), steps[m].norm());
        if length > FAR * usual + SCATTERED * noise {
            pieces[m] = (length / usual) as usize;
        }
    }
    pieces
}

/// The sides between corners where most steps are such: where it is not points being so far `off` that makes the way
/// turn sharply. An open list has corners for ends, and a side may have points on it.
fn between_corners(steps: &[Vector], closed: bool, off: f64) -> Vec<usize> {
    let long: Vec<usize> = (0..steps.len()).filter(|&m| steps[m].norm() > CLEAR * off).collect();
    let count = long.len();
    // Whether the way turns sharply before a long step; nothing where it goes straight on.
    let turn = |i: usize| {
        if !closed && (i == 0 || i == count) {
            return Some(true);
        }
        let cosine = cosine(steps[long[(i + count - 1) % count]], steps[long[i % count]]);
        (cosine < STRAIGHT).then_some(cosine < SHARP)
    };
    // How many steps there are to a corner that is not far and comes before any bend.
    let to_corner = |places: &mut dyn Iterator<Item = usize>| {
        let (before, sharp) = places.take(PIECES).enumerate().find_map(|(k, i)| Some((k, turn(i)?)))?;
        sharp.then_some(before + 1)
    };
    // A side that has many points on it is followed as it is.
    let is_side = |i: &usize| {
        let back = to_corner(&mut (0..count).map(|k| (i + count - k) % count));
        let on = to_corner(&mut (i + 1..=i + count));
        back.zip(on).is_some_and(|(back, on)| back + on <= PIECES)
    };
    let sides: Vec<usize> = (0..count).filter(is_side).map(|i| long[i]).collect();
    if 2 * sides.len() >= count { sides } else { Vec::new() }
}

/// The cosine of what a way turns by from one step to the next.
pub(super) fn cosine(before: Vector, after: Vector) -> f64 {
    before.dot(&after) / (before.norm() * after.norm())
}

/// What is at these numbers of a list.
pub(super) fn only(located: &Located, own: &[u32]) -> Located {
    let of = |list: &[f64]| own.iter().filter_map(|&m| list.get(m as usize).copied()).collect();
    Located {
        points: own.iter().map(|&m| located.points[m as usize]).collect(),
        parameters: of(&located.parameters),
        weights: of(&located.weights),
    }
}
