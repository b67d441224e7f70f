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
        for i in 0..self.first.len() {
            for j in self.first[i]..=i {
                let from = self.first[i].max(self.first[j]);
                let known: f64 =
                    self.row(i, from, j).iter().zip(self.row(j, from, j)).map(|(a, b)| a * b).sum();
                let at = (self.base[i] + j as isize) as usize;
                let rest = self.values[at] - known;
                self.values[at] = if j < i {
                    rest / self.values[(self.base[j] + j as isize) as usize]
                } else if rest > 1e-14 {
                    rest.sqrt()
                } else {
                    1.0
                };
            }
        }
    }

    /// Solves with the factor, in place.
    pub(super) fn solve(&self, x: &mut [f64]) {
        let diagonal = |i: usize| self.values[(self.base[i] + i as isize) as usize];
        for i in 0..x.len() {
            let from = self.first[i];
            let known: f64 = self.row(i, from, i).iter().zip(&x[from..i]).map(|(a, b)| a * b).sum();
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
