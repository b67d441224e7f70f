//! The problem on the knots that are in play: its spaces, its quadratic form, its linear systems.

use super::cone::Metric;
use super::interval::{Local, TERMS, polynomials};
use super::scaled::{Scaled, ScaledComponent};
use super::spline_space::{KnotSpace, ROOM};
use crate::error::Result;
use crate::limits;
use crate::numerics::Vector;
use crate::numerics::banded::Bordered;
use crate::numerics::order::{sort_by_number, sort_numbers};

/// The jump of the highest derivative at one knot: weights of its coefficients, and where these stand.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    pub(crate) weights: [f64; ROOM],
    /// Their places among the unknown points, in the order of the linear system.
    pub(crate) unknowns: [usize; ROOM],
}

/// One spline of the sum on its knots in play.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub(crate) space: KnotSpace,
    /// The knots in play, as indices of the grid, ascending.
    pub(crate) chosen: Vec<usize>,
    pub(crate) rows: Vec<Row>,
    /// Place of each coefficient among the unknown points.
    pub(crate) order: Vec<usize>,
}

/// A stretch between neighbouring knots of any part: all parts are polynomials there.
#[derive(Clone, Debug)]
pub(crate) struct Element {
    pub(crate) samples: (usize, usize),
    pub(crate) middle: f64,
    pub(crate) half: f64,
}

/// The least-squares part of the problem on the knots in play.
#[derive(Clone, Debug)]
pub(crate) struct Reduced {
    pub(crate) parts: Vec<Part>,
    pub(crate) elements: Vec<Element>,
    /// For each element and each part, in turn, its interval and its basis functions in the element's variable.
    locals: Vec<(usize, Local)>,
    /// How many unknown points there are.
    pub(crate) unknowns: usize,
    /// Unknown points in the band and coupling reach among them; the others are the border.
    banded: usize,
    reach: usize,
    /// 2 Σ w B B′ and the gauge: the same for both coordinates.
    pub(crate) quadratic: Bordered,
    /// 2 Σ w B p.
    pub(crate) linear: Vec<Vector>,
    /// The system of one iteration.
    pub(crate) system: Bordered,
}

impl Reduced {
    /// The problem on these knots; `chosen` names places of each component's grid.
    pub(crate) fn new(data: &Scaled, chosen: Vec<Vec<usize>>) -> Result<Self> {
        let mut parts = Vec::new();
        for (component, chosen) in data.components.iter().zip(chosen) {
            let mut knots = limits::with_room(chosen.len())?;
            knots.extend(chosen.iter().map(|&k| component.grid[k]));
            let space = KnotSpace::new(component.degree, &knots, 0.0, data.length, data.closed)?;
            parts.push(Part { space, chosen, rows: Vec::new(), order: Vec::new() });
        }
        let unknowns = order_unknowns(&mut parts);
        let (elements, locals) = elements(data, &parts);
        let mut reduced = Self {
            parts,
            elements,
            locals,
            unknowns,
            banded: 0,
            reach: 0,
            quadratic: Bordered::default(),
            linear: Vec::new(),
            system: Bordered::default(),
        };
        reduced.make_rows();
        reduced.shape()?;
        reduced.assemble(data);
        Ok(reduced)
    }

    /// λ of every knot in play.
    pub(crate) fn lambdas(&self, data: &Scaled) -> Vec<f64> {
        let one = |(part, component): (&Part, &ScaledComponent)| {
            core::iter::repeat_n(component.lambda, part.chosen.len())
        };
        self.parts.iter().zip(&data.components).flat_map(one).collect()
    }

    fn make_rows(&mut self) {
        for part in &mut self.parts {
            let degree = part.space.degree();
            part.rows.clear();
            for k in 0..part.chosen.len() {
                let (first, weights) = part.space.jump_weights(k, degree);
                let mut unknowns = [0; ROOM];
                for (i, unknown) in unknowns.iter_mut().enumerate().take(degree + 2) {
                    *unknown = part.order[part.space.coefficient(first + i)];
                }
                part.rows.push(Row { weights, unknowns });
            }
        }
    }

