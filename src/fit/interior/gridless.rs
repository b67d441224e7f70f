//! From the optimum on a grid to the one without: neighbouring knots are joined, all slide by Newton's method, and the
//! duality gap is certified on the continuum.

use super::iterate::ROUNDING;
use super::solver::{Settings, Solver};
use crate::error::Result;
use crate::fit::convex::certificate::{centre, dual_size, dual_values, uncentred};
use crate::fit::convex::problem::{Norm, Problem};
use crate::fit::convex::scaled::Scaled;
use crate::fit::convex::solution::{Solution, Spline};
use crate::fit::convex::spline_space::KnotSpace;
use crate::fit::knots::breaks::{Breaks, HIGHEST, Polynomial, Space, derivative};
use crate::fit::knots::envelope::Envelope;
use crate::limits;
use crate::numerics::Vector;
use crate::numerics::order::sort_numbers;

/// Places per step of the parameter at which the dual curve is looked at, before it is looked at closely.
const PLACES: usize = 8;
/// More knots than this do not slide: the system is dense.
const MOST_SLIDING: usize = 300;
/// The step of differences of the dual curve.
const STEP: f64 = 0.02;

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
    slid(problem, merged(problem, solution)?, target, most)
}

/// Whether the knots of a solution may leave the grid.
fn may_leave(problem: &Problem, solution: &Solution) -> bool {
    let (degree, count) = (problem.components.first(), solution.components.first());
    problem.components.len() == 1
        && degree.is_some_and(|component| component.degree > 1)
        && count.is_some_and(|spline| spline.knots.len() <= MOST_SLIDING)
}

/// The optimum on the knots of a solution, neighbours of like jumps joined.
pub(in crate::fit) fn merged(problem: &Problem, solution: &Solution) -> Result<Gridless> {
    let whole = Gridless { gap: gap(problem, solution)?, solution: solution.clone(), slides: 0 };
    if !may_leave(problem, solution) {
        return Ok(whole);
    }
    if problem.norm == Norm::L1 {
        return apart(problem, solution, 0, merged);
    }
    let (component, spline) = (&problem.components[0], &solution.components[0]);
    let step = (problem.end - problem.start) / component.grid.len().max(1) as f64;
    let joined = on_knots(problem, &merge(&spline.knots, &spline.jumps, step))?;
    // Joining may cost a little, which sliding then wins back.
    match joined.filter(|joined| joined.objective <= 1.001 * solution.objective) {
        Some(joined) => Ok(Gridless { gap: gap(problem, &joined)?, solution: joined, slides: 0 }),
        None => Ok(whole),
    }
}

/// The same with all knots free to slide.
pub(in crate::fit) fn slid(problem: &Problem, from: Gridless, target: f64, most: usize) -> Result<Gridless> {
    let mut best = from;
    if !may_leave(problem, &best.solution) {
        return Ok(best);
    }
    if problem.norm == Norm::L1 {
        return apart(problem, &best.solution, best.slides, |problem, solution| {
            let alone = Gridless { gap: gap(problem, solution)?, solution: solution.clone(), slides: 0 };
            slid(problem, alone, target, most)
        });
    }
    let mut damping = 1e-9;
    while best.slides < most && best.gap > target {
        best.slides += 1;
        let Some(slid) = slide(problem, &best.solution, &mut damping)? else {
            let Some(more) = with_violators(problem, &best.solution)? else { break };
            best.gap = gap(problem, &more)?;
            best.solution = more;
            continue;
        };
        best.gap = gap(problem, &slid)?;
        best.solution = slid;
    }
    Ok(best)
}

