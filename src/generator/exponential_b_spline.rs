//! Exponential B-splines for any list of roots.

use super::pieces::PolynomialPieces;
use super::propagation::Propagated;
use super::riesz::RieszBounds;
use super::roots::Roots;
use crate::error::Result;
use crate::limits::{MOST_EVALUATIONS, check, too_many, with_room};

/// The B-spline β of a list of roots, centred: support [−n₀/2, n₀/2], n₀ − 2 continuous derivatives.
///
/// Its integer shifts reproduce what the roots stand for; on every interval between knots it is a combination of these
/// functions. It is even if the list is symmetric.
///
/// # Accuracy
///
/// 1e-15 of the largest value, and of the largest of each derivative, however many roots and however they lie:
/// repeated, tiny and clustered ones are no special case, and those far from the imaginary axis neither, up to
/// |re| = 96/n₀ (`tests/generator/b_splines.rs`). A few larger ones among many others cancel: 3e-12 of the value and
/// 4e-6 of the sixth derivative are left for six times 0 and ±20.
///
/// # Source
///
/// [SFBGU17, eq. 1–4] and \[UB05\], by propagation of the state from knot to knot, in twofold precision (D 9.1).
///
/// # Example
///
/// ```
/// use expline::generator::{ExponentialBSpline, Roots};
///
/// let cubic = ExponentialBSpline::new(&Roots::polynomials(3)?)?;
/// assert!((cubic.at(0.0, 0) - 2.0 / 3.0).abs() < 1e-15);
/// # Ok::<(), expline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ExponentialBSpline {
    roots: Roots,
    pieces: PolynomialPieces,
}

impl ExponentialBSpline {
    /// The B-spline of these roots; all pieces are worked out here, once.
    ///
    /// # Errors
    ///
    /// Roots that leave no digits, as 14 times 0 and ±20; where memory is short.
    pub fn new(roots: &Roots) -> Result<Self> {
        Self::rounded(roots, &Propagated::new(roots)?)
    }

    /// The same from pieces that are there already.
    pub(super) fn rounded(roots: &Roots, exact: &Propagated) -> Result<Self> {
        Ok(Self { roots: roots.clone(), pieces: exact.rounded(1, roots.order() - 1)? })
    }

    /// The number of roots, n₀.
    pub fn order(&self) -> usize {
        self.roots.order()
    }

    /// The roots.
    pub fn roots(&self) -> &Roots {
        &self.roots
    }

    /// The polynomial on [k − n₀/2, k + 1 − n₀/2], k = 0 … n₀ − 1, in ascending powers of the distance from the middle
    /// of that interval. All have one length; beyond k = n₀ − 1 there is none.
    pub fn piece(&self, k: usize) -> &[f64] {
        if k < self.order() { self.pieces.piece(k) } else { &[] }
    }

    /// β at x, or a derivative. Orders to n₀ − 2 are continuous; beyond, the limit from the right.
    pub fn at(&self, x: f64, derivative: usize) -> f64 {
        self.pieces.at(x + 0.5 * self.order() as f64, derivative)
    }

    /// β, or a derivative of an order to n₀ − 1, at every x.
    ///
    /// # Errors
    ///
    /// An x that is not finite, a derivative above n₀ − 1, more than 4 million places.
    pub fn evaluate(&self, x: &[f64], derivative: usize) -> Result<Vec<f64>> {
        tabulate(x, derivative, self.order() - 1, &|x| self.at(x, derivative))
    }

    /// The largest lower and the smallest upper Riesz bound of the integer shifts.
    ///
    /// # Accuracy
    ///
    /// 1e-13 relative: the products of pieces are integrated exactly, and the extremes of the spectrum are found by
    /// its derivative (D 9.6).
    ///
    /// # Source
    ///
    /// [SFBGU17, eq. 10].
    pub fn riesz_bounds(&self) -> RieszBounds {
        self.pieces.riesz_bounds()
    }

    pub(crate) fn pieces(&self) -> &PolynomialPieces {
        &self.pieces
    }
}

/// Values of a function at many places.
pub(super) fn tabulate(
    x: &[f64],
    derivative: usize,
    most: usize,
    function: &dyn Fn(f64) -> f64,
) -> Result<Vec<f64>> {
    check("derivative", None, derivative as f64, 0.0, most as f64)?;
    if x.len() > MOST_EVALUATIONS {
        return Err(too_many("x", "maxEvalPoints", MOST_EVALUATIONS, x.len()));
    }
    let mut values = with_room(x.len())?;
    for (i, &x) in x.iter().enumerate() {
        check("x", Some(i), x, f64::MIN, f64::MAX)?;
        values.push(function(x));
    }
    Ok(values)
}
