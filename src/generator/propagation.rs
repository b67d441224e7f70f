//! The pieces of exponential B-splines, from knot to knot, in numbers of two doubles.
//!
//! Roots far from the imaginary axis, and interpolators of roots near ±iπ, cancel up to 16 digits; twofold numbers
//! have 32.

use super::pieces::PolynomialPieces;
use super::roots::Roots;
use crate::error::{Error, Result};
use crate::limits::with_room;
use crate::numerics::twofold::Twofold;

/// Taylor sums end where what is left is below this share of the largest term.
const NEGLIGIBLE: f64 = 1e-30;
/// Coefficients below this share of the largest, at the end of a piece, are cut off: derivatives amplify what is
/// missing.
const CUT: f64 = 1e-19;
/// And those below this share of each derivative: large roots that hardly show in the values do show there.
const CUT_OF_DERIVATIVES: f64 = 1e-16;

/// The integral is known from the roots; where that of the pieces is off by this share of their size, their digits are
/// lost.
const SOUND: f64 = 1e-9;

/// Pieces of length 1 in ascending powers of the distance from their middle, `terms` coefficients each.
#[derive(Debug)]
pub(super) struct Propagated {
    pub(super) coefficients: Vec<Twofold>,
    pub(super) terms: usize,
}

impl Propagated {
    /// The pieces of the B-spline of these roots (D 9.1).
    #[inline(never)]
    pub(super) fn new(roots: &Roots) -> Result<Self> {
        let order = roots.order();
        let terms = terms(order, roots.largest());
        let (left, right) = (order.div_ceil(2), order / 2);
        let mut whole = with_room(order * terms)?;
        from_the_left(roots, left, terms, &mut whole);
        if roots.is_symmetric() {
            if left != right {
                // The middle piece is even.
                whole[right * terms..].iter_mut().skip(1).step_by(2).for_each(|odd| *odd = Twofold::ZERO);
            }
            for k in (0..right).rev() {
                whole.extend_from_within(k * terms..(k + 1) * terms);
            }
        } else {
            // β⁺(n₀ − t) is e^{Σα} times the causal B-spline of the opposite roots.
            let scale = roots.growth();
            let mut mirrored = with_room(right * terms)?;
            from_the_left(&roots.opposite(), right, terms, &mut mirrored);
            for piece in mirrored.chunks_exact(terms).rev() {
                whole.extend(piece.iter().map(|c| c.times(scale)));
            }
        }
        for piece in whole[left * terms..].chunks_exact_mut(terms) {
            piece.iter_mut().skip(1).step_by(2).for_each(|odd| *odd = odd.negative());
        }
        // About their middles pieces need far fewer terms than the way to the next knot.
        let whole = Self { coefficients: whole, terms };
        let kept = whole.needed(0.5, [NEGLIGIBLE; 2], order - 1);
        let mut coefficients = with_room(order * kept)?;
        for piece in whole.coefficients.chunks_exact(terms) {
            coefficients.extend_from_slice(&piece[..kept]);
        }
        let pieces = Self { coefficients, terms: kept };
        // Written so that NaN fails.
        let sound =
            (pieces.integral() - roots.integral()).abs() <= SOUND * order as f64 * pieces.largest(0.5)[0];
        if sound { Ok(pieces) } else { Err(cancelled()) }
    }

    /// The integral of all pieces, of which even powers have one.
    fn integral(&self) -> f64 {
        let mut sum = Twofold::ZERO;
        for piece in self.coefficients.chunks_exact(self.terms) {
            let mut reach = 1.0;
            for (k, c) in piece.iter().enumerate().step_by(2) {
                sum = sum.plus_product(*c, Twofold::new(reach).over(Twofold::new((k + 1) as f64)));
                reach *= 0.25;
            }
        }
        sum.value()
    }

    /// The function at the end of piece k (from 0), or in its middle.
    pub(super) fn sample(&self, k: usize, middle: bool) -> Twofold {
        let Some(piece) = self.coefficients.get(k * self.terms..(k + 1) * self.terms) else {
            return Twofold::ZERO;
        };
        if middle {
            return piece[0];
        }
        piece.iter().rev().fold(Twofold::ZERO, |sum, c| c.plus(scaled(sum, -0.5)))
    }

    /// The largest of each coefficient, times its power of the distance from the middle to the ends.
    #[inline(never)]
    fn largest(&self, half: f64) -> Vec<f64> {
        let mut most = vec![0.0_f64; self.terms];
        for piece in self.coefficients.chunks_exact(self.terms) {
            let mut reach = 1.0;
            for (most, c) in most.iter_mut().zip(piece) {
                *most = most.max(c.high.abs() * reach);
                reach *= half;
            }
        }
        most
    }

