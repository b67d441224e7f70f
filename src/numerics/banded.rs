//! Symmetric positive definite systems whose matrix is a band with a border: splines on a line have the band,
//! splines on a circle the border too.

mod known_shape;
mod points;

use super::Vector;
use super::lists::dot;
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

/// The inverse of what replaces a pivot that vanished: the unknown is held at zero.
const HELD: f64 = 1e-300;

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
        matrix.corner = limits::filled(0.0, border.saturating_mul(border))?;
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

    /// Adds to the entries (i, j) and (j, i), which are one; i = j counts once. Entries outside the shape are ignored.
    #[inline]
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        let (row, column) = if i >= j { (i, j) } else { (j, i) };
        if let Some(place) = self.place(row, column) {
            *place += value;
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

    /// The factors L D L′, in place: of each pivot its inverse, and under it L D, which is what the elimination leaves
    /// there. Neither roots nor divisions are then on the way from one unknown to the next. A pivot of at most `floor`
    /// times what stood on the diagonal holds its unknown at zero; how many did is the answer. O(n·(half + border)²).
    pub fn factor(&mut self, floor: f64) -> usize {
        let border = self.border;
        let diagonal: Vec<f64> = (0..border).map(|i| self.corner[i * border + i]).collect();
        let mut held = match self.shape() {
            (5, 4) => known_shape::factor::<5, 4, 10>(&mut self.columns, &mut self.corner, floor),
            (9, 8) => known_shape::factor::<9, 8, 18>(&mut self.columns, &mut self.corner, floor),
            _ => self.factor_band(floor),
        };
        for (j, own) in diagonal.iter().enumerate() {
            let (head, rest) = self.corner[j * border..].split_at_mut(border);
            held += usize::from(invert(&mut head[j], own * floor));
            for (k, column) in rest.chunks_exact_mut(border).enumerate() {
                let first = j + 1 + k;
                subtract(&mut column[first..], head[first] * head[j], &head[first..]);
            }
        }
        held
    }

    /// Width of the band and size of the border, where there are code for their loops and as many columns as it needs.
    fn shape(&self) -> (usize, usize) {
        if self.band.is_multiple_of(2) { (self.half, self.border) } else { (0, 0) }
    }

    /// The elimination of the band, for any shape.
    #[allow(clippy::needless_range_loop, reason = "matrices are written with their indices")]
    fn factor_band(&mut self, floor: f64) -> usize {
        let (stride, half, border) = (self.stride(), self.half, self.border);
        let least = least_pivots(&self.columns, stride, floor);
        let mut held = 0;
        // Two columns at a time: what they take from those behind them is taken in one pass.
        let mut j = 0;
        while j < self.band {
            let (head, rest) = self.columns[j * stride..].split_at_mut(stride);
            held += usize::from(invert(&mut head[0], least[j]));
            if j + 1 == self.band || half == 0 {
                for k in 0..border {
                    let factor = head[half + 1 + k] * head[0];
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
            let own = head[1] * head[0];
            subtract(&mut second[..half], own, &head[1..=half]);
            subtract(&mut second[half + 1..], own, &head[half + 1..]);
            held += usize::from(invert(&mut second[0], least[j + 1]));
            let inverses = (head[0], second[0]);
            let (head_border, second_border) = (&head[half + 1..], &second[half + 1..]);
            for (k, column) in rest.chunks_exact_mut(stride).take(half).enumerate() {
                let coupled = head.get(k + 2).copied().unwrap_or(0.0) * in_band(k + 2, half);
                let (a, b) = (coupled * inverses.0, second[k + 1] * inverses.1);
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
                let (a, b) = (head_border[k] * inverses.0, second_border[k] * inverses.1);
                let column = &mut self.corner[k * border + k..(k + 1) * border];
                subtract_two(column, a, &head_border[k..], b, &second_border[k..]);
            }
            j += 2;
        }
        held
    }

    /// Solves with the factors, in place. O(n·(half + border)).
    pub fn solve(&self, right: &mut [f64]) {
        let (band, border) = right.split_at_mut(self.band);
        match self.shape() {
            (5, 4) => known_shape::forward::<5, 4, 10>(&self.columns, band, border),
            (9, 8) => known_shape::forward::<9, 8, 18>(&self.columns, band, border),
            _ => self.forward(band, border),
        }
        for j in 0..self.border {
            let column = &self.corner[j * self.border..][..self.border];
            let value = border[j] * column[j];
            border[j] = value;
            subtract(&mut border[j + 1..], value, &column[j + 1..]);
        }
        for j in (0..self.border).rev() {
            let column = &self.corner[j * self.border..][..self.border];
            border[j] -= dot(&border[j + 1..], &column[j + 1..]) * column[j];
        }
        match self.shape() {
            (5, 4) => known_shape::backward::<5, 4, 10>(&self.columns, band, border),
            (9, 8) => known_shape::backward::<9, 8, 18>(&self.columns, band, border),
            _ => self.backward(band, border),
        }
    }

    fn forward(&self, band: &mut [f64], border: &mut [f64]) {
        for (j, column) in self.columns.chunks_exact(self.stride()).enumerate() {
            let value = band[j] * column[0];
            band[j] = value;
            subtract(&mut band[j + 1..], value, &column[1..=self.half]);
            subtract(border, value, &column[self.half + 1..]);
        }
    }

    /// What was found last is added last: all other products do not wait for it.
    fn backward(&self, band: &mut [f64], border: &[f64]) {
        for (j, column) in self.columns.chunks_exact(self.stride()).enumerate().rev() {
            let mut known = dot(border, &column[self.half + 1..]);
            let near = self.half.min(self.band - 1 - j);
            for (value, weight) in band[j + 1..=j + near].iter().zip(&column[1..=near]).rev() {
                known += value * weight;
            }
            band[j] -= known * column[0];
        }
    }

    /// Adds the matrix times a list of points, before it is factored. O(n·(half + border)).
    pub fn times(&self, points: &[Vector], sum: &mut [Vector]) {
        let mut add = |i: usize, j: usize, value: f64| {
            sum[i] += points[j] * value;
            if i != j {
                sum[j] += points[i] * value;
            }
        };
        for (j, column) in self.columns.chunks_exact(self.stride()).enumerate() {
            let (band, border) = column.split_at(1 + self.half);
            for (i, value) in (j..self.band).zip(band) {
                add(i, j, *value);
            }
            for (i, value) in (self.band..).zip(border) {
                add(i, j, *value);
            }
        }
        for j in 0..self.border {
            for i in j..self.border {
                add(self.band + i, self.band + j, self.corner[j * self.border + i]);
            }
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

/// What the pivot of each column has to exceed.
fn least_pivots(columns: &[f64], stride: usize, floor: f64) -> Vec<f64> {
    columns.iter().step_by(stride).map(|diagonal| diagonal * floor).collect()
}

/// Puts its inverse in the place of a pivot, or holds the unknown where the pivot is not above `least`; answers
/// whether.
#[inline]
fn invert(pivot: &mut f64, least: f64) -> bool {
    let held = pivot.is_nan() || *pivot <= least.max(f64::MIN_POSITIVE);
    *pivot = if held { HELD } else { 1.0 / *pivot };
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

    #[test]
    fn a_border_whose_square_has_no_number_is_refused() {
        let side = 1 << (usize::BITS / 2);
        let refused = Bordered::new(0, 0, side).expect_err("more than there is memory for");
        assert!(matches!(*refused, crate::Error::OutOfMemory { .. }), "{refused}");
    }
}
