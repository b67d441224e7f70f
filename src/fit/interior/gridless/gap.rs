//! How far a spline is from the optimum when knots may be anywhere.

use super::residual_forces;
use crate::error::Result;
use crate::fit::convex::certificate::{centre, dual_size, uncentred};
use crate::fit::convex::problem::{Norm, Problem};
use crate::fit::convex::scaled::Scaled;
use crate::fit::convex::solution::Solution;
use crate::fit::interior::iterate::ROUNDING;
use crate::numerics::Vector;
use crate::numerics::order::sort_numbers;

/// Places per step of the parameter at which the dual curve is looked at, before it is looked at closely.
const PLACES: usize = 8;

/// The relative duality gap when knots may be anywhere: the dual curve's longest vector is bounded between the places
/// at which it is known by their second difference. (D 13.8)
pub(super) fn gap(problem: &Problem, solution: &Solution) -> Result<f64> {
    let v = residual_forces(problem, solution)?;
    let mut longest = 1.0_f64;
    for component in &problem.components {
        longest = longest.max(longest_between(problem, component.degree, component.lambda, &v));
    }
    let data = solution.data_term;
    let along = 2.0 * data + solution.regularizers.iter().sum::<f64>();
    let scale = if data > 0.0 { (0.5 * along / data).min(1.0 / longest) } else { 1.0 / longest };
    let bound = scale * along - scale * scale * data;
    // Of what is rounding no share could be saved, as the solver has it.
    let some = solution.objective > ROUNDING * Scaled::new(problem)?.objective_factor();
    Ok(if some { (solution.objective - bound) / solution.objective } else { 0.0 })
}

/// A bound of the dual curve's length on the whole domain.
fn longest_between(problem: &Problem, degree: usize, lambda: f64, v: &[Vector]) -> f64 {
    let count = problem.points.len().min(60_000) * PLACES;
    let step = (problem.end - problem.start) / count as f64;
    let place = |i: usize| problem.start + step * i as f64;
    let places: Vec<f64> = (0..=count).map(place).collect();
    let places = if problem.closed { &places[..count] } else { &places[..] };
    // Both looks are at one curve: a closed one has a constant to give, which is chosen once.
    let mut values = uncentred(problem, degree, lambda, v, places);
    let constant = centre(&values, problem);
    values.iter_mut().for_each(|v| *v -= constant);
    let length = |v: &Vector| dual_size(*v, problem.norm);
    let highest = values.iter().map(length).fold(0.0, f64::max);
    let coarse = bounds(&values, problem.closed, problem.norm);
    // Where the coarse bound says too much, sixteen places stand for each.
    let mut close = Vec::new();
    for i in (0..coarse.len()).filter(|&i| coarse[i] > highest) {
        close.extend((0..16).map(|k| places[i] + step * (k as f64 - 8.0) / 16.0));
    }
    close.retain(|t| (problem.start..problem.end).contains(t));
    sort_numbers(&mut close);
    close.dedup();
    let fine = uncentred(problem, degree, lambda, v, &close);
    let sharpest = coarse.iter().zip(&values).fold(0.0_f64, |most, (b, v)| most.max(b - length(v))) / 256.0;
    fine.iter().map(|v| length(&(v - constant))).fold(highest, f64::max) + sharpest
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
