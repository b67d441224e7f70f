//! Cubic Bézier curves near a curve.

use super::cubic_fit::{Candidate, Cubic, fit, hermite_cubic};
use super::cubic_proof::prove;
use super::spreading::{equal_parts, spread};
use super::tolerance::{beyond, check_tolerance, least_tolerance};
use crate::curve::Segment;
use crate::curve::piece::Piece;
use crate::curve::pieces::{Pieces, in_space, space_piece, space_start};
use crate::curve::space_piece::along;
use crate::error::Result;
use crate::limits::MOST_OUTPUT_POINTS;
use crate::numerics::entire::stumpff;
use crate::numerics::plane::{append, dot, norm, square};
use crate::numerics::{Point, Vector};

/// Halvings of a segment after which a piece is taken as it is.
const MOST_HALVINGS: usize = 40;
/// The most pieces that are balanced against each other; a segment that needs more is halved instead.
const MOST_BALANCED: usize = 256;
/// How often the ends of the pieces are moved to make their errors even.
const ROUNDS: usize = 3;
/// Parts are even where none is wider, by its error, than the mean one by more than a fiftieth: its error then is an
/// eighth larger.
const EVEN: f64 = 1.02;
/// How often an arc is divided before it is halved.
const PASSES: usize = 12;
/// Decaying arcs are balanced if they are so many of their widths long at most.
const STIFF: f64 = 24.0;

/// Cubic Bézier curves near a curve; see [`Curve::to_cubics`](crate::curve::Curve::to_cubics).
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
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
        return cubics_in_space(curve, tolerance);
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
            return Err(beyond(needed));
        }
        for cubic in &pieces {
            for &point in cubic {
                append(&mut cubics.path, point);
            }
        }
    }
    Ok(cubics)
}

/// The cubic with the ends and end derivatives of an arc of width h is at most h⁴/384·max|r⁗| away.
fn cubics_in_space(curve: &dyn Pieces, tolerance: f64) -> Result<Cubics> {
    let mut cubics = Cubics::default();
    for i in 0..curve.piece_count() {
        cubics.first.push((cubics.path.len() / 12) as u32);
        let piece = space_piece(curve, i);
        let bound = piece.fourth(0.5) / 384.0;
        let count = equal_parts(bound, tolerance, 4);
        let needed = (cubics.path.len() / 3) as f64 + 4.0 * count;
        if needed > (4 * MOST_OUTPUT_POINTS) as f64 {
            return Err(beyond(needed as usize));
        }
        cubics.deviation = cubics.deviation.max(bound / (count * count * count * count));
        let third = 1.0 / (3.0 * count);
        for k in 0..count as usize {
            let at = |k: usize| piece.jet(k as f64 / count - 0.5);
            let ([from, leaving, ..], [to, arriving, ..]) = (at(k), at(k + 1));
            let from = if k == 0 { space_start(curve, i)? } else { from };
            let to = if k + 1 == count as usize { space_start(curve, i + 1)? } else { to };
            for point in [from, along(&from, &leaving, third), along(&to, &arriving, -third), to] {
                cubics.path.extend(point);
            }
        }
    }
    Ok(cubics)
}

/// Appends the cubic Bézier curves of one segment and returns the proved bound of their distance from it.
pub(crate) fn segment_cubics(segment: &Segment<'_>, tolerance: f64, out: &mut Vec<[Point; 4]>) -> f64 {
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
    let deviation = divided(piece, tolerance, out);
    if let Some(cubic) = out.get_mut(begin) {
        cubic[0] = start;
    }
    if let Some(cubic) = out.last_mut() {
        cubic[3] = end;
    }
    deviation
}

