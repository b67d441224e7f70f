//! From an iterate, in which every jump in play is a little off zero, to the curve on its true knots.
//!
//! A knot is one where the jump is larger, by its scale, than the dual vector is short of one: at the optimum exactly
//! one of the two is zero. On those knots alone the objective is smooth, and Newton's method ends at its least value.
//! (D 12.7)

use super::cone::{Metric, dot, norm, stretch};
use super::dual::dual_curve;
use super::iterate::{Measure, dual_length, jump_length, lanes, measure, seen};
use super::play::{maxima, median};
use super::reduced::{Part, Reduced};
use super::solver::Solver;
use crate::error::Result;
use crate::fit::convex::scaled::Scaled;
use crate::fit::convex::solution::{Solution, Spline};
use crate::numerics::Vector;

/// A stiffness against coordinates of a jump that have to stay zero, in units of λ over the largest jump.
const STIFF: f64 = 1e9;

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

impl Solver {
    /// The curve that the run has come to, on its true knots; the run can go on afterwards. Its gap is its own, and at
    /// most that of the run.
    ///
    /// # Errors
    ///
    /// `OutOfMemory` only.
    pub fn solution(&self) -> Result<Solution> {
        if let Some(fixed) = &self.finished {
            return Ok(self.in_units_of_the_caller(fixed));
        }
        Ok(self.in_units_of_the_caller(&self.best()?))
    }

