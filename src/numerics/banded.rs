//! Symmetric positive definite systems whose matrix is a band with a border: splines on a line have the band,
//! splines on a circle the border too.

use super::Vector;
use crate::error::Result;
use crate::limits;

/// A symmetric matrix of `band` unknowns that couple only within `half` of one another, and of `border` unknowns after
/// them that couple with everything. Only the lower triangle is kept, column by column, each column with its part of
/// the border behind it: the elimination then runs along memory.
#[derive(Clone, Debug, Default)]
pub struct Bordered {
    band: usize,
    half: usize,
    border: usize,
    columns: Vec<f64>,
    corner: Vec<f64>,
}

/// What replaces a pivot that vanished: the unknown is held at zero.
const HELD: f64 = 1e150;

impl Bordered {
    /// The zero matrix of that shape.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory): (band)(1 + half + border) + border² numbers are kept.
    pub fn new(band: usize, half: usize, border: usize) -> Result<Self> {
        let half = half.min(band.saturating_sub(1));
        let mut matrix = Self { band, half, border, ..Self::default() };
        matrix.columns = limits::filled(0.0, band.saturating_mul(matrix.stride()))?;
        matrix.corner = limits::filled(0.0, border * border)?;
        Ok(matrix)
    }

    /// The zero matrix of `count` unknowns on a line or a circle, each coupled with the `reach` next to it on either
    /// side. On a circle the last `reach` unknowns are the border; where that is most of them, all of them are.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub fn ring(count: usize, reach: usize, closed: bool) -> Result<Self> {
        if closed && count <= 3 * reach {
            Self::new(0, 0, count)
        } else if closed {
            Self::new(count - reach, reach, reach)
        } else {
            Self::new(count, reach, 0)
        }
    }

    fn stride(&self) -> usize {
        1 + self.half + self.border
    }

    /// How many unknowns there are.
    pub fn len(&self) -> usize {
        self.band + self.border
    }

    /// Whether there is no unknown.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Makes every entry zero.
    pub fn clear(&mut self) {
        self.columns.fill(0.0);
        self.corner.fill(0.0);
    }

    /// Copies the entries of a matrix of the same shape.
    pub fn copy_from(&mut self, other: &Self) {
        self.columns.copy_from_slice(&other.columns);
        self.corner.copy_from_slice(&other.corner);
    }

    /// Adds to the entries (i, j) and (j, i), which are one; i = j counts once. Entries outside the shape are ignored.
    #[inline]
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        let (row, column) = if i >= j { (i, j) } else { (j, i) };
        if let Some(place) = self.place(row, column) {
            *place += value;
        }
    }

    /// Adds a symmetric 2 × 2 block (xx, xy, yy) to the rows 2i, 2i + 1 and columns 2j, 2j + 1, and its mirror image.
    #[inline]
    pub fn add_block(&mut self, i: usize, j: usize, [xx, xy, yy]: [f64; 3]) {
        let (row, column) = if i >= j { (2 * i, 2 * j) } else { (2 * j, 2 * i) };
        let stride = self.stride();
        if row == column || column >= self.band {
            self.add(row, column, xx);
            self.add(row + 1, column, xy);
            self.add(row + 1, column + 1, yy);
            if row != column {
                self.add(row, column + 1, xy);
            }
            return;
        }
        // Both columns are in the band, and both rows are or neither is.
        let first = if row >= self.band { 1 + self.half + row - self.band } else { row - column };
        let second = if row >= self.band { first } else { first - 1 };
        if let Some(place) = self.columns.get_mut(column * stride + first..column * stride + first + 2) {
            place[0] += xx;
            place[1] += xy;
        }
        let start = (column + 1) * stride + second;
        if let Some(place) = self.columns.get_mut(start..start + 2) {
            place[0] += xy;
            place[1] += yy;
        }
    }

    #[inline]
    fn place(&mut self, row: usize, column: usize) -> Option<&mut f64> {
        let stride = self.stride();
        if column >= self.band {
            self.corner.get_mut((column - self.band) * self.border + row - self.band)
        } else if row >= self.band {
            self.columns.get_mut(column * stride + 1 + self.half + row - self.band)
        } else if row - column <= self.half {
            self.columns.get_mut(column * stride + row - column)
        } else {
            None
        }
    }

    /// Cholesky's factors, in place. A pivot of at most `floor` times what stood on the diagonal holds its unknown at
    /// zero; how many did is the answer. O(n·(half + border)²).
    #[allow(clippy::needless_range_loop, reason = "matrices are written with their indices")]
    pub fn factor(&mut self, floor: f64) -> usize {
        let (stride, half, border) = (self.stride(), self.half, self.border);
        let diagonal: Vec<f64> = (0..border).map(|i| self.corner[i * border + i]).collect();
        let mut least: Vec<f64> = self.columns.iter().step_by(stride).map(|d| d * floor).collect();
        least.resize(self.band, 0.0);
        let mut held = 0;
        // Two columns at a time: what they take from those behind them is taken in one pass.
        let mut j = 0;
        while j < self.band {
            let (head, rest) = self.columns[j * stride..].split_at_mut(stride);
            held += usize::from(scale_by_pivot(head, 0, least[j]));
            if j + 1 == self.band || half == 0 {
                for k in 0..border {
                    let factor = head[half + 1 + k];
                    subtract(
                        &mut self.corner[k * border + k..(k + 1) * border],
                        factor,
                        &head[half + 1 + k..],
                    );
                }
                j += 1;
                continue;
            }
            let (second, rest) = rest.split_at_mut(stride);
            subtract(&mut second[..half], head[1], &head[1..=half]);
            subtract(&mut second[half + 1..], head[1], &head[half + 1..]);
            held += usize::from(scale_by_pivot(second, 0, least[j + 1]));
            let (head_border, second_border) = (&head[half + 1..], &second[half + 1..]);
            for (k, column) in rest.chunks_exact_mut(stride).take(half).enumerate() {
                let (a, b) = (head.get(k + 2).copied().unwrap_or(0.0) * in_band(k + 2, half), second[k + 1]);
                if k + 2 <= half {
                    subtract_two(
                        &mut column[..half - 1 - k],
                        a,
                        &head[k + 2..=half],
                        b,
                        &second[k + 1..half],
                    );
                }
                column[half - 1 - k] -= b * second[half];
                subtract_two(&mut column[half + 1..], a, head_border, b, second_border);
            }
            for k in 0..border {
                let (a, b) = (head_border[k], second_border[k]);
                let column = &mut self.corner[k * border + k..(k + 1) * border];
                subtract_two(column, a, &head_border[k..], b, &second_border[k..]);
            }
            j += 2;
        }
        for j in 0..border {
            let (head, rest) = self.corner[j * border..].split_at_mut(border);
            held += usize::from(scale_by_pivot(head, j, diagonal[j] * floor));
            for (k, column) in rest.chunks_exact_mut(border).enumerate() {
                let first = j + 1 + k;
                subtract(&mut column[first..], head[first], &head[first..]);
            }
        }
        held
    }

    /// Solves with the factors, in place. O(n·(half + border)).
    pub fn solve(&self, right: &mut [f64]) {
        let (stride, half) = (self.stride(), self.half);
        let (band, border) = right.split_at_mut(self.band);
        for (j, column) in self.columns.chunks_exact(stride).enumerate() {
            let value = band[j] / column[0];
            band[j] = value;
            subtract(&mut band[j + 1..], value, &column[1..=half]);
            subtract(border, value, &column[half + 1..]);
        }
        for j in 0..self.border {
            let column = &self.corner[j * self.border..][..self.border];
            let value = border[j] / column[j];
            border[j] = value;
            subtract(&mut border[j + 1..], value, &column[j + 1..]);
        }
        for j in (0..self.border).rev() {
            let column = &self.corner[j * self.border..][..self.border];
            border[j] = (border[j] - dot(&border[j + 1..], &column[j + 1..])) / column[j];
        }
        for (j, column) in self.columns.chunks_exact(stride).enumerate().rev() {
            let known = dot(&band[j + 1..], &column[1..=half]) + dot(border, &column[half + 1..]);
            band[j] = (band[j] - known) / column[0];
        }
    }

    /// Solves for both coordinates of points that share the matrix.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub fn solve_points(&self, right: &mut [Vector]) -> Result<()> {
        for axis in 0..2 {
            let mut line = limits::with_room(right.len())?;
            line.extend(right.iter().map(|v| v[axis]));
            self.solve(&mut line);
            for (point, value) in right.iter_mut().zip(&line) {
                point[axis] = *value;
            }
        }
        Ok(())
    }
}

