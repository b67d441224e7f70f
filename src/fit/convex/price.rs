//! What a λ means: the one that leaves no knot, and one scale for all drawings.

use super::certificate::{dual_values, project};
use super::problem::Problem;
use crate::error::Result;
use crate::limits;
use crate::numerics::Vector;
use crate::numerics::enclosing_circle::enclosing_circle;

/// The least λ of each component from which on it has no knot, when the others have none either.
///
/// Closed, it is the radius of the smallest circle around the integrated residuals of the mean point; open, their
/// longest vector, for the residuals of the best polynomial of the highest degree. Exact up to rounding, for knots at
/// the places of the grids. O(M + N). (D 12.9)
///
/// # Errors
///
/// As for [`Problem::check`].
pub fn lambda_max(problem: &Problem) -> Result<Vec<f64>> {
    problem.check()?;
    let count = problem.points.len();
    let centre = problem.points.iter().sum::<Vector>() / count as f64;
    let mut v = limits::with_room(count)?;
    for (m, point) in problem.points.iter().enumerate() {
        v.push((point - centre) * (2.0 * problem.weights.get(m).copied().unwrap_or(1.0)));
    }
    project(problem, &mut v);
    let most = |c: &super::problem::Component| Ok(dual_values(problem, c.degree, 1.0, &v, &c.grid)?.1);
    problem.components.iter().map(most).collect()
}

/// Beyond any degree that there is: what asks for more has no answer, but gets it soon.
const BEYOND: usize = 64;

/// λ for a length of detail ℓ, counted in points: what is shorter than about ℓ points is smoothed away. It means the
/// same for every degree, size and density of points: λ = D w̄ δᵃ (ℓ/2π)^{a+1} with the diameter D of the smallest
/// circle around the points, their mean weight w̄ and distance δ in the parameter. (D 12.2)
pub fn lambda_of_detail(problem: &Problem, degree: usize, detail: f64) -> f64 {
    let mut lambda = unit_lambda(problem, degree);
    for _ in 0..=degree.min(BEYOND) {
        lambda *= detail / core::f64::consts::TAU;
    }
    lambda.clamp(0.0, limits::LARGEST_LAMBDA)
}

/// The length of detail of a λ: the inverse of [`lambda_of_detail`]. 0 for λ = 0 and where all points are one.
pub fn detail_of_lambda(problem: &Problem, degree: usize, lambda: f64) -> f64 {
    let unit = unit_lambda(problem, degree);
    if unit <= 0.0 || lambda <= 0.0 {
        return 0.0;
    }
    core::f64::consts::TAU * libm::exp(libm::log(lambda / unit) / (degree as f64 + 1.0))
}

/// The length of detail of a smoothing between 0 (two points) and 1 (all of them): 2(M/2)ˢ.
pub fn detail_of_smoothing(problem: &Problem, smoothing: f64) -> f64 {
    2.0 * libm::exp(smoothing * libm::log(0.5 * problem.points.len().max(4) as f64))
}

/// The smoothing of a length of detail, not less than 0 and not more than 1: the inverse of [`detail_of_smoothing`].
pub fn smoothing_of_detail(problem: &Problem, detail: f64) -> f64 {
    let all = libm::log(0.5 * problem.points.len().max(4) as f64);
    if detail > 0.0 { (libm::log(0.5 * detail) / all).clamp(0.0, 1.0) } else { 0.0 }
}

/// λ for a length of detail of 2π points.
fn unit_lambda(problem: &Problem, degree: usize) -> f64 {
    let count = problem.points.len();
    if count == 0 {
        return 0.0;
    }
    let steps = if problem.closed { count } else { count.max(2) - 1 };
    let distance = (problem.end - problem.start) / steps as f64;
    let weight =
        if problem.weights.is_empty() { 1.0 } else { problem.weights.iter().sum::<f64>() / count as f64 };
    let mut lambda = weight * 2.0 * enclosing_circle(&problem.points).radius;
    for _ in 0..degree.min(BEYOND) {
        lambda *= distance;
    }
    lambda
}