    /// Finds how far unknowns couple, and how many of the last have to be the border.
    fn shape(&mut self) -> Result<()> {
        let (count, mut reach, mut border) = (self.unknowns, 0, 0);
        let mut couple = |set: &mut dyn Iterator<Item = usize>| {
            let (mut low, mut high, mut late) = (count, 0, count);
            let (mut first, mut last) = (count, 0);
            for unknown in set {
                (first, last) = (first.min(unknown), last.max(unknown));
                if 2 * unknown >= count {
                    late = late.min(unknown);
                } else {
                    (low, high) = (low.min(unknown), high.max(unknown));
                }
            }
            if first < count && 2 * (last - first) > count {
                border = border.max(count - late);
                reach = reach.max(high.saturating_sub(low));
            } else {
                reach = reach.max(last.saturating_sub(first));
            }
        };
        for part in &self.parts {
            for row in &part.rows {
                couple(&mut row.unknowns[..part.space.degree() + 2].iter().copied());
            }
        }
        for locals in self.locals.chunks_exact(self.parts.len()) {
            couple(&mut self.parts.iter().zip(locals).flat_map(|(part, (first, local))| {
                (*first..=first + local.degree).map(|j| part.order[part.space.coefficient(j)])
            }));
        }
        if 2 * border > count || 2 * reach > count {
            (border, reach) = (count, 0);
        }
        (self.banded, self.reach) = (count - border, reach);
        self.quadratic = Bordered::new(self.banded, reach, border)?;
        self.system = self.quadratic.of_points()?;
        Ok(())
    }

    /// The quadratic form and the linear one, element by element, from moments of the samples.
    fn assemble(&mut self, data: &Scaled) {
        self.linear.clear();
        self.linear.resize(self.unknowns, Vector::zeros());
        match self.highest() {
            1 => self.assemble_of::<2>(data),
            2 | 3 => self.assemble_of::<4>(data),
            _ => self.assemble_of::<TERMS>(data),
        }
        if self.parts.len() == 2 {
            self.hold_gauge(data);
        }
    }

    /// The highest degree of the parts.
    fn highest(&self) -> usize {
        self.parts[self.parts.len() - 1].space.degree()
    }

    /// The forms, for degrees below T: polynomials of lower degree have zeros for what they lack.
    #[allow(clippy::needless_range_loop, reason = "matrices are written with their indices")]
    fn assemble_of<const T: usize>(&mut self, data: &Scaled) {
        for (element, locals) in self.elements.iter().zip(self.locals.chunks_exact(self.parts.len())) {
            let (powers, values) = moments::<T>(data, element);
            for (p, (part, (first, local))) in self.parts.iter().zip(locals).enumerate() {
                for i in 0..=local.degree {
                    let row = part.order[part.space.coefficient(first + i)];
                    let own = leading::<T, f64>(&local.rows[i]);
                    // Gram's matrix with the functions of this part up to i, and with all of the parts before.
                    let mut image = [0.0; T];
                    let mut linear = Vector::zeros();
                    for k in 0..T {
                        linear += values[k] * (2.0 * own[k]);
                        for power in 0..T {
                            image[power] += own[k] * powers[power + k];
                        }
                    }
                    self.linear[row] += linear;
                    for (q, (before, (other_first, other))) in
                        self.parts.iter().zip(locals).enumerate().take(p + 1)
                    {
                        let last = if q == p { i } else { other.degree };
                        for j in 0..=last {
                            let column = before.order[before.space.coefficient(other_first + j)];
                            let twice = if row == column && (i != j || q != p) { 4.0 } else { 2.0 };
                            let other = leading::<T, f64>(&other.rows[j]);
                            let value: f64 = other.iter().zip(&image).map(|(a, b)| a * b).sum();
                            self.quadratic.add(row, column, twice * value);
                        }
                    }
                }
            }
        }
    }

    /// What both parts could represent belongs to the second: the first is drawn to zero at places enough.
    fn hold_gauge(&mut self, data: &Scaled) {
        let part = &self.parts[0];
        let strength = 0.2 * data.t.len() as f64;
        for t in gauge_places(part.space.degree(), data.length, data.closed) {
            let (first, basis) = part.space.basis(t, 0);
            for i in 0..=part.space.degree() {
                for j in 0..=i {
                    let row = part.order[part.space.coefficient(first + i)];
                    let column = part.order[part.space.coefficient(first + j)];
                    let twice = if row == column && i != j { 2.0 } else { 1.0 };
                    self.quadratic.add(row, column, twice * strength * basis[i] * basis[j]);
                }
            }
        }
    }

    /// Quadratic form plus Σ (row)′ metric (row), factored. `metrics` run through the knots of the parts.
    pub(crate) fn factor(&mut self, metrics: &[Metric]) -> usize {
        self.factor_above(metrics, 1e-14)
    }

