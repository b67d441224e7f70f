//! Both coordinates of points in one system: rows 2i and 2i + 1 belong to point i.

use super::Bordered;
use crate::error::Result;

impl Bordered {
    /// The zero matrix for both coordinates of points that couple as the unknowns of this one do: rows 2i and 2i + 1
    /// belong to point i.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub(crate) fn of_points(&self) -> Result<Self> {
        Self::new(2 * self.band, 2 * self.half + 1, 2 * self.border)
    }

    /// Every entry of the matrix of one coordinate, for both of them; the shape is that of [`Bordered::of_points`].
    pub(crate) fn copy_to_points(&self, points: &mut Self) {
        let (single, double) = (self.stride(), points.stride());
        let columns = self.columns.chunks_exact(single).zip(points.columns.chunks_exact_mut(2 * double));
        for (column, pair) in columns {
            let (x, y) = pair.split_at_mut(double);
            let (band, border) = column.split_at(1 + self.half);
            let (x_band, x_border) = x.split_at_mut(1 + points.half);
            let (y_band, y_border) = y.split_at_mut(1 + points.half);
            for ((x, y), &value) in x_band.chunks_exact_mut(2).zip(y_band.chunks_exact_mut(2)).zip(band) {
                (x[0], x[1], y[0], y[1]) = (value, 0.0, value, 0.0);
            }
            for ((x, y), &value) in x_border.chunks_exact_mut(2).zip(y_border.chunks_exact_mut(2)).zip(border)
            {
                (x[0], x[1], y[0], y[1]) = (value, 0.0, 0.0, value);
            }
        }
        for j in 0..self.border {
            for i in j..self.border {
                let (value, row) = (self.corner[j * self.border + i], points.border);
                let place = 2 * j * row + 2 * i;
                points.corner[place..place + 2].copy_from_slice(&[value, 0.0]);
                points.corner[place + row..place + row + 2].copy_from_slice(&[0.0, value]);
            }
        }
    }

    /// Adds weightsᵢ weightsⱼ times a symmetric 2 × 2 matrix (xx, xy, yy) for the points from `first` on, all in the
    /// band and within its width of one another. Answers whether they are; nothing is added otherwise.
    #[inline]
    pub(crate) fn add_outer(&mut self, first: usize, weights: &[f64], [xx, xy, yy]: [f64; 3]) -> bool {
        let (count, stride) = (weights.len(), self.stride());
        if 2 * (first + count) > self.band || 2 * count > 1 + self.half {
            return false;
        }
        let pairs = self.columns[2 * first * stride..].chunks_exact_mut(2 * stride);
        for (b, (pair, &own)) in pairs.zip(weights).enumerate() {
            let (x, y) = pair.split_at_mut(stride);
            let (along_x, across, along_y) = (own * xx, own * xy, own * yy);
            for (place, &weight) in x.chunks_exact_mut(2).zip(&weights[b..]) {
                place[0] += weight * along_x;
                place[1] += weight * across;
            }
            y[0] += own * along_y;
            for (place, &weight) in y[1..].chunks_exact_mut(2).zip(&weights[b + 1..]) {
                place[0] += weight * across;
                place[1] += weight * along_y;
            }
        }
        true
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
}