/// Jumps measured by |x| + |y|: each coordinate for itself, on knots of its own, and both together again. (D 12.15)
fn apart(
    problem: &Problem,
    solution: &Solution,
    slides: usize,
    freed: impl Fn(&Problem, &Solution) -> Result<Gridless>,
) -> Result<Gridless> {
    let mut found = limits::with_room(2)?;
    for axis in 0..2 {
        let mut alone = Problem { norm: Norm::L2, ..problem.clone() };
        alone.points.iter_mut().for_each(|point| point[1 - axis] = 0.0);
        let spline = &solution.components[0];
        let jumping = spline.knots.iter().zip(&spline.jumps).filter(|(_, jump)| jump[axis] != 0.0);
        let knots: Vec<f64> = jumping.map(|(knot, _)| *knot).collect();
        let own = match on_knots(&alone, &knots)? {
            Some(own) => own,
            // Too few for a problem of their own: that on the grid.
            None => solved(&alone)?,
        };
        found.push(freed(&alone, &own)?);
    }
    let both = together(&found[0].solution, &found[1].solution)?;
    let slides = slides + found[0].slides.max(found[1].slides);
    Ok(Gridless { gap: gap(problem, &both)?, solution: both, slides })
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

/// The optimum with knots at some places only; `None` where there are too few for a problem, or where a step has carried
/// one onto another or out of the domain.
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

fn solved(problem: &Problem) -> Result<Solution> {
    let mut solver = Solver::new(problem, Settings { gap: 1e-12, most_iterations: 200 })?;
    solver.run()?;
    solver.solution()
}

/// 2we: the dual vector that the residuals are.
fn residual_forces(problem: &Problem, solution: &Solution) -> Result<Vec<Vector>> {
    let places = solution.evaluate(&problem.parameters, 0)?;
    let weight = |m: usize| problem.weights.get(m).copied().unwrap_or(1.0);
    let force = |(m, (p, r)): (usize, (&Vector, Vector))| (p - r) * (2.0 * weight(m));
    Ok(problem.points.iter().zip(places).enumerate().map(force).collect())
}

/// The relative duality gap when knots may be anywhere: the dual curve's longest vector is bounded between the places
/// at which it is known by their second difference. (D 13.8)
fn gap(problem: &Problem, solution: &Solution) -> Result<f64> {
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

/// The dual curve and its first two derivatives at the knots.
fn dual_at(problem: &Problem, v: &[Vector], knots: &[f64]) -> Vec<[Vector; 3]> {
    let component = &problem.components[0];
    let inside = |t: f64| {
        let period = problem.end - problem.start;
        match problem.closed {
            true if t < problem.start => t + period,
            true if t >= problem.end => t - period,
            _ => t.clamp(problem.start, problem.end),
        }
    };
    let mut places: Vec<f64> = knots.iter().flat_map(|&t| [inside(t - STEP), t, inside(t + STEP)]).collect();
    let wanted = places.clone();
    sort_numbers(&mut places);
    places.dedup();
    let (values, _) = dual_values(problem, component.degree, component.lambda, v, &places);
    let at = |t: f64| values[places.partition_point(|&place| place < t).min(values.len() - 1)];
    wanted
        .chunks_exact(3)
        .map(|three| {
            let (before, here, after) = (at(three[0]), at(three[1]), at(three[2]));
            [here, (after - before) / (2.0 * STEP), (after - 2.0 * here + before) / (STEP * STEP)]
        })
        .collect()
}

/// Knots added where the dual curve is longer than one, away from those that are there.
fn with_violators(problem: &Problem, solution: &Solution) -> Result<Option<Solution>> {
    let v = residual_forces(problem, solution)?;
    let component = &problem.components[0];
    let count = problem.points.len() * 2;
    let step = (problem.end - problem.start) / count as f64;
    let places: Vec<f64> = (0..count).map(|i| problem.start + step * (i as f64 + 0.5)).collect();
    let (values, longest) = dual_values(problem, component.degree, component.lambda, &v, &places);
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

/// One Newton step of coefficients and knots together, then the optimum on the knots where they are now; `None` where
/// the objective does not fall.
fn slide(problem: &Problem, solution: &Solution, damping: &mut f64) -> Result<Option<Solution>> {
    let knots = &solution.components[0].knots;
    if knots.is_empty() {
        return Ok(None);
    }
    let newton = Newton::new(problem, solution)?;
    for _ in 0..4 {
        let steps = newton.steps(*damping);
        let mut moved: Vec<f64> = knots.iter().zip(&steps).map(|(t, by)| t + by).collect();
        let period = problem.end - problem.start;
        for t in &mut moved {
            if problem.closed && *t < problem.start {
                *t += period;
            } else if problem.closed && *t >= problem.end {
                *t -= period;
            }
        }
        sort_numbers(&mut moved);
        if let Some(slid) = on_knots(problem, &moved)?
            && slid.objective < solution.objective
        {
            *damping = (*damping * 0.05).max(1e-12);
            return Ok(Some(slid));
        }
        *damping = (*damping * 100.0).max(1e-6);
    }
    Ok(None)
}

/// The quadratic model of the objective in coefficients and knots. (D 13.8)
struct Newton {
    matrix: Envelope,
    right: Vec<f64>,
    coefficients: usize,
    room: Vec<f64>,
}

impl Newton {
    fn new(problem: &Problem, solution: &Solution) -> Result<Self> {
        let spline = &solution.components[0];
        let (degree, lambda) = (spline.degree, problem.components[0].lambda);
        let knots = &spline.knots;
        let at: Vec<f64> = knots.iter().map(|t| t - problem.start).collect();
        let breaks = Breaks::simple(degree, problem.closed, problem.end - problem.start, at);
        let room: Vec<f64> =
            (0..knots.len()).map(|k| 0.3 * breaks.gap_before(k).min(breaks.gap_after(k)).min(6.0)).collect();
        let space = Space::new(breaks);
        let count = 2 * space.count;
        let mut newton = Self {
            matrix: Envelope::new(vec![0; count + knots.len()]),
            right: vec![0.0; count + knots.len()],
            coefficients: count,
            room,
        };
        let bumps: Vec<(Vec<(usize, Polynomial)>, Vector)> = (0..knots.len())
            .map(|k| {
                let (pieces, jump) = space.bump(k, 1);
                (pieces, -spline.jumps[k] / jump)
            })
            .collect();
        newton.data(problem, &space, &bumps);
        let dual = dual_at(problem, &residual_forces(problem, solution)?, knots);
        for (k, jump) in spline.jumps.iter().enumerate() {
            newton.price(&space, &bumps, k, lambda, *jump, &dual[k]);
        }
        Ok(newton)
    }

    fn add(&mut self, row: &[(usize, f64)], factor: f64) {
        for &(i, a) in row {
            for &(j, b) in row {
                self.matrix.add(i, j, factor * a * b);
            }
        }
    }

    /// 2|change of the curve|² at the samples.
    fn data(&mut self, problem: &Problem, space: &Space, bumps: &[(Vec<(usize, Polynomial)>, Vector)]) {
        let mut of_span: Vec<Vec<(usize, Polynomial)>> = vec![Vec::new(); space.spans.len()];
        for (k, (pieces, _)) in bumps.iter().enumerate() {
            for (s, polynomial) in pieces {
                of_span[*s].push((k, *polynomial));
            }
        }
        let degree = space.breaks.degree;
        let mut at = 0;
        let mut rows: [Vec<(usize, f64)>; 2] = [Vec::new(), Vec::new()];
        for (m, t) in problem.parameters.iter().enumerate() {
            let (s, t) = space.find(t - problem.start, at);
            at = s;
            let span = &space.spans[s];
            let u = (t - span.middle) / span.half;
            rows.iter_mut().for_each(Vec::clear);
            for i in 0..=degree {
                let b = derivative(&space.basis[s][i], degree, u, 1.0, 0);
                let index = 2 * space.index(s, i);
                rows[0].push((index, b));
                rows[1].push((index + 1, b));
            }
            for (k, polynomial) in &of_span[s] {
                let value = derivative(polynomial, degree, u, 1.0, 0);
                rows[0].push((self.coefficients + k, value * bumps[*k].1.x));
                rows[1].push((self.coefficients + k, value * bumps[*k].1.y));
            }
            let weight = problem.weights.get(m).copied().unwrap_or(1.0);
            for row in &rows {
                self.add(row, 2.0 * weight);
            }
        }
    }

    /// λ|jump| to second order, and what the knot's place adds.
    fn price(
        &mut self,
        space: &Space,
        bumps: &[(Vec<(usize, Polynomial)>, Vector)],
        k: usize,
        lambda: f64,
        jump: Vector,
        dual: &[Vector; 3],
    ) {
        let size = jump.norm();
        if size <= 0.0 {
            return;
        }
        let unit = jump / size;
        let normal = Vector::new(-unit.y, unit.x);
        let (before, after) = space.sides(k);
        let degree = space.breaks.degree;
        let jump_of = |side_after: &Polynomial, side_before: &Polynomial| {
            derivative(side_after, degree, -1.0, space.spans[after].half, degree)
                - derivative(side_before, degree, 1.0, space.spans[before].half, degree)
        };
        // Change of the jump at knot k, for each coordinate, by each unknown.
        let zero = [0.0; HIGHEST + 1];
        let mut changes: Vec<(usize, Vector)> = Vec::new();
        for i in 0..=degree {
            let value = jump_of(&space.basis[after][i], &zero);
            let index = 2 * space.index(after, i);
            changes.push((index, Vector::new(value, 0.0)));
            changes.push((index + 1, Vector::new(0.0, value)));
            let value = jump_of(&zero, &space.basis[before][i]);
            let index = 2 * space.index(before, i);
            changes.push((index, Vector::new(value, 0.0)));
            changes.push((index + 1, Vector::new(0.0, value)));
        }
        for (other, (pieces, direction)) in bumps.iter().enumerate() {
            let side = |s: usize| pieces.iter().find(|(span, _)| *span == s).map_or(&zero, |(_, p)| p);
            let value = jump_of(side(after), side(before));
            if value != 0.0 {
                changes.push((self.coefficients + other, direction * value));
            }
        }
        let across: Vec<(usize, f64)> = changes.iter().map(|(i, c)| (*i, c.dot(&normal))).collect();
        self.add(&across, lambda / size);
        let own = self.coefficients + k;
        for (i, change) in &changes {
            let value = -lambda * dual[1].dot(change);
            let twice = if *i == own { 2.0 } else { 1.0 };
            self.matrix.add(own.max(*i), own.min(*i), twice * value);
        }
        let bend = (-lambda * size * unit.dot(&dual[2])).max(0.0);
        self.matrix.add(own, own, bend);
        self.right[own] += lambda * size * unit.dot(&dual[1]);
    }

    /// How far each knot is to go.
    fn steps(&self, damping: f64) -> Vec<f64> {
        let mut matrix = self.matrix.clone();
        let size = matrix.size();
        for i in 0..size {
            let more = if i < self.coefficients { 1e-13 } else { damping + 1e-12 } * matrix.diagonal(i);
            matrix.add(i, i, more + 1e-280);
        }
        matrix.factor();
        let mut steps = self.right.clone();
        matrix.solve(&mut steps);
        let bounded = |(by, room): (&f64, &f64)| if by.is_finite() { by.clamp(-*room, *room) } else { 0.0 };
        steps[self.coefficients..].iter().zip(&self.room).map(bounded).collect()
    }
}
