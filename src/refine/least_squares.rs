//! Going back down: the coarse points whose refinement is nearest to given fine ones.

use super::exponential::Target;
use crate::error::Result;
use crate::limits::filled;
use crate::numerics::lists::{add_scaled, dot};

/// The residual is this small after 200 rounds at the latest for 8 roots.
const CONVERGED: f64 = 1e-30;
const MOST_ROUNDS: usize = 1000;

/// The coarse points whose spread is nearest to `fine`: conjugate gradients on the normal equations, scaled by their
/// diagonal. Their condition does not grow with the number of points.
pub(crate) fn least_squares(
    target: &Target,
    fine: &[f64],
    dimension: usize,
    m: usize,
    filter: &[f64],
    size: usize,
) -> Result<Vec<f64>> {
    let mut x = filled(0.0, size)?;
    let mut residual = filled(0.0, size)?;
    target.gather(fine, dimension, m, filter, &mut residual);
    let squares: Vec<f64> = filter.iter().map(|tap| tap * tap).collect();
    let mut diagonal = filled(0.0, size)?;
    target.gather(&vec![1.0; fine.len()], dimension, m, &squares, &mut diagonal);
    let (mut step, mut image) = (filled(0.0, size)?, filled(0.0, size)?);
    fill_quotients(&mut step, &residual, &diagonal);
    let mut energy = dot(&residual, &step);
    let enough = CONVERGED * energy;
    for _ in 0..MOST_ROUNDS {
        // Written so that NaN ends it.
        if !matches!(energy.partial_cmp(&enough), Some(core::cmp::Ordering::Greater)) {
            break;
        }
        target.gather(&target.fill(&step, dimension, m, filter)?, dimension, m, filter, &mut image);
        let along = energy / dot(&step, &image);
        add_scaled(&mut x, along, &step);
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