/// The candidate and the proved bound of its distance, or what is nearer where that is beyond the tolerance.
fn proved(piece: &Piece, candidate: &Candidate, tolerance: f64) -> (Cubic, f64) {
    // No proof can succeed where the candidate is known to be too far.
    let hopeless = candidate.off > tolerance;
    let bound = if hopeless { f64::INFINITY } else { prove(piece, candidate, tolerance) };
    if bound <= tolerance {
        return (candidate.cubic, bound);
    }
    let [lo, hi] = candidate.ends();
    let plain = hermite_cubic(piece, lo, hi);
    let gap = piece.cubic_gap(lo, hi);
    let (line, off) = straight(piece, &plain, lo, hi);
    if off <= tolerance && off < gap {
        (line, off)
    } else if bound <= gap {
        (candidate.cubic, bound)
    } else {
        (plain, gap)
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

/// Cubics for a piece, halved where they cannot be balanced: near cusps, bends, and the ends of long hyperbolic
/// segments.
fn divided(piece: &Piece, tolerance: f64, out: &mut Vec<Cubic>) -> f64 {
    let mut deviation: f64 = 0.0;
    let mut stack = [(0.0, 0.0); MOST_HALVINGS + 1];
    stack[0] = (-0.5, 0.5);
    let mut open = 1;
    while open > 0 {
        open -= 1;
        let (lo, hi) = stack[open];
        let whole = fit(piece, lo, hi, tolerance);
        let (cubic, bound) = proved(piece, &whole, tolerance);
        let halvable = open + 2 <= stack.len();
        if bound <= tolerance || !halvable {
            out.push(cubic);
            deviation = deviation.max(bound);
        } else if let Some(worst) = balanced(piece, whole, tolerance, out) {
            deviation = deviation.max(worst);
        } else {
            let middle = 0.5 * (lo + hi);
            stack[open] = (middle, hi);
            stack[open + 1] = (lo, middle);
            open += 2;
        }
    }
    deviation
}

/// As few parts as can be, with even errors; none where the arc is not smooth enough for that.
fn balanced(piece: &Piece, whole: Candidate, tolerance: f64, out: &mut Vec<Cubic>) -> Option<f64> {
    let [lo, hi] = whole.ends();
    if piece.is_decaying() && piece.rate() * (hi - lo) * (hi - lo) < -STIFF * STIFF {
        return None;
    }
    let mut parts = Division { edges: vec![lo, hi], before: vec![0.0], candidates: vec![whole] };
    // So many parts are too few, and so many passes have been made with the same number.
    let (mut too_few, mut rounds) = (1, 0);
    for _ in 0..=PASSES {
        let (count, most) = (parts.candidates.len(), parts.weigh(tolerance));
        let wanted = parts.wanted();
        let fewer = enough(wanted) < count && count > too_few + 1;
        let uneven = most > EVEN * wanted / count as f64;
        if count > too_few && !fewer && !(uneven && rounds < ROUNDS) {
            if let Some(worst) = parts.proved(piece, tolerance, out) {
                return Some(worst);
            }
            too_few = count;
        }
        if wanted.is_nan() || wanted >= MOST_BALANCED as f64 {
            return None;
        }
        let next = enough(wanted).max(too_few + 1);
        rounds = if next == count { rounds + 1 } else { 1 };
        parts.divide(piece, next, tolerance);
    }
    None
}

/// The error is of the sixth order, so many parts at least are enough; the proof costs up to 1/200 of its bound.
fn enough(wanted: f64) -> usize {
    (1.002 * wanted).ceil() as usize
}

/// A piece in parts, each with a cubic.
struct Division {
    edges: Vec<f64>,
    /// How many parts are wanted before each edge, by the estimates of those that there are.
    before: Vec<f64>,
    candidates: Vec<Candidate>,
}

impl Division {
    fn wanted(&self) -> f64 {
        self.before.last().copied().unwrap_or(f64::INFINITY)
    }

    /// Divides the piece evenly by what is wanted.
    fn divide(&mut self, piece: &Piece, count: usize, tolerance: f64) {
        let [from, to] = [self.edges[0], self.edges[self.candidates.len()]];
        let mut edges = vec![to; count + 1];
        edges[0] = from;
        spread(&self.edges, &self.before, &mut edges[1..count]);
        self.edges = edges;
        self.candidates.clear();
        for pair in self.edges.windows(2) {
            self.candidates.push(fit(piece, pair[0], pair[1], tolerance));
        }
    }

    /// Appends the cubics of all parts, if each is within the tolerance.
    fn proved(&self, piece: &Piece, tolerance: f64, out: &mut Vec<Cubic>) -> Option<f64> {
        let begin = out.len();
        let mut worst: f64 = 0.0;
        for candidate in &self.candidates {
            let (cubic, bound) = proved(piece, candidate, tolerance);
            if bound.is_nan() || bound > tolerance {
                out.truncate(begin);
                return None;
            }
            worst = worst.max(bound);
            out.push(cubic);
        }
        Some(worst)
    }

    /// Finds anew how many parts are wanted before each edge; of the parts that there are the most that one is worth.
    fn weigh(&mut self, tolerance: f64) -> f64 {
        self.before.clear();
        let (mut total, mut most) = (0.0, 0.0_f64);
        self.before.push(total);
        for candidate in &self.candidates {
            let share = sixth_root(candidate.off / tolerance).clamp(0.05, 20.0);
            most = most.max(share);
            total += share;
            self.before.push(total);
        }
        most
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
