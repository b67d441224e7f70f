//! Symmetric positive definite systems whose rows end early: only the entries up to a row's last are kept.

use crate::error::Result;
use crate::limits::refill;

/// The upper triangle, row by row from the diagonal to each row's last entry; room that is used for one system after another.
#[derive(Debug, Default)]
pub(super) struct Skyline {
    last: Vec<usize>,
    /// Where each row begins, at its diagonal.
    start: Vec<usize>,
    values: Vec<f64>,
    /// One over each pivot.
    inverse: Vec<f64>,
}

impl Skyline {
    /// Begins a system of so many unknowns. The last column of every row is to be written into what this returns: each is its own so far.
    pub(super) fn begin(&mut self, count: usize) -> Result<&mut [usize]> {
        refill(&mut self.last, 0, count)?;
        self.last.iter_mut().enumerate().for_each(|(i, last)| *last = i);
        Ok(&mut self.last)
    }

    /// Makes room: all entries are 0.
    pub(super) fn lay_out(&mut self) -> Result<()> {
        refill(&mut self.start, 0, self.last.len())?;
        let (mut size, mut most) = (0, 0);
        for (i, (last, start)) in self.last.iter_mut().zip(&mut self.start).enumerate() {
            // What a row has, those that it takes part in will have: ends never fall.
            most = most.max(*last);
            *last = most;
            *start = size;
            size += most + 1 - i;
        }
        refill(&mut self.inverse, 1.0, self.last.len())?;
        refill(&mut self.values, 0.0, size)
    }

    /// Adds to the entry of two unknowns.
    #[inline(always)]
    pub(super) fn add(&mut self, one: usize, other: usize, value: f64) {
        let (row, further) = (one.min(other), one.abs_diff(other));
        self.values[self.start[row] + further] += value;
    }

    /// Gauss's elimination in place. A pivot that is lost is replaced by one: its unknown stays where it is.
    pub(super) fn factor(&mut self) {
        for (i, &start) in self.start.iter().enumerate() {
            let width = self.last[i] + 1 - i;
            let (done, below) = self.values.split_at_mut(start + width);
            let row = &mut done[start..];
            if row[0] <= 1e-14 {
                row[0] = 1.0;
            }
            let inverse = 1.0 / row[0];
            self.inverse[i] = inverse;
            for k in 1..width {
                let share = row[k] * inverse;
                let from = self.start[i + k] - (start + width);
                let other = &mut below[from..from + width - k];
                for (entry, above) in other.iter_mut().zip(&row[k..]) {
                    *entry -= share * above;
                }
            }
        }
    }

    /// Solves after the elimination, in place.
    pub(super) fn solve(&self, x: &mut [f64]) {
        let row = |i: usize| &self.values[self.start[i]..][1..=self.last[i] - i];
        for i in 0..x.len() {
            let value = x[i] * self.inverse[i];
            x[i] = value;
            let row = row(i);
            // Below, a row's share of what is above it.
            for (entry, below) in row.iter().zip(&mut x[i + 1..]) {
                *below -= entry * value;
            }
        }
        for i in (0..x.len()).rev() {
            let known: f64 = row(i).iter().zip(&x[i + 1..]).map(|(entry, value)| entry * value).sum();
            x[i] -= known * self.inverse[i];
        }
    }
}
