//! Going back down: the coarse points whose refinement is nearest to given fine ones.

use super::exponential::Target;
use crate::error::Result;
use crate::limits::filled;
use crate::numerics::lists::{add_scaled, dot};

/// One pass ends when the gradient's energy is this part of what it was, after 100 rounds at the latest for 8 roots.
const CONVERGED: f64 = 1e-16;
/// Of all passes.
const MOST_ROUNDS: usize = 1000;
/// What is left is computed anew for every pass: the recurrence of the gradients knows only half of the digits where
/// points beyond an open end weigh little. A pass that begins with no less than this part of the energy before begins
/// with roundings.
const GAINED: f64 = 1e-3;

/// The coarse points whose spread is nearest to `fine`: conjugate gradients on the normal equations, scaled by their
/// diagonal. Their condition does not grow with the number of points.
///
/// They begin with means of the fine points that each coarse one acts on: of an open curve too short to tell all points
/// beyond its ends, those come out that are near by and move with it.
pub(crate) fn least_squares(
    target: &Target,
    fine: &[f64],
    dimension: usize,
    m: usize,
    filter: &[f64],
    size: usize,
) -> Result<Vec<f64>> {
    let (mut x, mut residual) = (filled(0.0, size)?, filled(0.0, size)?);
    let squares: Vec<f64> = filter.iter().map(|tap| tap * tap).collect();
    let mut diagonal = filled(0.0, size)?;
    target.gather(&vec![1.0; fine.len()], dimension, m, &squares, &mut diagonal);
    target.gather(fine, dimension, m, &squares, &mut residual);
    fill_quotients(&mut x, &residual, &diagonal);
    let (mut step, mut image) = (filled(0.0, size)?, filled(0.0, size)?);
    let (mut energy, mut enough, mut most) = (0.0, 0.0, f64::MAX);
    for _ in 0..MOST_ROUNDS {
        if energy <= enough {
            let mut beyond = target.fill(&x, dimension, m, filter)?;
            add_scaled(&mut beyond, -1.0, fine);
            target.gather(&beyond, dimension, m, filter, &mut residual);
            fill_quotients(&mut step, &residual, &diagonal);
            energy = dot(&residual, &step);
            if energy == 0.0 || energy >= most {
                break;
            }
            (enough, most) = (CONVERGED * energy, GAINED * energy);
        }
        target.gather(&target.fill(&step, dimension, m, filter)?, dimension, m, filter, &mut image);
        let along = energy / dot(&step, &image);
        add_scaled(&mut x, -along, &step);
        add_scaled(&mut residual, -along, &image);
        let before = energy;
        fill_quotients(&mut image, &residual, &diagonal);
        energy = dot(&residual, &image);
        add_scaled(&mut image, energy / before, &step);
        core::mem::swap(&mut step, &mut image);
    }
    Ok(x)
}

/// The residual scaled by the diagonal.
#[inline(never)]
fn fill_quotients(to: &mut [f64], above: &[f64], below: &[f64]) {
    for ((to, above), below) in to.iter_mut().zip(above).zip(below) {
        *to = above / below;
    }
}
