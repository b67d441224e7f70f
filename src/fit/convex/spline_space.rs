//! Splines of one degree on any sorted knots, on a line or on a circle.

use super::interval::{Local, MOST_DEGREE, polynomials};
use crate::error::{Error, Result};
use crate::limits;
use crate::numerics::Vector;
use crate::numerics::banded::Bordered;

/// Room for one number per basis function that is not zero at a point, or per coefficient of a jump.
pub const ROOM: usize = MOST_DEGREE + 2;

/// The splines of degree 1 … 5 whose highest derivative jumps at the given knots and nowhere else.
///
/// Closed: functions of period `end − start`; K knots make K coefficients (no knot: the constants). Open: functions on
/// \[start, end\]; K knots inside make K + degree + 1 coefficients, clamped at the ends. A knot that stands m times
/// lets the m highest derivatives jump. Interval k has the basis functions k … k + degree, their coefficients
/// [`KnotSpace::coefficient`]; closed, interval k starts at knot k, open it ends there. [deB78, IX–X], (D 12.3).
#[derive(Clone, Debug)]
pub struct KnotSpace {
    degree: usize,
    start: f64,
    end: f64,
    closed: bool,
    /// How many knots.
    count: usize,
    /// The knots with `degree` more before and behind: repeated by the period, or clamped.
    padded: Vec<f64>,
}

impl KnotSpace {
    /// The space on these knots.
    ///
    /// # Errors
    ///
    /// `OutOfRange` for a degree not in 1 … 5, `NotFinite`, and `Degenerate` for a domain without length, for knots
    /// that fall, that lie outside \[start, end) (closed) or (start, end) (open), or that stand more than `degree`
    /// times.
    pub fn new(degree: usize, knots: &[f64], start: f64, end: f64, closed: bool) -> Result<Self> {
        limits::check("degree", None, degree as f64, 1.0, MOST_DEGREE as f64)?;
        check_knots(degree, knots, start, end, closed)?;
        let mut space = Self { degree, start, end, closed, count: 0, padded: Vec::new() };
        space.set_knots(knots)?;
        Ok(space)
    }

    /// The same kind of space on other knots, which are known to be good.
    pub(crate) fn set_knots(&mut self, knots: &[f64]) -> Result<()> {
        let (degree, period) = (self.degree, self.end - self.start);
        let lone = [self.start];
        let knots = if self.closed && knots.is_empty() { &lone[..] } else { knots };
        self.count = knots.len();
        self.padded.clear();
        let room = knots.len() + 2 * degree + 2;
        if self.padded.try_reserve(room).is_err() {
            return Err(Error::memory(room * size_of::<f64>()));
        }
        if self.closed {
            let turns = degree.div_ceil(knots.len());
            let first = turns * knots.len() - degree;
            self.padded.extend(
                (first..first + room)
                    .map(|i| knots[i % knots.len()] + period * ((i / knots.len()) as f64 - turns as f64)),
            );
        } else {
            self.padded.resize(degree + 1, self.start);
            self.padded.extend_from_slice(knots);
            self.padded.resize(room, self.end);
        }
        Ok(())
    }

    /// The degree.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Whether the functions are periodic.
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// Start and end of the domain; closed, the end is the start of the next period.
    pub fn domain(&self) -> (f64, f64) {
        (self.start, self.end)
    }

    /// How many knots there are. A closed space without knots has one at the start, where nothing can jump.
    pub fn knot_count(&self) -> usize {
        self.count
    }

    /// Knot k.
    pub fn knot(&self, k: usize) -> f64 {
        self.padded[self.place(k)]
    }

    /// Where knot k stands in the padded knots.
    #[inline]
    pub(crate) fn place(&self, k: usize) -> usize {
        k + self.degree + usize::from(!self.closed)
    }

    /// How many coefficients a function has.
    pub fn dimension(&self) -> usize {
        if self.closed { self.count } else { self.count + self.degree + 1 }
    }

    /// How many intervals there are between the knots.
    pub fn interval_count(&self) -> usize {
        if self.closed { self.count } else { self.count + 1 }
    }

    /// Start and end of interval k; the last of a closed space ends beyond the period. Empty between equal knots.
    #[inline]
    pub fn interval(&self, k: usize) -> (f64, f64) {
        (self.padded[k + self.degree], self.padded[k + self.degree + 1])
    }

    /// The coefficient of basis function j, 0 … `interval_count` + `degree` − 1: closed, the functions come round.
    #[inline]
    pub fn coefficient(&self, j: usize) -> usize {
        if self.closed && j >= self.count {
            let round = j - self.count;
            if round < self.count { round } else { j % self.count }
        } else {
            j
        }
    }

    /// The interval that holds t, and t as seen from there (closed: moved by periods). Right-continuous, except that
    /// the end of an open domain belongs to the last interval.
    #[inline]
    pub fn locate(&self, t: f64) -> (usize, f64) {
        self.locate_after(0, t)
    }

