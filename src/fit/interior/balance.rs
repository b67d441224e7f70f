//! Whether the residuals of a curve are in balance, as they are at an optimum.
//!
//! Moving the curve by what costs nothing, constants on a circle and polynomials on a line, changes no jump, so at the
//! optimum the weighted residuals vanish against them. Bounds assume it (D 12.4). Where rounding has taken it, the
//! curve could be moved for less, and a bound says more than is true.

use super::fixed_knots::Fixed;
use super::iterate::ROUNDING;
use super::run::Run;
use crate::error::Result;
use crate::fit::convex::interval::TERMS;
use crate::fit::convex::scaled::Scaled;
use crate::limits;
use crate::numerics::Vector;
use crate::numerics::banded::Bordered;

/// Rounding that shows in what can be checked is larger elsewhere: by so much, as a rule less.
const CAUTION: f64 = 100.0;

impl Run {
    /// Adds to the gap what the curve lacks of balance, so that no bound counts that is none.
    pub(super) fn doubt(&mut self) -> Result<()> {
        if let Some(fixed) = &self.finished {
            let _ = fixed.reduced.residuals(&self.data, &fixed.unknowns, &mut self.weighted, &mut Vec::new());
        }
        let lacking = imbalance(&self.data, &self.weighted)?;
        self.measure.gap += share(lacking, self.measure.primal);
        if let Some(fixed) = &mut self.finished {
            fixed.measure = self.measure;
        }
        Ok(())
    }
}

impl Run {
    /// What the gap of a curve that the run has not come to lacks of balance.
    pub(super) fn lacking(&self, fixed: &Fixed) -> Result<f64> {
        let mut weighted = limits::with_room(self.data.t.len())?;
        weighted.resize(self.data.t.len(), Vector::zeros());
        let _ = fixed.reduced.residuals(&self.data, &fixed.unknowns, &mut weighted, &mut Vec::new());
        let lacking = imbalance(&self.data, &weighted)?;
        Ok(share(lacking, fixed.measure.primal))
    }
}

/// What is lacking as a part of the gap; nothing where the objective is rounding itself.
fn share(lacking: f64, primal: f64) -> f64 {
    if primal > ROUNDING { CAUTION * lacking / primal } else { 0.0 }
}

/// By how much the sum of squares falls when the curve is moved by the best of what costs nothing: Σ|⟨we, q⟩|² over
/// such q that are orthonormal under the weights w. O(M).
fn imbalance(data: &Scaled, weighted: &[Vector]) -> Result<f64> {
    let highest = data.components.last().map_or(1, |component| component.degree);
    let count = if data.closed { 1 } else { highest + 1 };
    let mut moments = [Vector::zeros(); TERMS];
    // The product of two of Chebyshev's polynomials is half of two others.
    let mut weights = [0.0; 2 * TERMS];
    for ((t, w), force) in data.t.iter().zip(&data.w).zip(weighted) {
        let x = 2.0 * t / data.length - 1.0;
        let (mut before, mut here) = (x, 1.0);
        for i in 0..2 * count {
            weights[i] += w * here;
            if i < count {
                moments[i] += force * here;
            }
            (before, here) = (here, 2.0 * x * here - before);
        }
    }
    let mut gram = Bordered::new(0, 0, count)?;
    for i in 0..count {
        for j in 0..=i {
            gram.add(i, j, 0.5 * (weights[i + j] + weights[i - j]));
        }
    }
    let _ = gram.factor(1e-14);
    let mut shares = moments[..count].to_vec();
    gram.solve_points(&mut shares)?;
    Ok(shares.iter().zip(&moments).map(|(share, moment)| share.x * moment.x + share.y * moment.y).sum())
}