    /// The same in units of the solver.
    pub(crate) fn best(&self) -> Result<Fixed> {
        if let Some(fixed) = &self.finished {
            return Ok(fixed.clone());
        }
        let tried = if self.tried || self.is_hurried() { None } else { self.polished(false)? };
        Ok(match tried {
            Some((fixed, _)) if fixed.measure.gap <= self.measure.gap => fixed,
            _ => Fixed {
                reduced: self.iterate.reduced.clone(),
                unknowns: self.iterate.unknowns.clone(),
                jumps: self.iterate.jumps.clone(),
                measure: self.measure,
            },
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
        let lanes = lanes(self.data.norm);
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
            let Some(newton) = newton(&self.data, reduced, &start, lanes, accuracy) else { break };
            let turned = if lanes == 1 { turned(&newton.jumps, &start) } else { 0 };
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
            let (fixed, eta) = self.assessed(newton, lanes);
            let mut jumps = fixed.jumps.iter();
            let mut any = false;
            for (set, eta) in sets.iter_mut().zip(&eta) {
                for (_, jump) in set.iter_mut() {
                    *jump = *jumps.next().unwrap_or(jump);
                }
                let typical = median(set.iter().map(|(_, jump)| norm(*jump)).collect());
                for k in maxima(eta, self.data.closed, lanes, 1.0 + 1e-11) {
                    if let Err(at) = set.binary_search_by_key(&k, |(place, _)| *place) {
                        set.insert(at, (k, wanted(eta[k], lanes) * (1e-2 * typical)));
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
    pub(super) fn assessed(&self, newton: Newton, lanes: usize) -> (Fixed, Vec<Vec<Vector>>) {
        let mut weighted = vec![Vector::zeros(); self.data.t.len()];
        let data_term =
            newton.reduced.residuals(&self.data, &newton.unknowns, &mut weighted, &mut Vec::new());
        let (mut regularizer, mut work, mut longest, mut knot) = (0.0, 0.0, 0.0_f64, 0);
        let mut curves = Vec::new();
        for (part, component) in newton.reduced.parts.iter().zip(&self.data.components) {
            let range = knot..knot + part.chosen.len();
            for (jump, pull) in newton.jumps[range.clone()].iter().zip(&newton.pulls[range.clone()]) {
                regularizer += component.lambda * jump_length(*jump, lanes);
                work += component.lambda * dot(*jump, *pull);
            }
            knot = range.end;
            let mut eta = Vec::new();
            dual_curve(&self.data, component, &part.chosen, &weighted, &newton.pulls[range], &mut eta);
            longest = eta.iter().fold(longest, |most, v| most.max(dual_length(*v, lanes)));
            curves.push(eta);
        }
        let measure = measure(data_term, regularizer, work, longest);
        let Newton { reduced, unknowns, jumps, .. } = newton;
        (Fixed { reduced, unknowns, jumps, measure }, curves)
    }

    pub(crate) fn in_units_of_the_caller(&self, fixed: &Fixed) -> Solution {
        let data = &self.data;
        let (factor, lanes) = (data.objective_factor(), lanes(data.norm));
        let mut knot = 0;
        let mut regularizers = Vec::new();
        let last = fixed.reduced.parts.len() - 1;
        let components = fixed.reduced.parts.iter().enumerate().map(|(i, part)| {
            let component = &data.components[i];
            let mut jump_factor = data.size;
            for _ in 0..component.degree {
                jump_factor /= data.step;
            }
            let jumps: Vec<Vector> =
                fixed.jumps[knot..knot + part.chosen.len()].iter().map(|v| v * jump_factor).collect();
            knot += part.chosen.len();
            let lambda =
                if self.free { 0.0 } else { component.lambda / data.lambda_factor(component.degree) };
            regularizers.push(lambda * jumps.iter().map(|v| jump_length(*v, lanes)).sum::<f64>());
            // The centre of the points belongs to the last component, which has the constants.
            let centre = if i == last { data.centre } else { Vector::zeros() };
            Spline {
                degree: component.degree,
                lambda,
                knots: part.chosen.iter().map(|&k| component.grid[k] * data.step + data.start).collect(),
                jumps,
                coefficients: part.order.iter().map(|&k| fixed.unknowns[k] * data.size + centre).collect(),
            }
        });
        let components = components.collect();
        Solution {
            components,
            domain: (data.start, data.start + data.length * data.step, data.closed),
            objective: fixed.measure.primal * factor,
            data_term: fixed.measure.data_term * factor,
            regularizers,
            gap: fixed.measure.gap.max(0.0),
            status: self.status,
            iterations: self.iteration,
        }
    }
}

impl Solver {
    /// The knots of part i, the first of them number `from`, whose jump stays while its dual vector comes to the
    /// boundary, with these jumps. After a short step sizes decide instead of tendencies.
    pub(crate) fn active(&self, i: usize, from: usize) -> Vec<(usize, Vector)> {
        let lanes = lanes(self.data.norm);
        let part = &self.iterate.reduced.parts[i];
        let lambda = self.data.components[i].lambda;
        let jumps = &self.iterate.jumps[from..from + part.chosen.len()];
        let largest = jumps.iter().fold(0.0_f64, |most, v| most.max(norm(*v)));
        let mut found = Vec::new();
        for (k, jump) in jumps.iter().enumerate() {
            let mut kept = Vector::zeros();
            for lane in 0..lanes {
                let at = (from + k) * lanes + lane;
                let (size, slack) = self.iterate.cones[at].sizes();
                let stays = if self.before.len() == self.iterate.cones.len() {
                    size * self.before[at].1 > slack * self.before[at].0
                } else {
                    size * lambda > slack * largest
                };
                if stays && size > 0.0 {
                    kept += seen(*jump, lane, lanes);
                }
            }
            if norm(kept) > 0.0 {
                found.push((part.chosen[k], kept));
            }
        }
        found
    }
}

/// How accurate jumps have to be for a gap: an error of δ in their directions costs about δ² of the objective.
pub(super) fn accuracy(gap: f64) -> f64 {
    (0.03 * gap.sqrt()).max(1e-13)
}

/// The jump that a dual vector longer than one asks for.
pub(super) fn wanted(eta: Vector, lanes: usize) -> Vector {
    if lanes == 1 {
        return eta;
    }
    let beyond = |v: f64| if v.abs() > 1.0 { v } else { 0.0 };
    Vector::new(beyond(eta.x), beyond(eta.y))
}

/// How many jumps have turned round or vanished.
fn turned(after: &[Vector], before: &[Vector]) -> usize {
    after.iter().zip(before).filter(|(a, b)| dot(**a, **b).is_nan() || dot(**a, **b) <= 0.0).count()
}

/// Newton's method for the objective on fixed knots, from directions and lengths of their jumps.
#[inline(never)]
pub(super) fn newton(
    data: &Scaled,
    mut reduced: Reduced,
    start: &[Vector],
    lanes: usize,
    accuracy: f64,
) -> Option<Newton> {
    let lambdas = reduced.lambdas(data);
    let largest = start.iter().fold(f64::MIN_POSITIVE, |most, v| most.max(norm(*v)));
    let mut jumps = start.to_vec();
    let (mut unknowns, mut line, mut forces, mut metrics) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let mut next = Vec::new();
    let (mut change, mut settled) = (f64::INFINITY, false);
    for _ in 0..MOST_NEWTON {
        forces.clear();
        metrics.clear();
        for (jump, lambda) in jumps.iter().zip(&lambdas) {
            let (force, metric) =
                if lanes == 1 { bent(*jump, *lambda) } else { boxed(*jump, *lambda, largest) };
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
        let stop = if lanes == 2 {
            release(&mut jumps, &next, &lambdas, largest)
        } else {
            let before = change;
            change = next.iter().zip(&jumps).fold(0.0_f64, |most, (a, b)| most.max(norm(a - b) / norm(*a)));
            change < accuracy || (change < 1e-9 && change >= before) || turned(&next, start) > 0
        };
        settled = stop;
        if stop {
            break;
        }
        if lanes == 1 {
            jumps.clone_from(&next);
        }
    }
    // Stiff systems leave residuals; what they leave is solved for again.
    let mut weighted = vec![Vector::zeros(); data.t.len()];
    let (mut rest, mut pull, mut forces_of_elements) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..if accuracy > ROUGH { 0 } else { lanes } {
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
    if lanes == 2 {
        for (jump, own) in next.iter_mut().zip(&jumps) {
            // What had to stay zero is zero.
            *jump =
                Vector::new(if own.x == 0.0 { 0.0 } else { jump.x }, if own.y == 0.0 { 0.0 } else { jump.y });
        }
    }
    Some(Newton { reduced, unknowns, jumps: next, pulls, settled })
}

/// Holds coordinates that turned round and frees those held by more than λ; answers whether there were none.
fn release(jumps: &mut [Vector], next: &[Vector], lambdas: &[f64], largest: f64) -> bool {
    let mut settled = true;
    for ((jump, next), lambda) in jumps.iter_mut().zip(next).zip(lambdas) {
        for axis in 0..2 {
            let changed = if jump[axis] == 0.0 {
                if (STIFF * lambda / largest * next[axis]).abs() > lambda * (1.0 + 1e-4) {
                    next[axis]
                } else {
                    0.0
                }
            } else if jump[axis] * next[axis] <= 0.0 {
                0.0
            } else {
                jump[axis]
            };
            settled &= changed == jump[axis];
            jump[axis] = changed;
        }
    }
    settled
}

/// −λU and λ(1 − UU′)/ρ for a jump ρU: gradient and curvature of λ|w|.
fn bent(jump: Vector, lambda: f64) -> (Vector, Metric) {
    let length = norm(jump);
    let (unit, stiffness) = (jump / length, lambda / length);
    let metric = [stiffness * unit.y * unit.y, -stiffness * unit.x * unit.y, stiffness * unit.x * unit.x];
    (unit * -lambda, metric)
}

/// The same for λ(|x| + |y|), with coordinates that are zero held there.
fn boxed(jump: Vector, lambda: f64, largest: f64) -> (Vector, Metric) {
    let sign = |v: f64| if v == 0.0 { 0.0 } else { v.signum() };
    let hold = |v: f64| if v == 0.0 { STIFF * lambda / largest } else { 0.0 };
    (Vector::new(sign(jump.x), sign(jump.y)) * -lambda, [hold(jump.x), 0.0, hold(jump.y)])
}
