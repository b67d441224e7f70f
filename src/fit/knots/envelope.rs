//! Symmetric positive definite systems stored row by row from their first entry: bands, and bands with a border.
//!
//! A closed spline's equations are a band whose last rows reach back to the first column. In an envelope that is
//! nothing special: those rows are long.

/// A symmetric matrix, then its Cholesky factor in the same place.
#[derive(Clone, Debug, Default)]
pub(in crate::fit) struct Envelope {
    /// Where row i's first entry is kept; entry (i, j) is at `start[i] + j − first[i]`.
    start: Vec<usize>,
    first: Vec<usize>,
    entries: Vec<f64>,
}

impl Envelope {
    /// Zeros, with row i reaching back to column `first[i] ≤ i`.
    pub(in crate::fit) fn new(first: Vec<usize>) -> Self {
        let mut start = Vec::with_capacity(first.len());
        let mut size = 0;
        for (i, &f) in first.iter().enumerate() {
            start.push(size);
            size += i + 1 - f;
        }
        Self { start, first, entries: vec![0.0; size] }
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

    /// The diagonal entry of row i.
    pub(in crate::fit) fn diagonal(&self, i: usize) -> f64 {
        self.entries[self.start[i] + i - self.first[i]]
    }

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
        self.forward_near(x, from, self.size());
    }

    /// [`Envelope::forward`] for the rows below `to` alone, the unknowns behind `from` being 0 before: what is left out
    /// has decayed where `to` is far behind the last entry that is not 0.
    pub(super) fn forward_near(&self, x: &mut [f64], from: usize, to: usize) {
        for i in from..to.min(self.size()) {
            let (f, row) = (self.first[i], self.row(i));
            let lo = f.max(from);
            let product = dot(&row[lo - f..i - f], &x[lo..i]);
            x[i] = (x[i] - product) / row[i - f];
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

/// The scalar product of two lists of one length.
#[inline(always)]
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::Envelope;

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
        matrix.solve(&mut right);
        for (got, expected) in right.iter().zip(&x) {
            assert!((got - expected).abs() < 1e-13, "{got} for {expected}");
        }
    }
}
