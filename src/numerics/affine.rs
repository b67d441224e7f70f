//! Affine maps of the plane and of space, given by the matrices of graphics.

use crate::error::{Error, Result};
use crate::limits::{LARGEST_COORDINATE, check, settle};

/// How far the last row of a 4 × 4 matrix may be from 0, 0, 0, 1: products and inverses in single precision are off by
/// as much.
const ROUNDED: f64 = 1e-6;

/// An affine map: the columns of its matrix, and last where it takes the origin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Affine<'a> {
    matrix: &'a [f64],
    dimension: usize,
}

impl<'a> Affine<'a> {
    /// In the plane the map of the 6 numbers of an SVG matrix, in space that of the 16 of a 4 × 4 matrix, column by
    /// column.
    ///
    /// # Errors
    ///
    /// `matrix`: another length; an entry that is not finite; a last row other than 0, 0, 0, 1; a translation of what
    /// is not `movable`, as it does not keep constants.
    pub(crate) fn new(matrix: &'a [f64], dimension: usize, movable: bool) -> Result<Self> {
        let needed = if dimension == 2 { 6 } else { 16 };
        if matrix.len() != needed {
            return Err(Error::wrong_length("matrix", matrix.len(), needed));
        }
        let map = Self { matrix, dimension };
        for (i, &entry) in matrix.iter().enumerate() {
            let last = i >= dimension * map.rows();
            let (middle, slack) =
                if i % map.rows() == 3 { (f64::from(last), ROUNDED) } else { (0.0, f64::MAX) };
            check("matrix", Some(i), entry, middle - slack, middle + slack)?;
            if last && !movable && middle == 0.0 && entry != 0.0 {
                return Err(Error::degenerate("matrix", Some(i), "what has no root 0 cannot be moved"));
            }
        }
        Ok(map)
    }

    /// Numbers in a column.
    fn rows(self) -> usize {
        if self.dimension == 2 { 2 } else { 4 }
    }

    /// Puts the images of points, interleaved, in their place.
    ///
    /// # Errors
    ///
    /// `matrix` where an image is not within ±1e9.
    pub(crate) fn map_points(self, points: &mut [f64]) -> Result<()> {
        self.map(points, 1.0, LARGEST_COORDINATE)
    }

    /// The same of displacements and derivatives, which translations leave as they are, within ±`most`.
    ///
    /// # Errors
    ///
    /// `matrix` where an image is beyond.
    pub(crate) fn map_vectors(self, vectors: &mut [f64], most: f64) -> Result<()> {
        self.map(vectors, 0.0, most)
    }

    fn map(self, list: &mut [f64], shift: f64, most: f64) -> Result<()> {
        let column = |k: usize| &self.matrix[k * self.rows()..];
        for place in list.chunks_exact_mut(self.dimension) {
            let mut image = [0.0; 3];
            for (row, sum) in image[..self.dimension].iter_mut().enumerate() {
                for (k, x) in place.iter().enumerate() {
                    *sum += column(k)[row] * x;
                }
                *sum += shift * column(self.dimension)[row];
                if !(-most..=most).contains(sum) {
                    return Err(Error::out_of_range("matrix", None, *sum, -most, most));
                }
            }
            place.copy_from_slice(&image[..self.dimension]);
        }
        settle(list);
        Ok(())
    }
}
