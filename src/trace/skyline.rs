//! Symmetric positive definite systems whose rows begin late: only the entries from a row's first on are kept.

use crate::error::Result;
use crate::limits::{filled, with_room};

/// The lower triangle, row by row from each row's first entry to the diagonal.
#[derive(Debug)]
pub(super) struct Skyline {
    first: Vec<usize>,
    /// Where row i would have its entry 0: its entry j is at `base[i] + j`.
    base: Vec<isize>,
    values: Vec<f64>,
}

impl Skyline {
    /// Zeros, with the first column of every row.
    pub(super) fn new(first: Vec<usize>) -> Result<Self> {
        let mut base = with_room(first.len())?;
        let mut size = 0;
        for (i, &start) in first.iter().enumerate() {
            base.push(size as isize - start as isize);
            size += i + 1 - start;
        }
        Ok(Self { first, base, values: filled(0.0, size)? })
    }

    /// Adds to entry (row, column), column ≤ row.
    pub(super) fn add(&mut self, row: usize, column: usize, value: f64) {
        self.values[(self.base[row] + column as isize) as usize] += value;
    }

    fn row(&self, i: usize, from: usize, to: usize) -> &[f64] {
        &self.values[(self.base[i] + from as isize) as usize..(self.base[i] + to as isize) as usize]
    }

    /// Cholesky's factor in place. A pivot that is lost is replaced by one: its unknown stays where it is.
    pub(super) fn factor(&mut self) {
        for (i, &first) in self.first.iter().enumerate() {
            let (before, rest) = self.values.split_at_mut((self.base[i] + first as isize) as usize);
            let row = &mut rest[..=i - first];
            for j in first..i {
                let other = self.first[j];
                let from = first.max(other);
                let start = (self.base[j] + from as isize) as usize;
                let above = &before[start..=start + j - from];
                let known = product(&row[from - first..j - first], above);
                row[j - first] = (row[j - first] - known) / above[j - from];
            }
            let own = row[i - first] - product(&row[..i - first], &row[..i - first]);
            row[i - first] = if own > 1e-14 { own.sqrt() } else { 1.0 };
        }
    }

    /// Solves with the factor, in place.
    pub(super) fn solve(&self, x: &mut [f64]) {
        let diagonal = |i: usize| self.values[(self.base[i] + i as isize) as usize];
        for i in 0..x.len() {
            let from = self.first[i];
            let known = product(self.row(i, from, i), &x[from..i]);
            x[i] = (x[i] - known) / diagonal(i);
        }
        for i in (0..x.len()).rev() {
            x[i] /= diagonal(i);
            let (value, from) = (x[i], self.first[i]);
            for (entry, below) in self.row(i, from, i).iter().zip(&mut x[from..i]) {
                *below -= entry * value;
            }
        }
    }
}

/// The scalar product of a row with the beginning of another: in pairs, as two numbers fit into one register.
fn product(a: &[f64], b: &[f64]) -> f64 {
    let b = &b[..a.len()];
    let (mut sums, mut k) = ([0.0; 2], 0);
    while k + 1 < a.len() {
        sums[0] += a[k] * b[k];
        sums[1] += a[k + 1] * b[k + 1];
        k += 2;
    }
    let sum = sums[0] + sums[1];
    if k < a.len() { sum + a[k] * b[k] } else { sum }
}
