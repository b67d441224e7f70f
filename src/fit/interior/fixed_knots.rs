//! The curve on fixed knots: Newton's method for an objective that is smooth there. (D 12.7)

use super::cone::{Metric, dot, norm, stretch};
use super::iterate::Measure;
use super::reduced::Reduced;
use crate::fit::convex::scaled::Scaled;
use crate::numerics::Vector;

/// From this tolerance of jumps on rounding does not matter.
const ROUGH: f64 = 1e-5;
/// The most steps of Newton's method on one set.
const MOST_NEWTON: usize = 5;

/// A curve on chosen knots.
#[derive(Clone, Debug)]
pub(crate) struct Fixed {
    pub(crate) reduced: Reduced,
    pub(crate) unknowns: Vec<Vector>,
    pub(crate) jumps: Vec<Vector>,
    pub(crate) measure: Measure,
}

/// Where Newton's method ended on fixed knots, with the dual vectors at them: exactly stationary.
pub(super) struct Newton {
    pub(super) reduced: Reduced,
    pub(super) unknowns: Vec<Vector>,
    pub(super) jumps: Vec<Vector>,
    pub(super) pulls: Vec<Vector>,
    /// Whether a further step would change nothing.
    pub(super) settled: bool,
}

/// The tolerance of jumps for a gap: directions that are off by δ cost about δ² of the objective.
pub(super) fn tolerance_of_jumps(gap: f64) -> f64 {
    (0.03 * gap.sqrt()).max(1e-13)
}

/// How many jumps have turned round or vanished.
pub(super) fn turned(after: &[Vector], before: &[Vector]) -> usize {
    after.iter().zip(before).filter(|(a, b)| dot(**a, **b).is_nan() || dot(**a, **b) <= 0.0).count()
}

/// Newton's method for the objective on fixed knots, from directions and lengths of their jumps, until a step changes
/// none by more than a share `tolerance` of itself.
#[inline(never)]
pub(super) fn newton(
    data: &Scaled,
    mut reduced: Reduced,
    start: &[Vector],
    tolerance: f64,
) -> Option<Newton> {
    let lambdas = reduced.lambdas(data);
    let mut jumps = start.to_vec();
    let (mut unknowns, mut line, mut forces, mut metrics) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let mut next = Vec::new();
    let (mut change, mut settled) = (f64::INFINITY, false);
    for _ in 0..MOST_NEWTON {
        forces.clear();
        metrics.clear();
        for (jump, lambda) in jumps.iter().zip(&lambdas) {
            let (force, metric) = bent(*jump, *lambda);
            forces.push(force);
            metrics.push(metric);
        }
        let _ = reduced.factor(&metrics);
        unknowns.clone_from(&reduced.linear);
        reduced.pull(&forces, &mut unknowns);
        reduced.solve(&mut unknowns, &mut line);
        reduced.jumps(&unknowns, &mut next);
        if next.iter().any(|v| !(v.x.is_finite() && v.y.is_finite())) {
            return None;
        }
        let before = change;
        change = next.iter().zip(&jumps).fold(0.0_f64, |most, (a, b)| most.max(norm(a - b) / norm(*a)));
        settled = change < tolerance || (change < 1e-9 && change >= before) || turned(&next, start) > 0;
        if settled {
            break;
        }
        jumps.clone_from(&next);
    }
    // Stiff systems leave residuals; what they leave is solved for again.
    let mut weighted = vec![Vector::zeros(); data.t.len()];
    let (mut rest, mut pull, mut forces_of_elements) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..if tolerance > ROUGH { 0 } else { 1 } {
        let _ = reduced.residuals(data, &unknowns, &mut weighted, &mut forces_of_elements);
        reduced.gradient(&forces_of_elements, &mut rest);
        pull.clear();
        pull.extend((0..next.len()).map(|k| stretch(&metrics[k], next[k]) - forces[k]));
        reduced.pull(&pull, &mut rest);
        reduced.solve(&mut rest, &mut line);
        for (unknown, by) in unknowns.iter_mut().zip(&rest) {
            *unknown -= by;
        }
        reduced.jumps(&unknowns, &mut next);
    }
    // −λu = −λU − metric·w: the dual vectors that balance the residuals exactly.
    let pulls = (0..next.len()).map(|k| (stretch(&metrics[k], next[k]) - forces[k]) / lambdas[k]).collect();
    Some(Newton { reduced, unknowns, jumps: next, pulls, settled })
}

/// −λU and λ(1 − UU′)/ρ for a jump ρU: gradient and curvature of λ|w|.
fn bent(jump: Vector, lambda: f64) -> (Vector, Metric) {
    let length = norm(jump);
    let (unit, stiffness) = (jump / length, lambda / length);
    let metric = [stiffness * unit.y * unit.y, -stiffness * unit.x * unit.y, stiffness * unit.x * unit.x];
    (unit * -lambda, metric)
}
