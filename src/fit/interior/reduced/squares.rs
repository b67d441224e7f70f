//! The squares of the distances on the knots in play: sums over samples stretch by stretch, the quadratic form that
//! they make, residuals and gradient.

use super::{Part, Reduced};
use crate::fit::convex::interval::{Local, TERMS, polynomials};
use crate::fit::convex::scaled::Scaled;
use crate::numerics::Vector;
use crate::numerics::order::sort_numbers;

/// A stretch between neighbouring knots of any part: all parts are polynomials there.
#[derive(Clone, Debug)]
pub(crate) struct Element {
    samples: (usize, usize),
    middle: f64,
    half: f64,
    /// Σ w xʲ over its samples, for every power that the forms need.
    powers: [f64; 2 * TERMS],
    /// Σ w xʲ p.
    values: [Vector; TERMS],
}

impl Reduced {
    /// The quadratic form and the linear one, element by element, from the sums over their samples.
    pub(super) fn assemble(&mut self, data: &Scaled) {
        self.linear.clear();
        self.linear.resize(self.unknowns, Vector::zeros());
        match self.highest() {
            1 => self.assemble_of::<2>(),
            2 | 3 => self.assemble_of::<4>(),
            _ => self.assemble_of::<TERMS>(),
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
    fn assemble_of<const T: usize>(&mut self) {
        for (element, locals) in self.elements.iter().zip(self.locals.chunks_exact(self.parts.len())) {
            let (powers, values) = (&element.powers, &element.values);
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

    /// The polynomial of the whole sum on an element, given by its functions there, in ascending powers of its
    /// variable.
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
fn gauge_places(degree: usize, length: f64, closed: bool) -> Vec<f64> {
    if closed { vec![0.0] } else { (0..=degree).map(|i| length * (i as f64 / degree as f64)).collect() }
}

/// The first T of some numbers or vectors.
#[inline]
fn leading<const T: usize, V: Copy>(of: &[V; TERMS]) -> [V; T] {
    core::array::from_fn(|i| of[i])
}

/// Notes Σ w xʲ for j up to 2T − 2, and Σ w xʲ p for j below T, over the samples of an element.
#[inline]
fn sum_up<const T: usize>(data: &Scaled, element: &mut Element) {
    let (mut low, mut high) = ([0.0; T], [0.0; T]);
    let mut values = [Vector::zeros(); T];
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
    element.powers[..T].copy_from_slice(&low);
    element.powers[T..2 * T].copy_from_slice(&high);
    element.values[..T].copy_from_slice(&values);
}

/// The stretches between all knots, from start to end, and what the parts are there. Sums over samples are taken from
/// those of `known`, ascending as well, that are the same stretches.
pub(super) fn elements(
    data: &Scaled,
    parts: &[Part],
    known: &[Element],
) -> (Vec<Element>, Vec<(usize, Local)>) {
    let mut breaks = vec![0.0, data.length];
    for part in parts {
        breaks.extend((0..part.space.knot_count()).map(|k| part.space.knot(k)));
    }
    sort_numbers(&mut breaks);
    breaks.dedup();
    let mut elements = Vec::with_capacity(breaks.len());
    let mut locals = Vec::with_capacity(breaks.len() * parts.len());
    let highest = parts[parts.len() - 1].space.degree();
    let (mut sample, mut next) = (0, 0);
    let mut intervals = vec![0; parts.len()];
    for pair in breaks.windows(2) {
        let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
        for (part, before) in parts.iter().zip(&mut intervals) {
            let (interval, moved) = part.space.locate_after(*before, middle);
            *before = interval;
            let knots = part.space.around(interval);
            locals.push((interval, polynomials(knots, part.space.degree(), moved, half)));
        }
        while known.get(next).is_some_and(|other| other.middle < middle) {
            next += 1;
        }
        if let Some(same) = known.get(next).filter(|other| other.middle == middle && other.half == half) {
            sample = same.samples.1;
            elements.push(same.clone());
            continue;
        }
        let from = sample;
        let last = pair[1] >= data.length;
        while sample < data.t.len() && (last || data.t[sample] < pair[1]) {
            sample += 1;
        }
        let (powers, values) = ([0.0; 2 * TERMS], [Vector::zeros(); TERMS]);
        let mut element = Element { samples: (from, sample), middle, half, powers, values };
        match highest {
            1 => sum_up::<2>(data, &mut element),
            2 | 3 => sum_up::<4>(data, &mut element),
            _ => sum_up::<TERMS>(data, &mut element),
        }
        elements.push(element);
    }
    (elements, locals)
}
