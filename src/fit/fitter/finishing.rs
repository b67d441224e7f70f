//! From the convex optimum to fewer knots: what is joined, moved, weighed anew and dropped.

use super::super::outcome::{Changed, Fit};
use super::super::report;
use super::Fitter;
use super::description::ended;
use crate::error::Result;
use crate::fit::convex::solution::{Solution, Status};
use crate::fit::interior::gridless::{merged, slid};
use crate::fit::interior::solver::Solver;
use crate::fit::knots::combine::combined;
use crate::fit::knots::foot_points::Spline;
use crate::fit::knots::free_knots::FreeKnots;
use crate::fit::knots::sparsest::Sparsest;

/// Slides of the knots off the grid, where the gap that is asked for is not reached before: four times as many reach it
/// in one more case of ten.
const MOST_SLIDES: usize = 6;

/// What comes after the convex problem.
#[derive(Clone, Debug)]
pub(super) struct Finishing {
    pub(super) solver: Box<Solver>,
    /// The optimum on the grid.
    convex: Solution,
    /// The same, or what sliding has made of it.
    solution: Solution,
    changes: Vec<Changed>,
    pub(super) search: Option<Sparsest>,
    /// The curve after debiasing or pruning.
    spline: Option<Spline>,
}

impl Finishing {
    /// One round of pruning; answers whether there is nothing more to do.
    pub(super) fn round(&mut self) -> bool {
        let Some(search) = &mut self.search else { return true };
        if !search.is_done() {
            search.step();
        }
        if search.is_done() {
            self.spline = Some(search.clone().finish().spline);
        }
        search.is_done()
    }
}

impl Fitter {
    /// Exchanges, merging and sliding at once; debiasing and pruning get ready.
    pub(super) fn finishing(&self, solver: Box<Solver>) -> Result<Finishing> {
        let finish = self.options.finish;
        let convex = solver.solution()?;
        let mut solution = convex.clone();
        let mut changes = Vec::new();
        let total = report::weight(&self.located);
        let unit = self.samples.scale * self.samples.scale / total;
        let changed = |step, before: &Solution, after: &Solution, gap| Changed {
            step,
            knots: (before.knot_count(), after.knot_count()),
            qfe: (before.data_term * unit, after.data_term * unit),
            gap,
        };
        if finish.extreme {
            let found = solver.extreme()?;
            changes.push(changed("extreme", &solution, &found, None));
            solution = found;
        }
        if let Some(problem) = self.problem.as_ref().filter(|_| finish.merge || finish.slide) {
            let before = solution.knot_count();
            let mut found = merged(problem, &solution)?;
            if finish.merge {
                changes.push(changed("merge", &solution, &found.solution, Some(found.gap)));
            }
            if finish.slide {
                let joined = if finish.merge { found.solution.clone() } else { solution.clone() };
                found = slid(problem, found, self.options.gap, MOST_SLIDES)?;
                changes.push(changed("slide", &joined, &found.solution, Some(found.gap)));
            }
            if found.slides > 0 || found.solution.knot_count() != before {
                // It is certified beyond the grid then, and stands as that gap says.
                let status = match convex.status {
                    _ if found.gap <= self.options.gap => Status::Converged,
                    Status::Converged => Status::Stalled,
                    early => early,
                };
                solution = Solution { gap: found.gap, status, ..found.solution };
            }
        }
        let mut finishing = Finishing { solver, convex, solution, changes, search: None, spline: None };
        if !(finish.debias || finish.prune) {
            return Ok(finishing);
        }
        let Some(mut whole) = combined(&self.summands(&finishing.solution)) else { return Ok(finishing) };
        let breaks = &mut whole.space.breaks;
        breaks.sharpest = if self.options.degrees.len() == 1 { 1 } else { breaks.degree };
        let count = finishing.solution.knot_count();
        let fitted = FreeKnots::new(breaks.clone(), &self.located);
        let before = finishing.solution.data_term;
        finishing.changes.push(Changed {
            step: "debias",
            knots: (count, breaks.len()),
            qfe: (before * unit, fitted.squares() * unit),
            gap: None,
        });
        if finish.prune {
            let target = before.max(fitted.squares());
            finishing.search =
                Some(Sparsest::pruning(self.located.clone(), breaks.clone(), target, self.noise));
        }
        finishing.spline = Some(Spline::of(&fitted));
        Ok(finishing)
    }

    pub(super) fn finished(&self, finishing: &Finishing) -> Result<Fit> {
        let mut fit = self.solved(&finishing.solver, &finishing.solution)?;
        fit.changes.clone_from(&finishing.changes);
        let (Some(spline), frame) = (&finishing.spline, self.frame()) else { return Ok(fit) };
        let mut after = report::fit(&frame, spline, &self.located, None)?;
        after.knots = report::knots(&frame, spline);
        after.parts = vec![report::part(&frame, spline, self.samples.center)?];
        // What was certified is the optimum of the convex problem, before the rest was made of it.
        let (convex, square) = (&finishing.convex, self.samples.scale * self.samples.scale);
        after.objective = convex.objective * square;
        after.data_term = convex.data_term * square;
        after.regularizer = convex.regularizers.iter().sum::<f64>() * square;
        after.gap = convex.gap;
        (after.lambda, after.smoothing) = (fit.lambda, fit.smoothing);
        after.status = ended(convex.status);
        (after.iterations, after.changes) = (fit.iterations, fit.changes);
        if finishing.search.is_some() {
            let (from, last) = (after.changes.last().map_or(0, |change| change.knots.1), after.knots.len());
            let before = after.changes.last().map_or(after.qfe, |change| change.qfe.1);
            let (knots, qfe) = ((from, last), (before, after.qfe));
            after.changes.push(Changed { step: "prune", knots, qfe, gap: None });
        }
        Ok(after)
    }
}
