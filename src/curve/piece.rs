//! One segment as a closed form about its middle: what every measure of a curve is computed from.
//!
//! With y = x − 1/2 in [−1/2, 1/2] and w the local frequency, a segment is
//!
//! ```text
//! r(y) = a + b·y + p·y²·c₂(w²y²) + q·y³·c₃(w²y²)
//! ```
//!
//! with Stumpff's functions c₂ and c₃, so that a, b, p, q are the point and its first three derivatives in the middle,
//! for every w. In the hyperbolic space w² is negative; beyond w = 4 segments there are written with decaying
//! exponentials, which cannot overflow: r(y) = a + b·y + p·exp(w(y − 1/2)) + q·exp(−w(y + 1/2)).
//!
//! Pieces of spline curves for other roots are polynomials of any degree, Taylor sums of entire functions; a, b, p, q
//! are the same there, and what bounds the rest is the fourth derivative.

use super::Segment;
use super::any_roots::{ANY_ROOTS, ListOfAnyRoots, list_of_any_roots};
use crate::generator::Space;
use crate::numerics::entire::{Stumpff, stumpff};
use crate::numerics::pair::Pair;
use crate::numerics::plane::{norm, taxi};
use crate::numerics::{Point, Vector};

/// Below this frequency a segment is its cubic limit to the last bit: cos w = 1 to rounding.
const CUBIC_BELOW: f64 = 1e-8;
/// Hyperbolic segments above this frequency are written with decaying exponentials.
const DECAY_ABOVE: f64 = 4.0;
/// Decaying exponentials are nothing after this many of their widths: exp(−40) = 4e-18.
const LAYER: f64 = 40.0;

/// Whether there are curves whose pieces are Hermite segments. A wasm module that has none leaves out what measures it:
/// a branch on this costs nothing and saves what is behind it.
pub(super) const HERMITE: bool =
    cfg!(not(all(target_arch = "wasm32", feature = "wasm-spline", not(feature = "wasm"))));

/// A point of a piece and its first three derivatives with respect to y.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jet {
    pub(crate) position: Point,
    pub(crate) first: Vector,
    pub(crate) second: Vector,
    pub(crate) third: Vector,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Form {
    Cubic,
    Centred,
    Decaying,
    Polynomial,
}

/// A segment in closed form; see the module's text.
#[derive(Clone, Debug)]
pub struct Piece {
    a: Point,
    b: Vector,
    p: Vector,
    q: Vector,
    /// w² for trigonometric, −w² for hyperbolic, 0 for cubic pieces: r'''' = −rate·r''.
    rate: f64,
    w: f64,
    form: Form,
    /// Of a polynomial all coefficients, ascending; else nothing.
    powers: ListOfAnyRoots<Vector>,
    /// Of a polynomial a bound of |r⁗| on the whole piece.
    fourth: f64,
}

/// The point in the middle and the three derivatives there, of a segment that is a cubic.
#[inline]
pub(crate) fn cubic_middle(segment: &Segment<'_>) -> Option<[Vector; 4]> {
    if segment.basis.frequency() >= CUBIC_BELOW {
        return None;
    }
    let chord = segment.end - segment.start;
    let sum = (segment.leaving + segment.arriving) * segment.length;
    let p = (segment.arriving - segment.leaving) * segment.length;
    let q = sum * 6.0 - chord * 12.0;
    let mean = (segment.start + segment.end) * 0.5;
    Some([mean - p * 0.125, chord - q * (1.0 / 24.0), p, q])
}

impl Piece {
    /// The cubic with middle 0 and those derivatives there.
    pub(crate) fn cubic(b: Vector, p: Vector, q: Vector) -> Self {
        let (a, powers) = (Point::zeros(), ListOfAnyRoots::default());
        Self { a, b, p, q, rate: 0.0, w: 0.0, form: Form::Cubic, powers, fourth: 0.0 }
    }

    /// The cubic, or with a rate the trigonometric or hyperbolic piece, with that point and those derivatives in the
    /// middle; w of at most 4.
    pub(crate) fn about([a, b, p, q]: [Vector; 4], rate: f64) -> Self {
        let form = if rate == 0.0 { Form::Cubic } else { Form::Centred };
        Self { a, rate, w: rate.abs().sqrt(), form, ..Self::cubic(b, p, q) }
    }

