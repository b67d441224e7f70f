//! From the optimum on a grid to the one without: neighbouring knots are joined, all slide by Newton's method, and the
//! duality gap is certified on the continuum.

mod freeing;
mod gap;
mod newton;

pub(in crate::fit) use self::freeing::Freeing;
use self::newton::Newton;
use super::settings::Settings;
use super::solver::Solver;
use crate::error::Result;
use crate::fit::convex::certificate::centred;
use crate::fit::convex::problem::Problem;
use crate::fit::convex::solution::{Solution, Spline};
use crate::fit::convex::spline_space::KnotSpace;
use crate::numerics::Vector;
use crate::numerics::order::sort_numbers;

/// An optimum on chosen knots, and how far from the optimum over all knots it can be.
#[derive(Clone, Debug)]
pub struct Gridless {
    /// The spline.
    pub solution: Solution,
    /// The relative duality gap to the problem in which knots may be anywhere.
    pub gap: f64,
    /// How often the knots slid.
    pub slides: usize,
}

/// Joins runs of neighbouring grid knots with like jumps into one knot at their centre; `step` is the grid's.
pub fn merge(knots: &[f64], jumps: &[Vector], step: f64) -> Vec<f64> {
    let mut merged = Vec::new();
    let mut i = 0;
    while i < knots.len() {
        let (mut sum, mut moment, mut total) = (Vector::zeros(), 0.0, 0.0);
        let first = i;
        while i < knots.len() && knots[i] - knots[first] <= 2.0 * step * (1.0 + 1e-9) {
            let size = jumps[i].norm();
            // Within 60 degrees of what came before.
            if i > first && jumps[i].dot(&sum) < 0.5 * size * sum.norm() {
                break;
            }
            if i > first && knots[i] - knots[i - 1] > step * (1.0 + 1e-9) {
                break;
            }
            sum += jumps[i];
            moment += size * knots[i];
            total += size;
            i += 1;
        }
        merged.push(if total > 0.0 { moment / total } else { knots[first] });
    }
    merged
}

/// Improves the solution of a problem with one component by freeing its knots from the grid: until the certified gap
/// is `target`, or after `most` slides. (D 13.8)
///
/// Degree 1 is left as it is, with the gap of the grid: an optimum over all knots has them at the points' parameters.
///
/// # Errors
///
/// Those of [`Solver::new`]; none for a problem that was solved.
pub fn gridless(problem: &Problem, solution: &Solution, target: f64, most: usize) -> Result<Gridless> {
    let joined = Freeing::joining(solution).run(problem)?;
    Freeing::sliding(joined, target, most).run(problem)
}

/// The curve with one coordinate of each, by knot insertion.
fn together(x: &Solution, y: &Solution) -> Result<Solution> {
    let (first, second) = (&x.components[0], &y.components[0]);
    let mut knots = first.knots.clone();
    knots.extend_from_slice(&second.knots);
    sort_numbers(&mut knots);
    knots.dedup();
    let (start, end, closed) = x.domain;
    let finer = KnotSpace::new(first.degree, &knots, start, end, closed)?;
    let mut coefficients = [Vec::new(), Vec::new()];
    for ((solution, spline), result) in [(x, first), (y, second)].into_iter().zip(&mut coefficients) {
        solution.space(spline)?.refine_into(&spline.coefficients, &finer, result);
    }
    let jump = |spline: &Spline, knot: &f64, axis: usize| {
        let at = spline.knots.partition_point(|own| own < knot);
        if spline.knots.get(at) == Some(knot) { spline.jumps[at][axis] } else { 0.0 }
    };
    let both = Spline {
        jumps: knots.iter().map(|t| Vector::new(jump(first, t, 0), jump(second, t, 1))).collect(),
        coefficients: (coefficients[0].iter().zip(&coefficients[1]))
            .map(|(x, y)| Vector::new(x.x, y.y))
            .collect(),
        knots,
        ..first.clone()
    };
    Ok(Solution {
        components: vec![both],
        objective: x.objective + y.objective,
        data_term: x.data_term + y.data_term,
        regularizers: vec![x.regularizers[0] + y.regularizers[0]],
        ..x.clone()
    })
}

/// The optimum with knots at some places only; `None` where there are too few for a problem, or where a step has
/// carried one onto another or out of the domain.
#[inline(never)]
fn on_knots(problem: &Problem, knots: &[f64]) -> Result<Option<Solution>> {
    let mut small = problem.clone();
    let degree = small.components[0].degree;
    let inside = |t: f64| t < problem.end && (t > problem.start || problem.closed && t >= problem.start);
    if !knots.iter().all(|&t| inside(t)) || !knots.windows(2).all(|pair| pair[0] < pair[1]) {
        return Ok(None);
    }
    if knots.is_empty() || (problem.closed && knots.len() < degree + 2) {
        return Ok(None);
    }
    small.components[0].grid = knots.to_vec();
    Ok(Some(solved(&small)?))
}

#[inline(never)]
fn solved(problem: &Problem) -> Result<Solution> {
    let mut solver = Solver::new(problem, Settings { gap: 1e-12, most_iterations: 200 })?;
    solver.run()?;
    solver.solution()
}

/// 2we: the dual vector that the residuals are.
#[inline(never)]
fn residual_forces(problem: &Problem, solution: &Solution) -> Result<Vec<Vector>> {
    let places = solution.evaluate(&problem.parameters, 0)?;
    let weight = |m: usize| problem.weights.get(m).copied().unwrap_or(1.0);
    let force = |(m, (p, r)): (usize, (&Vector, Vector))| (p - r) * (2.0 * weight(m));
    Ok(problem.points.iter().zip(places).enumerate().map(force).collect())
}

/// Knots added where the dual curve is longer than one, away from those that are there, from its values at some places.
fn with_violators(
    problem: &Problem,
    solution: &Solution,
    places: &[f64],
    values: Vec<Vector>,
) -> Result<Option<Solution>> {
    let (values, longest) = centred(problem, values);
    let (count, step) = (places.len(), step_of(problem, places.len()));
    let mut knots = solution.components[0].knots.clone();
    let before = knots.len();
    for (i, place) in places.iter().enumerate().take(count - 1).skip(1) {
        let length = values[i].norm();
        let top = length >= values[i - 1].norm() && length > values[i + 1].norm();
        if top && length > 1.0 + 0.3 * (longest - 1.0) && longest > 1.0 + 1e-6 {
            let k = knots.partition_point(|knot| knot < place);
            let near = |k: usize| knots.get(k).is_some_and(|knot| (knot - place).abs() < step);
            if !(near(k) || k > 0 && near(k - 1)) {
                knots.insert(k, *place);
            }
        }
    }
    if knots.len() == before { Ok(None) } else { on_knots(problem, &knots) }
}

/// One of so many steps through the domain.
fn step_of(problem: &Problem, count: usize) -> f64 {
    (problem.end - problem.start) / count as f64
}

/// The optimum on the knots where a damped step of Newton's carries them; `None` where the objective does not fall.
fn slide(problem: &Problem, solution: &Solution, newton: &Newton, damping: f64) -> Result<Option<Solution>> {
    let steps = newton.steps(damping);
    let mut moved: Vec<f64> = solution.components[0].knots.iter().zip(&steps).map(|(t, by)| t + by).collect();
    let period = problem.end - problem.start;
    for t in &mut moved {
        if problem.closed && *t < problem.start {
            *t += period;
        } else if problem.closed && *t >= problem.end {
            *t -= period;
        }
    }
    sort_numbers(&mut moved);
    Ok(on_knots(problem, &moved)?.filter(|slid| slid.objective < solution.objective))
}
