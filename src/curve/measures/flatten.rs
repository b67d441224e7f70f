//! A polyline near a curve.
//!
//! A chord of parameter width h is κ·ds²/8 away from a short arc, so points that are evenly spread over
//! ∫√(|r′ × r″|/|r′|) dy make equal errors: as few as can be. Then every chord is proved, whatever was assumed before.

use super::arc_chords::{Arc, WIDEST};
use super::arcs::Cutter;
use super::chords;
use super::spreading::equal_parts;
use super::tolerance::{beyond, check_tolerance, least_tolerance};
use crate::curve::HermiteCurve;
use crate::curve::piece::{Piece, cubic_middle};
use crate::curve::pieces::{Pieces, hermite, in_space, space_piece, space_start};
use crate::error::Result;
use crate::limits::{MOST_OUTPUT_POINTS, with_room};
use crate::numerics::plane::larger;

pub(crate) fn flatten(curve: &dyn Pieces, tolerance: f64) -> Result<(Vec<f64>, f64)> {
    check_tolerance(tolerance)?;
    let tolerance = least_tolerance(curve, tolerance);
    if in_space(curve) {
        return flatten_in_space(curve, tolerance);
    }
    let pieces = curve.piece_count();
    let mut out = with_room(16 * pieces)?;
    let mut deviation = 0.0;
    if let Some(own) = hermite(curve) {
        deviation = cut_segments(own, tolerance, &mut out)?;
    } else {
        for i in 0..pieces {
            deviation = larger(deviation, chords::cut(&curve.piece(i), curve.start(i), tolerance, &mut out)?);
        }
    }
    if !curve.closed() {
        out.push(curve.start(pieces).into());
    }
    Ok((out.into_flattened(), deviation))
}

/// Appends the starts of all segments and the points between them; returns the bound of the distance.
fn cut_segments(curve: &HermiteCurve, tolerance: f64, out: &mut Vec<[f64; 2]>) -> Result<f64> {
    let mut cutter = Cutter::new(tolerance);
    for i in 0..curve.segment_count() {
        let segment = curve.nth_segment(i);
        let start = segment.start;
        if let Some(middle) = cubic_middle(&segment) {
            cutter.push(&Arc { middle, rate: 0.0, start }, out)?;
            continue;
        }
        let piece = Piece::new(&segment);
        if piece.is_decaying() {
            cutter.cut_piece(&piece, start, out)?;
        } else {
            let parts = (segment.basis.frequency() * (1.0 / WIDEST)).ceil();
            cutter.push_parts(&piece, start, parts as usize, out)?;
        }
    }
    cutter.flush(out)?;
    Ok(cutter.deviation)
}

/// A chord of width h is at most h²/8·max|r″| away.
fn flatten_in_space(curve: &dyn Pieces, tolerance: f64) -> Result<(Vec<f64>, f64)> {
    let (mut out, mut deviation) = (Vec::new(), 0.0_f64);
    for i in 0..curve.piece_count() {
        let piece = space_piece(curve, i);
        let bound = 0.125 * piece.bend();
        let count = equal_parts(bound, tolerance, 2);
        let needed = (out.len() / 3) as f64 + count;
        if needed > MOST_OUTPUT_POINTS as f64 {
            return Err(beyond(needed as usize));
        }
        deviation = deviation.max(bound / (count * count));
        out.extend(space_start(curve, i)?);
        for k in 1..count as usize {
            out.extend(piece.position(k as f64 / count - 0.5));
        }
    }
    if !curve.closed() {
        out.extend(space_start(curve, curve.piece_count())?);
    }
    Ok((out, deviation))
}
