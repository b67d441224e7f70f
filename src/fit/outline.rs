//! Points on the long sides of an outline: one that has its sides by their ends only is to be followed there as well.

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

/// The samples with points along their sides as well, as far apart as those around, and the numbers that the samples have there; `None`
/// where no step is far longer than those around. O(M).
///
/// # Errors
///
/// `OutOfMemory` where there is no room for a fit of so many points.
pub(super) fn filled(samples: &Samples, noise: f64) -> Result<Option<(Samples, Vec<u32>)>> {
    let count = samples.points.len();
    let last = if samples.closed { count } else { count - 1 };
    let steps: Vec<Vector> = (0..last).map(|m| samples.points[(m + 1) % count] - samples.points[m]).collect();
    let pieces = pieces(&steps, samples.closed, noise);
    let sides = pieces.iter().filter(|pieces| **pieces > 1).count();
    if sides == 0 {
        return Ok(None);
    }
    limits::probe((2 * count + SPARE).saturating_mul(PER_POINT))?;
    let most = ((count + SPARE) / sides).clamp(1, MOST);
    let (mut points, mut weights, mut own) = (Vec::new(), Vec::new(), Vec::new());
    for m in 0..count {
        own.push(points.len() as u32);
        points.push(samples.points[m]);
        weights.push(samples.weights[m]);
        for k in 1..pieces.get(m).map_or(1, |pieces| most.min(*pieces)) {
            points.push(samples.points[m] + steps[m] * (k as f64 / most.min(pieces[m]) as f64));
            weights.push(1.0);
        }
    }
    Ok(Some((Samples { points, weights, ..samples.clone() }, own)))
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

/// What is at these numbers of a list.
pub(super) fn only(located: &Located, own: &[u32]) -> Located {
    let of = |list: &[f64]| own.iter().filter_map(|&m| list.get(m as usize).copied()).collect();
    Located {
        points: own.iter().map(|&m| located.points[m as usize]).collect(),
        parameters: of(&located.parameters),
        weights: of(&located.weights),
    }
}
