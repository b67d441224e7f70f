//! How far a spline is from the optimum when knots may be anywhere.

use super::{residual_forces, step_of};
use crate::error::Result;
use crate::fit::convex::certificate::{Integral, Sweep, centre, dual_size};
use crate::fit::convex::problem::{Norm, Problem};
use crate::fit::convex::scaled::Scaled;
use crate::fit::convex::solution::Solution;
use crate::fit::interior::iterate::ROUNDING;
use crate::numerics::Vector;
use crate::numerics::order::sort_numbers;

/// Places per step of the parameter at which the dual curve is looked at, before it is looked at closely.
const PLACES: usize = 8;
/// Of more points than this the dual curve is looked at as of so many.
const MOST_POINTS: usize = 60_000;

/// Steps from one place to the next, far apart.
fn steps(problem: &Problem) -> usize {
    problem.points.len().min(MOST_POINTS) * PLACES
}

/// The relative duality gap when knots may be anywhere, found in rounds: the dual curve's longest vector is bounded
/// between the places at which it is known by their second difference. (D 13.8)
#[derive(Clone, Debug)]
pub(super) struct Measuring {
    /// The dual vector; empty before it is found.
    v: Vec<Vector>,
    /// Components of which the longest vector is known.
    known: usize,
    longest: f64,
    look: Option<Look>,
}

/// A look at the dual curve of a component, far apart first and then closely.
#[derive(Clone, Debug)]
struct Look {
    places: Vec<f64>,
    sweep: Sweep,
    /// Both looks are at one curve: a closed one has a constant to give, which is chosen once.
    constant: Option<Vector>,
    coarse: Option<Coarse>,
}

/// What the look from far apart has told.
#[derive(Clone, Copy, Debug)]
struct Coarse {
    highest: f64,
    /// By how much the curve may be longer between close places.
    between: f64,
}

impl Measuring {
    pub(super) fn new() -> Self {
        Self { v: Vec::new(), known: 0, longest: 1.0, look: None }
    }

    /// One round, past so many samples at most; the gap, once it is known.
    pub(super) fn round(
        &mut self,
        problem: &Problem,
        solution: &Solution,
        samples: usize,
    ) -> Result<Option<f64>> {
        if self.v.is_empty() {
            self.v = residual_forces(problem, solution)?;
            return Ok(None);
        }
        let Some(component) = problem.components.get(self.known) else {
            return self.gap(problem, solution).map(Some);
        };
        let mut look = match self.look.take() {
            Some(look) => look,
            None => Look::new(problem)?,
        };
        let (degree, lambda) = (component.degree, component.lambda);
        let integral = Integral { problem, degree, lambda, v: &self.v };
        let swept = look.constant.is_some() && look.coarse.is_none();
        if !swept && !look.sweep.round(&integral, &look.places, samples) {
            self.look = Some(look);
            return Ok(None);
        }
        match (look.constant, look.coarse) {
            (None, _) => {
                look.constant = Some(centre(&look.sweep.values, problem));
                self.look = Some(look);
            }
            (Some(constant), None) => self.look = Some(look.closer(problem, constant)?),
            (Some(constant), Some(coarse)) => {
                let length = |v: &Vector| dual_size(v - constant, problem.norm);
                let longest = look.sweep.values.iter().map(length).fold(coarse.highest, f64::max);
                self.longest = self.longest.max(longest + coarse.between);
                self.known += 1;
            }
        }
        Ok(None)
    }

    fn gap(&self, problem: &Problem, solution: &Solution) -> Result<f64> {
        let data = solution.data_term;
        let along = 2.0 * data + solution.regularizers.iter().sum::<f64>();
        let scale =
            if data > 0.0 { (0.5 * along / data).min(1.0 / self.longest) } else { 1.0 / self.longest };
        let bound = scale * along - scale * scale * data;
        // Of what is rounding no share could be saved, as the solver has it.
        let some = solution.objective > ROUNDING * Scaled::new(problem)?.objective_factor();
        Ok(if some { (solution.objective - bound) / solution.objective } else { 0.0 })
    }
}

impl Look {
    fn new(problem: &Problem) -> Result<Self> {
        let count = steps(problem);
        let step = step_of(problem, count);
        let place = |i: usize| problem.start + step * i as f64;
        let last = if problem.closed { count } else { count + 1 };
        let places: Vec<f64> = (0..last).map(place).collect();
        Ok(Self { sweep: Sweep::new(problem, last)?, places, constant: None, coarse: None })
    }

    /// The same closely, where the bound from far apart says too much.
    fn closer(self, problem: &Problem, constant: Vector) -> Result<Self> {
        let (places, mut values) = (self.places, self.sweep.values);
        let step = step_of(problem, steps(problem));
        values.iter_mut().for_each(|v| *v -= constant);
        let length = |v: &Vector| dual_size(*v, problem.norm);
        let highest = values.iter().map(length).fold(0.0, f64::max);
        let coarse = bounds(&values, problem.closed, problem.norm);
        // Sixteen places stand for each.
        let mut close = Vec::new();
        for i in (0..coarse.len()).filter(|&i| coarse[i] > highest) {
            close.extend((0..16).map(|k| places[i] + step * (k as f64 - 8.0) / 16.0));
        }
        close.retain(|t| (problem.start..problem.end).contains(t));
        sort_numbers(&mut close);
        close.dedup();
        let over = |(bound, v): (&f64, &Vector)| bound - length(v);
        let between = coarse.iter().zip(&values).map(over).fold(0.0, f64::max) / 256.0;
        let sweep = Sweep::new(problem, close.len())?;
        let coarse = Some(Coarse { highest, between });
        Ok(Self { places: close, sweep, constant: Some(constant), coarse })
    }
}

/// Around every place, half a step to both sides, how long the curve can be.
fn bounds(values: &[Vector], closed: bool, norm: Norm) -> Vec<f64> {
    let count = values.len();
    (0..count)
        .map(|i| {
            let (before, after) = match (closed, i) {
                (true, _) => (values[(i + count - 1) % count], values[(i + 1) % count]),
                (false, 0) => (Vector::zeros(), values[1.min(count - 1)]),
                (false, _) => (values[i - 1], values.get(i + 1).copied().unwrap_or_else(Vector::zeros)),
            };
            // Twice what a parabola would need.
            dual_size(values[i], norm) + dual_size(before - 2.0 * values[i] + after, norm) * 0.25
        })
        .collect()
}
