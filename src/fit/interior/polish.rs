//! From an iterate, in which every jump in play is a little off zero, to the curve on its true knots.
//!
//! A knot is one where the jump is larger, by its scale, than the dual vector is short of one: at the optimum exactly
//! one of the two is zero. On those knots alone the objective is smooth, and Newton's method ends at its least value.
//! (D 12.7)

use super::cone::{Metric, dot, norm, stretch};
use super::dual::dual_curve;
use super::iterate::{Measure, measure};
use super::play::{maxima, median};
use super::reduced::{Part, Reduced};
use super::run::Run;
use crate::error::Result;
use crate::fit::convex::scaled::Scaled;
use crate::numerics::Vector;

/// The most changes of the set of knots.
const MOST_ROUNDS: usize = 14;
/// Who asks for a gap like this wants to see the curve at once.
pub(crate) const GLIMPSE: f64 = 1e-3;
/// The same then, and where the optimum of another λ is followed.
const MOST_FOLLOWING: usize = 5;
/// Where jumps are not wanted more accurately than this, rounding does not matter.
const ROUGH: f64 = 1e-5;
/// One in so many knots may turn out to be none.
const MOST_TURNED: usize = 5;
/// So few may all be none, as they are beyond the price at which no knot is left.
const FEW: usize = 24;
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
    unknowns: Vec<Vector>,
    pub(super) jumps: Vec<Vector>,
    pulls: Vec<Vector>,
    /// Whether a further step would change nothing.
    pub(super) settled: bool,
}

impl Run {
    /// The curve that the run has come to, on its true knots; the run can go on afterwards. Its gap is its own, and at
    /// most that of the run.
    pub(crate) fn best(&self) -> Result<Fixed> {
        if let Some(fixed) = &self.finished {
            return Ok(fixed.clone());
        }
        let tried = if self.tried || self.is_hurried() { None } else { self.polished(false)? };
        if let Some((mut fixed, _)) = tried {
            fixed.measure.gap += self.lacking(&fixed)?;
            if fixed.measure.gap <= self.measure.gap {
                return Ok(fixed);
            }
        }
        Ok(Fixed {
            reduced: self.iterate.reduced.clone(),
            unknowns: self.iterate.unknowns.clone(),
            jumps: self.iterate.jumps.clone(),
            measure: self.measure,
        })
    }

    /// The least objective on the knots that the iterate singles out, and on those that the dual curve then asks for.
    /// `on_the_way` there is a next time: what looks bad is given up at once.
    pub(crate) fn polished(&self, on_the_way: bool) -> Result<Option<(Fixed, Vec<Vec<Vector>>)>> {
        let mut sets = Vec::new();
        let mut knot = 0;
        for (i, part) in self.iterate.reduced.parts.iter().enumerate() {
            sets.push(self.active(i, knot));
            knot += part.chosen.len();
        }
        self.improved(sets, MOST_ROUNDS, on_the_way)
    }

    /// The optimum of the last run, followed to the λ that are in force now; `None` where it does not come within the
    /// asked gap of the new one.
    pub(crate) fn followed(&self) -> Result<Option<(Fixed, Vec<Vec<Vector>>)>> {
        let Some(last) = &self.finished else { return Ok(None) };
        let mut jumps = last.jumps.iter();
        let of_part = |part: &Part| part.chosen.iter().copied().zip(jumps.by_ref().copied()).collect();
        let sets: Vec<Vec<(usize, Vector)>> = last.reduced.parts.iter().map(of_part).collect();
        let found = self.improved(sets, MOST_FOLLOWING, false)?;
        Ok(found.filter(|(fixed, _)| fixed.measure.gap <= self.settings.gap))
    }

