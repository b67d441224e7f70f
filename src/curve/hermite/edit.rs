//! Changes of a curve: every one gives a new curve and leaves the old one as it was.

use super::{HermiteCurve, HermiteOptions, Side};
use crate::error::Result;
use crate::limits::{LARGEST_TANGENT, check};
use crate::numerics::affine::Affine;
use crate::numerics::{Point, Vector};

impl HermiteCurve {
    /// The curve with point i at `point`; its tangents stay.
    ///
    /// # Errors
    ///
    /// An index beyond the last point; a coordinate that is not finite or beyond ±1e9.
    pub fn with_point(&self, i: usize, point: Point) -> Result<Self> {
        self.check_index(i)?;
        self.changed(&mut |data| data.points[i] = point)
    }

    /// The curve with another derivative at point i, on one side or on both.
    ///
    /// # Errors
    ///
    /// An index beyond the last point; a component that is not finite or beyond ±8e9.
    pub fn with_tangent(&self, i: usize, tangent: Vector, side: Side) -> Result<Self> {
        self.check_index(i)?;
        self.changed(&mut |data| {
            if side != Side::In {
                data.tangents[i] = tangent;
            }
            if side != Side::Out {
                data.tangents_in[i] = tangent;
            }
        })
    }

    /// The curve run through backwards: `reversed.evaluate(t)` is `self.evaluate(end − t)`.
    ///
    /// A closed curve still starts at point 0. Twice reversed it is the old curve to the last bit.
    pub fn reversed(&self) -> Self {
        // The same numbers in another order pass the same checks.
        self.backwards().unwrap_or_else(|_| self.clone())
    }

    /// [`Self::reversed`], with the error that cannot be.
    pub(crate) fn backwards(&self) -> Result<Self> {
        let from = usize::from(self.is_closed());
        self.changed(&mut |data| {
            core::mem::swap(&mut data.tangents, &mut data.tangents_in);
            for list in [&mut data.points, &mut data.tangents, &mut data.tangents_in] {
                reverse(&mut list[from..]);
            }
            for list in [&mut data.tangents, &mut data.tangents_in] {
                negate(list);
            }
            for list in [&mut data.omega, &mut data.lengths] {
                reverse(list);
            }
        })
    }

    /// The image under (x, y) ↦ (a·x + c·y + e, b·x + d·y + f), with the matrix in SVG's order a b c d e f.
    ///
    /// Exact: the spaces contain the constants, so an affine map acts on points and tangents alone.
    ///
    /// # Errors
    ///
    /// `matrix`: an entry that is not finite; an image that leaves ±1e9, or a tangent that leaves ±8e9.
    pub fn transformed(&self, matrix: [f64; 6]) -> Result<Self> {
        let map = Affine::new(&matrix, 2, true)?;
        let mut data = self.to_options();
        data.points.iter_mut().try_for_each(|point| map.map_points(point.as_mut_slice()))?;
        for tangent in data.tangents.iter_mut().chain(&mut data.tangents_in) {
            map.map_vectors(tangent.as_mut_slice(), LARGEST_TANGENT)?;
        }
        Self::new(data)
    }

    /// The curve that is made from this one's data after `change`.
    pub(super) fn changed(&self, change: &mut dyn FnMut(&mut HermiteOptions)) -> Result<Self> {
        let mut data = self.to_options();
        change(&mut data);
        Self::new(data)
    }

    /// The same curve: who changes curves has the code for this anyway, and needs none to copy them.
    pub(super) fn remade(&self) -> Result<Self> {
        Self::new(self.to_options())
    }

    pub(super) fn check_index(&self, i: usize) -> Result<()> {
        check("i", None, i as f64, 0.0, (self.points().len() - 1) as f64)
    }
}

/// Without the vector code of the standard library: this is done once in a while.
#[inline(never)]
fn reverse<T>(list: &mut [T]) {
    let count = list.len();
    for i in 0..count / 2 {
        list.swap(i, count - 1 - i);
    }
}

#[inline(never)]
fn negate(list: &mut [Vector]) {
    for v in list {
        *v = -*v;
    }
}
