//! Arc length, and the parameter at a length.

use super::tolerance::check_tolerance;
use crate::curve::piece::cubic_middle;
use crate::curve::pieces::{AnyPiece, Pieces, hermite, in_space};
use crate::curve::speed::LengthSum;
use crate::error::{Error, Result};
use crate::numerics::roots::bracketed_root;

pub(crate) fn length(curve: &dyn Pieces, tolerance: f64) -> Result<f64> {
    check_tolerance(tolerance)?;
    let count = curve.piece_count();
    let share = tolerance / count as f64;
    if in_space(curve) {
        return Ok((0..count).map(|i| AnyPiece::new(curve, i).length(-0.5, 0.5, share)).sum());
    }
    let mut sum = LengthSum::new(share);
    let own = hermite(curve);
    for i in 0..count {
        // Cubics are so quick that making a piece of each would show.
        match own.and_then(|curve| cubic_middle(&curve.nth_segment(i))) {
            Some([_, b, p, q]) => sum.add_cubic(b, p, q),
            None => sum.add(&curve.piece(i)),
        }
    }
    Ok(sum.finish())
}

pub(crate) fn parameter_at_length(curve: &dyn Pieces, length: f64, tolerance: f64) -> Result<f64> {
    check_tolerance(tolerance)?;
    let count = curve.piece_count();
    let share = tolerance / count as f64;
    let mut before = 0.0;
    for i in 0..count {
        let piece = AnyPiece::new(curve, i);
        let whole = piece.length(-0.5, 0.5, share);
        if length >= 0.0 && length <= before + whole {
            let y = place_on(&piece, length - before, whole, share);
            let (from, to) = (curve.knot(i), curve.knot(i + 1));
            return Ok((from + (y + 0.5) * (to - from)).min(to));
        }
        before += whole;
    }
    // Of two lengths that are within the tolerance of the true one, either may be the larger.
    if length > before && length <= before + 2.0 * tolerance {
        return Ok(curve.knot(count));
    }
    Err(Error::unfit("length", None, length, 0.0, before))
}

/// The y at which a piece of length `whole` has `length` behind it.
pub(super) fn place_on(piece: &AnyPiece, length: f64, whole: f64, tolerance: f64) -> f64 {
    if length <= 0.0 {
        return -0.5;
    }
    if length >= whole {
        return 0.5;
    }
    let guess = length / whole - 0.5;
    bracketed_root(-0.5, 0.5, true, guess, &mut |y| {
        let gap = piece.length(-0.5, y, tolerance) - length;
        (if gap.abs() <= 0.5 * tolerance { 0.0 } else { gap }, piece.speed(y))
    })
}
