//! Coefficients from least squares on windows of the spline itself: what they are, what each point counts, what each
//! knot is worth.

use super::cloud::Cloud;
use super::knots::{Knots, MOST_DEGREE, Values};
use super::{End, held};
use crate::error::Result;
use crate::limits::{LEAST_LENGTH, filled, with_room};

/// Pieces on both sides of a B-spline's support from which its coefficient is taken, where nothing else is asked for.
pub(in crate::trace) const REACH: usize = 2;
/// What a jump of the highest derivative costs, squared and with knots a unit apart: a thousandth of what a point does.
const STIFFNESS: f64 = 1e-3;
/// Added to the diagonal: clouds of too few abscissae have an answer as well.
const RIDGE: f64 = 1e-10;

/// The most coefficients that one row of a window has anything to do with: those of a jump.
const BAND: usize = MOST_DEGREE + 2;
type Row = [f64; BAND];

/// The projection of a cloud onto the splines of some knots, coefficient by coefficient (D 14.10).
pub(super) struct Projection<'a> {
    cloud: &'a Cloud,
    knots: &'a Knots,
    held: Vec<Option<f64>>,
    reach: usize,
    /// The first point of each piece, and one more.
    first: Vec<usize>,
    values: Vec<Values>,
    jumps: Vec<Row>,
    window: Window,
}

/// The normal equations of one window, solved.
struct Window {
    /// Row a: the entries (a, a), (a, a + 1), … of the matrix; of its factor; at last of its inverse.
    matrix: Vec<Row>,
    factor: Vec<Row>,
    solution: Vec<f64>,
    /// The row of the inverse that belongs to the window's own coefficient.
    influence: Vec<f64>,
}

/// What a projection says besides its coefficients.
pub(super) struct Report {
    pub(super) coefficients: Vec<f64>,
    /// The errors of predicting each point from all the others.
    pub(super) left_out: Vec<f64>,
    /// By how much the squares within the window would grow without each interior knot.
    pub(super) worth: Vec<f64>,
    /// The most points that count in one coefficient.
    pub(super) neighbours: usize,
    /// How many points the first and the last piece have.
    pub(super) outer: [usize; 2],
}

impl<'a> Projection<'a> {
    pub(super) fn new(cloud: &'a Cloud, knots: &'a Knots, reach: usize, ends: [End; 2]) -> Result<Self> {
        let pieces = knots.piece_count();
        let mut first = with_room(pieces + 1)?;
        let mut values = with_room(cloud.len())?;
        for (i, &x) in cloud.x().iter().enumerate() {
            let (piece, local) = knots.values(x);
            first.resize(first.len().max(piece + 1), i);
            values.push(local);
        }
        first.resize(pieces + 1, cloud.len());
        let mut jumps = with_room(pieces - 1)?;
        jumps.extend((1..pieces).map(|i| jump(knots, i)));
        let mut ends_held = with_room(knots.count())?;
        ends_held.extend((0..knots.count()).map(|q| held(knots, q, ends)));
        let size = knots.count().min(2 * (knots.degree() + reach) + 1);
        let window = Window {
            matrix: with_room(size)?,
            factor: with_room(size)?,
            solution: filled(0.0, size)?,
            influence: filled(0.0, size)?,
        };
        Ok(Self { cloud, knots, held: ends_held, reach, first, values, jumps, window })
    }

    /// The coefficients alone.
    pub(super) fn coefficients(mut self) -> Result<Vec<f64>> {
        let mut coefficients = with_room(self.knots.count())?;
        for q in 0..self.knots.count() {
            coefficients.push(match self.held[q] {
                Some(value) => value,
                None => {
                    let low = self.solve(q);
                    self.window.solution[q - low]
                }
            });
        }
        Ok(coefficients)
    }

