//! Symmetric positive definite systems whose rows end early: only the entries up to a row's last are kept.

use crate::error::Result;
use crate::limits::refill;
use wide::f64x2;

/// The upper triangle, row by row from the diagonal to each row's last entry; room that is used for one system after
/// another.
#[derive(Debug, Default)]
pub(super) struct Skyline {
    last: Vec<usize>,
    /// Where each row begins, at its diagonal.
    start: Vec<usize>,
    /// Behind every row a nought, so that two entries at a time may be one too many.
    values: Vec<f64>,
    /// One over each pivot.
    inverse: Vec<f64>,
}

impl Skyline {
    /// Begins a system of so many unknowns. The last column of every row is to be written into what this returns: each
    /// is its own so far.
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
            size += most + 2 - i;
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
        let mut i = 0;
        while let Some(&last) = self.last.get(i) {
            // The rows of a node's unknowns mostly end together, and then the rows below are gone through half as
            // often.
            if self.last.get(i + 1) == Some(&last) {
                self.eliminate_two(i);
                i += 2;
            } else {
                self.eliminate(i);
                i += 1;
            }
        }
    }

    /// Takes from the rows below what they share with row i.
    fn eliminate(&mut self, i: usize) {
        let width = self.last[i] + 1 - i;
        let (done, mut below) = self.values.split_at_mut(self.start[i] + width + 1);
        let row = &mut done[self.start[i]..];
        self.inverse[i] = invert(&mut row[0]);
        for k in 1..width {
            let share = row[k] * self.inverse[i];
            let (other, rest) = below.split_at_mut(self.last[i + k] + 2 - (i + k));
            other.iter_mut().zip(&row[k..]).for_each(|(entry, above)| *entry -= share * above);
            below = rest;
        }
    }

    /// The same of two rows that end together.
    fn eliminate_two(&mut self, i: usize) {
        let (start, width) = (self.start[i], self.last[i] + 1 - i);
        let (done, mut below) = self.values.split_at_mut(start + 2 * width + 1);
        let (row, next) = done[start..].split_at_mut(width + 1);
        let one = invert(&mut row[0]);
        let share = row[1] * one;
        next.iter_mut().zip(&row[1..]).for_each(|(entry, above)| *entry -= share * above);
        let two = invert(&mut next[0]);
        (self.inverse[i], self.inverse[i + 1]) = (one, two);
        for k in 2..width {
            let shares = [row[k] * one, next[k - 1] * two].map(f64x2::splat);
            let above = row[k..].as_chunks().0.iter().zip(next[k - 1..].as_chunks().0);
            let (other, rest) = below.split_at_mut(self.last[i + k] + 2 - (i + k));
            for (entries, (row, next)) in other.as_chunks_mut().0.iter_mut().zip(above) {
                let left = f64x2::new(*entries) - shares[0] * f64x2::new(*row);
                *entries = (left - shares[1] * f64x2::new(*next)).to_array();
            }
            below = rest;
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

/// One over a pivot.
fn invert(pivot: &mut f64) -> f64 {
    if *pivot <= 1e-14 {
        *pivot = 1.0;
    }
    1.0 / *pivot
}

#[cfg(test)]
mod tests {
    use super::Skyline;
    use crate::error::Result;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    #[test]
    fn systems_are_solved_whether_their_rows_end_together_or_one_by_one() -> Result<()> {
        // Where the rows end: in pairs, in threes, one after another, and all at the last.
        let shapes: [&[usize]; 4] =
            [&[3, 3, 5, 5, 6, 6, 6], &[4, 4, 4, 6, 6, 6, 6], &[1, 2, 3, 4, 5, 6, 6], &[6; 7]];
        for ends in shapes {
            let mut system = Skyline::default();
            system.begin(ends.len())?.copy_from_slice(ends);
            system.lay_out()?;
            let entry = |i: usize, j: usize| {
                let (low, high) = (i.min(j), i.max(j));
                let other = 1.0 / ((3 * low + 2 * high) as f64 + 1.5);
                if i == j {
                    4.0 + i as f64
                } else if high <= ends[low] {
                    other
                } else {
                    0.0
                }
            };
            for (i, &end) in ends.iter().enumerate() {
                (i..=end).for_each(|j| system.add(j, i, entry(i, j)));
            }
            let wanted: Vec<f64> = (0..ends.len()).map(|i| 1.0 - 0.3 * i as f64).collect();
            let product = |i: usize| wanted.iter().enumerate().map(|(j, x)| entry(i, j) * x).sum();
            let mut found: Vec<f64> = (0..ends.len()).map(product).collect();
            system.factor();
            system.solve(&mut found);
            for (found, wanted) in found.iter().zip(&wanted) {
                // The diagonal is larger than the rest of its row: no error grows.
                assert!((found - wanted).abs() < 1e-14, "{found} instead of {wanted}, rows to {ends:?}");
            }
        }
        Ok(())
    }
}
