//! Points that are equally far apart along a curve.
//!
//! On each segment the inverse of the length is tabulated: cells on which the polynomial of degree 7 with the exact
//! parameter and three derivatives at both ends is as near as is asked for,
//!
//! ```text
//! dy/ds = 1/v,   d²y/ds² = −v′/v³,   d³y/ds³ = 3v′²/v⁵ − v″/v⁴
//! v = |r′|,   v′ = r′·r″/v,   v″ = (|r″|² + r′·r‴ − v′²)/v
//! ```
//!
//! so that a point costs seven multiplications and no iteration.

use super::length::place_on;
use super::tolerance::check_tolerance;
use crate::curve::piece::{Jet, Piece};
use crate::curve::pieces::{AnyPiece, Pieces};
use crate::curve::speed::{ROUNDING, fastest, piece_length};
use crate::error::{Error, Result};
use crate::limits::{MOST_OUTPUT_POINTS, filled, too_many, with_room};
use crate::numerics::lists::steps;
use crate::numerics::plane::{dot, larger, norm, smaller, square};

/// The most intervals that wait to be looked at: halves of halves down to the least width.
const STACK: usize = 64;
/// Where the first intervals end, from the last one on.
const START: [f64; 4] = [0.5, 0.25, 0.0, -0.25];
/// Points that are placed before they are written.
const BATCH: usize = 64;
/// Where a cell is looked at: in the middle, where it is off most, and where it is when it is right there by chance.
const LOOKS: [f64; 3] = [0.5, 0.3, 0.72];
/// Cells of less than this share of a segment are taken as they are.
const LEAST_WIDTH: f64 = 1e-14;
/// The most cells of a piece. Towards a cusp they shrink by a factor each, so that a few hundred are many.
const MOST_CELLS: usize = 4096;

/// Tables of curves with more pieces are not kept: they are a kilobyte for each.
const MOST_KEPT: usize = 10_000;

/// A curve prepared for samplings evenly by length: what costs most is done once for all of them.
///
/// The inverse of the length is tabulated piece by piece when points are asked for there.
#[derive(Clone, Debug)]
pub struct LengthTable {
    tolerance: f64,
    /// The length of each piece.
    lengths: Vec<f64>,
    total: f64,
    /// The table of each piece, empty until it is needed; none at all where there would be too many.
    cells: Vec<Vec<Cell>>,
}

impl LengthTable {
    /// Measures the pieces of a curve.
    pub(crate) fn of(curve: &dyn Pieces, tolerance: f64) -> Result<Self> {
        check_tolerance(tolerance)?;
        let pieces = curve.piece_count();
        let share = share(tolerance, pieces);
        let mut lengths = with_room(pieces)?;
        lengths.extend((0..pieces).map(|i| AnyPiece::new(curve, i).length(-0.5, 0.5, share)));
        let total = lengths.iter().sum();
        let kept = if pieces > MOST_KEPT { 0 } else { pieces };
        let mut cells = with_room(kept)?;
        cells.resize_with(kept, Vec::new);
        Ok(Self { tolerance, lengths, total, cells })
    }

    /// The tolerance that the table was made for.
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Parameters evenly by length of the curve that was measured.
    pub(crate) fn parameters_of(&mut self, curve: &dyn Pieces, count: usize) -> Result<Vec<f64>> {
        self.along(curve, count, 1, &mut |_, [from, to], places, out| {
            for (t, y) in out.iter_mut().zip(places) {
                *t = smaller(from + (y + 0.5) * (to - from), to);
            }
        })
    }

    /// Refuses a curve that cannot be the one that was measured.
    pub(crate) fn check(&self, curve: &dyn Pieces) -> Result<()> {
        let (got, needed) = (curve.piece_count(), self.lengths.len());
        if got == needed { Ok(()) } else { Err(Error::wrong_length("curve", got, needed)) }
    }

