//! Changes of a curve: every one gives a new curve and leaves the old one as it was.

use super::hermite::{HermiteCurve, Side};
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

    pub(super) fn check_index(&self, i: usize) -> Result<()> {
        let most = (self.points().len() - 1) as f64;
        if i as f64 > most {
            let value = i as f64;
            return Err(Error::OutOfRange { argument: "i", index: None, value, least: 0.0, most });
        }
        Ok(())
    }
}
