//! How far a curve can be from the optimum: a lower bound of the problem, found without the solver.
//!
//! Any vector v over the samples that vanishes on polynomials of the components' degrees is a dual vector once it is
//! scaled so that its dual curves stay within the unit disc. Here v comes from the residuals of the curve. Everything
//! is computed anew: the residuals by de Boor's rule, the dual curves by plain integration in 106 bits. (D 12.4),
//! (D 12.8)

mod integral;
mod refinement;

pub(crate) use self::integral::{Integral, Sweep};
use self::refinement::Refinement;
use super::problem::{Norm, Problem};
use super::solution::{Solution, Spline};
use crate::error::{Error, Result};
use crate::limits;
use crate::numerics::Vector;
use crate::numerics::enclosing_circle::enclosing_circle;
use crate::numerics::order::sort_numbers;
use crate::numerics::twofold::Twofold;

/// What was proved.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Certificate {
    /// The objective of the curve.
    pub objective: f64,
    /// No curve of the problem has less.
    pub bound: f64,
    /// (objective − bound)/objective; 0 where the objective is.
    pub gap: f64,
    /// By how much the residuals had to be scaled: the longest dual vector of each component.
    pub longest: Vec<f64>,
}

/// Bounds the objective of a solution from below, and so its distance from the optimum.
///
/// The bound holds for knots at the places of the grids, up to a relative 1e-13 of rounding. O(M + N), and O(K³) for
/// two components of K knots.
///
/// # Errors
///
/// As for [`Problem::check`]; `WrongLength` when the solution has not the components of the problem, or
/// one of them not the numbers that its knots ask for; `Degenerate` when their degrees or domains differ.
pub fn verify(problem: &Problem, solution: &Solution) -> Result<Certificate> {
    problem.check()?;
    if solution.components.len() != problem.components.len() {
        let (got, needed) = (solution.components.len(), problem.components.len());
        return Err(Error::wrong_length("components", got, needed));
    }
    belongs(solution, problem)?;
    let residuals = residuals(problem, solution)?;
    let weight = |m: usize| problem.weights.get(m).copied().unwrap_or(1.0);
    let mut objective = 0.0;
    let mut v = limits::with_room(residuals.len())?;
    for (m, e) in residuals.iter().enumerate() {
        objective += weight(m) * (e.x * e.x + e.y * e.y);
        v.push(e * (2.0 * weight(m)));
    }
    for (spline, component) in solution.components.iter().zip(&problem.components) {
        let jumps = spline_jumps(spline, solution.domain);
        objective += component.lambda * jumps.iter().map(|j| size(*j, problem.norm)).sum::<f64>();
    }
    let mut best = Certificate { objective, bound: f64::NEG_INFINITY, gap: 0.0, longest: Vec::new() };
    if objective <= 0.0 || problem.components.iter().any(|c| c.lambda <= 0.0) {
        best.bound = 0.0;
        best.gap = if objective <= 0.0 { 0.0 } else { 1.0 };
        return Ok(best);
    }
    let mut refinement = Refinement::new(problem, solution)?;
    for _ in 0..4 {
        project(problem, &mut v);
        let curve = |i: usize| Curve::new(problem, solution, i, &v);
        let curves: Vec<Curve> = (0..problem.components.len()).map(curve).collect::<Result<_>>()?;
        let longest: Vec<f64> = curves.iter().map(|curve| curve.longest).collect();
        let bound = bound(problem, &v, longest.iter().fold(0.0, |most, l| l.max(most)));
        let progress = bound > best.bound;
        if progress {
            (best.bound, best.longest) = (bound, longest);
        }
        let Some(refinement) = &mut refinement else { break };
        let drift = refinement.correct(problem, &curves, &mut v);
        if !progress || drift < 1e-14 {
            break;
        }
    }
    best.gap = (best.objective - best.bound) / best.objective;
    Ok(best)
}

fn size(v: Vector, norm: Norm) -> f64 {
    match norm {
        Norm::L2 => (v.x * v.x + v.y * v.y).sqrt(),
        Norm::L1 => v.x.abs() + v.y.abs(),
    }
}

/// The bound of the scaled dual vector: the best scale of those that keep it feasible.
fn bound(problem: &Problem, v: &[Vector], longest: f64) -> f64 {
    let count = problem.points.len() as f64;
    let centre = problem.points.iter().sum::<Vector>() / count;
    let (mut along, mut square) = (Twofold::ZERO, Twofold::ZERO);
    for (m, (v, p)) in v.iter().zip(&problem.points).enumerate() {
        let p = p - centre;
        along = along.plus(Twofold::product(v.x, p.x)).plus(Twofold::product(v.y, p.y));
        let weight = problem.weights.get(m).copied().unwrap_or(1.0);
        square = square.plus(Twofold::new((v.x * v.x + v.y * v.y) / (4.0 * weight)));
    }
    let (along, square) = (along.value(), square.value());
    if square <= 0.0 || !square.is_finite() {
        return 0.0;
    }
    let scale = (0.5 * along / square).min(1.0 / longest.max(1e-300)).max(0.0);
    (scale * (along - scale * square)).max(0.0)
}