    /// The same, with pivots of at most `floor` of their diagonal held at zero; answers how many those are.
    pub(crate) fn factor_above(&mut self, metrics: &[Metric], floor: f64) -> usize {
        self.quadratic.copy_to_points(&mut self.system);
        let mut metrics = metrics.iter();
        for part in &self.parts {
            let count = part.space.degree() + 2;
            for row in &part.rows {
                let Some(metric) = metrics.next() else { break };
                // Where the coefficients stand in a row, so do their columns.
                let first = row.unknowns[0];
                let straight = row.unknowns[..count].iter().enumerate().all(|(i, at)| *at == first + i);
                if straight && self.system.add_outer(first, &row.weights[..count], *metric) {
                    continue;
                }
                for i in 0..count {
                    for j in 0..=i {
                        let (a, b) = (row.unknowns[i], row.unknowns[j]);
                        let twice = if a == b && i != j { 2.0 } else { 1.0 };
                        let product = row.weights[i] * row.weights[j] * twice;
                        let block = [product * metric[0], product * metric[1], product * metric[2]];
                        self.system.add_block(a, b, block);
                    }
                }
            }
        }
        self.system.factor(floor)
    }

    /// Solves the system that was factored last, in place.
    pub(crate) fn solve(&self, right: &mut [Vector], buffer: &mut Vec<f64>) {
        buffer.clear();
        buffer.extend(right.iter().flat_map(|v| [v.x, v.y]));
        self.system.solve(buffer);
        for (v, pair) in right.iter_mut().zip(buffer.chunks_exact(2)) {
            *v = Vector::new(pair[0], pair[1]);
        }
    }

    /// The jumps at all knots in play.
    pub(crate) fn jumps(&self, unknowns: &[Vector], jumps: &mut Vec<Vector>) {
        jumps.clear();
        for part in &self.parts {
            let count = part.space.degree() + 2;
            jumps.extend(part.rows.iter().map(|row| {
                let mut jump = Vector::zeros();
                for (weight, unknown) in row.weights.iter().zip(row.unknowns).take(count) {
                    jump += unknowns[unknown] * *weight;
                }
                jump
            }));
        }
    }

    /// Adds the transpose of the jumps: forces at knots become forces at coefficients.
    pub(crate) fn pull(&self, forces: &[Vector], sum: &mut [Vector]) {
        let mut forces = forces.iter();
        for part in &self.parts {
            let count = part.space.degree() + 2;
            for row in &part.rows {
                let Some(force) = forces.next() else { break };
                for (weight, unknown) in row.weights.iter().zip(row.unknowns).take(count) {
                    sum[unknown] += force * *weight;
                }
            }
        }
    }

    /// The polynomial of the whole sum on an element, given by its functions there, in ascending powers of its variable.
    fn polynomial(&self, locals: &[(usize, Local)], unknowns: &[Vector]) -> [Vector; TERMS] {
        let mut sum = [Vector::zeros(); TERMS];
        for (part, (first, local)) in self.parts.iter().zip(locals) {
            for i in 0..=local.degree {
                let coefficient = unknowns[part.order[part.space.coefficient(first + i)]];
                for (term, row) in sum.iter_mut().zip(&local.rows[i][..=local.degree]) {
                    *term += coefficient * *row;
                }
            }
        }
        sum
    }

    /// Weighted residuals w(p − r) of all samples, their moments Σ w(p − r)xʲ on every element, and Σ w |p − r|².
    pub(crate) fn residuals(
        &self,
        data: &Scaled,
        unknowns: &[Vector],
        out: &mut [Vector],
        moments: &mut Vec<[Vector; TERMS]>,
    ) -> f64 {
        moments.clear();
        moments.resize(self.elements.len(), [Vector::zeros(); TERMS]);
        match self.highest() {
            1 => self.residuals_of::<2>(data, unknowns, out, moments),
            2 | 3 => self.residuals_of::<4>(data, unknowns, out, moments),
            _ => self.residuals_of::<TERMS>(data, unknowns, out, moments),
        }
    }

    /// The same for degrees below T.
    fn residuals_of<const T: usize>(
        &self,
        data: &Scaled,
        unknowns: &[Vector],
        out: &mut [Vector],
        moments: &mut [[Vector; TERMS]],
    ) -> f64 {
        let mut total = data.beyond;
        let locals = self.locals.chunks_exact(self.parts.len());
        for ((element, locals), moments) in self.elements.iter().zip(locals).zip(moments) {
            let (from, to) = element.samples;
            if from == to {
                continue;
            }
            let terms: [Vector; T] = leading(&self.polynomial(locals, unknowns));
            let mut sums = [Vector::zeros(); T];
            let inverse = 1.0 / element.half;
            let points = data.x[from..to].iter().zip(&data.y[from..to]);
            let times = data.t[from..to].iter().zip(&data.w[from..to]);
            for (((t, w), (x, y)), out) in times.zip(points).zip(&mut out[from..to]) {
                let s = (t - element.middle) * inverse;
                let mut value = terms[T - 1];
                for term in terms[..T - 1].iter().rev() {
                    value = value * s + term;
                }
                let error = Vector::new(x - value.x, y - value.y);
                let mut force = error * *w;
                total += force.x * error.x + force.y * error.y;
                *out = force;
                for sum in &mut sums {
                    *sum += force;
                    force *= s;
                }
            }
            moments[..T].copy_from_slice(&sums);
        }
        total
    }