/// Divides a column by the root of its pivot, or holds the unknown where the pivot is not above `least`.
#[inline]
fn scale_by_pivot(column: &mut [f64], at: usize, least: f64) -> bool {
    let pivot = column[at];
    let held = pivot.is_nan() || pivot <= least.max(f64::MIN_POSITIVE);
    let root = if held { HELD } else { pivot.sqrt() };
    column[at] = root;
    let inverse = 1.0 / root;
    for value in &mut column[at + 1..] {
        *value *= inverse;
    }
    held
}

#[inline]
fn subtract(from: &mut [f64], factor: f64, values: &[f64]) {
    for (target, value) in from.iter_mut().zip(values) {
        *target -= factor * value;
    }
}

#[inline]
fn subtract_two(from: &mut [f64], a: f64, u: &[f64], b: f64, v: &[f64]) {
    for ((target, x), y) in from.iter_mut().zip(u).zip(v) {
        *target -= a * x + b * y;
    }
}

/// One for entries of the band, zero for those behind it.
#[inline]
fn in_band(entry: usize, half: usize) -> f64 {
    if entry <= half { 1.0 } else { 0.0 }
}

#[inline]
fn dot(u: &[f64], v: &[f64]) -> f64 {
    u.iter().zip(v).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::Bordered;

    /// A diagonally dominant matrix of that shape, dense, and the same in its own storage.
    #[allow(clippy::needless_range_loop, reason = "matrices are written with their indices")]
    fn example(count: usize, reach: usize, closed: bool) -> (Vec<Vec<f64>>, Bordered) {
        let mut dense = vec![vec![0.0; count]; count];
        let mut matrix = Bordered::ring(count, reach, closed).expect("small");
        for i in 0..count {
            for step in 0..=reach {
                let j = if closed { (i + step) % count } else { i + step };
                if j >= count {
                    continue;
                }
                let value =
                    if step == 0 { 4.0 * (reach + 1) as f64 } else { 1.0 / (1 + i + 2 * j) as f64 - 0.3 };
                matrix.add(i, j, value);
                dense[i][j] += value;
                if i != j {
                    dense[j][i] += value;
                }
            }
        }
        (dense, matrix)
    }

    #[test]
    fn systems_of_any_shape_are_solved() {
        for closed in [false, true] {
            for count in 1..24 {
                for reach in 0..5.min(count) {
                    let (dense, mut matrix) = example(count, reach, closed);
                    let x: Vec<f64> = (0..count).map(|i| 1.0 + (i * i % 7) as f64).collect();
                    let mut right: Vec<f64> =
                        dense.iter().map(|row| row.iter().zip(&x).map(|(a, b)| a * b).sum()).collect();
                    assert_eq!(matrix.factor(1e-12), 0, "positive definite");
                    matrix.solve(&mut right);
                    for (found, expected) in right.iter().zip(&x) {
                        assert!(
                            (found - expected).abs() < 1e-12,
                            "{count} unknowns, reach {reach}, {closed}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn an_unknown_that_nothing_determines_stays_at_zero() {
        let mut matrix = Bordered::ring(2, 1, false).expect("small");
        for (i, j) in [(0, 0), (0, 1), (1, 1)] {
            matrix.add(i, j, 1.0);
        }
        let mut right = [3.0, 3.0];
        assert_eq!(matrix.factor(1e-12), 1, "the rank is one");
        matrix.solve(&mut right);
        assert!((right[0] - 3.0).abs() < 1e-12 && right[1].abs() < 1e-12, "{right:?}");
    }
}