    /// The least objective on these knots with about these jumps, and on those that the dual curve then asks for; over
    /// as soon as the asked gap is reached.
    pub(super) fn improved(
        &self,
        mut sets: Vec<Vec<(usize, Vector)>>,
        most: usize,
        on_the_way: bool,
    ) -> Result<Option<(Fixed, Vec<Vec<Vector>>)>> {
        let accuracy = accuracy(self.settings.gap);
        let mut best: Option<(Fixed, Vec<Vec<Vector>>)> = None;
        let mut known = self.iterate.reduced.elements.clone();
        for _ in 0..most {
            for set in &mut sets {
                // The jumps of a closed curve sum to zero: one alone is none.
                if self.data.closed && set.len() == 1 {
                    set.clear();
                }
            }
            let chosen = sets.iter().map(|set| set.iter().map(|(place, _)| *place).collect()).collect();
            let start: Vec<Vector> = sets.iter().flatten().map(|(_, jump)| *jump).collect();
            let reduced = Reduced::new(&self.data, chosen, &known)?;
            known.clone_from(&reduced.elements);
            let Some(newton) = newton(&self.data, reduced, &start, accuracy) else { break };
            let turned = turned(&newton.jumps, &start);
            // Where many of the knots that were singled out on a fine grid are none, others are missing as well.
            let many = start.len() > FEW && MOST_TURNED * turned > start.len();
            let hasty = on_the_way || self.data.components.len() == 1;
            if hasty && self.is_fine() && best.is_none() && many {
                break;
            }
            if turned > 0 {
                let mut pairs = newton.jumps.iter().zip(&start);
                for set in &mut sets {
                    set.retain(|_| pairs.next().is_some_and(|(a, b)| dot(*a, *b) > 0.0));
                }
                continue;
            }
            let settled = newton.settled;
            let (fixed, eta) = self.assessed(newton);
            let mut jumps = fixed.jumps.iter();
            let mut any = false;
            for (set, eta) in sets.iter_mut().zip(&eta) {
                for (_, jump) in set.iter_mut() {
                    *jump = *jumps.next().unwrap_or(jump);
                }
                let typical = median(set.iter().map(|(_, jump)| norm(*jump)).collect());
                for k in maxima(eta, self.data.closed, 1.0 + 1e-11) {
                    if let Err(at) = set.binary_search_by_key(&k, |(place, _)| *place) {
                        set.insert(at, (k, eta[k] * (1e-2 * typical)));
                        any = true;
                    }
                }
            }
            let better = best.as_ref().is_none_or(|(best, _)| fixed.measure.gap < best.measure.gap);
            let worse = best.as_ref().is_some_and(|(best, _)| fixed.measure.gap > 10.0 * best.measure.gap);
            if better {
                best = Some((fixed, eta));
            }
            let enough = best.as_ref().is_some_and(|(best, _)| best.measure.gap <= self.settings.gap);
            if enough || worse || (settled && !any) {
                break;
            }
        }
        Ok(best)
    }

    /// Objective and bound of a curve on fixed knots, with its dual curves.
    #[inline(never)]
    pub(super) fn assessed(&self, newton: Newton) -> (Fixed, Vec<Vec<Vector>>) {
        let mut weighted = vec![Vector::zeros(); self.data.t.len()];
        let data_term =
            newton.reduced.residuals(&self.data, &newton.unknowns, &mut weighted, &mut Vec::new());
        let (mut regularizer, mut work, mut longest, mut knot) = (0.0, 0.0, 0.0_f64, 0);
        let mut curves = Vec::new();
        for (part, component) in newton.reduced.parts.iter().zip(&self.data.components) {
            let range = knot..knot + part.chosen.len();
            for (jump, pull) in newton.jumps[range.clone()].iter().zip(&newton.pulls[range.clone()]) {
                regularizer += component.lambda * norm(*jump);
                work += component.lambda * dot(*jump, *pull);
            }
            knot = range.end;
            let mut eta = Vec::new();
            dual_curve(&self.data, component, &part.chosen, &weighted, &newton.pulls[range], &mut eta);
            longest = eta.iter().fold(longest, |most, v| most.max(norm(*v)));
            curves.push(eta);
        }
        let measure = measure(data_term, regularizer, work, longest);
        let Newton { reduced, unknowns, jumps, .. } = newton;
        (Fixed { reduced, unknowns, jumps, measure }, curves)
    }

    /// The knots of part i, the first of them number `from`, whose jump stays while its dual vector comes to the
    /// boundary, with these jumps. After a short step sizes decide instead of tendencies.
    pub(crate) fn active(&self, i: usize, from: usize) -> Vec<(usize, Vector)> {
        let part = &self.iterate.reduced.parts[i];
        let lambda = self.data.components[i].lambda;
        let jumps = &self.iterate.jumps[from..from + part.chosen.len()];
        let largest = jumps.iter().fold(0.0_f64, |most, v| most.max(norm(*v)));
        let mut found = Vec::new();
        for (k, jump) in jumps.iter().enumerate() {
            let (size, slack) = self.iterate.cones[from + k].sizes();
            let stays = if self.before.len() == self.iterate.cones.len() {
                size * self.before[from + k].1 > slack * self.before[from + k].0
            } else {
                size * lambda > slack * largest
            };
            if stays && size > 0.0 {
                found.push((part.chosen[k], *jump));
            }
        }
        found
    }
}

/// How accurate jumps have to be for a gap: an error of δ in their directions costs about δ² of the objective.
pub(super) fn accuracy(gap: f64) -> f64 {
    (0.03 * gap.sqrt()).max(1e-13)
}

/// How many jumps have turned round or vanished.
fn turned(after: &[Vector], before: &[Vector]) -> usize {
    after.iter().zip(before).filter(|(a, b)| dot(**a, **b).is_nan() || dot(**a, **b) <= 0.0).count()
}

/// Newton's method for the objective on fixed knots, from directions and lengths of their jumps.
#[inline(never)]
pub(super) fn newton(data: &Scaled, mut reduced: Reduced, start: &[Vector], accuracy: f64) -> Option<Newton> {
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
        settled = change < accuracy || (change < 1e-9 && change >= before) || turned(&next, start) > 0;
        if settled {
            break;
        }
        jumps.clone_from(&next);
    }
    // Stiff systems leave residuals; what they leave is solved for again.
    let mut weighted = vec![Vector::zeros(); data.t.len()];
    let (mut rest, mut pull, mut forces_of_elements) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..if accuracy > ROUGH { 0 } else { 1 } {
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