/// w-weighted residuals without the weight: p − r at every parameter.
fn residuals(problem: &Problem, solution: &Solution) -> Result<Vec<Vector>> {
    let mut e = limits::with_room(problem.points.len())?;
    e.extend_from_slice(&problem.points);
    for spline in &solution.components {
        let knots = padded(spline, solution.domain);
        let count = spline.coefficients.len();
        let closed = solution.domain.2;
        let first = knots[spline.degree];
        let period = solution.domain.1 - solution.domain.0;
        let mut interval = 0;
        let last = knots.len() - 2 * spline.degree - 2;
        for (e, &t) in e.iter_mut().zip(&problem.parameters) {
            // Closed, the part before the first knot belongs to the last interval, a period later.
            let before = closed && t < first;
            let t = if before { t + period } else { t };
            interval = if before {
                last
            } else if interval == last && t < knots[last + spline.degree] {
                0
            } else {
                interval
            };
            while interval < last && t >= knots[interval + spline.degree + 1] {
                interval += 1;
            }
            let mut points = [Vector::zeros(); 6];
            for (i, point) in points.iter_mut().enumerate().take(spline.degree + 1) {
                let j = interval + i;
                *point = spline.coefficients[if closed { j % count } else { j.min(count - 1) }];
            }
            for r in 1..=spline.degree {
                for i in (r..=spline.degree).rev() {
                    let (low, high) = (knots[interval + i], knots[interval + i + spline.degree + 1 - r]);
                    let share = (t - low) / (high - low);
                    points[i] = points[i - 1] * (1.0 - share) + points[i] * share;
                }
            }
            *e -= points[spline.degree];
        }
    }
    Ok(e)
}

/// Whether a solution is one that the problem can have.
fn belongs(solution: &Solution, problem: &Problem) -> Result<()> {
    let (start, end, closed) = solution.domain;
    if [start, end] != [problem.start, problem.end] || closed != problem.closed {
        return Err(Error::degenerate("domain", None, "it is not that of the problem"));
    }
    for (i, (spline, component)) in solution.components.iter().zip(&problem.components).enumerate() {
        if spline.degree != component.degree {
            return Err(Error::degenerate("components", Some(i), "its degree is not that of the problem"));
        }
        solution.space(spline)?;
    }
    Ok(())
}

/// The knots of a spline with `degree` (open: clamped, with one more) on either side.
fn padded(spline: &Spline, (start, end, closed): (f64, f64, bool)) -> Vec<f64> {
    let degree = spline.degree as isize;
    if !closed {
        let mut knots = vec![start; spline.degree + 1];
        knots.extend_from_slice(&spline.knots);
        knots.resize(knots.len() + spline.degree + 1, end);
        return knots;
    }
    let lone = [start];
    let own = if spline.knots.is_empty() { &lone[..] } else { &spline.knots };
    let count = own.len() as isize;
    (-degree..=count + degree)
        .map(|i| own[i.rem_euclid(count) as usize] + (end - start) * i.div_euclid(count) as f64)
        .collect()
}

/// The jumps of the highest derivative, by differentiating the coefficients down to constants.
fn spline_jumps(spline: &Spline, domain: (f64, f64, bool)) -> Vec<Vector> {
    let knots = padded(spline, domain);
    let (degree, count) = (spline.degree, spline.coefficients.len());
    let intervals = knots.len() - 2 * degree - 1;
    let mut values: Vec<Vector> =
        (0..intervals + degree).map(|j| spline.coefficients[if domain.2 { j % count } else { j }]).collect();
    for r in 1..=degree {
        for j in (r..values.len()).rev() {
            let width = knots[j + degree - r + 1] - knots[j];
            values[j] = (values[j] - values[j - 1]) * ((degree - r + 1) as f64 / width);
        }
    }
    let constants = &values[degree..];
    if domain.2 {
        (0..spline.knots.len()).map(|k| constants[k] - constants[(k + intervals - 1) % intervals]).collect()
    } else {
        constants.windows(2).map(|pair| pair[1] - pair[0]).collect()
    }
}

