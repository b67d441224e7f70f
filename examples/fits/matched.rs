//! The convex optimum whose mean square is what was asked for.

use expline::Result;
use expline::fit::gridless::merge;
use expline::fit::{Ask, Finish, Fit, Norm, Options, Problem, Settings, Solution, Solver, fit};
use expline::numerics::Point;

/// How near the mean square comes to what was asked for, and the most solves until then.
const NEAR: f64 = 1e-4;
const MOST_SOLVES: usize = 40;

/// An optimum, and the λ that it is of.
pub(crate) struct Matched {
    pub(crate) problem: Problem,
    pub(crate) solution: Solution,
    pub(crate) lambdas: Vec<f64>,
}

/// Degrees with λ and places for knots each.
pub(crate) type Splines = [(usize, f64, usize)];

/// The optimum for λ as they are.
pub(crate) fn solved(points: &[Point], splines: &Splines, norm: Norm) -> Result<Matched> {
    let mut problem = Problem::of_points(points, true, splines)?;
    problem.norm = norm;
    let mut solver = Solver::new(&problem, SETTINGS)?;
    solver.run()?;
    let lambdas = splines.iter().map(|spline| spline.1).collect();
    Ok(Matched { solution: solver.solution()?, problem, lambdas })
}

const SETTINGS: Settings = Settings { gap: 1e-7, most_iterations: 200 };

/// The optimum with this mean square; all λ are those given times one factor, which is searched for by its logarithm.
pub(crate) fn at_mean_square(
    points: &[Point],
    splines: &Splines,
    norm: Norm,
    square: f64,
) -> Result<Matched> {
    let mut problem = Problem::of_points(points, true, splines)?;
    problem.norm = norm;
    let mut solver = Solver::new(&problem, SETTINGS)?;
    let (mut low, mut high) = (None, None);
    let mut factor = 1.0_f64;
    let mut solve = 0;
    loop {
        let lambdas: Vec<f64> = splines.iter().map(|spline| spline.1 * factor).collect();
        solver.set_lambdas(&lambdas)?;
        solver.run()?;
        let solution = solver.solution()?;
        let excess = libm::log(solution.quadratic_fitting_error(&problem).max(1e-300) / square);
        if excess.abs() < NEAR || solve == MOST_SOLVES {
            for (component, lambda) in problem.components.iter_mut().zip(&lambdas) {
                component.lambda = *lambda;
            }
            return Ok(Matched { problem, solution, lambdas });
        }
        let here = Some((libm::log(factor), excess));
        if excess > 0.0 {
            high = here
        } else {
            low = here
        }
        factor = match (low, high) {
            // The middle now and then: a straight line alone may creep.
            (Some((a, _)), Some((b, _))) if solve % 3 == 2 => libm::exp(0.5 * (a + b)),
            (Some((a, below)), Some((b, above))) => libm::exp(a - below * (b - a) / (above - below)),
            (None, _) => factor * 0.4,
            (_, None) => factor * 2.5,
        };
        solve += 1;
    }
}

impl Matched {
    pub(crate) fn square(&self) -> f64 {
        self.solution.quadratic_fitting_error(&self.problem)
    }

    /// Knots of the grid, and what is left when neighbours that stand for one knot are joined.
    pub(crate) fn knots(&self) -> (usize, usize) {
        let joined =
            self.solution.components.iter().zip(&self.problem.components).map(|(spline, component)| {
                let step = (self.problem.end - self.problem.start) / component.grid.len() as f64;
                merge(&spline.knots, &spline.jumps, step).len()
            });
        (self.solution.knot_count(), joined.sum())
    }

    /// The mean square distance from other places at the same parameters.
    pub(crate) fn square_to(&self, places: &[Point]) -> Result<f64> {
        let own = self.solution.evaluate(&self.problem.parameters, 0)?;
        let sum: f64 = own.iter().zip(places).map(|(a, b)| (a - b).norm_squared()).sum();
        Ok(sum / places.len() as f64)
    }

    /// Where the knots of each component are.
    pub(crate) fn places(&self) -> Result<Vec<Vec<Point>>> {
        self.solution.components.iter().map(|spline| self.solution.evaluate(&spline.knots, 0)).collect()
    }

    /// Its points fitted again with the same λ; `finish` says what is done afterwards.
    pub(crate) fn fitted(&self, finish: Finish) -> Result<Fit> {
        let options = Options {
            degrees: self.problem.components.iter().map(|component| component.degree).collect(),
            closed: Some(true),
            grid_size: self.problem.components.first().map(|component| component.grid.len()),
            finish,
            ..Options::default()
        };
        fit(&self.problem.points, Ask::Lambda(self.lambdas.clone()), &options)
    }
}
