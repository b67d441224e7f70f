//! What a closed curve encloses.

use crate::curve::piece::panels;
use crate::curve::pieces::{Pieces, in_space};
use crate::error::{Error, Result};
use crate::numerics::plane::{cross, norm};
use crate::numerics::quadrature::{EIGHT, Rule, TWENTY_FOUR, nodes};
use crate::numerics::{Point, Vector};

pub(crate) fn area(curve: &dyn Pieces) -> Result<f64> {
    Ok(0.5 * Swept::new(curve)?.twice)
}

pub(crate) fn centroid(curve: &dyn Pieces) -> Result<Point> {
    let Swept { origin, twice, size, moment, rounding } = Swept::new(curve)?;
    if twice.abs() <= 1e-14 * size + rounding {
        let reason = "the curve encloses no area";
        return Err(Error::degenerate("curve", None, reason));
    }
    Ok(origin + moment / (1.5 * twice))
}

/// What the ray from `origin` sweeps over as its end runs along the curve.
struct Swept {
    origin: Point,
    /// ∮ r × dr, twice the area.
    twice: f64,
    /// The same with all parts positive.
    size: f64,
    /// ∮ r (r × dr).
    moment: Vector,
    /// By how much `twice` is off as points are rounded to the digits of their coordinates.
    rounding: f64,
}

impl Swept {
    fn new(curve: &dyn Pieces) -> Result<Self> {
        if !curve.closed() {
            return Err(Error::degenerate("curve", None, "an open curve encloses no area"));
        }
        if in_space(curve) {
            return Err(Error::degenerate("curve", None, "a curve in space encloses no area"));
        }
        let origin = curve.start(0);
        let mut swept = Self { origin, twice: 0.0, size: 0.0, moment: Vector::zeros(), rounding: 0.0 };
        for i in 0..curve.piece_count() {
            let piece = curve.piece(i);
            panels(&piece, &mut |lo, hi| {
                let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
                // The integrand of a cubic's centre of mass has degree 8.
                let rule: &Rule = if piece.is_cubic() { &EIGHT } else { &TWENTY_FOUR };
                nodes(rule, |x, weight| {
                    let jet = piece.jet(middle + half * x);
                    let r = jet.position - origin;
                    let sweep = cross(r, jet.first) * weight * half;
                    swept.twice += sweep;
                    swept.size += sweep.abs();
                    swept.moment += r * sweep;
                    let last_place = f64::EPSILON * jet.position.amax();
                    swept.rounding += last_place * norm(jet.first) * weight * half;
                });
            });
        }
        Ok(swept)
    }
}