    /// The polynomial with these coefficients of ascending powers of y, x and y in turn.
    pub(crate) fn polynomial(coefficients: &[f64]) -> Self {
        let mut powers: Vec<Vector> = Vec::with_capacity(coefficients.len() / 2);
        for pair in coefficients.chunks_exact(2) {
            powers.push(Vector::new(pair[0], pair[1]));
        }
        let power = |k: usize| powers.get(k).copied().unwrap_or_default();
        let mut piece = Self { a: power(0), ..Self::cubic(power(1), power(2) * 2.0, power(3) * 6.0) };
        if powers.len() > 4 {
            piece.powers = list_of_any_roots(powers);
            piece.form = Form::Polynomial;
            piece.fourth = piece.fourth_within(0.5);
        }
        piece
    }

    /// The closed form of a segment.
    pub(crate) fn new(segment: &Segment<'_>) -> Self {
        if let Some([a, b, p, q]) = cubic_middle(segment) {
            return Self { a, ..Self::cubic(b, p, q) };
        }
        let w = segment.basis.frequency();
        let chord = segment.end - segment.start;
        let mean = (segment.end + segment.start) * 0.5;
        let sum = (segment.leaving + segment.arriving) * segment.length;
        let difference = (segment.arriving - segment.leaving) * segment.length;
        let hyperbolic = segment.basis.space() == Space::Hyperbolic;
        if hyperbolic && w > DECAY_ABOVE {
            let tail = libm::exp(-w);
            let p_plus_q = difference / (w * (1.0 - tail));
            let p_minus_q = (sum * 0.5 - chord) / (0.5 * w * (1.0 + tail) - (1.0 - tail));
            let (p, q) = ((p_plus_q + p_minus_q) * 0.5, (p_plus_q - p_minus_q) * 0.5);
            let (a, b) = (mean - p_plus_q * (0.5 * (1.0 + tail)), chord - p_minus_q * (1.0 - tail));
            let piece = Self { a, ..Self::cubic(b, p, q) };
            return Self { rate: -w * w, w, form: Form::Decaying, ..piece };
        }
        let rate = if hyperbolic { -w * w } else { w * w };
        let Stumpff { c1, c2, c3, .. } = stumpff(0.25 * rate);
        let p = difference / c1;
        let q = (sum * 2.0 - chord * 4.0) / (c2 - c3);
        let (a, b) = (mean - p * (0.25 * c2), chord - q * (0.25 * c3));
        Self { a, rate, w, form: Form::Centred, ..Self::cubic(b, p, q) }
    }

    /// w² for trigonometric, −w² for hyperbolic, 0 for cubic pieces.
    pub(crate) fn rate(&self) -> f64 {
        self.rate
    }

    /// Whether the piece is a polynomial of degree 3.
    #[inline]
    pub(crate) fn is_cubic(&self) -> bool {
        self.form == Form::Cubic
    }

    /// Whether the coefficients p and q are those of decaying exponentials.
    #[inline]
    pub(crate) fn is_decaying(&self) -> bool {
        HERMITE && self.form == Form::Decaying
    }

    /// Whether it is a polynomial of degree 4 or more.
    #[inline]
    pub(crate) fn is_polynomial(&self) -> bool {
        ANY_ROOTS && self.form == Form::Polynomial
    }

    /// Whether the piece is a straight line, run through evenly, between lo and hi: so far inside a long hyperbolic
    /// segment that nothing is left of what happens at its ends.
    #[inline]
    pub(crate) fn is_straight_on(&self, lo: f64, hi: f64) -> bool {
        self.is_decaying() && self.w * (lo + 0.5).min(0.5 - hi) >= LAYER
    }

    /// The coefficients a, b, p, q; for a cubic the point and the derivatives in the middle.
    #[inline]
    pub(crate) fn coefficients(&self) -> [Vector; 4] {
        [self.a, self.b, self.p, self.q]
    }

    /// The point at y in [−1/2, 1/2].
    #[inline(never)]
    pub(crate) fn position(&self, y: f64) -> Point {
        if self.is_cubic() {
            return self.a + (self.b + (self.p * 0.5 + self.q * (y / 6.0)) * y) * y;
        }
        if self.is_polynomial() {
            return self.powers.iter().rev().fold(Point::zeros(), |sum, c| sum * y + c);
        }
        self.jet(y).position
    }

