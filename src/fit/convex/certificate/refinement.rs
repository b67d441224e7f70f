//! What takes the rounding of residuals out of a dual curve.

use super::{Curve, size, spline_jumps};
use crate::error::Result;
use crate::fit::convex::problem::{Norm, Problem};
use crate::fit::convex::solution::Solution;
use crate::fit::convex::spline_space::KnotSpace;
use crate::numerics::Vector;
use crate::numerics::banded::Bordered;

/// Systems of more unknowns than this are not refined: the bound is then what the residuals as they are give.
const MOST_DENSE: usize = 1200;

/// A coordinate that jumps by this share of the largest jump, or less, does not jump where |x| + |y| is measured: what
/// it does then is rounding.
const NOTHING: f64 = 1e-8;
/// The dual curve of a coordinate that does not jump may be anything up to one: it stays as it is found.
const ANY: f64 = f64::NAN;

/// Rounding of the residuals, integrated often, bends the dual curve away from the directions of the jumps. A change of
/// v by a spline on the knots of the solution takes it back; whatever the change, the bound stays a bound.
pub(super) struct Refinement {
    spaces: Vec<KnotSpace>,
    targets: Vec<Vec<Vector>>,
    matrix: Bordered,
}

impl Refinement {
    pub(super) fn new(problem: &Problem, solution: &Solution) -> Result<Option<Self>> {
        let (mut spaces, mut targets) = (Vec::new(), Vec::new());
        for spline in &solution.components {
            spaces.push(solution.space(spline)?);
            let jumps = spline_jumps(spline, solution.domain);
            let nothing = NOTHING * jumps.iter().fold(0.0_f64, |most, v| most.max(v.amax()));
            let sign = |v: f64| if v.abs() <= nothing { ANY } else { v.signum() };
            let unit = |v: &Vector| match problem.norm {
                Norm::L2 => v / size(*v, Norm::L2).max(f64::MIN_POSITIVE),
                Norm::L1 => Vector::new(sign(v.x), sign(v.y)),
            };
            targets.push(jumps.iter().map(unit).collect::<Vec<Vector>>());
        }
        let unknowns: usize = spaces.iter().map(KnotSpace::dimension).sum();
        if spaces.len() > 1 && unknowns > MOST_DENSE {
            return Ok(None);
        }
        let mut matrix = if spaces.len() == 1 {
            spaces[0].normal_matrix(&problem.parameters, &problem.weights)?
        } else {
            joint_matrix(problem, &spaces, unknowns)?
        };
        let _ = matrix.factor(1e-12);
        Ok(Some(Self { spaces, targets, matrix }))
    }

    /// Changes v; answers how far the dual curves were off.
    pub(super) fn correct(&mut self, problem: &Problem, curves: &[Curve], v: &mut [Vector]) -> f64 {
        let mut drift = 0.0_f64;
        let mut right = Vec::new();
        for (i, space) in self.spaces.iter().enumerate() {
            let offset = right.len();
            right.resize(offset + space.dimension(), Vector::zeros());
            for (k, (target, found)) in self.targets[i].iter().zip(&curves[i].at_knots).enumerate() {
                let missing = (target - found).map(|v| if v.is_nan() { 0.0 } else { v });
                drift = drift.max(size(missing, Norm::L2));
                let (first, weights) = space.jump_weights(k, space.degree());
                for (j, weight) in weights.iter().enumerate().take(space.degree() + 2) {
                    right[offset + space.coefficient(first + j)] +=
                        missing * (weight * problem.components[i].lambda);
                }
            }
        }
        if self.matrix.solve_points(&mut right).is_err() {
            return 0.0;
        }
        for (m, &t) in problem.parameters.iter().enumerate() {
            let weight = problem.weights.get(m).copied().unwrap_or(1.0);
            let mut offset = 0;
            for space in &self.spaces {
                let (interval, basis) = space.basis(t, 0);
                for (j, value) in basis.iter().enumerate().take(space.degree() + 1) {
                    v[m] += right[offset + space.coefficient(interval + j)] * (weight * value);
                }
                offset += space.dimension();
            }
        }
        drift
    }
}

/// Gram's matrix of both components together; what they share is held by the floor of the factorisation.
fn joint_matrix(problem: &Problem, spaces: &[KnotSpace], unknowns: usize) -> Result<Bordered> {
    let mut matrix = Bordered::new(0, 0, unknowns)?;
    for (m, &t) in problem.parameters.iter().enumerate() {
        let weight = problem.weights.get(m).copied().unwrap_or(1.0);
        let mut entries: Vec<(usize, f64)> = Vec::new();
        let mut offset = 0;
        for space in spaces {
            let (interval, basis) = space.basis(t, 0);
            for (j, value) in basis.iter().enumerate().take(space.degree() + 1) {
                entries.push((offset + space.coefficient(interval + j), *value));
            }
            offset += space.dimension();
        }
        for (p, (i, a)) in entries.iter().enumerate() {
            for (j, b) in &entries[..=p] {
                let twice = if i == j && !core::ptr::eq(a, b) { 2.0 } else { 1.0 };
                matrix.add(*i, *j, twice * weight * a * b);
            }
        }
    }
    Ok(matrix)
}
