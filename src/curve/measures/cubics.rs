//! Cubic Bézier curves near a curve.

use super::cubic_fit::{Cubic, estimate, fit, hermite_cubic, prove};
use super::flatten::{least_tolerance, spread};
use super::length::check_tolerance;
use super::spatial;
use crate::curve::Segment;
use crate::curve::piece::Piece;
use crate::curve::pieces::{Pieces, in_space};
use crate::error::Result;
use crate::limits::{MOST_OUTPUT_POINTS, too_many};
use crate::numerics::entire::stumpff;
use crate::numerics::plane::{append, dot, norm, square};
use crate::numerics::{Point, Vector};

/// Halvings of a segment after which a piece is taken as it is.
const MOST_HALVINGS: usize = 40;
/// The most pieces that are balanced against each other; a segment that needs more is halved instead.
const MOST_BALANCED: usize = 256;
/// How often the ends of the pieces are moved to make their errors even.
const ROUNDS: usize = 3;

/// Cubic Bézier curves near a curve; see [`Curve::to_cubics`](crate::curve::Curve::to_cubics).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cubics {
    /// Eight numbers for each cubic, twelve in space: start, two handles, end. Each starts where the one before ends.
    pub path: Vec<f64>,
    /// The proved bound of the distance between the path and the curve, both ways.
    pub deviation: f64,
    /// For every segment or piece of the curve, how many cubics precede it.
    pub first: Vec<u32>,
}

pub(crate) fn to_cubics(curve: &dyn Pieces, tolerance: f64) -> Result<Cubics> {
    check_tolerance(tolerance)?;
    let tolerance = least_tolerance(curve, tolerance);
    if in_space(curve) {
        return spatial::to_cubics(curve, tolerance, 4 * MOST_OUTPUT_POINTS);
    }
    let mut cubics = Cubics::default();
    let mut pieces = Vec::new();
    for i in 0..curve.piece_count() {
        cubics.first.push((cubics.path.len() / 8) as u32);
        pieces.clear();
        let ends = [curve.start(i), curve.start(i + 1)];
        let deviation = piece_cubics(&curve.piece(i), ends, curve.tangents(i), tolerance, &mut pieces);
        cubics.deviation = cubics.deviation.max(deviation);
        let needed = cubics.path.len() / 2 + 4 * pieces.len();
        if needed > 4 * MOST_OUTPUT_POINTS {
            return Err(too_many("tolerance", "maxOutputPoints", MOST_OUTPUT_POINTS, needed));
        }
        for cubic in &pieces {
            for &point in cubic {
                append(&mut cubics.path, point);
            }
        }
    }
    Ok(cubics)
}

/// Appends the cubic Bézier curves of one segment and returns the proved bound of their distance from it.
pub fn segment_cubics(segment: &Segment<'_>, tolerance: f64, out: &mut Vec<[Point; 4]>) -> f64 {
    let tangents = [segment.leaving * segment.length, segment.arriving * segment.length];
    piece_cubics(&Piece::new(segment), [segment.start, segment.end], tangents, tolerance, out)
}

/// The same for any piece, whose ends and end derivatives are known to the last bit.
fn piece_cubics(
    piece: &Piece,
    [start, end]: [Point; 2],
    [leaving, arriving]: [Vector; 2],
    tolerance: f64,
    out: &mut Vec<[Point; 4]>,
) -> f64 {
    if piece.is_cubic() {
        out.push([start, start + leaving / 3.0, end - arriving / 3.0, end]);
        return 0.0;
    }
    let begin = out.len();
    let deviation = match balanced(piece, tolerance, out) {
        Some(deviation) => deviation,
        None => {
            out.truncate(begin);
            halved(piece, tolerance, out)
        }
    };
    if let Some(cubic) = out.get_mut(begin) {
        cubic[0] = start;
    }
    if let Some(cubic) = out.last_mut() {
        cubic[3] = end;
    }
    deviation
}

/// The best cubic for an arc and the proved bound of its distance.
fn best(piece: &Piece, lo: f64, hi: f64, tolerance: f64) -> (Cubic, f64) {
    let cubic = fit(piece, lo, hi);
    let bound = prove(piece, &cubic, lo, hi, tolerance);
    if bound <= tolerance {
        return (cubic, bound);
    }
    let plain = hermite_cubic(piece, lo, hi);
    let gap = piece.cubic_gap(lo, hi);
    let (line, off) = straight(piece, &plain, lo, hi);
    if off <= tolerance && off < gap {
        (line, off)
    } else if gap < bound {
        (plain, gap)
    } else {
        (cubic, bound)
    }
}

