//! Changes of a curve: every one gives a new curve and leaves the old one as it was.

use super::{HermiteCurve, HermiteOptions, Side};
use crate::error::{Error, Result};
use crate::limits::check;
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
    /// An index beyond the last point; a component that is not finite or beyond ±1e9.
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
    /// An entry that is not finite; an image that leaves ±1e9.
    pub fn transformed(&self, matrix: [f64; 6]) -> Result<Self> {
        if let Some(i) = matrix.iter().position(|entry| !entry.is_finite()) {
            return Err(Error::not_finite("matrix", Some(i)));
        }
        let [a, b, c, d, e, f] = matrix;
        self.changed(&mut |data| {
            map(&mut data.points, [a, b, c, d], Vector::new(e, f));
            map(&mut data.tangents, [a, b, c, d], Vector::zeros());
            map(&mut data.tangents_in, [a, b, c, d], Vector::zeros());
        })
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

/// v ↦ (a·x + c·y, b·x + d·y) + shift, for all.
#[inline(never)]
fn map(list: &mut [Vector], [a, b, c, d]: [f64; 4], shift: Vector) {
    for v in list {
        *v = Vector::new(a * v.x + c * v.y, b * v.x + d * v.y) + shift;
    }
}