    /// The same, which is known at once where it is interval `before` or the one after it: whoever walks along the
    /// knots searches for none.
    pub(crate) fn locate_after(&self, before: usize, t: f64) -> (usize, f64) {
        let mut t = t;
        if self.closed {
            let (first, period) = (self.padded[self.degree], self.end - self.start);
            t -= period * ((t - first) / period).floor();
            if t >= first + period {
                t = first;
            }
        }
        for k in before..(before + 2).min(self.interval_count()) {
            let (from, to) = self.interval(k);
            if from <= t && t < to {
                return (k, t);
            }
        }
        let starts = &self.padded[self.degree..self.degree + self.interval_count()];
        (starts.partition_point(|&knot| knot <= t).max(1) - 1, t)
    }

    /// The basis functions of interval k as polynomials of x = (t − middle)/half, one row of ascending powers each.
    pub fn polynomials(&self, k: usize) -> Local {
        let (left, right) = self.interval(k);
        polynomials(self.around(k), self.degree, 0.5 * (left + right), 0.5 * (right - left))
    }

    /// The 2·degree + 2 knots around interval k, which lies between the two in the middle.
    pub(crate) fn around(&self, k: usize) -> &[f64] {
        &self.padded[k..k + 2 * self.degree + 2]
    }

    /// Where coefficient j's basis function is not zero; closed, from at most a few periods before the domain on.
    pub(crate) fn support(&self, j: usize) -> (f64, f64) {
        (self.padded[j], self.padded[j + self.degree + 1])
    }

    /// A derivative of the function at t; order 0 is the value. At a knot the limit from the right.
    pub fn evaluate(&self, coefficients: &[Vector], t: f64, order: usize) -> Vector {
        let (interval, t) = self.locate(t);
        let local = self.polynomials(interval);
        let mut sum = Vector::zeros();
        for i in 0..=self.degree {
            sum += coefficients[self.coefficient(interval + i)] * local.derivative(i, t, order);
        }
        sum
    }

    /// The values at t of the basis functions that are not zero there, and the interval that names them.
    pub fn basis(&self, t: f64, order: usize) -> (usize, [f64; ROOM]) {
        let (interval, t) = self.locate(t);
        let local = self.polynomials(interval);
        let mut values = [0.0; ROOM];
        for (i, value) in values.iter_mut().enumerate().take(self.degree + 1) {
            *value = local.derivative(i, t, order);
        }
        (interval, values)
    }

    /// The jump at knot k of the derivative of that order, as weights of the basis functions first … first + order + 1
    /// (answer: first, weights). A knot that stands m times, k the first of them, has jumps from order degree + 1 − m
    /// on.
    pub fn jump_weights(&self, k: usize, order: usize) -> (usize, [f64; ROOM]) {
        let place = self.place(k);
        // One turn more on a circle, where the first function may be the last one of the turn before.
        let first = place + if self.closed { self.count } else { 0 } - order - 1;
        let mut weights = [0.0; ROOM];
        weights[order] = -1.0;
        weights[order + 1] = 1.0;
        // Weights of the coefficients of derivative r become weights of those of derivative r − 1.
        for r in (1..=order).rev() {
            let factor = (self.degree - r + 1) as f64;
            for i in r..=order + 1 {
                let j = place + i - order - 1;
                let width = self.padded[j + self.degree - r + 1] - self.padded[j];
                let weight = if width > 0.0 { weights[i] * factor / width } else { 0.0 };
                weights[i] = weight;
                weights[i - 1] -= weight;
            }
        }
        (first, weights)
    }

    /// The jumps of the highest derivative at all knots, each of which stands once.
    pub fn jumps(&self, coefficients: &[Vector]) -> Vec<Vector> {
        (0..self.count)
            .map(|k| {
                let (first, weights) = self.jump_weights(k, self.degree);
                let mut jump = Vector::zeros();
                for (i, weight) in weights.iter().enumerate().take(self.degree + 2) {
                    jump += coefficients[self.coefficient(first + i)] * *weight;
                }
                jump
            })
            .collect()
    }

    /// The same function with one more knot, by Boehm's rule: convex combinations, no digit is lost.
    ///
    /// # Errors
    ///
    /// As for [`KnotSpace::new`].
    pub fn insert(&self, coefficients: &[Vector], knot: f64) -> Result<(Self, Vec<Vector>)> {
        let mut knots: Vec<f64> = (0..self.count).map(|k| self.knot(k)).collect();
        knots.insert(knots.partition_point(|&other| other <= knot), knot);
        let finer = Self::new(self.degree, &knots, self.start, self.end, self.closed)?;
        let mut result = Vec::new();
        self.refine_into(coefficients, &finer, &mut result);
        Ok((finer, result))
    }