/// Makes v vanish on what costs nothing: constants (closed) or polynomials of the highest degree (open).
pub(crate) fn project(problem: &Problem, v: &mut [Vector]) {
    let degree = if problem.closed { 0 } else { problem.components.last().map_or(1, |c| c.degree) };
    let weight = |m: usize| problem.weights.get(m).copied().unwrap_or(1.0);
    let (middle, half) = (0.5 * (problem.start + problem.end), 0.5 * (problem.end - problem.start));
    let size = degree + 1;
    for _ in 0..3 {
        let mut gram = [[Twofold::ZERO; 6]; 6];
        let mut right = [[Twofold::ZERO; 2]; 6];
        for (m, (v, &t)) in v.iter().zip(&problem.parameters).enumerate() {
            let basis = chebyshev((t - middle) / half);
            for i in 0..size {
                for axis in 0..2 {
                    right[i][axis] = right[i][axis].plus(Twofold::product(basis[i], v[axis]));
                }
                for j in 0..=i {
                    gram[i][j] = gram[i][j].plus(Twofold::new(weight(m) * basis[i] * basis[j]));
                }
            }
        }
        solve(&mut gram, &mut right, size);
        for (m, (v, &t)) in v.iter_mut().zip(&problem.parameters).enumerate() {
            let basis = chebyshev((t - middle) / half);
            for axis in 0..2 {
                let sum = (0..size).fold(0.0, |sum, i| sum + right[i][axis].value() * basis[i]);
                v[axis] -= weight(m) * sum;
            }
        }
    }
}

/// Chebyshev's polynomials of degree 0 … 5.
fn chebyshev(x: f64) -> [f64; 6] {
    let mut values = [1.0, x, 0.0, 0.0, 0.0, 0.0];
    for i in 2..6 {
        values[i] = 2.0 * x * values[i - 1] - values[i - 2];
    }
    values
}

/// Solves a small positive definite system in 106 bits, in place.
#[allow(clippy::needless_range_loop, reason = "matrices are written with their indices")]
fn solve(gram: &mut [[Twofold; 6]; 6], right: &mut [[Twofold; 2]; 6], size: usize) {
    for j in 0..size {
        for i in j + 1..size {
            let factor = gram[i][j].over(gram[j][j]).negative();
            for k in i..size {
                gram[k][i] = gram[k][i].plus(factor.times(gram[k][j]));
            }
            for axis in 0..2 {
                right[i][axis] = right[i][axis].plus(factor.times(right[j][axis]));
            }
        }
    }
    for i in (0..size).rev() {
        for axis in 0..2 {
            let mut sum = right[i][axis];
            for k in i + 1..size {
                sum = sum.plus(gram[k][i].times(right[k][axis]).negative());
            }
            right[i][axis] = sum.over(gram[i][i]);
        }
    }
}

/// The dual curve of one component.
struct Curve {
    /// At the knots of the solution.
    at_knots: Vec<Vector>,
    /// The longest vector at the places of the grid and at the knots.
    longest: f64,
}

impl Curve {
    fn new(problem: &Problem, solution: &Solution, index: usize, v: &[Vector]) -> Result<Self> {
        let component = &problem.components[index];
        let knots = &solution.components[index].knots;
        let mut places = component.grid.clone();
        places.extend_from_slice(knots);
        sort_numbers(&mut places);
        places.dedup();
        let (values, longest) = dual_values(problem, component.degree, component.lambda, v, &places)?;
        let at = |knot: &f64| values[places.partition_point(|place| place < knot)];
        Ok(Self { at_knots: knots.iter().map(at).collect(), longest })
    }
}

/// The dual curve of v for that λ at ascending places, and the length of its longest vector there.
pub(crate) fn dual_values(
    problem: &Problem,
    degree: usize,
    lambda: f64,
    v: &[Vector],
    places: &[f64],
) -> Result<(Vec<Vector>, f64)> {
    let integral = Integral { problem, degree, lambda, v };
    let mut sweep = Sweep::new(problem, places.len())?;
    while !sweep.round(&integral, places, usize::MAX) {}
    Ok(centred(problem, sweep.values))
}

/// Values of a dual curve with the best constant taken from them, and the length of the longest.
pub(crate) fn centred(problem: &Problem, mut values: Vec<Vector>) -> (Vec<Vector>, f64) {
    let centre = centre(&values, problem);
    let mut longest = 0.0_f64;
    for value in &mut values {
        *value -= centre;
        longest = longest.max(dual_size(*value, problem.norm));
    }
    (values, longest)
}

/// The length of a dual vector in the norm that jumps of length one ask for.
pub(crate) fn dual_size(v: Vector, norm: Norm) -> f64 {
    match norm {
        Norm::L2 => size(v, Norm::L2),
        Norm::L1 => v.x.abs().max(v.y.abs()),
    }
}

/// The constant to take from a dual curve so that it is shortest: an open one has none to give.
pub(crate) fn centre(values: &[Vector], problem: &Problem) -> Vector {
    if !problem.closed {
        return Vector::zeros();
    }
    match problem.norm {
        Norm::L2 => enclosing_circle(values).centre,
        Norm::L1 => {
            let first = values.first().copied().unwrap_or_else(Vector::zeros);
            let (mut least, mut most) = (first, first);
            for v in values {
                least = Vector::new(least.x.min(v.x), least.y.min(v.y));
                most = Vector::new(most.x.max(v.x), most.y.max(v.y));
            }
            (least + most) * 0.5
        }
    }
}