    /// The points at many y, x and y in turn.
    pub(crate) fn positions(&self, places: &[f64], out: &mut [f64]) {
        let points = out.as_chunks_mut::<2>().0.iter_mut().zip(places);
        if self.is_cubic() {
            let [a, b, p, q] = [self.a, self.b, self.p * 0.5, self.q].map(|v| Pair::new(v.x, v.y));
            for (point, &y) in points {
                let (sixth, y) = (Pair::twice(y / 6.0), Pair::twice(y));
                let on = a + (b + (p + q * sixth) * y) * y;
                *point = [on.first(), on.second()];
            }
            return;
        }
        for (point, &y) in points {
            *point = self.position(y).into();
        }
    }

    /// The point and its first three derivatives at y.
    #[inline(never)]
    pub(crate) fn jet(&self, y: f64) -> Jet {
        self.inline_jet(y)
    }

    /// The same where a call would cost more than the work, at the price of code.
    #[inline(always)]
    pub(crate) fn inline_jet(&self, y: f64) -> Jet {
        let Self { a, b, p, q, .. } = *self;
        if self.is_cubic() {
            let second = p + q * y;
            return Jet {
                position: a + (b + (p * 0.5 + q * (y / 6.0)) * y) * y,
                first: b + (p + q * (0.5 * y)) * y,
                second,
                third: q,
            };
        }
        self.transcendental_jet(y)
    }

    #[inline(never)]
    fn transcendental_jet(&self, y: f64) -> Jet {
        if !HERMITE || self.is_polynomial() {
            return polynomial_jet(&self.powers, y);
        }
        let Self { a, b, p, q, rate, w, .. } = *self;
        if self.is_decaying() {
            let up = p * libm::exp(w * (y - 0.5));
            let down = q * libm::exp(-w * (y + 0.5));
            return Jet {
                position: a + b * y + up + down,
                first: b + (up - down) * w,
                second: (up + down) * (w * w),
                third: (up - down) * (w * w * w),
            };
        }
        let Stumpff { c0, c1, c2, c3 } = stumpff(rate * y * y);
        Jet {
            position: a + (b + (p * c2 + q * (c3 * y)) * y) * y,
            first: b + (p * c1 + q * (c2 * y)) * y,
            second: p * c0 + q * (c1 * y),
            third: q * c0 - p * (rate * c1 * y),
        }
    }

    /// A bound of |r''| on [lo, hi], sharp to first order in the width.
    pub(crate) fn bend(&self, lo: f64, hi: f64) -> f64 {
        if self.is_decaying() {
            let (up, down) = self.decay_ends(lo, hi);
            return (up + down) * (self.w * self.w);
        }
        let half = 0.5 * (hi - lo);
        let middle = self.jet(0.5 * (lo + hi));
        let (even, odd) = self.growth(half);
        norm(middle.second) * even + (norm(middle.third) * odd + 0.5 * half * self.fourth) * half
    }

    /// A bound of |r⁗| where |r″| is at most `bend`.
    #[inline]
    pub(crate) fn fourth(&self, bend: f64) -> f64 {
        self.rate.abs() * bend + self.fourth
    }

    /// A bound of |r⁗| of a polynomial for all complex y of at most this modulus (D 10.1).
    fn fourth_within(&self, radius: f64) -> f64 {
        let mut sum = 0.0;
        for (k, c) in self.powers.iter().enumerate().skip(4).rev() {
            let k = k as f64;
            sum = sum * radius + k * (k - 1.0) * (k - 2.0) * (k - 3.0) * taxi(*c);
        }
        sum
    }

