//! A function in pieces of one length, each a polynomial about its middle.

use super::riesz::RieszBounds;
use crate::numerics::quadrature::{THIRTY_TWO, nodes};
use crate::numerics::roots::bracketed_root;

/// Nodes of the quadrature rule.
const NODES: usize = 32;
/// Places per oscillation at which the spectrum is looked at before its extremes are pinned down.
const LOOKS: usize = 16;

/// Polynomials in ascending powers of the distance from the middle of their piece, `stride` coefficients each.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PolynomialPieces {
    pub(crate) coefficients: Vec<f64>,
    pub(crate) stride: usize,
    /// How many pieces make a unit: 1 or 2.
    pub(crate) per_unit: usize,
}

impl PolynomialPieces {
    /// Piece k from the left.
    pub(crate) fn piece(&self, k: usize) -> &[f64] {
        self.coefficients.get(k * self.stride..(k + 1) * self.stride).unwrap_or(&[])
    }

    pub(crate) fn count(&self) -> usize {
        self.coefficients.len() / self.stride
    }

    /// The function at the distance x from its left end, or a derivative; the limit from the right at the knots, 0
    /// outside.
    #[inline(never)]
    pub(crate) fn at(&self, x: f64, derivative: usize) -> f64 {
        let per_unit = self.per_unit as f64;
        let place = (x * per_unit).floor();
        if !(place >= 0.0 && place < self.count() as f64) {
            return 0.0;
        }
        polynomial(self.piece(place as usize), x - (place + 0.5) / per_unit, derivative)
    }

    /// The same pieces times `factor`, in a variable of which `length` makes one of here.
    #[inline(never)]
    pub(crate) fn stretched(&self, length: f64, factor: f64) -> Self {
        let mut scaled = self.clone();
        for piece in scaled.coefficients.chunks_exact_mut(self.stride) {
            let mut scale = factor;
            for c in piece {
                *c *= scale;
                scale *= length;
            }
        }
        scaled
    }

    /// Piece k at a distance from its middle, or a derivative.
    #[inline(never)]
    pub(crate) fn value(&self, k: usize, y: f64, derivative: usize) -> f64 {
        polynomial(self.piece(k), y, derivative)
    }

    /// ∫f(x)f(x − n)dx for n = 0, 1, …: all that are not 0.
    #[inline(never)]
    pub(crate) fn autocorrelation(&self) -> Vec<f64> {
        let (count, half) = (self.count(), 0.5 / self.per_unit as f64);
        let mut values = Vec::with_capacity(count * NODES);
        let mut weights = Vec::with_capacity(NODES);
        for k in 0..count {
            nodes(&THIRTY_TWO, |node, weight| {
                values.push(polynomial(self.piece(k), half * node, 0));
                if k == 0 {
                    weights.push(half * weight);
                }
            });
        }
        let mut products = Vec::new();
        for shift in (0..count).step_by(self.per_unit) {
            let pairs = values.iter().zip(values.iter().skip(shift * NODES));
            products.push(pairs.zip(weights.iter().cycle()).map(|((a, b), w)| a * b * w).sum());
        }
        products
    }

    /// The exact Riesz bounds of the integer shifts: the extremes of Σₖ|f̂(ω − 2πk)|² = `a[0]` + 2Σ`a[n]` cos nω.
    #[inline(never)]
    pub(crate) fn riesz_bounds(&self) -> RieszBounds {
        let products = self.autocorrelation();
        let steps = LOOKS * products.len();
        let place = |i: usize| core::f64::consts::PI * i as f64 / steps as f64;
        let mut bounds = (f64::INFINITY, 0.0_f64);
        let mut before = 0.0;
        for i in 0..=steps {
            let (value, slope, _) = spectrum(&products, place(i));
            let mut extend = |v: f64| bounds = (bounds.0.min(v), bounds.1.max(v));
            extend(value);
            // The slope is 0 at both ends.
            if i > 1 && i < steps && (slope > 0.0) != (before > 0.0) {
                let inside = bracketed_root(place(i - 1), place(i), slope > 0.0, f64::NAN, &mut |w| {
                    let (_, slope, bend) = spectrum(&products, w);
                    (slope, bend)
                });
                extend(spectrum(&products, inside).0);
            }
            before = slope;
        }
        RieszBounds { lower: bounds.0.max(0.0).sqrt(), upper: bounds.1.sqrt() }
    }
}

/// `a[0]` + 2Σ`a[n]` cos nω with two derivatives.
#[inline(never)]
fn spectrum(products: &[f64], omega: f64) -> (f64, f64, f64) {
    let mut sums = (products.first().copied().unwrap_or(0.0), 0.0, 0.0);
    for (n, &a) in products.iter().enumerate().skip(1) {
        let n = n as f64;
        let (sine, cosine) = crate::numerics::angle::sin_cos(n * omega);
        sums.0 += 2.0 * a * cosine;
        sums.1 -= 2.0 * a * n * sine;
        sums.2 -= 2.0 * a * n * n * cosine;
    }
    sums
}

/// A polynomial or its derivative by Horner's rule.
#[inline(never)]
pub(crate) fn polynomial(coefficients: &[f64], x: f64, derivative: usize) -> f64 {
    let mut value = 0.0;
    if derivative == 0 {
        for &c in coefficients.iter().rev() {
            value = value * x + c;
        }
        return value;
    }
    for (power, &c) in coefficients.iter().enumerate().skip(derivative).rev() {
        let mut factor = c;
        for k in 0..derivative {
            factor *= (power - k) as f64;
        }
        value = value * x + factor;
    }
    value
}

/// The same polynomial about a place that is `by` further on, in place.
#[inline(never)]
pub(crate) fn recentre(coefficients: &mut [f64], by: f64) {
    let count = coefficients.len();
    for done in 1..count {
        for k in (done - 1..count - 1).rev() {
            coefficients[k] += by * coefficients[k + 1];
        }
    }
}
