//! Exponential B-splines for any list of roots.

use super::pieces::Pieces;
use super::riesz::RieszBounds;
use super::roots::Roots;
use crate::error::Result;
use crate::limits::{MOST_EVALUATIONS, check, too_many, with_room};

/// Taylor sums end where what is left is below this share of the largest term.
const NEGLIGIBLE: f64 = 1e-19;
/// Coefficients below this share of the largest, at the end of a piece, are cut off: derivatives amplify what is missing.
const CUT: f64 = 1e-19;

/// The B-spline β of a list of roots, centred: support [−n₀/2, n₀/2], n₀ − 2 continuous derivatives.
///
/// Its integer shifts reproduce what the roots stand for; on every interval between knots it is a combination of these
/// functions. It is even if the list is symmetric.
///
/// # Accuracy
///
/// 4e-15 of the largest value for |re| ≤ 3 and 8 roots, 1e-13 at |re| = 5, for the derivatives likewise; repeated, tiny
/// and clustered roots are no special case (`tests/b_splines.rs`).
///
/// # Source
///
/// [SFBGU17, eq. 1–4] and [UB05], by propagation of the state from knot to knot (D 9.1).
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
    pieces: Pieces,
}

impl ExponentialBSpline {
    /// The B-spline of these roots; all pieces are worked out here, once.
    pub fn new(roots: &Roots) -> Result<Self> {
        Ok(Self { roots: roots.clone(), pieces: propagate(roots)? })
    }

    /// The number of roots, n₀.
    pub fn order(&self) -> usize {
        self.roots.order()
    }

    /// The roots.
    pub fn roots(&self) -> &Roots {
        &self.roots
    }

    /// The polynomial on [k − n₀/2, k + 1 − n₀/2], k = 0 … n₀ − 1, in ascending powers of the distance from the middle of
    /// that interval. All have one length; beyond k = n₀ − 1 there is none.
    pub fn piece(&self, k: usize) -> &[f64] {
        self.pieces.piece(k)
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
    pub fn riesz_bounds(&self) -> Result<RieszBounds> {
        Ok(self.pieces.riesz_bounds())
    }

    pub(crate) fn pieces(&self) -> &Pieces {
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

/// All pieces, cut to the length that the longest needs.
#[inline(never)]
fn propagate(roots: &Roots) -> Result<Pieces> {
    let order = roots.order();
    let terms = terms(order, roots.largest());
    let (left, right) = (order.div_ceil(2), order / 2);
    let mut whole: Vec<f64> = with_room(order * terms)?;
    whole.extend(from_the_left(roots, left, terms));
    if roots.is_symmetric() {
        if left != right {
            // The middle piece is even.
            whole[right * terms..].iter_mut().skip(1).step_by(2).for_each(|odd| *odd = 0.0);
        }
        for k in (0..right).rev() {
            whole.extend_from_within(k * terms..(k + 1) * terms);
            let begin = whole.len() - terms;
            Pieces::mirror(&mut whole[begin..]);
        }
    } else {
        // β⁺(n₀ − t) is e^{Σα} times the causal B-spline of the opposite roots.
        let sum: f64 = roots.as_slice().iter().map(|r| r.re).sum();
        let mirrored = from_the_left(&roots.opposite(), right, terms);
        for piece in mirrored.chunks_exact(terms).rev() {
            let begin = whole.len();
            whole.extend(piece.iter().map(|c| c * libm::exp(sum)));
            Pieces::mirror(&mut whole[begin..]);
        }
    }
    let stride = needed(&whole, terms);
    let mut coefficients = with_room(order * stride)?;
    for piece in whole.chunks_exact(terms) {
        coefficients.extend_from_slice(&piece[..stride]);
    }
    Ok(Pieces { coefficients, stride, per_unit: 1 })
}

/// How many Taylor terms cover a step of 1 for roots to this size.
fn terms(order: usize, largest: f64) -> usize {
    let (mut count, mut term) = (1, largest);
    while term >= NEGLIGIBLE {
        count += 1;
        term *= largest / count as f64;
    }
    (order + 12 + count).max(34)
}

/// The number of coefficients after which all pieces are negligible.
#[inline(never)]
fn needed(whole: &[f64], terms: usize) -> usize {
    let mut most = vec![0.0_f64; terms];
    for piece in whole.chunks_exact(terms) {
        let mut reach = 1.0;
        for (most, c) in most.iter_mut().zip(piece) {
            *most = most.max(c.abs() * reach);
            reach *= 0.5;
        }
    }
    let largest = most.iter().fold(0.0, |a: f64, &b| a.max(b));
    most.iter().rposition(|&m| m > CUT * largest).map_or(1, |last| last + 1)
}

/// The first `count` pieces of the causal B-spline, about their middles.
///
/// The state, n₀ derivatives at a knot, goes to the next knot by Taylor sums; there the derivative of order n₀ − 1 jumps
/// by the next coefficient of Π(1 − e^a z) (D 9.1).
#[inline(never)]
fn from_the_left(roots: &Roots, count: usize, terms: usize) -> Vec<f64> {
    let (characteristic, jumps, order) = (roots.characteristic(), roots.localisation(), roots.order());
    let mut inverse = vec![1.0; terms];
    for k in 1..terms {
        inverse[k] = inverse[k - 1] / k as f64;
    }
    let mut pieces = Vec::with_capacity(count * terms);
    let mut state = vec![0.0; terms];
    for &jump in jumps.iter().take(count) {
        state[order - 1] += jump;
        for m in order..terms {
            let mut next = 0.0;
            for (c, y) in characteristic.iter().zip(&state[m - order..m]) {
                next -= c * y;
            }
            state[m] = next;
        }
        for q in 0..terms {
            pieces.push(inverse[q] * taylor(&state[q..], &inverse, 0.5));
        }
        for q in 0..order {
            state[q] = taylor(&state[q..], &inverse, 1.0);
        }
    }
    pieces
}

/// Σ yᵢ·stepⁱ/i!, from the small terms up.
#[inline(never)]
fn taylor(derivatives: &[f64], inverse: &[f64], step: f64) -> f64 {
    let mut scale = 1.0;
    for _ in 1..derivatives.len() {
        scale *= step;
    }
    let mut sum = 0.0;
    for (y, inverse) in derivatives.iter().zip(inverse).rev() {
        sum += y * inverse * scale;
        scale /= step;
    }
    sum
}