/// The chord as a cubic, and its distance from the arc: the arc lies in the hull of its generalised Bézier points, a
/// polynomial near that of its plain cubic.
fn straight(piece: &Piece, plain: &Cubic, lo: f64, hi: f64) -> (Cubic, f64) {
    let [start, first, second, end] = *plain;
    let chord = end - start;
    let third = chord / 3.0;
    // The plain cubic's handles have a third of the derivative, the space's own have κ of it.
    let stretch = 3.0 * kappa(piece.rate() * (hi - lo) * (hi - lo));
    let off = |handle: Point| {
        let share = (dot(handle, chord) / square(chord)).clamp(0.0, 1.0);
        norm(handle - chord * share)
    };
    let (one, two) = ((first - start) * stretch, chord + (second - end) * stretch);
    let bound = off(one).max(off(two)) + if piece.is_polynomial() { piece.cubic_gap(lo, hi) } else { 0.0 };
    let bound = if bound.is_nan() { f64::INFINITY } else { bound };
    ([start, start + third, end - third, end], bound)
}

/// κ = c₃/c₂ of the square of a frequency.
fn kappa(square: f64) -> f64 {
    if square < -1600.0 {
        // sinh x − x over x(cosh x − 1), where the exponentials are all that is left.
        return 1.0 / (-square).sqrt();
    }
    let c = stumpff(square);
    c.c3 / c.c2
}

/// As few pieces as can be, with even errors; none where the piece is not smooth enough for that.
fn balanced(piece: &Piece, tolerance: f64, out: &mut Vec<Cubic>) -> Option<f64> {
    let (cubic, bound) = best(piece, -0.5, 0.5, tolerance);
    if bound <= tolerance {
        out.push(cubic);
        return Some(bound);
    }
    if piece.is_decaying() {
        return None;
    }
    // The error is of the sixth order: so many pieces at least.
    let mut edges = vec![-0.5, 0.5];
    let mut before = vec![0.0, sixth_root(estimate(piece, &cubic, -0.5, 0.5) / tolerance)];
    let mut next = Vec::new();
    for _ in 0..8 {
        let wanted = before.last().copied().unwrap_or(f64::INFINITY);
        if wanted.is_nan() || wanted >= MOST_BALANCED as f64 {
            return None;
        }
        // The proof costs up to 1/200 of the bound.
        let count = (1.002 * wanted).ceil().max(2.0).max((edges.len() - 1) as f64) as usize;
        for _ in 0..ROUNDS {
            divide(&edges, &before, count, &mut next);
            std::mem::swap(&mut edges, &mut next);
            weigh(piece, &edges, tolerance, &mut before);
        }
        let begin = out.len();
        let mut worst: f64 = 0.0;
        for pair in edges.windows(2) {
            let (cubic, bound) = best(piece, pair[0], pair[1], tolerance);
            worst = worst.max(bound);
            out.push(cubic);
        }
        if worst <= tolerance {
            return Some(worst);
        }
        out.truncate(begin);
        // One more, at least.
        let total = before.last().copied().unwrap_or(0.0);
        if let Some(last) = before.last_mut() {
            *last = total.max(count as f64);
        }
    }
    None
}

/// The edges of `count` pieces, evenly by what is before each of the old edges.
fn divide(edges: &[f64], before: &[f64], count: usize, out: &mut Vec<f64>) {
    out.clear();
    out.resize(count + 1, 0.5);
    out[0] = -0.5;
    let tilts = vec![0.0; edges.len() - 1];
    spread(edges, before, &tilts, &mut out[1..count]);
}

/// How many pieces are wanted before each edge, by the estimates of those that there are.
fn weigh(piece: &Piece, edges: &[f64], tolerance: f64, before: &mut Vec<f64>) {
    before.clear();
    let mut total = 0.0;
    before.push(total);
    for pair in edges.windows(2) {
        let cubic = fit(piece, pair[0], pair[1]);
        total += sixth_root(estimate(piece, &cubic, pair[0], pair[1]) / tolerance).clamp(0.05, 20.0);
        before.push(total);
    }
}

/// x^(1/6) within 2e-4 of itself, which is plenty for a count of pieces.
///
/// A sixth of the exponent's bits is within a few percent of the root; two steps of Newton's method do the rest.
fn sixth_root(x: f64) -> f64 {
    let mut root = f64::from_bits(x.to_bits() / 6 + 1.0_f64.to_bits() / 6 * 5);
    for _ in 0..2 {
        let fifth = root * root * root * root * root;
        root -= (root - x / fifth) / 6.0;
    }
    root
}

/// Pieces by halving, down to the plain bound of Hermite interpolation: for long hyperbolic segments and cusps.
fn halved(piece: &Piece, tolerance: f64, out: &mut Vec<Cubic>) -> f64 {
    let mut deviation: f64 = 0.0;
    let mut stack = [(0.0, 0.0); MOST_HALVINGS + 1];
    stack[0] = (-0.5, 0.5);
    let mut open = 1;
    while open > 0 {
        open -= 1;
        let (lo, hi) = stack[open];
        let (cubic, bound) = best(piece, lo, hi, tolerance);
        if bound > tolerance && open + 2 <= stack.len() {
            let middle = 0.5 * (lo + hi);
            stack[open] = (middle, hi);
            stack[open + 1] = (lo, middle);
            open += 2;
            continue;
        }
        out.push(cubic);
        deviation = deviation.max(bound);
    }
    deviation
}
