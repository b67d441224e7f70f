//! From an iterate, in which every jump in play is a little off zero, to the curve on its true knots.
//!
//! A knot is one where the jump is larger, by its scale, than the dual vector is short of one: at the optimum exactly
//! one of the two is zero. On those knots alone the objective is smooth, and Newton's method ends at its least value.
//! (D 12.7)

use super::active_set::{ActiveSet, Knots};
use super::cone::{dot, norm};
use super::dual::dual_curve;
use super::fixed_knots::{Fixed, Newton, newton, tolerance_of_jumps, turned};
use super::iterate::measure;
use super::reduced::{Part, Reduced};
use super::run::Run;
use crate::error::Result;
use crate::numerics::Vector;

/// The most changes of the set of knots.
const MOST_ROUNDS: usize = 14;
/// The same then, and where the optimum of another λ is followed.
const MOST_FOLLOWING: usize = 5;
/// One in so many knots may turn out to be none.
const MOST_TURNED: usize = 5;
/// So few may all be none, as they are beyond the price at which no knot is left.
const FEW: usize = 24;

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
        self.improved(ActiveSet(sets), MOST_ROUNDS, on_the_way)
    }

    /// The optimum of the last run, followed to the λ that are in force now; `None` where it does not come within the
    /// asked gap of the new one.
    pub(crate) fn followed(&self) -> Result<Option<(Fixed, Vec<Vec<Vector>>)>> {
        let Some(last) = &self.finished else { return Ok(None) };
        let mut jumps = last.jumps.iter();
        let of_part = |part: &Part| part.chosen.iter().copied().zip(jumps.by_ref().copied()).collect();
        let sets: Vec<Knots> = last.reduced.parts.iter().map(of_part).collect();
        let found = self.improved(ActiveSet(sets), MOST_FOLLOWING, false)?;
        Ok(found.filter(|(fixed, _)| fixed.measure.gap <= self.settings.gap))
    }

    /// The least objective on these knots with about these jumps, and on those that the dual curve then asks for; over
    /// as soon as the asked gap is reached.
    pub(super) fn improved(
        &self,
        mut active: ActiveSet,
        most: usize,
        on_the_way: bool,
    ) -> Result<Option<(Fixed, Vec<Vec<Vector>>)>> {
        let tolerance = tolerance_of_jumps(self.settings.gap);
        let mut best: Option<(Fixed, Vec<Vec<Vector>>)> = None;
        let mut known = self.iterate.reduced.elements.clone();
        for _ in 0..most {
            active.leave_lonely(self.data.closed);
            let start = active.jumps();
            let reduced = Reduced::new(&self.data, active.places(), &known)?;
            known.clone_from(&reduced.elements);
            let Some(newton) = newton(&self.data, reduced, &start, tolerance) else { break };
            let turned = turned(&newton.jumps, &start);
            // Where many of the knots that were singled out on a fine grid are none, others are missing as well.
            let many = start.len() > FEW && MOST_TURNED * turned > start.len();
            let hasty = on_the_way || self.data.components.len() == 1;
            if hasty && self.is_fine() && best.is_none() && many {
                break;
            }
            if turned > 0 {
                active.leave_turned(&start, &newton.jumps);
                continue;
            }
            let settled = newton.settled;
            let (fixed, eta) = self.assessed(newton);
            let any = active.join(&fixed.jumps, &eta, self.data.closed, 0.0);
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
    pub(crate) fn active(&self, i: usize, from: usize) -> Knots {
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