    /// The coefficients, and all that is known beside them.
    pub(super) fn report(mut self) -> Result<Report> {
        let (count, degree) = (self.knots.count(), self.knots.degree());
        let pieces = self.knots.piece_count();
        let outer = [self.first[1], self.cloud.len() - self.first[pieces - 1]];
        let mut report = Report {
            outer,
            coefficients: with_room(count)?,
            left_out: with_room(self.cloud.len())?,
            worth: filled(f64::MAX, self.jumps.len())?,
            neighbours: 1,
        };
        report.left_out.extend_from_slice(self.cloud.y());
        for q in 0..count {
            let low = self.solve(q);
            let pieces = low..(low + self.window.matrix.len() - degree);
            let within = self.first[pieces.end] - self.first[pieces.start];
            report.neighbours = report.neighbours.max(within);
            self.window.invert(q - low, degree + 2);
            let held = self.held[low..].iter().zip(&mut self.window.matrix);
            held.filter(|(held, _)| held.is_some()).for_each(|(_, row)| row[0] = 0.0);
            // The window of coefficient q holds the whole jump of the knot in its middle.
            if let Some(knot) = q.checked_sub(degree.div_ceil(2)).filter(|&knot| knot < self.jumps.len()) {
                report.worth[knot] = self.window.worth(&self.jumps[knot], knot - low, degree);
            }
            let own = self.held[q].unwrap_or(self.window.solution[q - low]);
            report.coefficients.push(own);
            for piece in q.saturating_sub(degree)..=q.min(self.knots.piece_count() - 1) {
                for i in self.first[piece]..self.first[piece + 1] {
                    let share = self.values[i][q - piece];
                    let change = match self.held[q] {
                        Some(_) => 0.0,
                        None => self.window.change(&self.values[i], piece - low, degree, self.cloud.y()[i]),
                    };
                    report.left_out[i] -= share * (own - change);
                }
            }
        }
        Ok(report)
    }

    /// Solves the window of coefficient q; returns the window's first coefficient.
    fn solve(&mut self, q: usize) -> usize {
        let (degree, count) = (self.knots.degree(), self.knots.count());
        let low = q.saturating_sub(degree + self.reach);
        let high = (q + degree + self.reach).min(count - 1);
        let window = &mut self.window;
        let size = high - low + 1;
        window.matrix.clear();
        window.matrix.resize(size, [0.0; BAND]);
        window.matrix.iter_mut().for_each(|row| row[0] = RIDGE);
        window.solution.clear();
        window.solution.resize(size, 0.0);
        for piece in low..=high - degree {
            for i in self.first[piece]..self.first[piece + 1] {
                let values = &self.values[i][..=degree];
                window.add(piece - low, values, 1.0);
                for (right, value) in window.solution[piece - low..].iter_mut().zip(values) {
                    *right += value * self.cloud.y()[i];
                }
            }
        }
        for knot in low..high - degree {
            window.add(knot - low, &self.jumps[knot][..degree + 2], STIFFNESS);
        }
        for a in 0..size {
            if let Some(value) = self.held[low + a] {
                window.hold(a, value);
            }
        }
        window.solve(degree + 2);
        low
    }
}

/// The jump of the p-th derivative at interior knot i, from the p + 2 coefficients that make it, times the p-th power
/// of the mean distance to the knots beside it; nothing where knots are the same.
fn jump(knots: &Knots, i: usize) -> Row {
    let degree = knots.degree();
    let list = knots.as_slice();
    let mut row = [0.0; BAND];
    let gap = 0.5 * (list[i + degree + 1] - list[i + degree - 1]);
    for (side, sign) in [(0, -1.0), (1, 1.0)] {
        // The p-th derivative on the piece of coefficients i − 1 + side …, by differences, written out in the
        // coefficients.
        let piece = i - 1 + side;
        let mut table = [[0.0; BAND]; BAND];
        (0..=degree).for_each(|a| table[a][a + side] = sign);
        for order in 1..=degree {
            for a in 0..=degree - order {
                let (left, right) = (list[piece + a + order], list[piece + a + degree + 1]);
                if right - left < LEAST_LENGTH {
                    return [0.0; BAND];
                }
                let factor = gap * (degree + 1 - order) as f64 / (right - left);
                let next = table[a + 1];
                table[a].iter_mut().zip(next).for_each(|(value, next)| *value = factor * (next - *value));
            }
        }
        row.iter_mut().zip(table[0]).for_each(|(value, part)| *value += part);
    }
    row
}

