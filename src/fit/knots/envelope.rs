//! Symmetric positive definite systems stored row by row from their first entry: bands, and bands with a border.
//!
//! A closed spline's equations are a band whose last rows reach back to the first column. In an envelope that is
//! nothing special: those rows are long.

use crate::numerics::lists::{add_scaled, dot};
use crate::numerics::pair::Pair;

/// A symmetric matrix, then its Cholesky factor in the same place.
#[derive(Clone, Debug, Default)]
pub(in crate::fit) struct Envelope {
    /// Where row i's first entry is kept; entry (i, j) is at `start[i] + j − first[i]`.
    start: Vec<usize>,
    first: Vec<usize>,
    entries: Vec<f64>,
    /// From this row on they reach farther back than the row before, all other rows by at most so many columns.
    border: usize,
    reach: usize,
}

/// What is left of a solution, in units of its largest entry, where it has decayed.
const DECAYED: f64 = 1e-10;
/// Rows of the border that are so many behind the last entry of a right side are left out: beside the seam of a closed
/// curve with many knots that makes a solution smaller than it is, and knots dearer that are soon judged again.
const FAR: usize = 40;

impl Envelope {
    /// Zeros, with row i reaching back to column `first[i] ≤ i`.
    pub(in crate::fit) fn new(first: Vec<usize>) -> Self {
        let mut start = Vec::with_capacity(first.len());
        let (mut size, mut border, mut reach) = (0, first.len(), 0);
        for (i, &f) in first.iter().enumerate() {
            start.push(size);
            size += i + 1 - f;
            if border == first.len() && i > 0 && f < first[i - 1] {
                border = i;
            }
            if border == first.len() {
                reach = reach.max(i - f);
            }
        }
        Self { start, first, entries: vec![0.0; size], border, reach }
    }

    /// How many unknowns there are.
    pub(in crate::fit) fn size(&self) -> usize {
        self.first.len()
    }

    /// Adds to the entry (i, j); one of (i, j) and (j, i) is kept, and only that one is to be added to.
    pub(in crate::fit) fn add(&mut self, i: usize, j: usize, value: f64) {
        if j <= i {
            self.entries[self.start[i] + j - self.first[i]] += value;
        }
    }

    /// Adds `times` some numbers to the first entries of row i, which reaches back to the first column.
    pub(super) fn add_to_row(&mut self, i: usize, numbers: &[f64], times: f64) {
        add_scaled(&mut self.entries[self.start[i]..self.start[i] + numbers.len()], times, numbers);
    }

    /// The diagonal entry of row i.
    pub(in crate::fit) fn diagonal(&self, i: usize) -> f64 {
        self.entries[self.start[i] + i - self.first[i]]
    }

    #[inline(always)]
    fn row(&self, i: usize) -> &[f64] {
        &self.entries[self.start[i]..=self.start[i] + i - self.first[i]]
    }

    /// Cholesky, in place. A pivot that rounding has made worthless becomes one: its unknown is then near 0.
    pub(in crate::fit) fn factor(&mut self) {
        for i in 0..self.size() {
            let (before, rest) = self.entries.split_at_mut(self.start[i]);
            let (f, row) = (self.first[i], &mut rest[..=i - self.first[i]]);
            for j in f..i {
                let (g, other) = (self.first[j], &before[self.start[j]..=self.start[j] + j - self.first[j]]);
                let from = f.max(g);
                let product = dot(&row[from - f..j - f], &other[from - g..j - g]);
                row[j - f] = (row[j - f] - product) / other[j - g];
            }
            let whole = row[i - f];
            let pivot = whole - dot(&row[..i - f], &row[..i - f]);
            row[i - f] = if pivot > 1e-14 * whole && pivot > 0.0 { pivot.sqrt() } else { 1e30 };
        }
    }

    /// Solves with the lower factor, from the first unknown that is not 0.
    pub(super) fn forward(&self, x: &mut [f64], from: usize) {
        for i in from..self.size() {
            let (f, row) = (self.first[i], self.row(i));
            let lo = f.max(from);
            let product = dot(&row[lo - f..i - f], &x[lo..i]);
            x[i] = (x[i] - product) / row[i - f];
        }
    }

    /// From this row on rows reach far back.
    pub(super) fn border(&self) -> usize {
        self.border
    }