    /// Bounds for complex parameters within `reach` of the one that the jet is at: of the way from there, and of |r′|.
    ///
    /// The functions of the spaces are largest where they are hyperbolic, polynomials where all terms add up.
    pub(crate) fn within(&self, jet: &Jet, at: f64, reach: f64) -> [f64; 2] {
        let growth = if !HERMITE || self.rate == 0.0 {
            1.0
        } else {
            stumpff(-(self.rate.abs() * reach * reach).min(490_000.0)).c0
        };
        let fourth = if self.is_polynomial() { self.fourth_within(at.abs() + reach) } else { 0.0 };
        let (first, second, third) = (norm(jet.first), growth * norm(jet.second), growth * norm(jet.third));
        let way = first + reach * (second / 2.0 + reach * (third / 6.0 + reach * fourth / 24.0));
        let speed = first + reach * (second + reach * (third / 2.0 + reach * fourth / 6.0));
        [reach * way, speed]
    }

    /// A bound of the distance, at equal parameters, from the cubic with the same ends and end derivatives:
    /// h⁴/384·max|r⁗|.
    pub(crate) fn cubic_gap(&self, lo: f64, hi: f64) -> f64 {
        if self.is_cubic() {
            return 0.0;
        }
        // What a polynomial's fourth derivative is at most does not depend on the second.
        let bend = if self.is_polynomial() { 0.0 } else { self.bend(lo, hi) };
        let h = (hi - lo) * (hi - lo);
        h * h * (1.0 / 384.0) * self.fourth(bend)
    }

    /// A bound of |r'''| on [lo, hi].
    pub(crate) fn jolt(&self, lo: f64, hi: f64) -> f64 {
        if self.is_cubic() {
            return norm(self.q);
        }
        if self.is_decaying() {
            let (up, down) = self.decay_ends(lo, hi);
            return (up + down) * (self.w * self.w * self.w);
        }
        let half = 0.5 * (hi - lo);
        let middle = self.jet(0.5 * (lo + hi));
        let (even, odd) = self.growth(half);
        norm(middle.third) * even + (norm(middle.second) * self.rate.abs() * odd + self.fourth) * half
    }

    /// The largest values on |u| <= half of |cos wu| and |sin wu|/(w|u|), or of cosh and sinh.
    fn growth(&self, half: f64) -> (f64, f64) {
        if !HERMITE || self.rate >= 0.0 {
            return (1.0, 1.0);
        }
        let x = self.w * half;
        let Stumpff { c0, c1, .. } = stumpff(-x * x);
        (c0, c1)
    }

    fn decay_ends(&self, lo: f64, hi: f64) -> (f64, f64) {
        (norm(self.p) * libm::exp(self.w * (hi - 0.5)), norm(self.q) * libm::exp(-self.w * (lo + 0.5)))
    }

    /// The corners of a box that holds the piece: Taylor's sums.
    pub(crate) fn corners(&self) -> [Point; 2] {
        let cubic = [self.b * 0.5, self.p * 0.125, self.q * (1.0 / 48.0)];
        let mut size = cubic.iter().fold(Vector::zeros(), |sum, v| sum + v.abs());
        let mut share = 1.0 / 16.0;
        for c in self.powers.iter().skip(4) {
            size += c.abs() * share;
            share *= 0.5;
        }
        [self.a - size, self.a + size]
    }
}

/// A polynomial and its first three derivatives, by Horner's rule.
#[inline(never)]
fn polynomial_jet(powers: &[Vector], y: f64) -> Jet {
    let zero = Vector::zeros();
    let (mut value, mut first, mut second, mut third) = (zero, zero, zero, zero);
    for c in powers.iter().rev() {
        third = third * y + second;
        second = second * y + first;
        first = first * y + value;
        value = value * y + c;
    }
    Jet { position: value, first, second: second * 2.0, third: third * 6.0 }
}

/// Calls `f` with intervals that cover the piece and on which its functions are tame: the whole piece, or for a
/// decaying one intervals that shrink towards the ends like the layers there.
#[inline(never)]
pub(crate) fn panels(piece: &Piece, f: &mut dyn FnMut(f64, f64)) {
    if !piece.is_decaying() {
        return f(-0.5, 0.5);
    }
    let (mut inner, step) = (0.0, 4.0 / piece.w);
    while inner < 0.5 {
        if inner * piece.w >= LAYER {
            return f(inner - 0.5, 0.5 - inner);
        }
        let outer = if inner + 1.5 * step < 0.5 { inner + step } else { 0.5 };
        f(inner - 0.5, outer - 0.5);
        f(0.5 - outer, 0.5 - inner);
        inner = outer;
    }
}
