//! One step of coefficients and knots together.

use super::residual_forces;
use crate::error::Result;
use crate::fit::convex::certificate::dual_values;
use crate::fit::convex::problem::Problem;
use crate::fit::convex::solution::Solution;
use crate::fit::knots::breaks::{Breaks, HIGHEST, Polynomial, Space, derivative};
use crate::fit::knots::envelope::Envelope;
use crate::numerics::Vector;
use crate::numerics::order::sort_numbers;

/// The step of differences of the dual curve.
const STEP: f64 = 0.02;

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

/// The quadratic model of the objective in coefficients and knots. (D 13.8)
pub(super) struct Newton {
    matrix: Envelope,
    right: Vec<f64>,
    coefficients: usize,
    room: Vec<f64>,
}

impl Newton {
    pub(super) fn new(problem: &Problem, solution: &Solution) -> Result<Self> {
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
    pub(super) fn steps(&self, damping: f64) -> Vec<f64> {
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
