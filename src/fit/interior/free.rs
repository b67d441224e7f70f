//! λ = 0: jumps cost nothing, so the optimum is the least-squares spline with a knot at every place there is.

use super::cone::{Metric, dot};
use super::iterate::{Measure, ROUNDING};
use super::polish::Fixed;
use super::reduced::Reduced;
use super::run::Run;
use crate::error::Result;
use crate::fit::convex::scaled::Scaled;
use crate::fit::convex::solution::Status;
use crate::numerics::Vector;

/// What holds coefficients that no point determines; it is taken back again by the refinements.
const HOLD: f64 = 1e-9;
/// How often the solution is refined: what is well determined loses nine digits of its error each time.
const REFINEMENTS: usize = 4;

impl Run {
    /// The whole run where every λ is 0: one linear system. O(M + N).
    pub(crate) fn solve_for_free(&mut self) -> Result<()> {
        let fixed = least_squares(&self.data)?;
        self.measure = fixed.measure;
        self.finished = Some(fixed);
        self.status = Status::Converged;
        Ok(())
    }
}

fn least_squares(data: &Scaled) -> Result<Fixed> {
    let all = data.components.iter().map(|component| (0..component.grid.len()).collect()).collect();
    let mut reduced = Reduced::new(data, all, &[])?;
    let knots: usize = reduced.parts.iter().map(|part| part.rows.len()).sum();
    let metrics: Vec<Metric> = vec![[HOLD, 0.0, HOLD]; knots];
    let _ = reduced.factor(&metrics);
    let (mut weighted, mut moments, mut line) = (vec![Vector::zeros(); data.t.len()], Vec::new(), Vec::new());
    let mut unknowns = vec![Vector::zeros(); reduced.unknowns];
    let (mut data_term, mut change) = (0.0, Vec::new());
    let mut missing = 0.0;
    for round in 0..=REFINEMENTS {
        data_term = reduced.residuals(data, &unknowns, &mut weighted, &mut moments);
        reduced.gradient(&moments, &mut change);
        let gradient = if round == REFINEMENTS { change.clone() } else { Vec::new() };
        reduced.solve(&mut change, &mut line);
        if round == REFINEMENTS {
            // Half the gradient along Newton's step is what the objective can still fall by.
            missing = 0.5 * gradient.iter().zip(&change).map(|(a, b)| dot(*a, *b)).sum::<f64>();
            break;
        }
        for (unknown, by) in unknowns.iter_mut().zip(&change) {
            *unknown -= by;
        }
    }
    let gap = if data_term > ROUNDING { (missing / data_term).clamp(0.0, 1.0) } else { 0.0 };
    let mut jumps = Vec::new();
    reduced.jumps(&unknowns, &mut jumps);
    let measure = Measure { data_term, primal: data_term, dual: data_term - missing, longest: 0.0, gap };
    Ok(Fixed { reduced, unknowns, jumps, measure })
}
