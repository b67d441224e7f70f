//! The solver that the paper uses, beside ours: to compare results and times with.

use super::cone::{Metric, norm};
use super::reduced::Reduced;
use crate::error::Result;
use crate::fit::convex::problem::{Norm, Problem};
use crate::fit::convex::scaled::Scaled;
use crate::numerics::Vector;

/// What holds two components to where they were: in one step they do not exchange what the points hardly tell apart.
const HOLD: f64 = 1e-4;

/// The alternating direction method of multipliers on all places for knots. [LDAU22, III-D], [BPCPE11, 3]
///
/// Splits w = Lc; with over-relaxation by 1.6 and penalties balanced by the residuals. Linear convergence at best:
/// 300 to 2000 iterations for three digits on small problems, and no knot is ever exactly zero in Lc. Two components on
/// fine grids share curves that the points hardly tell apart, and their systems lose all digits: a proximal term keeps
/// them regular and leaves the optimum where it is. \[FPST13\]
#[derive(Clone, Debug)]
pub struct Admm {
    data: Scaled,
    norm: Norm,
    reduced: Reduced,
    unknowns: Vec<Vector>,
    split: Vec<Vector>,
    dual: Vec<Vector>,
    penalties: Vec<f64>,
    lambdas: Vec<f64>,
    /// The proximal weight of the coefficients.
    hold: f64,
    iteration: usize,
}

impl Admm {
    /// Starts from the curve without knots.
    ///
    /// # Errors
    ///
    /// As for [`Problem::check`].
    pub fn new(problem: &Problem) -> Result<Self> {
        problem.check()?;
        let data = Scaled::new(problem)?;
        let all = data.components.iter().map(|c| (0..c.grid.len()).collect()).collect();
        let mut reduced = Reduced::new(&data, all, &[])?;
        let hold = if reduced.parts.len() > 1 { HOLD } else { 0.0 };
        for i in 0..reduced.unknowns {
            reduced.quadratic.add(i, i, hold);
        }
        let lambdas = reduced.lambdas(&data);
        // A typical jump is a hundredth of the drawing over the time that λ speaks of: ρ = 20λ/jump.
        let penalties = lambdas.iter().map(|lambda| lambda * lambda.max(1.0)).collect();
        let knots = lambdas.len();
        let mut admm = Self {
            unknowns: vec![Vector::zeros(); reduced.unknowns],
            split: vec![Vector::zeros(); knots],
            dual: vec![Vector::zeros(); knots],
            data,
            norm: problem.norm,
            reduced,
            penalties,
            lambdas,
            hold,
            iteration: 0,
        };
        admm.factor();
        Ok(admm)
    }

    /// Factors the system of the penalties in force.
    fn factor(&mut self) {
        let metrics: Vec<Metric> = self.penalties.iter().map(|&p| [p, 0.0, p]).collect();
        let _ = self.reduced.factor(&metrics);
    }

    /// The dual vectors are kept in units of the penalties.
    fn scale_penalties(&mut self, ratio: f64) {
        for (penalty, dual) in self.penalties.iter_mut().zip(&mut self.dual) {
            *penalty *= ratio;
            *dual /= ratio;
        }
    }

    /// One iteration.
    pub fn step(&mut self) {
        const RELAXATION: f64 = 1.6;
        let forces: Vec<Vector> =
            (0..self.split.len()).map(|k| (self.split[k] - self.dual[k]) * self.penalties[k]).collect();
        for (unknown, linear) in self.unknowns.iter_mut().zip(&self.reduced.linear) {
            *unknown = *unknown * self.hold + linear;
        }
        self.reduced.pull(&forces, &mut self.unknowns);
        self.reduced.solve(&mut self.unknowns, &mut Vec::new());
        let mut jumps = Vec::new();
        self.reduced.jumps(&self.unknowns, &mut jumps);
        let (mut primal, mut moved) = (0.0, 0.0);
        for (k, jump) in jumps.iter().enumerate() {
            let relaxed = jump * RELAXATION + self.split[k] * (1.0 - RELAXATION);
            let limit = self.lambdas[k] / self.penalties[k];
            let next = shrunk(relaxed + self.dual[k], limit, self.norm);
            let penalty = self.penalties[k];
            primal += (jump - next).norm_squared() * penalty;
            moved += (next - self.split[k]).norm_squared() * penalty;
            self.dual[k] += relaxed - next;
            self.split[k] = next;
        }
        self.iteration += 1;
        // Residual balancing, seldom enough that it ends.
        if self.iteration.is_multiple_of(20) && self.iteration <= 2000 {
            let ratio = (primal / moved.max(f64::MIN_POSITIVE)).sqrt().sqrt().clamp(0.2, 5.0);
            if !(0.7..=1.4).contains(&ratio) {
                self.scale_penalties(ratio);
                self.factor();
            }
        }
    }

    /// The objective at the coefficients, in the caller's units.
    pub fn objective(&self) -> f64 {
        let mut weighted = vec![Vector::zeros(); self.data.t.len()];
        let data_term = self.reduced.residuals(&self.data, &self.unknowns, &mut weighted, &mut Vec::new());
        let mut jumps = Vec::new();
        self.reduced.jumps(&self.unknowns, &mut jumps);
        let size = |v: &Vector| match self.norm {
            Norm::L2 => norm(*v),
            Norm::L1 => v.x.abs() + v.y.abs(),
        };
        let regularizer: f64 =
            jumps.iter().zip(&self.lambdas).map(|(jump, lambda)| lambda * size(jump)).sum();
        (data_term + regularizer) * self.data.objective_factor()
    }

    /// Iterations so far.
    pub fn iterations(&self) -> usize {
        self.iteration
    }
}

/// The proximal point of a jump: shorter by `limit`, as a vector or coordinate by coordinate.
fn shrunk(v: Vector, limit: f64, kind: Norm) -> Vector {
    match kind {
        Norm::L2 => {
            let length = norm(v);
            if length > limit { v * (1.0 - limit / length) } else { Vector::zeros() }
        }
        Norm::L1 => {
            let one = |x: f64| x.signum() * (x.abs() - limit).max(0.0);
            Vector::new(one(v.x), one(v.y))
        }
    }
}
