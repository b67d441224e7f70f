//! The best curve of a run so far, and what is known of it.

use super::super::options::Ask;
use super::super::outcome::{Changed, Fit, FitStatus, Part};
use super::super::report;
use super::{Fitter, Run};
use crate::error::{Error, Result};
use crate::fit::convex::solution::Status;
use crate::fit::convex::solution::{self, Solution};
use crate::fit::interior::settings::GLIMPSE;
use crate::fit::interior::solver::Solver;
use crate::fit::knots::combine::{Summand, combined};
use crate::fit::knots::sparsest::Sparsest;
use crate::fit::knots::spline::Spline;
use crate::numerics::Point;
use crate::numerics::order::sort_by_number;

/// How a run of the solver ended, in the words of fits.
pub(super) fn ended(status: Status) -> FitStatus {
    match status {
        Status::Running => FitStatus::Running,
        Status::Converged => FitStatus::Converged,
        Status::IterationLimit => FitStatus::MostIterations,
        Status::Stalled => FitStatus::Stalled,
    }
}

/// The search with the fewest pieces among those that reached what was asked for.
#[inline(never)]
pub(super) fn best_of(searches: &[Sparsest]) -> &Sparsest {
    let far = |search: &Sparsest| (search.merit().0, search.merit().2);
    let mut best = &searches[0];
    for search in &searches[1..] {
        let kept = [search, best].map(|search| search.status() == FitStatus::Converged);
        let better = match kept {
            [true, true] => search.merit() < best.merit(),
            // Of curves that are all too far away the nearest is the best.
            [false, false] => search.is_done() && far(search) < far(best),
            [kept, _] => kept,
        };
        if better {
            best = search;
        }
    }
    best
}

impl Fitter {
    pub(super) fn described(&self) -> Result<Fit> {
        match &self.run {
            Run::Idle => Err(Error::degenerate("points", None, "nothing was asked for yet")),
            Run::Choice(rivals, _) => self.searched(&rivals[0]),
            Run::Search(searches) => self.searched(best_of(searches)),
            Run::Convex(solver) => self.solved(solver, &solver.solution()?),
            Run::Finish(finishing) => self.finished(finishing),
        }
    }

    fn searched(&self, search: &Sparsest) -> Result<Fit> {
        let over = matches!(&self.run, Run::Search(searches) if searches.iter().all(Sparsest::is_done));
        let status = match (over, self.is_spent()) {
            (true, _) => search.status(),
            (false, true) => FitStatus::MostIterations,
            (false, false) => FitStatus::Running,
        };
        let before = search.knots_at_first();
        let polished;
        let found = match search.found() {
            Some(found) => found,
            None => {
                polished = search.clone().finish();
                &polished
            }
        };
        let frame = self.frame();
        // A mean square is one at given parameters, and these reach from end to end.
        let free = !matches!(self.ask, Ask::MeanSquare(_));
        let trimmed = if free { found.spline.trimmed(&found.located)? } else { None };
        let (spline, located) =
            trimmed.as_ref().map_or((&found.spline, &found.located), |(spline, located)| (spline, located));
        let mut fit = report::fit(&frame, spline, located, None)?;
        fit.knots = report::knots(&frame, spline);
        fit.parts = vec![Part {
            degree: spline.space.breaks.degree,
            curve: fit.curve.clone(),
            coefficients: report::coefficients(&frame, spline),
        }];
        let kept = !matches!(self.ask, Ask::Tolerance(tolerance) if fit.max_error > tolerance);
        fit.status = if status == FitStatus::Converged && !kept { FitStatus::Stalled } else { status };
        fit.iterations = self.rounds;
        let after = fit.knots.len();
        fit.changes =
            vec![Changed { step: "search", knots: (before, after), qfe: (fit.qfe, fit.qfe), gap: None }];
        Ok(fit)
    }

    /// The summands of a solution.
    pub(super) fn summands(&self, solution: &Solution) -> Vec<Spline> {
        let one = |(component, &degree): (&solution::Spline, &usize)| {
            let (knots, coefficients) = (component.knots.clone(), component.coefficients.clone());
            Summand { degree, knots, coefficients }.spline(self.samples.closed, self.end)
        };
        solution.components.iter().zip(&self.options.degrees).map(one).collect()
    }

    pub(super) fn solved(&self, solver: &Solver, solution: &Solution) -> Result<Fit> {
        let frame = self.frame();
        let closed = self.samples.closed;
        let splines = self.summands(solution);
        let Some(whole) = combined(&splines) else {
            return Err(Error::degenerate("degrees", None, "there are none"));
        };
        let mut fit = report::fit(&frame, &whole, &self.located, Some(solution.data_term))?;
        let square = self.samples.scale * self.samples.scale;
        fit.objective = solution.objective * square;
        fit.data_term = solution.data_term * square;
        fit.regularizer = solution.regularizers.iter().sum::<f64>() * square;
        fit.qfe = fit.data_term / report::weight(&self.located);
        fit.gap = solution.gap;
        fit.lambda.clone_from(&self.lambdas);
        fit.smoothing = match self.ask {
            Ask::Smoothing(smoothing) => Some(smoothing),
            _ => self.smoothing_of(),
        };
        fit.iterations = solver.iterations();
        fit.status = ended(solution.status);
        let shift = if closed { whole.space.breaks.at.first().copied().unwrap_or(0.0) } else { 0.0 };
        for (component, spline) in solution.components.iter().zip(&splines) {
            if !component.knots.is_empty() {
                fit.knots.extend(report::simple_knots(&frame, spline, &whole, shift));
            }
            // The last one carries the place.
            let last = fit.parts.len() + 1 == splines.len();
            let center = if last { self.samples.center } else { Point::zeros() };
            let part = if splines.len() > 1 {
                report::part(&frame, spline, center)?
            } else {
                let coefficients = report::coefficients(&frame, spline);
                Part { degree: spline.space.breaks.degree, curve: fit.curve.clone(), coefficients }
            };
            fit.parts.push(part);
        }
        sort_by_number(&mut fit.knots, &|knot| knot.t);
        Ok(fit)
    }

    pub(super) fn frame(&self) -> report::Frame<'_> {
        let solved = matches!(self.run, Run::Convex(_) | Run::Finish(_));
        report::Frame {
            samples: &self.samples,
            unit: self.unit,
            noise: self.level,
            robust: self.options.robust,
            own: &self.own,
            hurried: solved && self.options.gap >= GLIMPSE,
        }
    }
}