    /// The points there: the table knows on which piece they are, so that nothing is looked for.
    pub(crate) fn points_of(&mut self, curve: &dyn Pieces, count: usize) -> Result<Vec<f64>> {
        self.along(curve, count, curve.coordinate_count(), &mut |piece, _, places, out| match piece {
            AnyPiece::Plane(piece) => piece.positions(places, out),
            AnyPiece::Space(piece) => {
                for (point, &y) in out.chunks_exact_mut(3).zip(places) {
                    point.copy_from_slice(&piece.position(y));
                }
            }
        })
    }

    fn along(&mut self, curve: &dyn Pieces, count: usize, each: usize, write: Write<'_>) -> Result<Vec<f64>> {
        if count > MOST_OUTPUT_POINTS {
            return Err(too_many("count", "maxOutputPoints", MOST_OUTPUT_POINTS, count));
        }
        let step = self.total / steps(count, curve.closed()) as f64;
        let share = share(self.tolerance, self.lengths.len());
        let mut out = filled(0.0, each * count)?;
        let mut rest = out.as_mut_slice();
        let (mut passing, mut places, mut before, mut done) = (Vec::new(), [0.0; BATCH], 0.0, 0);
        for (i, &whole) in self.lengths.iter().enumerate() {
            // The points whose place is on this piece; the last one takes what roundings leave.
            let end = before + whole;
            let last = i + 1 == self.lengths.len();
            let until = if last { count } else { ((end / step) as usize).saturating_add(1).min(count) };
            if done < until {
                let piece = AnyPiece::new(curve, i);
                let cells = self.cells.get_mut(i).unwrap_or_else(|| {
                    passing.clear();
                    &mut passing
                });
                if let (AnyPiece::Plane(piece), true) = (&piece, cells.is_empty()) {
                    tabulate(piece, 0.125 * self.tolerance, share, cells);
                }
                let (from, to) = (curve.knot(i), curve.knot(i + 1));
                let scale = cells.last().map_or(1.0, |cell: &Cell| cell.end / whole);
                let scale = if scale.is_finite() { scale } else { 0.0 };
                let (mut cell, mut least) = (0, -0.5);
                // Some at a time: a call for each would cost more than the place.
                while done < until {
                    let number = (until - done).min(BATCH);
                    for (k, y) in places.iter_mut().enumerate().take(number) {
                        let place = ((done + k) as f64 * step - before) * scale;
                        while cell + 1 < cells.len() && place > cells[cell].end {
                            cell += 1;
                        }
                        let found = match &piece {
                            AnyPiece::Plane(_) => cells[cell].parameter(place),
                            AnyPiece::Space(_) => place_on(&piece, place, whole, share),
                        };
                        // Where the tolerance is wide a point may come out before the one before it, which is nearer
                        // to its place, then.
                        least = larger(least, found);
                        *y = least;
                    }
                    let (now, later) = rest.split_at_mut(each * number);
                    write(&piece, [from, to], &places[..number], now);
                    (rest, done) = (later, done + number);
                }
            }
            before = end;
        }
        Ok(out)
    }
}

/// What each piece may be off.
fn share(tolerance: f64, pieces: usize) -> f64 {
    0.125 * tolerance / pieces as f64
}

/// What is written for some points: of their piece, its first and last parameter, their places there.
type Write<'a> = &'a mut dyn FnMut(&AnyPiece, [f64; 2], &[f64], &mut [f64]);

/// A stretch of a piece, and its parameter as a polynomial of the length along it.
#[derive(Clone, Copy, Debug)]
struct Cell {
    /// Length from the start of the piece to the start of the cell, and to its end.
    start: f64,
    end: f64,
    /// 1/(end − start), 0 for a cell without length.
    inverse: f64,
    coefficients: [f64; 8],
    hi: f64,
}

