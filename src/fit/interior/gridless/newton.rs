//! One step of coefficients and knots together.

use super::residual_forces;
use crate::error::Result;
use crate::fit::convex::certificate::{Integral, Sweep, centred};
use crate::fit::convex::problem::Problem;
use crate::fit::convex::solution::Solution;
use crate::fit::knots::breaks::{Breaks, HIGHEST};
use crate::fit::knots::envelope::Envelope;
use crate::fit::knots::space::{Polynomial, Space, derivative};
use crate::numerics::Vector;
use crate::numerics::order::sort_numbers;
use crate::numerics::plane::{larger, smaller};

/// The step of differences of the dual curve.
const STEP: f64 = 0.02;

/// The knots and places beside them, three for each.
fn places_at(problem: &Problem, knots: &[f64]) -> Vec<f64> {
    let inside = |t: f64| {
        let period = problem.end - problem.start;
        match problem.closed {
            true if t < problem.start => t + period,
            true if t >= problem.end => t - period,
            _ => smaller(larger(t, problem.start), problem.end),
        }
    };
    knots.iter().flat_map(|&t| [inside(t - STEP), t, inside(t + STEP)]).collect()
}

/// The dual curve and its first two derivatives at the knots, from its values at some places, these among them.
fn dual_at(wanted: &[f64], places: &[f64], values: &[Vector]) -> Vec<[Vector; 3]> {
    let at = |t: f64| values[places.partition_point(|&place| place < t).min(values.len() - 1)];
    wanted
        .chunks_exact(3)
        .map(|three| {
            let (before, here, after) = (at(three[0]), at(three[1]), at(three[2]));
            [here, (after - before) / (2.0 * STEP), (after - 2.0 * here + before) / (STEP * STEP)]
        })
        .collect()
}

/// What a knot's place changes: polynomials on some pieces, and the direction.
type Bump = (Vec<(usize, Polynomial)>, Vector);

/// The quadratic model of the objective in coefficients and knots, made in rounds. (D 13.8)
#[derive(Clone, Debug)]
pub(super) struct Newton {
    matrix: Envelope,
    right: Vec<f64>,
    coefficients: usize,
    room: Vec<f64>,
    space: Space,
    bumps: Vec<Bump>,
    /// Samples that are in it, and the piece of the last of them.
    samples: usize,
    piece: usize,
    /// The dual curve that is still to be known: its vector, the places in order, how far it is.
    dual: Option<(Vec<Vector>, Vec<f64>, Sweep)>,
}

impl Newton {
    pub(super) fn new(problem: &Problem, solution: &Solution) -> Self {
        let spline = &solution.components[0];
        let knots = &spline.knots;
        let at: Vec<f64> = knots.iter().map(|t| t - problem.start).collect();
        let breaks = Breaks::simple(spline.degree, problem.closed, problem.end - problem.start, at);
        let room: Vec<f64> =
            (0..knots.len()).map(|k| 0.3 * breaks.gap_before(k).min(breaks.gap_after(k)).min(6.0)).collect();
        let space = Space::new(breaks);
        let count = 2 * space.count;
        let bump = |k: usize| {
            let (pieces, jump) = space.bump(k, 1);
            (pieces, -spline.jumps[k] / jump)
        };
        Self {
            matrix: Envelope::new(vec![0; count + knots.len()]),
            right: vec![0.0; count + knots.len()],
            coefficients: count,
            room,
            bumps: (0..knots.len()).map(bump).collect(),
            space,
            samples: 0,
            piece: 0,
            dual: None,
        }
    }

    /// One round, past so many samples at most; answers whether the model is whole.
    pub(super) fn round(&mut self, problem: &Problem, solution: &Solution, most: usize) -> Result<bool> {
        if self.samples < problem.points.len() {
            self.data(problem, most);
            return Ok(false);
        }
        let (component, spline) = (&problem.components[0], &solution.components[0]);
        let (degree, lambda) = (component.degree, component.lambda);
        let Some((v, places, sweep)) = &mut self.dual else {
            let mut places = places_at(problem, &spline.knots);
            sort_numbers(&mut places);
            places.dedup();
            let sweep = Sweep::new(problem, places.len())?;
            self.dual = Some((residual_forces(problem, solution)?, places, sweep));
            return Ok(false);
        };
        if !sweep.round(&Integral { problem, degree, lambda, v }, places, most) {
            return Ok(false);
        }
        let (values, _) = centred(problem, core::mem::take(&mut sweep.values));
        let dual = dual_at(&places_at(problem, &spline.knots), places, &values);
        let (space, bumps) = (self.space.clone(), core::mem::take(&mut self.bumps));
        for (k, jump) in spline.jumps.iter().enumerate() {
            self.price(&space, &bumps, k, lambda, *jump, &dual[k]);
        }
        self.dual = None;
        Ok(true)
    }

    fn add(&mut self, row: &[(usize, f64)], factor: f64) {
        for &(i, a) in row {
            for &(j, b) in row {
                self.matrix.add(i, j, factor * a * b);
            }
        }
    }

    /// 2|change of the curve|² at so many samples more.
    fn data(&mut self, problem: &Problem, most: usize) {
        let mut of_span: Vec<Vec<(usize, Polynomial)>> = vec![Vec::new(); self.space.spans.len()];
        for (k, (pieces, _)) in self.bumps.iter().enumerate() {
            for (s, polynomial) in pieces {
                of_span[*s].push((k, *polynomial));
            }
        }
        let degree = self.space.breaks.degree;
        let mut rows: [Vec<(usize, f64)>; 2] = [Vec::new(), Vec::new()];
        let until = self.samples.saturating_add(most).min(problem.points.len());
        for m in self.samples..until {
            let (s, t) = self.space.find(problem.parameters[m] - problem.start, self.piece);
            self.piece = s;
            let span = &self.space.spans[s];
            let u = (t - span.middle) / span.half;
            rows.iter_mut().for_each(Vec::clear);
            for i in 0..=degree {
                let b = derivative(&self.space.basis[s][i], degree, u, 1.0, 0);
                let index = 2 * self.space.index(s, i);
                rows[0].push((index, b));
                rows[1].push((index + 1, b));
            }
            for (k, polynomial) in &of_span[s] {
                let value = derivative(polynomial, degree, u, 1.0, 0);
                rows[0].push((self.coefficients + k, value * self.bumps[*k].1.x));
                rows[1].push((self.coefficients + k, value * self.bumps[*k].1.y));
            }
            let weight = problem.weights.get(m).copied().unwrap_or(1.0);
            for row in &rows {
                self.add(row, 2.0 * weight);
            }
        }
        self.samples = until;
    }

    /// λ|jump| to second order, and what the knot's place adds.
    fn price(
        &mut self,
        space: &Space,
        bumps: &[Bump],
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
        let bounded =
            |(by, room): (&f64, &f64)| if by.is_finite() { smaller(larger(*by, -*room), *room) } else { 0.0 };
        steps[self.coefficients..].iter().zip(&self.room).map(bounded).collect()
    }
}
