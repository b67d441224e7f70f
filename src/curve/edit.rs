//! Changes of a curve: every one gives a new curve and leaves the old one as it was.

use super::hermite::{HermiteCurve, HermiteOptions, Side};
use crate::error::{Error, Result};
use crate::numerics::{Point, Vector};

impl HermiteCurve {
    /// The curve with point i at `point`; its tangents stay.
    ///
    /// # Errors
    ///
    /// An index beyond the last point; a coordinate that is not finite or beyond ±1e9.
    pub fn with_point(&self, i: usize, point: Point) -> Result<Self> {
        self.check_index(i)?;
        let mut options = self.to_options();
        options.points[i] = point;
        Self::new(options)
    }

    /// The curve with another derivative at point i, on one side or on both.
    ///
    /// # Errors
    ///
    /// An index beyond the last point; a component that is not finite or beyond ±1e9.
    pub fn with_tangent(&self, i: usize, tangent: Vector, side: Side) -> Result<Self> {
        self.check_index(i)?;
        let mut options = self.to_options();
        if side != Side::In {
            options.tangents[i] = tangent;
        }
        if side != Side::Out {
            options.tangents_in[i] = tangent;
        }
        Self::new(options)
    }

    /// The curve run through backwards: `reversed.evaluate(t)` is `self.evaluate(end − t)`.
    ///
    /// A closed curve still starts at point 0. Twice reversed it is the old curve to the last bit.
    pub fn reversed(&self) -> Self {
        let mut options = self.to_options();
        let from = usize::from(self.is_closed());
        let HermiteOptions { points, tangents, tangents_in, omega, lengths, .. } = &mut options;
        core::mem::swap(tangents, tangents_in);
        for tangent in tangents.iter_mut().chain(tangents_in.iter_mut()) {
            *tangent = -*tangent;
        }
        points[from..].reverse();
        tangents[from..].reverse();
        tangents_in[from..].reverse();
        omega.reverse();
        lengths.reverse();
        // The same numbers in another order pass the same checks.
        Self::new(options).unwrap_or_else(|_| self.clone())
    }

    /// The image under (x, y) ↦ (a·x + c·y + e, b·x + d·y + f), with the matrix in SVG's order a b c d e f.
    ///
    /// Exact: the spaces contain the constants, so an affine map acts on points and tangents alone.
    ///
    /// # Errors
    ///
    /// An entry that is not finite; an image that leaves ±1e9.
    pub fn transformed(&self, matrix: [f64; 6]) -> Result<Self> {
        if let Some(i) = matrix.iter().position(|entry| !entry.is_finite()) {
            return Err(Error::NotFinite { argument: "matrix", index: Some(i) });
        }
        let [a, b, c, d, e, f] = matrix;
        let linear = |v: &Vector| Vector::new(a * v.x + c * v.y, b * v.x + d * v.y);
        let mut options = self.to_options();
        for point in &mut options.points {
            *point = linear(point) + Vector::new(e, f);
        }
        for tangent in options.tangents.iter_mut().chain(&mut options.tangents_in) {
            *tangent = linear(tangent);
        }
        Self::new(options)
    }

    pub(super) fn check_index(&self, i: usize) -> Result<()> {
        let most = (self.points().len() - 1) as f64;
        if i as f64 > most {
            let value = i as f64;
            return Err(Error::OutOfRange { argument: "i", index: None, value, least: 0.0, most });
        }
        Ok(())
    }
}