    /// The gradient of the least-squares part, Q c − b, from the moments of the residuals; without the gauge, which is
    /// met.
    pub(crate) fn gradient(&self, moments: &[[Vector; TERMS]], sum: &mut Vec<Vector>) {
        sum.clear();
        sum.resize(self.unknowns, Vector::zeros());
        for (locals, moments) in self.locals.chunks_exact(self.parts.len()).zip(moments) {
            for (part, (first, local)) in self.parts.iter().zip(locals) {
                for i in 0..=local.degree {
                    let unknown = part.order[part.space.coefficient(first + i)];
                    let mut force = Vector::zeros();
                    for (row, moment) in local.rows[i].iter().zip(moments).take(local.degree + 1) {
                        force += moment * *row;
                    }
                    sum[unknown] -= force * 2.0;
                }
            }
        }
    }
}

/// Where the first of two components is held at zero.
pub(crate) fn gauge_places(degree: usize, length: f64, closed: bool) -> Vec<f64> {
    if closed { vec![0.0] } else { (0..=degree).map(|i| length * (i as f64 / degree as f64)).collect() }
}

/// The first T of some numbers or vectors.
#[inline]
fn leading<const T: usize, V: Copy>(of: &[V; TERMS]) -> [V; T] {
    core::array::from_fn(|i| of[i])
}

/// Σ w xʲ for j up to 2T − 2, and Σ w xʲ p for j below T, over the samples of an element.
#[inline]
fn moments<const T: usize>(data: &Scaled, element: &Element) -> ([f64; 2 * TERMS], [Vector; T]) {
    let (mut powers, mut values) = ([0.0; 2 * TERMS], [Vector::zeros(); T]);
    let (mut low, mut high) = ([0.0; T], [0.0; T]);
    let inverse = 1.0 / element.half;
    let (from, to) = element.samples;
    let points = data.x[from..to].iter().zip(&data.y[from..to]);
    for ((t, w), (x, y)) in data.t[from..to].iter().zip(&data.w[from..to]).zip(points) {
        let s = (t - element.middle) * inverse;
        let point = Vector::new(*x, *y);
        let mut power = *w;
        for (sum, value) in low.iter_mut().zip(&mut values) {
            *value += point * power;
            *sum += power;
            power *= s;
        }
        for sum in &mut high[..T - 1] {
            *sum += power;
            power *= s;
        }
    }
    powers[..T].copy_from_slice(&low);
    powers[T..2 * T].copy_from_slice(&high);
    (powers, values)
}

/// Orders the coefficients of all parts along the curve, by the middles of their supports.
fn order_unknowns(parts: &mut [Part]) -> usize {
    let mut centres = Vec::new();
    for (p, part) in parts.iter().enumerate() {
        let (start, end) = part.space.domain();
        for j in 0..part.space.dimension() {
            let (from, to) = part.space.support(j);
            let mut centre = 0.5 * (from + to);
            if part.space.is_closed() && centre < start {
                centre += end - start;
            }
            if part.space.is_closed() && centre >= end {
                centre -= end - start;
            }
            centres.push((centre, p, j));
        }
    }
    sort_by_number(&mut centres, &|centre| centre.0);
    for part in parts.iter_mut() {
        part.order.clear();
        part.order.resize(part.space.dimension(), 0);
    }
    for (place, &(_, p, j)) in centres.iter().enumerate() {
        parts[p].order[j] = place;
    }
    centres.len()
}

/// The stretches between all knots, from start to end, and what the parts are there.
fn elements(data: &Scaled, parts: &[Part]) -> (Vec<Element>, Vec<(usize, Local)>) {
    let mut breaks = vec![0.0, data.length];
    for part in parts {
        breaks.extend((0..part.space.knot_count()).map(|k| part.space.knot(k)));
    }
    sort_numbers(&mut breaks);
    breaks.dedup();
    let mut elements = Vec::with_capacity(breaks.len());
    let mut locals = Vec::with_capacity(breaks.len() * parts.len());
    let mut sample = 0;
    for pair in breaks.windows(2) {
        let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
        let from = sample;
        let last = pair[1] >= data.length;
        while sample < data.t.len() && (last || data.t[sample] < pair[1]) {
            sample += 1;
        }
        for part in parts {
            let (interval, moved) = part.space.locate(middle);
            let knots = part.space.around(interval);
            locals.push((interval, polynomials(knots, part.space.degree(), moved, half)));
        }
        elements.push(Element { samples: (from, sample), middle, half });
    }
    (elements, locals)
}