    /// The coefficients of the same function on finer knots, by blossoms. Each is taken from the polynomial of the
    /// longest interval among the knots that it depends on: no other is far away by that measure. [deB78, XI]
    pub(crate) fn refine_into(&self, coefficients: &[Vector], finer: &Self, result: &mut Vec<Vector>) {
        let degree = self.degree;
        result.clear();
        result.extend((0..finer.dimension()).map(|j| {
            let knots = &finer.padded[j..j + degree + 2];
            let length = |i: usize| knots[i + 1] - knots[i];
            // Between the arguments if there is anything between them, otherwise before or behind.
            let mut longest = usize::from(degree > 1);
            for i in (2..degree).chain([0, degree]) {
                if length(i) > length(longest) && ((1..degree).contains(&i) || length(longest) <= 0.0) {
                    longest = i;
                }
            }
            let middle = knots[longest] + 0.5 * length(longest);
            let (interval, moved) = self.locate(middle);
            self.blossom(coefficients, interval, &knots[1..=degree], moved - middle)
        }));
    }

    /// The blossom of the polynomial of an interval at as many arguments as the degree has, all moved by `shift`.
    fn blossom(&self, coefficients: &[Vector], interval: usize, at: &[f64], shift: f64) -> Vector {
        let degree = self.degree;
        let knots = &self.padded[interval..interval + 2 * degree + 2];
        let mut points = [Vector::zeros(); ROOM];
        for (i, point) in points.iter_mut().enumerate().take(degree + 1) {
            *point = coefficients[self.coefficient(interval + i)];
        }
        for (r, &argument) in at.iter().enumerate() {
            for i in 0..degree - r {
                let (low, high) = (knots[r + 1 + i], knots[degree + 1 + i]);
                let share = (argument + shift - low) / (high - low);
                points[i] = points[i] * (1.0 - share) + points[i + 1] * share;
            }
        }
        points[0]
    }

    /// The matrix Σ wₘ Bᵢ(tₘ) Bⱼ(tₘ), in the order of the coefficients, for systems of least squares.
    ///
    /// # Errors
    ///
    /// `OutOfMemory`, and `WrongLength` when there are weights, but not as many as parameters.
    pub fn normal_matrix(&self, parameters: &[f64], weights: &[f64]) -> Result<Bordered> {
        check_weights(parameters, weights)?;
        let mut matrix = Bordered::ring(self.dimension(), self.degree, self.closed)?;
        for (m, &t) in parameters.iter().enumerate() {
            let weight = weights.get(m).copied().unwrap_or(1.0);
            let (interval, basis) = self.basis(t, 0);
            for i in 0..=self.degree {
                for j in 0..=i {
                    let (row, column) = (self.coefficient(interval + i), self.coefficient(interval + j));
                    // On few knots two functions of one interval may be the same coefficient: both products count.
                    let twice = if i != j && row == column { 2.0 } else { 1.0 };
                    matrix.add(row, column, twice * weight * basis[i] * basis[j]);
                }
            }
        }
        Ok(matrix)
    }

    /// The right-hand side Σ wₘ Bᵢ(tₘ) pₘ that belongs to [`KnotSpace::normal_matrix`].
    ///
    /// # Errors
    ///
    /// `WrongLength` when there are not as many points (or, if any, weights) as parameters.
    pub fn right_side(&self, parameters: &[f64], weights: &[f64], points: &[Vector]) -> Result<Vec<Vector>> {
        check_weights(parameters, weights)?;
        if points.len() != parameters.len() {
            return Err(Error::wrong_length("points", points.len(), parameters.len()));
        }
        let mut right = limits::with_room(self.dimension())?;
        right.resize(self.dimension(), Vector::zeros());
        for (m, (&t, point)) in parameters.iter().zip(points).enumerate() {
            let weight = weights.get(m).copied().unwrap_or(1.0);
            let (interval, basis) = self.basis(t, 0);
            for (i, value) in basis.iter().enumerate().take(self.degree + 1) {
                right[self.coefficient(interval + i)] += point * (weight * value);
            }
        }
        Ok(right)
    }
}

fn check_weights(parameters: &[f64], weights: &[f64]) -> Result<()> {
    if weights.is_empty() || weights.len() == parameters.len() {
        Ok(())
    } else {
        Err(Error::wrong_length("weights", weights.len(), parameters.len()))
    }
}

fn check_knots(degree: usize, knots: &[f64], start: f64, end: f64, closed: bool) -> Result<()> {
    if !(start.is_finite() && end.is_finite()) {
        return Err(Error::not_finite("domain", None));
    }
    if start >= end {
        return Err(Error::degenerate("domain", None, "it has no length"));
    }
    let mut times = 0;
    let mut before = f64::NEG_INFINITY;
    for (k, &knot) in knots.iter().enumerate() {
        if !knot.is_finite() {
            return Err(Error::not_finite("knots", Some(k)));
        }
        let inside = knot < end && (knot > start || (closed && knot >= start));
        if !inside {
            return Err(Error::degenerate("knots", Some(k), "it lies outside the domain"));
        }
        times = if knot == before { times + 1 } else { 1 };
        if knot < before || times > degree {
            return Err(Error::degenerate("knots", Some(k), "knots ascend, at most degree of them equal"));
        }
        before = knot;
    }
    Ok(())
}