    /// How many coefficients the function needs, cut at a share of its largest term, and its derivatives, cut at one of
    /// theirs.
    fn needed(&self, half: f64, [share, of_derivatives]: [f64; 2], derivatives: usize) -> usize {
        let mut terms = self.largest(half);
        let mut needed = last_above(share, &terms);
        for derivative in 0..derivatives {
            // k(k − 1)… times the coefficient of a power, and none of the powers that are gone.
            for (k, term) in terms.iter_mut().enumerate() {
                *term *= k as f64 - derivative as f64;
            }
            needed = needed.max(last_above(of_derivatives, &terms));
        }
        needed
    }

    /// Rounded, and cut to the length that the longest piece needs, for the function and its derivatives up to one.
    #[inline(never)]
    pub(super) fn rounded(&self, per_unit: usize, derivatives: usize) -> Result<PolynomialPieces> {
        let stride = self.needed(0.5 / per_unit as f64, [CUT, CUT_OF_DERIVATIVES], derivatives);
        let mut coefficients = with_room(self.coefficients.len() / self.terms * stride)?;
        for piece in self.coefficients.chunks_exact(self.terms) {
            coefficients.extend(piece[..stride].iter().map(|c| c.high));
        }
        Ok(PolynomialPieces { coefficients, stride, per_unit })
    }
}

#[cold]
fn cancelled() -> Box<Error> {
    Error::degenerate("roots", None, "so large ones among so many leave no digits of the B-spline")
}

/// How many terms there are up to the last above a share of the largest.
fn last_above(share: f64, terms: &[f64]) -> usize {
    let largest = terms.iter().fold(0.0, |a: f64, &b| a.max(b));
    terms.iter().rposition(|&term| term > share * largest).map_or(1, |last| last + 1)
}

/// How many Taylor terms cover a step of 1 for roots to this size.
fn terms(order: usize, largest: f64) -> usize {
    let (mut count, mut term) = (1, largest);
    while term >= NEGLIGIBLE {
        count += 1;
        term *= largest / count as f64;
    }
    order + count + if count > 1 { 12 } else { 0 }
}

/// The first `count` pieces of the causal B-spline.
///
/// The state, n₀ derivatives at a knot, goes to the next knot by Taylor's sum; there the derivative of order n₀ − 1
/// jumps by the next coefficient of Π(1 − e^a z) (D 9.1).
#[inline(never)]
fn from_the_left(roots: &Roots, count: usize, terms: usize, pieces: &mut Vec<Twofold>) {
    let (characteristic, jumps, order) = (roots.operator(), roots.recurrence(), roots.order());
    let mut state = vec![Twofold::ZERO; terms];
    for &jump in jumps.iter().take(count) {
        state[order - 1] = state[order - 1].plus(jump);
        for m in order..terms {
            let mut next = Twofold::ZERO;
            for (c, y) in characteristic.iter().zip(&state[m - order..m]) {
                next = next.plus_product(*c, *y);
            }
            state[m] = next.negative();
        }
        // Derivatives become coefficients, and those of the end derivatives again.
        by_factorials(&mut state, false);
        recentre(&mut state, 0.5, terms);
        pieces.extend_from_slice(&state);
        recentre(&mut state, 0.5, order);
        by_factorials(&mut state[..order], true);
    }
}

/// Multiplies number k by k!, or divides it.
#[inline(never)]
fn by_factorials(numbers: &mut [Twofold], times: bool) {
    let mut factorial = Twofold::new(1.0);
    for (k, number) in numbers.iter_mut().enumerate().skip(1) {
        factorial = factorial.times(Twofold::new(k as f64));
        *number = if times { number.times(factorial) } else { number.over(factorial) };
    }
}

/// A polynomial about a place that is `by` further on, in place, its first `wanted` coefficients only; `by` is a power
/// of two or its opposite.
#[inline(never)]
pub(super) fn recentre(coefficients: &mut [Twofold], by: f64, wanted: usize) {
    let count = coefficients.len();
    for done in 1..count.min(wanted + 1) {
        for k in (done - 1..count - 1).rev() {
            coefficients[k] = coefficients[k].plus(scaled(coefficients[k + 1], by));
        }
    }
}

/// A number times a power of two.
#[inline]
fn scaled(number: Twofold, by: f64) -> Twofold {
    Twofold { high: number.high * by, low: number.low * by }
}