impl Cell {
    /// The polynomial through both ends; the chord where the derivatives are of no use.
    #[inline(never)]
    fn new(lo: &Node, hi: &Node, length: f64) -> Self {
        let h = length;
        let [d0, e0, f0] = [lo.slopes[0] * h, 0.5 * lo.slopes[1] * h * h, lo.slopes[2] * h * h * h / 6.0];
        let [d1, e1, f1] = [hi.slopes[0] * h, 0.5 * hi.slopes[1] * h * h, hi.slopes[2] * h * h * h / 6.0];
        // What is left of the value and the derivatives at 1 after the first four terms.
        let u = hi.y - lo.y - d0 - e0 - f0;
        let v = d1 - d0 - 2.0 * e0 - 3.0 * f0;
        let (w, x) = (e1 - e0 - 3.0 * f0, f1 - f0);
        let mut coefficients = [
            lo.y,
            d0,
            e0,
            f0,
            35.0 * u - 15.0 * v + 5.0 * w - x,
            -84.0 * u + 39.0 * v - 14.0 * w + 3.0 * x,
            70.0 * u - 34.0 * v + 13.0 * w - 3.0 * x,
            -20.0 * u + 10.0 * v - 4.0 * w + x,
        ];
        if !coefficients.iter().all(|c| c.is_finite()) {
            coefficients = [lo.y, hi.y - lo.y, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        }
        let inverse = 1.0 / length;
        let inverse = if inverse.is_finite() { inverse } else { 0.0 };
        Self { start: 0.0, end: length, inverse, coefficients, hi: hi.y }
    }

    /// The parameter at a length from the start of the piece.
    #[inline(always)]
    fn parameter(&self, place: f64) -> f64 {
        let s = (place - self.start) * self.inverse;
        let s = if s > 0.0 { s } else { 0.0 };
        let s = if s < 1.0 { s } else { 1.0 };
        let [a, b, c, d, e, f, g, h] = self.coefficients;
        let square = s * s;
        let (low, high) = ((a + s * b) + square * (c + s * d), (e + s * f) + square * (g + s * h));
        let y = low + square * square * high;
        let y = if y > a { y } else { a };
        if y < self.hi { y } else { self.hi }
    }

    /// How far the parameter at a share of a cell from `lo` on, which is not put after others yet, is from there along
    /// the piece.
    #[inline(never)]
    fn gap(&self, piece: &Piece, lo: f64, share: f64, tolerance: f64) -> f64 {
        let place = share * self.end;
        (piece_length(piece, lo, self.parameter(place), tolerance) - place).abs()
    }
}

/// A parameter, and its first three derivatives by the length.
#[derive(Clone, Copy)]
struct Node {
    y: f64,
    slopes: [f64; 3],
}

impl Node {
    #[inline(never)]
    fn new(piece: &Piece, y: f64) -> Self {
        let Jet { first, second, third, .. } = piece.jet(y);
        let slope = 1.0 / norm(first);
        let one = dot(first, second) * slope;
        let two = (square(second) + dot(first, third) - one * one) * slope;
        let square = slope * slope;
        Self { y, slopes: [slope, -one * slope * square, (3.0 * one * one * slope - two) * square * square] }
    }
}

/// Cells over the piece on which places are within `tolerance`; each length within `share`.
fn tabulate(piece: &Piece, tolerance: f64, share: f64, cells: &mut Vec<Cell>) {
    cells.clear();
    // Places that a rounding of the parameter moves by more cannot be told apart: smaller cells would not help.
    let tolerance = tolerance.max(4.0 * ROUNDING * fastest(piece, -0.5, 0.5));
    let (mut total, mut from) = (0.0, Node::new(piece, -0.5));
    // Where the intervals end that wait to be looked at, the next one last. Four at first: in the middle of a symmetric
    // piece any polynomial is right.
    let (mut ends, mut open) = ([0.0; STACK], START.len());
    ends[..open].copy_from_slice(&START);
    while open > 0 {
        let (lo, hi) = (from.y, ends[open - 1]);
        let (to, length) = (Node::new(piece, hi), piece_length(piece, lo, hi, 0.25 * share));
        let mut cell = Cell::new(&from, &to, length);
        let dividable = hi - lo > LEAST_WIDTH && open < STACK && cells.len() < MOST_CELLS;
        let off = |look: f64| cell.gap(piece, lo, look, 0.25 * share) > tolerance;
        if length > tolerance && dividable && LOOKS.into_iter().any(off) {
            ends[open] = 0.5 * (lo + hi);
            open += 1;
            continue;
        }
        cell.start = total;
        total += length;
        cell.end = total;
        cells.push(cell);
        from = to;
        open -= 1;
    }
}
