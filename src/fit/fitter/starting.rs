//! Begins a run: of the solver, for λ, or of the search for few knots.

use super::asking::Purpose;
use super::{Fitter, Run};
use crate::error::Result;
use crate::fit::convex::problem::{Component, Problem, interpolating_grid, uniform_grid};
use crate::fit::corners::corners;
use crate::fit::interior::settings::{GLIMPSE, Settings};
use crate::fit::interior::solver::Solver;
use crate::fit::knots::free_knots::Located;
use crate::fit::knots::sparsest::{Aim, Plan, Sparsest};
use crate::limits::LARGEST_LAMBDA;

/// So many iterations the solver has, where nobody says how many.
const MOST_ITERATIONS: usize = 400;
/// More points than this are not fitted a second time with knots that all count twice.
const MOST_TWICE: usize = 2000;
/// More points than this have a curve through them only on a grid that is asked for.
const MOST_THROUGH: usize = 50_000;

impl Fitter {
    pub(super) fn solve(&mut self) -> Result<()> {
        let factor = |degree: usize| libm::pow(self.unit, -(degree as f64)) / self.samples.scale;
        let degrees = &self.options.degrees;
        let lambdas: Vec<f64> =
            degrees.iter().zip(&self.lambdas).map(|(&d, l)| (l * factor(d)).min(LARGEST_LAMBDA)).collect();
        let count = self.located.points.len();
        let through = self.is_free() && self.coarse().is_none() && count <= MOST_THROUGH;
        let same = through == self.through && !through;
        self.through = through;
        if let Some(solver) = self.warm.take()
            && same
        {
            return self.solve_on(solver, &lambdas);
        }
        let problem = self.stated(&lambdas);
        let most_iterations = self.options.most_iterations.unwrap_or(MOST_ITERATIONS);
        let settings = Settings { gap: self.options.gap, most_iterations };
        self.run = Run::Convex(Box::new(Solver::new(&problem, settings)?));
        self.problem = Some(problem);
        Ok(())
    }

    /// Other λ for the last run's problem.
    fn solve_on(&mut self, mut solver: Box<Solver>, lambdas: &[f64]) -> Result<()> {
        // What is to be seen at once begins where the last curve ended; what is to stay is the same whatever came
        // before.
        if self.options.gap >= GLIMPSE {
            solver.set_lambdas(lambdas)?;
        } else {
            *solver = solver.anew(lambdas)?;
        }
        if let Some(problem) = &mut self.problem {
            problem.components.iter_mut().zip(lambdas).for_each(|(c, &lambda)| c.lambda = lambda);
        }
        self.run = Run::Convex(solver);
        Ok(())
    }

    fn stated(&self, lambdas: &[f64]) -> Problem {
        let components = self
            .options
            .degrees
            .iter()
            .zip(lambdas)
            .map(|(&degree, &lambda)| Component { degree, lambda, grid: self.grid(degree) })
            .collect();
        Problem {
            points: self.located.points.clone(),
            parameters: self.located.parameters.clone(),
            weights: self.located.weights.clone(),
            start: 0.0,
            end: self.end,
            closed: self.samples.closed,
            components,
            norm: self.options.norm,
        }
    }

    /// So many places for knots as were asked for. On a grid that is finer than the points nothing says where knots are
    /// to be that cost nothing.
    fn coarse(&self) -> Option<usize> {
        self.options.grid_size.filter(|size| !(self.is_free() && *size > self.located.points.len()))
    }

    /// The places for knots of a degree: even ones, or those that let the curve through the points.
    fn grid(&self, degree: usize) -> Vec<f64> {
        let closed = self.samples.closed;
        if self.through {
            let places = interpolating_grid(degree, &self.located.parameters, 0.0, self.end, closed);
            // Too few different parameters leave an even grid.
            if places.len() >= degree + 2 {
                return places;
            }
        }
        let count = self.located.points.len();
        let chosen = if degree == 1 { count.min(5000) } else { count.min(2000) };
        let size = self.coarse().unwrap_or(chosen).max(degree + 2);
        uniform_grid(degree, size, 0.0, self.end, closed)
    }

    #[inline(never)]
    pub(super) fn search(&mut self, aim: Aim, cornered: bool, sweeps: bool) -> Result<()> {
        let degree = self.options.degrees.last().copied().unwrap_or(3);
        let sharpest = match aim {
            Aim::Squares(_) => 1,
            _ if cornered => degree,
            _ => (degree - 1).max(1),
        };
        let least_turn = if cornered { self.options.least_turn } else { 0.0 };
        let plan = |smoothest: usize| Plan {
            degree,
            sharpest,
            smoothest,
            closed: self.samples.closed,
            least_turn,
            end: self.end,
            spaced: self.even,
            free: false,
            timed: !self.options.parameters.is_empty(),
            // What lies on sides that were filled up says where these are.
            sweeps: sweeps && self.own.is_empty() && least_turn <= 0.0,
        };
        if self.own.is_empty() && self.located_for == Some(Purpose::Clicks) {
            let smooth = Plan { sharpest: degree - 1, ..plan(1) };
            let corners = corners(&self.samples);
            let search =
                Sparsest::between_corners(self.located.copied()?, smooth, aim, self.level, &corners)?;
            self.run = Run::Search(vec![search]);
            return Ok(());
        }
        if self.own.is_empty()
            && let Some(search) = Sparsest::of_one_piece(self.located.copied()?, plan(1), aim, self.level)?
        {
            self.run = Run::Search(vec![search]);
            return Ok(());
        }
        let start = |located: &Located, smoothest| -> Result<Sparsest> {
            Ok(Sparsest::new(located.copied()?, plan(smoothest), aim, self.level))
        };
        // Knots that all count twice often get by with fewer of them.
        let mut others = Vec::new();
        if matches!(aim, Aim::Tolerance(_)) && sharpest > 1 && self.located.points.len() <= MOST_TWICE {
            others.push(start(&self.located, 2)?);
        }
        // Points are free to slide while smooth knots are thinned out; where they are even they are placed along the
        // curve then.
        let free = degree > 1 && matches!(aim, Aim::Noise(_));
        let smooth = Plan { free, ..plan(1) };
        let mut rivals = vec![Sparsest::new(self.located.copied()?, smooth, aim, self.level)];
        if cornered {
            let corners = Sparsest::from_corners(self.located.copied()?, plan(1), aim, self.level)?;
            let few = self.located.points.len() <= MOST_TWICE || aim.is_fine();
            let apart = matches!(aim, Aim::Tolerance(_)) && few;
            if apart { others.extend(corners) } else { rivals.extend(corners) }
        }
        // Of a rough line hardly any corner turns by as much as is asked for: without any it has fewer knots than where
        // those that turn too little are made smooth.
        if matches!(aim, Aim::Tolerance(_)) && least_turn > 0.0 && degree > 1 && self.own.is_empty() {
            for smoothest in 1..degree.min(3) {
                let smooth = Plan { sharpest: degree - 1, least_turn: 0.0, sweeps, ..plan(smoothest) };
                others.push(Sparsest::new(self.located.copied()?, smooth, aim, self.level));
            }
        }
        self.run = Run::Choice(rivals, others);
        Ok(())
    }
}
