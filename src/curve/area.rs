//! What a closed curve encloses.

use super::HermiteCurve;
use super::piece::{Piece, panels};
use crate::error::{Error, Result};
use crate::numerics::entire::{Stumpff, stumpff};
use crate::numerics::plane::cross;
use crate::numerics::quadrature::{SIXTEEN, TWENTY_FOUR, nodes};
use crate::numerics::{Point, Vector};

impl HermiteCurve {
    /// The signed area that a closed curve encloses.
    ///
    /// ```text
    /// A = ½ ∮ (x dy − y dx)
    /// ```
    ///
    /// Positive for a curve that turns from the x axis towards the y axis: counter-clockwise in a y-up world, clockwise
    /// on a screen whose y points down. A curve that goes round twice counts twice, a figure of eight the difference.
    ///
    /// # Accuracy
    ///
    /// A few roundings of the extent squared: the integral is a bilinear form of each segment's coefficients whose
    /// constants are closed (cubic, long hyperbolic) or a 16-point Gauss–Legendre sum of analytic functions with a
    /// remainder below 1e-17.
    ///
    /// # Errors
    ///
    /// `Degenerate` for an open curve, which encloses nothing.
    pub fn area(&self) -> Result<f64> {
        self.must_be_closed()?;
        let origin = self.points()[0];
        let mut moments = Moments { rate: 0.0, values: CUBIC_MOMENTS };
        let mut twice = 0.0;
        for segment in self.segments() {
            twice += moments.swept(&Piece::new(&segment), origin);
        }
        Ok(0.5 * twice)
    }

    /// The centre of mass of what a closed curve encloses.
    ///
    /// ```text
    /// c = ∮ r (r × dr) / 3A,   A = ½ ∮ r × dr
    /// ```
    ///
    /// # Accuracy
    ///
    /// A few roundings of the extent cubed, divided by the area.
    ///
    /// # Errors
    ///
    /// `Degenerate` for an open curve, and for one that encloses no area: a double line, or a figure of eight whose
    /// halves cancel.
    pub fn centroid(&self) -> Result<Point> {
        self.must_be_closed()?;
        let origin = self.points()[0];
        let (mut twice, mut moment, mut size) = (0.0, Vector::zeros(), 0.0);
        for segment in self.segments() {
            let piece = Piece::new(&segment);
            panels(&piece, &mut |lo, hi| {
                let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
                nodes(&TWENTY_FOUR, |x, weight| {
                    let jet = piece.jet(middle + half * x);
                    let r = jet.position - origin;
                    let sweep = cross(r, jet.first) * weight * half;
                    twice += sweep;
                    size += sweep.abs();
                    moment += r * sweep;
                });
            });
        }
        if twice.abs() <= 1e-14 * size {
            let reason = "the curve encloses no area";
            return Err(Error::degenerate("curve", None, reason));
        }
        Ok(origin + moment / (1.5 * twice))
    }

    fn must_be_closed(&self) -> Result<()> {
        if self.is_closed() {
            return Ok(());
        }
        Err(Error::degenerate("curve", None, "an open curve encloses no area"))
    }
}

/// ∫y²c₂, ∫y²c₁ − ∫y²c₂ and ∫y⁴c₂² − ∫y⁴c₁c₃ over [−1/2, 1/2], for w = 0.
const CUBIC_MOMENTS: [f64; 3] = [1.0 / 24.0, 1.0 / 24.0, 1.0 / 960.0];

/// The constants of the bilinear form, kept for as long as the frequency stays the same.
struct Moments {
    rate: f64,
    values: [f64; 3],
}

impl Moments {
    /// ∫ r × dr over a piece, with r from `origin`.
    fn swept(&mut self, piece: &Piece, origin: Point) -> f64 {
        let [a, b, p, q] = piece.coefficients();
        let a = a - origin;
        if piece.is_decaying() {
            let w = (-piece.rate()).sqrt();
            let tail = libm::exp(-w);
            let (rise, share) = (1.0 - tail, (1.0 - tail) / w);
            let lever = 0.5 * (1.0 + tail) - 2.0 * share;
            return cross(a, b) + cross(a, p - q) * rise + cross(b, p + q) * lever
                - cross(p, q) * (2.0 * w * tail);
        }
        if piece.rate() != self.rate {
            self.rate = piece.rate();
            self.values = moments(self.rate);
        }
        let [m0, m1, m2] = self.values;
        cross(a, b) + cross(a, q) * m0 + cross(b, p) * m1 + cross(p, q) * m2
    }
}

fn moments(rate: f64) -> [f64; 3] {
    if rate == 0.0 {
        return CUBIC_MOMENTS;
    }
    let mut sums = [0.0; 3];
    for (x, weight) in SIXTEEN {
        add_moments(rate, 0.25 * x * x, weight, &mut sums);
    }
    sums
}

/// Adds the integrands where y² is `square`. Not inlined: the sum's loop is unrolled.
#[inline(never)]
fn add_moments(rate: f64, square: f64, weight: f64, sums: &mut [f64; 3]) {
    let Stumpff { c1, c2, c3, .. } = stumpff(rate * square);
    sums[0] += weight * square * c2;
    sums[1] += weight * square * (c1 - c2);
    sums[2] += weight * square * square * (c2 * c2 - c1 * c3);
}
