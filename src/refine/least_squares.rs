//! Going back down: the coarse points whose refinement is nearest to given fine ones.

use super::exponential::Target;
use crate::error::Result;
use crate::limits::filled;

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
    let mut step: Vec<f64> = residual.iter().zip(&diagonal).map(|(r, d)| r / d).collect();
    let mut image = filled(0.0, size)?;
    let mut energy = dot(&residual, &step);
    let enough = CONVERGED * energy;
    for _ in 0..MOST_ROUNDS {
        // Written so that NaN ends it.
        if !matches!(energy.partial_cmp(&enough), Some(core::cmp::Ordering::Greater)) {
            break;
        }
        target.gather(&target.fill(&step, dimension, m, filter)?, dimension, m, filter, &mut image);
        let along = energy / dot(&step, &image);
        for (k, x) in x.iter_mut().enumerate() {
            *x += along * step[k];
            residual[k] -= along * image[k];
        }
        let before = energy;
        let scaled = residual.iter().zip(&diagonal).map(|(r, d)| r / d);
        energy = residual.iter().zip(scaled.clone()).map(|(r, s)| r * s).sum();
        for (step, scaled) in step.iter_mut().zip(scaled) {
            *step = scaled + energy / before * *step;
        }
    }
    Ok(x)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
