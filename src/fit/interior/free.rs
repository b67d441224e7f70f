//! λ = 0: jumps cost nothing, so the optimum is the least-squares spline with a knot at every place there is.

use super::cone::{Metric, dot};
use super::fixed_knots::Fixed;
use super::iterate::{Measure, ROUNDING};
use super::reduced::Reduced;
use super::run::Run;
use crate::error::Result;
use crate::fit::convex::scaled::Scaled;
use crate::fit::convex::solution::Status;
use crate::numerics::Vector;

/// What holds coefficients that no point determines, where the least weight is the largest, and at least; it is taken
/// back again by the refinements.
const HOLD: f64 = 1e-9;
const LEAST_HOLD: f64 = 1e-13;
/// How often the solution is refined, and how often at most where the gap is larger than asked for: what is well
/// determined loses nine digits of its error each time, what weights a million times smaller say as good as none.
const REFINEMENTS: usize = 4;
const MOST_REFINEMENTS: usize = 200;

impl Run {
    /// The whole run where every λ is 0: one linear system. O(M + N).
    pub(crate) fn solve_for_free(&mut self) -> Result<()> {
        let fixed = least_squares(&self.data, self.settings.gap)?;
        self.measure = fixed.measure;
        self.finished = Some(fixed);
        let reached = self.measure.gap <= self.settings.gap;
        self.status = if reached { Status::Converged } else { Status::Stalled };
        Ok(())
    }
}

fn least_squares(data: &Scaled, asked: f64) -> Result<Fixed> {
    let all = data.components.iter().map(|component| (0..component.grid.len()).collect()).collect();
    let mut reduced = Reduced::new(data, all, &[])?;
    let knots: usize = reduced.parts.iter().map(|part| part.rows.len()).sum();
    let (least, most) = data.w.iter().fold((f64::INFINITY, 0.0_f64), |(l, m), &w| (l.min(w), m.max(w)));
    let hold = (HOLD * (least / most)).max(LEAST_HOLD);
    let metrics: Vec<Metric> = vec![[hold, 0.0, hold]; knots];
    let _ = reduced.factor(&metrics);
    let (mut weighted, mut moments, mut line) = (vec![Vector::zeros(); data.t.len()], Vec::new(), Vec::new());
    let mut unknowns = vec![Vector::zeros(); reduced.unknowns];
    let (mut change, mut round) = (Vec::new(), 0);
    let (data_term, missing, gap) = loop {
        let data_term = reduced.residuals(data, &unknowns, &mut weighted, &mut moments);
        reduced.gradient(&moments, &mut change);
        let gradient = if round < REFINEMENTS { Vec::new() } else { change.clone() };
        reduced.solve(&mut change, &mut line);
        if round >= REFINEMENTS {
            // Half the gradient along Newton's step is what the objective can still fall by.
            let missing = 0.5 * gradient.iter().zip(&change).map(|(a, b)| dot(*a, *b)).sum::<f64>();
            let gap = if data_term > ROUNDING { (missing / data_term).clamp(0.0, 1.0) } else { 0.0 };
            if gap <= asked || round == MOST_REFINEMENTS {
                break (data_term, missing, gap);
            }
        }
        for (unknown, by) in unknowns.iter_mut().zip(&change) {
            *unknown -= by;
        }
        round += 1;
    };
    let mut jumps = Vec::new();
    reduced.jumps(&unknowns, &mut jumps);
    let measure = Measure { data_term, primal: data_term, dual: data_term - missing, longest: 0.0, gap };
    Ok(Fixed { reduced, unknowns, jumps, measure })
}