impl Window {
    /// Adds a row's product with itself, times a weight.
    #[inline(never)]
    fn add(&mut self, at: usize, row: &[f64], weight: f64) {
        for (a, &value) in row.iter().enumerate() {
            for (entry, &other) in self.matrix[at + a].iter_mut().zip(&row[a..]) {
                *entry += weight * value * other;
            }
        }
    }

    /// Makes an unknown a number.
    fn hold(&mut self, a: usize, value: f64) {
        for b in a.saturating_sub(BAND - 1)..self.matrix.len().min(a + BAND) {
            let (row, column) = (a.min(b), a.abs_diff(b));
            let entry = core::mem::take(&mut self.matrix[row][column]);
            self.solution[b] -= entry * value;
        }
        self.matrix[a][0] = 1.0;
        self.solution[a] = value;
    }

    /// Cholesky's factor, and the solution by it.
    fn solve(&mut self, width: usize) {
        let size = self.matrix.len();
        self.factor.clear();
        self.factor.extend_from_slice(&self.matrix);
        for a in 0..size {
            let reach = width.min(size - a);
            let lead = self.factor[a][0].max(RIDGE * RIDGE).sqrt();
            self.factor[a][0] = lead;
            (1..reach).for_each(|b| self.factor[a][b] /= lead);
            for b in 1..reach {
                for c in b..reach {
                    self.factor[a + b][c - b] -= self.factor[a][b] * self.factor[a][c];
                }
            }
        }
        substitute(&self.factor, width, &mut self.solution);
    }

    /// The inverse within the band, and its row q, after [`Window::solve`].
    fn invert(&mut self, q: usize, width: usize) {
        let size = self.matrix.len();
        self.influence.clear();
        self.influence.resize(size, 0.0);
        self.influence[q] = 1.0;
        substitute(&self.factor, width, &mut self.influence);
        for a in (0..size).rev() {
            let reach = width.min(size - a);
            let lead = self.factor[a][0];
            for b in (0..reach).rev() {
                let mut rest = if b == 0 { 1.0 / lead } else { 0.0 };
                for c in 1..reach {
                    let (low, high) = (b.min(c), b.max(c));
                    rest -= self.factor[a][c] * self.matrix[a + low][high - low];
                }
                self.matrix[a][b] = rest / lead;
            }
        }
    }

    /// vᵀ times the inverse times v, for numbers v from coefficient `at` on.
    #[inline(never)]
    fn form(&self, v: &[f64], at: usize) -> f64 {
        let mut sum = 0.0;
        for (a, &value) in v.iter().enumerate() {
            let row = &self.matrix[at + a];
            let beside: f64 = v[a + 1..].iter().zip(&row[1..]).map(|(v, entry)| v * entry).sum();
            sum += value * (value * row[0] + 2.0 * beside);
        }
        sum
    }

    /// By how much the squares grow if a jump has to vanish.
    fn worth(&self, jump: &Row, at: usize, degree: usize) -> f64 {
        let jump = &jump[..degree + 2];
        let size: f64 = jump.iter().zip(&self.solution[at..]).map(|(a, b)| a * b).sum();
        size * size / self.form(jump, at).max(f64::MIN_POSITIVE)
    }

    /// By how much the window's own coefficient changes for one point.
    fn change(&self, values: &Values, at: usize, degree: usize, y: f64) -> f64 {
        let values = &values[..=degree];
        let along = |list: &[f64]| -> f64 { values.iter().zip(&list[at..]).map(|(a, b)| a * b).sum() };
        let rest = 1.0 - self.form(values, at);
        along(&self.influence) * (y - along(&self.solution)) / rest.max(1e-9)
    }
}

fn substitute(factor: &[Row], width: usize, x: &mut [f64]) {
    let size = x.len();
    for a in 0..size {
        x[a] /= factor[a][0];
        for b in 1..width.min(size - a) {
            x[a + b] -= factor[a][b] * x[a];
        }
    }
    for a in (0..size).rev() {
        let known: f64 = (1..width.min(size - a)).map(|b| factor[a][b] * x[a + b]).sum();
        x[a] = (x[a] - known) / factor[a][0];
    }
}
