//! From the convex optimum to fewer knots: what is joined, moved, weighed anew and dropped.

use super::super::outcome::{Changed, Fit};
use super::super::report;
use super::Fitter;
use super::description::ended;
use crate::error::Result;
use crate::fit::convex::solution::{Solution, Status};
use crate::fit::interior::gridless::{Freeing, Gridless};
use crate::fit::interior::solver::Solver;
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::combine::combined;
use crate::fit::knots::free_knots::{FreeKnots, Located};
use crate::fit::knots::sparsest::Sparsest;
use crate::fit::knots::spline::Spline;

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
    stage: Stage,
    pub(super) search: Option<Sparsest>,
    /// The curve after debiasing or pruning.
    spline: Option<Spline>,
}

/// What is done next; each takes a round at least.
#[derive(Clone, Debug)]
enum Stage {
    Exchange,
    Join(Freeing),
    /// With knots and mean square before.
    Slide(Freeing, (usize, f64)),
    Debias,
    /// Knots go that the sum of squares allows.
    Prune(Breaks, f64),
    /// To be off its points by no larger sum of squares.
    Search(f64),
    Done,
}

impl Finishing {
    pub(super) fn new(solver: Box<Solver>) -> Result<Self> {
        let convex = solver.solution()?;
        let (solution, stage) = (convex.clone(), Stage::Exchange);
        Ok(Self { solver, convex, solution, changes: Vec::new(), stage, search: None, spline: None })
    }

    /// One round of pruning; answers what is next.
    fn prune(&mut self, data: &Located, target: f64) -> Stage {
        let Some(search) = &mut self.search else { return Stage::Done };
        if !search.is_done() {
            search.step();
        }
        if !search.is_done() {
            return Stage::Search(target);
        }
        let found = search.clone().finish();
        if found.is_wild(data) {
            self.search = None;
        } else {
            self.spline = Some(found.spline);
        }
        Stage::Done
    }

    /// Goes on with what was found beyond the grid, if that is something else: it is certified there then, and stands
    /// as that gap says.
    fn leave_grid(&mut self, found: Gridless, asked: f64) {
        if found.slides == 0 && found.solution.knot_count() == self.solution.knot_count() {
            return;
        }
        let status = match self.convex.status {
            _ if found.gap <= asked => Status::Converged,
            Status::Converged => Status::Stalled,
            early => early,
        };
        self.solution = Solution { gap: found.gap, status, ..found.solution };
    }
}

impl Fitter {
    /// One round of what comes after the convex problem; answers whether there is nothing more to do.
    pub(super) fn finish(&self, finishing: &mut Finishing) -> Result<bool> {
        let finish = self.options.finish;
        let gridless = self.problem.as_ref().filter(|_| finish.merge || finish.slide);
        finishing.stage = match (core::mem::replace(&mut finishing.stage, Stage::Done), gridless) {
            (Stage::Exchange, gridless) => {
                if finish.extreme {
                    let found = finishing.solver.extreme()?;
                    self.note(finishing, "extreme", self.size_of(&finishing.solution), &found, None);
                    finishing.solution = found;
                }
                gridless.map_or(Stage::Debias, |_| Stage::Join(Freeing::joining(&finishing.solution)))
            }
            (Stage::Join(mut joining), Some(problem)) => {
                if joining.round(problem)? {
                    self.joined(finishing, joining.found())
                } else {
                    Stage::Join(joining)
                }
            }
            (Stage::Slide(mut sliding, before), Some(problem)) => {
                if sliding.round(problem)? {
                    let found = sliding.found();
                    self.note(finishing, "slide", before, &found.solution, Some(found.gap));
                    finishing.leave_grid(found, self.options.gap);
                    Stage::Debias
                } else {
                    Stage::Slide(sliding, before)
                }
            }
            (Stage::Debias, _) => self.debias(finishing),
            (Stage::Prune(breaks, target), _) => {
                finishing.search =
                    Some(Sparsest::pruning(self.located.copied()?, breaks, target, self.level));
                Stage::Search(target)
            }
            (Stage::Search(target), _) => finishing.prune(&self.located, target),
            _ => Stage::Done,
        };
        Ok(matches!(finishing.stage, Stage::Done))
    }

    /// One square of the solver in the mean square of the caller.
    fn mean_square(&self) -> f64 {
        self.samples.scale * self.samples.scale / report::weight(&self.located)
    }

    /// Knots and mean square of a solution.
    fn size_of(&self, solution: &Solution) -> (usize, f64) {
        (solution.knot_count(), solution.data_term * self.mean_square())
    }

    fn note(
        &self,
        finishing: &mut Finishing,
        step: &'static str,
        before: (usize, f64),
        after: &Solution,
        gap: Option<f64>,
    ) {
        let after = self.size_of(after);
        finishing.changes.push(Changed { step, knots: (before.0, after.0), qfe: (before.1, after.1), gap });
    }

    /// What follows once neighbours are joined.
    fn joined(&self, finishing: &mut Finishing, found: Gridless) -> Stage {
        let finish = self.options.finish;
        let mut before = self.size_of(&finishing.solution);
        if finish.merge {
            self.note(finishing, "merge", before, &found.solution, Some(found.gap));
            before = self.size_of(&found.solution);
        }
        if finish.slide {
            return Stage::Slide(Freeing::sliding(found, self.options.gap, MOST_SLIDES), before);
        }
        finishing.leave_grid(found, self.options.gap);
        Stage::Debias
    }

    fn debias(&self, finishing: &mut Finishing) -> Stage {
        let finish = self.options.finish;
        if !(finish.debias || finish.prune) {
            return Stage::Done;
        }
        let Some(mut whole) = combined(&self.summands(&finishing.solution)) else { return Stage::Done };
        let breaks = &mut whole.space.breaks;
        breaks.sharpest = if self.options.degrees.len() == 1 { 1 } else { breaks.degree };
        let fitted = FreeKnots::new(breaks.clone(), &self.located);
        let target = finishing.solution.data_term.max(fitted.squares());
        let spline = Spline::of(&fitted);
        // The price is what holds a curve where its knots are nearly as many as the points.
        if spline.wild_piece(&self.located, fitted.squares()).is_none() {
            let (count, before) = self.size_of(&finishing.solution);
            finishing.changes.push(Changed {
                step: "debias",
                knots: (count, breaks.len()),
                qfe: (before, fitted.squares() * self.mean_square()),
                gap: None,
            });
            finishing.spline = Some(spline);
        }
        if finish.prune {
            return Stage::Prune(breaks.clone(), target);
        }
        Stage::Done
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