    /// [`Envelope::forward`] where the entries of the right side outside the border lie in `from..=last`. Answers where
    /// the solution has decayed: from there to the border it is left 0.
    pub(super) fn forward_near(&self, x: &mut [f64], from: usize, last: usize) -> usize {
        let (mut end, mut peak, mut calm) = (from.min(self.border), 0.0_f64, 0);
        while end < self.border && (end <= last || calm < self.reach) {
            let (f, row) = (self.first[end], self.row(end));
            let lo = f.max(from);
            let product = dot(&row[lo - f..end - f], &x[lo..end]);
            let value = (x[end] - product) / row[end - f];
            x[end] = value;
            if value.abs() > peak {
                peak = value.abs();
            }
            calm = if value.abs() <= DECAYED * peak { calm + 1 } else { 0 };
            end += 1;
        }
        for i in self.border..self.size().min(last + FAR) {
            let (f, row) = (self.first[i], self.row(i));
            let lo = f.max(from);
            let near = if lo < end { dot(&row[lo - f..end - f], &x[lo..end]) } else { 0.0 };
            let own = f.max(self.border);
            x[i] = (x[i] - near - dot(&row[own - f..i - f], &x[own..i])) / row[i - f];
        }
        end
    }

    /// Solves the factored system for two right sides at once.
    pub(super) fn solve_both(&self, x: &mut [Pair]) {
        let zero = Pair::twice(0.0);
        for i in 0..self.size() {
            let (f, row) = (self.first[i], self.row(i));
            let terms = row.iter().zip(&x[f..i]);
            let product = terms.fold(zero, |sum, (entry, x)| sum + Pair::twice(*entry) * *x);
            x[i] = (x[i] - product) / Pair::twice(row[i - f]);
        }
        for i in (0..self.size()).rev() {
            let (f, row) = (self.first[i], self.row(i));
            let value = x[i] / Pair::twice(row[i - f]);
            x[i] = value;
            for (x, entry) in x[f..i].iter_mut().zip(row) {
                *x = *x - Pair::twice(*entry) * value;
            }
        }
    }

    /// Solves with the upper factor: x ← R⁻¹x.
    pub(super) fn backward(&self, x: &mut [f64]) {
        for i in (0..self.size()).rev() {
            let (f, row) = (self.first[i], self.row(i));
            let value = x[i] / row[i - f];
            x[i] = value;
            for (x, entry) in x[f..i].iter_mut().zip(row) {
                *x -= entry * value;
            }
        }
    }

    /// Solves the factored system in place.
    pub(in crate::fit) fn solve(&self, x: &mut [f64]) {
        self.forward(x, 0);
        self.backward(x);
    }
}

#[cfg(test)]
mod tests {
    use super::{Envelope, FAR, Pair};

    #[test]
    fn a_band_with_a_border_is_solved() {
        let n = 9;
        let first: Vec<usize> = (0..n).map(|i: usize| if i >= 7 { 0 } else { i.saturating_sub(2) }).collect();
        let mut matrix = Envelope::new(first.clone());
        let value =
            |i: usize, j: usize| if i == j { 9.0 + i as f64 } else { 1.0 / (1.0 + (i + 2 * j) as f64) };
        let x: Vec<f64> = (0..n).map(|i| 1.0 - 0.3 * i as f64).collect();
        let mut right = vec![0.0; n];
        for i in 0..n {
            for j in first[i]..=i {
                matrix.add(i, j, value(i, j));
                right[i] += value(i, j) * x[j];
                if j < i {
                    right[j] += value(i, j) * x[i];
                }
            }
        }
        matrix.factor();
        let mut both: Vec<Pair> = right.iter().map(|&value| Pair::new(value, -2.0 * value)).collect();
        matrix.solve_both(&mut both);
        matrix.solve(&mut right);
        for ((got, both), expected) in right.iter().zip(&both).zip(&x) {
            assert!((got - expected).abs() < 1e-13, "{got} for {expected}");
            assert_eq!((both.first(), both.second()), (*got, -2.0 * got), "two at once are the same");
        }
    }

    #[test]
    fn what_has_decayed_is_not_looked_for() {
        let n = 70;
        let mut matrix =
            Envelope::new((0..n).map(|i: usize| if i >= n - 2 { 0 } else { i.saturating_sub(2) }).collect());
        for i in 0..n {
            for (back, value) in [(0, 4.0), (1, 1.0), (2, 0.4)] {
                let j = (i + n - back) % n;
                matrix.add(i.max(j), i.min(j), value);
            }
        }
        matrix.factor();
        for (from, last) in [(0, 3), (20, 24), (60, 67), (66, 69)] {
            let mut whole = vec![0.0; n];
            whole[from..=last].fill(1.0);
            let mut near = whole.clone();
            matrix.forward(&mut whole, 0);
            let end = matrix.forward_near(&mut near, from, last);
            assert!(end <= matrix.border() && (from > 20 || end < 60), "{from}: to {end}");
            // A border far behind is left out.
            let counted = if last + FAR < n { matrix.border() } else { n };
            for (i, (got, expected)) in near.iter().zip(&whole).take(counted).enumerate() {
                assert!((got - expected).abs() < 1e-9, "{from}: {got} for {expected} at {i}");
            }
        }
    }
}
