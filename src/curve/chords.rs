//! Chords of a piece, and the proof that they are near it.
//!
//! Let v, a, j be the derivatives of a cubic in the middle of a chord c of parameter width h. With s from 0 to 1 along it
//! the cubic is off the chord's line by
//!
//! ```text
//! h²·s(1 − s)((A − B)(1 − s) + (A + B)s)/|c|
//! A = (h/2)·v × a − (h³/48)·a × j     B = (h²/12)·v × j     c = h(v + (h²/24)·j)
//! ```
//!
//! which is at most h²·max(|A|/4 + (8/27 − 1/4)|B|, 4/27·(|A| + |B|))/|c|. Where (h/2)|a| + (h²/12)|j| ≤ |c|/2h its
//! control points project into the chord, and that bounds the distance both ways. Where not (cusps, turns) the
//! distance of equal parameters does, ¼·max|h·r′ − c|. A piece that is not a cubic differs from the cubic with the same ends
//! and end derivatives by at most h⁴/384·max|r⁗|.

use super::flatten::{beyond, chord_count, spread};
use super::limits::{MOST_OUTPUT_POINTS, with_room};
use super::piece::Piece;
use crate::error::{Error, Result};
use crate::numerics::plane::{cross, dot, square, taxi};
use crate::numerics::{Point, Vector};

/// Halvings of a chord after which it is taken as it is.
const MOST_HALVINGS: usize = 48;
/// Chords are worked on so many at a time; the last few of a piece are of length 0.
const LANES: usize = 4;
/// How often the points of a piece are spread anew before single chords are halved.
const ATTEMPTS: usize = 3;

/// A curve cut into chords, one piece after another.
pub(super) struct Chords {
    tolerance: f64,
    spans: Vec<Span>,
    /// The parameters at the ends of all chords, and the squared bounds of the chords that start there.
    places: Vec<f64>,
    bounds: Vec<f32>,
    /// The largest squared bound of all that was written.
    worst: f64,
}

/// The chords of one piece.
struct Span {
    piece: Piece,
    start: Point,
    first: usize,
    count: usize,
}

impl Span {
    fn padded(&self) -> usize {
        self.count.next_multiple_of(LANES)
    }
}

impl Chords {
    pub(super) fn new(tolerance: f64, pieces: usize) -> Result<Self> {
        let spans = with_room(pieces)?;
        let places = with_room(16 * pieces)?;
        Ok(Self { tolerance, spans, places, bounds: Vec::new(), worst: 0.0 })
    }

    /// Cuts a piece into `count` chords at the places that `spread` fills in.
    #[inline]
    pub(super) fn cut(
        &mut self,
        piece: Piece,
        start: Point,
        count: usize,
        spread: impl FnOnce(&mut [f64]),
    ) -> Result<()> {
        let first = self.places.len();
        if first + count > 2 * MOST_OUTPUT_POINTS {
            return Err(beyond(first + count));
        }
        let span = Span { piece, start, first, count };
        let room = span.padded() + 1;
        self.places.try_reserve(room).map_err(|_| Error::OutOfMemory { bytes: 8 * room })?;
        self.places.resize(first + room, 0.5);
        self.places[first] = -0.5;
        spread(&mut self.places[first + 1..first + count]);
        self.spans.push(span);
        Ok(())
    }

    /// Proves all chords, mends those that are not good, appends their starts and returns the largest bound.
    ///
    /// Everything is cut before anything is proved, so that what the one loop stores has reached the cache when the
    /// other loads it.
    pub(super) fn finish(mut self, out: &mut Vec<f64>) -> Result<f64> {
        let room = 2 * self.places.len();
        out.try_reserve(room).map_err(|_| Error::OutOfMemory { bytes: 8 * room })?;
        self.bounds.try_reserve(self.places.len()).map_err(|_| Error::OutOfMemory { bytes: 4 * room })?;
        self.bounds.resize(self.places.len(), 0.0);
        for span in &self.spans {
            if span.piece.is_cubic() {
                let (from, to) = (span.first, span.first + span.padded());
                Turning::new(&span.piece).squared_bounds(&self.places[from..=to], &mut self.bounds[from..to]);
            }
        }
        let most = self.tolerance * self.tolerance;
        for span in &self.spans {
            let places = &self.places[span.first..=span.first + span.count];
            let bounds = &self.bounds[span.first..span.first + span.padded()];
            let worst = if span.piece.is_cubic() {
                let unit = taxi_size(&span.piece);
                f64::from(largest(bounds)) * unit * unit
            } else {
                f64::INFINITY
            };
            if out.len() / 2 + span.count > MOST_OUTPUT_POINTS {
                return Err(beyond(out.len() / 2 + span.count));
            }
            out.extend([span.start.x, span.start.y]);
            if worst <= most {
                self.worst = if worst > self.worst { worst } else { self.worst };
                write(&span.piece, places, out);
            } else {
                let unit = taxi_size(&span.piece).powi(2);
                let short = bounds.iter().filter(|&&bound| f64::from(bound) * unit > most).count();
                let few = span.piece.is_cubic() && 8 * short <= span.count + 8;
                let worst = if few {
                    halve_some(&span.piece, places, bounds, unit, self.tolerance, out)?
                } else {
                    mend(&span.piece, places, self.tolerance, out)?
                };
                self.worst = self.worst.max(worst * worst);
            }
        }
        Ok(self.worst.sqrt())
    }
}

/// The largest of the bounds.
#[inline]
fn largest(bounds: &[f32]) -> f32 {
    let mut most = [0.0_f32; LANES];
    for bounds in bounds.chunks_exact(LANES) {
        for (most, &bound) in most.iter_mut().zip(bounds) {
            *most = if bound > *most { bound } else { *most };
        }
    }
    most.iter().fold(0.0, |a: f32, &b| if b > a { b } else { a })
}

/// Appends the points between the ends.
#[inline(never)]
fn write(piece: &Piece, places: &[f64], out: &mut Vec<f64>) {
    let inner = places.get(1..places.len() - 1).unwrap_or_default();
    let written = out.len();
    out.resize(written + 2 * inner.len(), 0.0);
    let pairs = out[written..].chunks_exact_mut(2).zip(inner);
    if piece.is_cubic() {
        let [a, b, p, q] = piece.coefficients();
        let (p, q) = (p * 0.5, q * (1.0 / 6.0));
        for (pair, &y) in pairs {
            pair[0] = a.x + y * (b.x + y * (p.x + y * q.x));
            pair[1] = a.y + y * (b.y + y * (p.y + y * q.y));
        }
        return;
    }
    for (pair, &y) in pairs {
        let p = piece.position(y);
        (pair[0], pair[1]) = (p.x, p.y);
    }
}

/// Writes the points of a piece and halves the few chords that are not good; returns the largest bound.
#[cold]
fn halve_some(
    piece: &Piece,
    places: &[f64],
    bounds: &[f32],
    unit: f64,
    tolerance: f64,
    out: &mut Vec<f64>,
) -> Result<f64> {
    let mut worst: f64 = 0.0;
    for (k, (pair, &bound)) in places.windows(2).zip(bounds).enumerate() {
        if k > 0 {
            let p = piece.position(pair[0]);
            out.extend([p.x, p.y]);
        }
        let known = (f64::from(bound) * unit).sqrt();
        let bound = if known <= tolerance { known } else { halve(piece, pair[0], pair[1], tolerance, out)? };
        worst = worst.max(bound);
    }
    Ok(worst)
}

/// Spreads the points of a piece by the errors that were found, which are a better density than the one before; if all
/// attempts fail, chords that are not good are halved. Returns the largest bound.
#[cold]
fn mend(piece: &Piece, places: &[f64], tolerance: f64, out: &mut Vec<f64>) -> Result<f64> {
    let mut places = places.to_vec();
    for attempt in 0..=ATTEMPTS {
        let (mut worst, mut total) = (0.0_f64, 0.0);
        let mut before = vec![total];
        for pair in places.windows(2) {
            let bound = bound(piece, pair[0], pair[1]);
            worst = worst.max(bound);
            total += (bound / tolerance).sqrt().clamp(1e-3, 4.0);
            before.push(total);
        }
        if worst <= tolerance {
            write(piece, &places, out);
            return Ok(worst);
        }
        if attempt == ATTEMPTS {
            break;
        }
        // Evenly is never quite even: a little more makes the next attempt the last.
        let count = chord_count(1.02 * total);
        if out.len() / 2 + count > MOST_OUTPUT_POINTS {
            return Err(beyond(out.len() / 2 + count));
        }
        let mut next = vec![0.5; count + 1];
        next[0] = -0.5;
        spread(&places, &before, &vec![0.0; places.len() - 1], &mut next[1..count]);
        places = next;
    }
    let mut worst: f64 = 0.0;
    for (k, pair) in places.windows(2).enumerate() {
        if k > 0 {
            let p = piece.position(pair[0]);
            out.extend([p.x, p.y]);
        }
        worst = worst.max(halve(piece, pair[0], pair[1], tolerance, out)?);
    }
    Ok(worst)
}

/// A cubic's velocity and turning as polynomials in single precision, scaled to about 1.
pub(super) struct Turning {
    /// What lengths are in units of.
    pub(super) size: f64,
    b: [f32; 2],
    p: [f32; 2],
    q: [f32; 2],
    /// b × p, b × q and p × q.
    products: [f32; 3],
}

impl Turning {
    #[inline(never)]
    pub(super) fn new(piece: &Piece) -> Self {
        let [_, b, p, q] = piece.coefficients();
        let size = taxi_size(piece);
        let scale = 1.0 / size;
        let single = |v: Vector| [(v.x * scale) as f32, (v.y * scale) as f32];
        let (b, p, q) = (single(b), single(p), single(q));
        let cross = |u: [f32; 2], v: [f32; 2]| u[0] * v[1] - u[1] * v[0];
        Self { size, b, p, q, products: [cross(b, p), cross(b, q), cross(p, q)] }
    }

    /// r′ and r′ × r″ at y.
    #[inline]
    pub(super) fn at(&self, y: f32) -> [f32; 3] {
        let Self { b, p, q, products: [bp, bq, pq], .. } = *self;
        let half = 0.5 * y;
        [b[0] + y * (p[0] + half * q[0]), b[1] + y * (p[1] + half * q[1]), bp + y * (bq + half * pq)]
    }

    /// √(|r′ × r″|/|r′|) at every place. Not inlined, so that the loop stays one and becomes vector code.
    #[inline(never)]
    pub(super) fn densities(&self, places: &[f32], roots: &mut [f32]) {
        for (root, &y) in roots.iter_mut().zip(places) {
            let [x, y, turn] = self.at(y);
            *root = (turn.abs() / ((x * x + y * y).sqrt() + 1e-12)).sqrt();
        }
    }

    /// The squared bounds of all chords between the places.
    #[inline(never)]
    fn squared_bounds(&self, places: &[f64], bounds: &mut [f32]) {
        let Some((_, next)) = places.split_first() else { return };
        for ((bound, &lo), &hi) in bounds.iter_mut().zip(places).zip(next) {
            *bound = self.squared_bound((0.5 * (lo + hi)) as f32, (hi - lo) as f32);
        }
    }

    /// The squared bound of a chord by its middle and width; infinite where its control points may leave it.
    ///
    /// Roundings of single precision are at most 1e-5 of the bound where it is finite; the factor covers them.
    #[inline]
    fn squared_bound(&self, middle: f32, width: f32) -> f32 {
        let Self { p, q, products: [_, bq, pq], .. } = *self;
        let [x, y, turn] = self.at(middle);
        let square = width * width;
        let even = (0.5 * turn - square * (1.0 / 48.0) * pq).abs();
        let odd = (width * (1.0 / 12.0) * (bq + middle * pq)).abs();
        let (one, two) = (0.25 * even + (8.0 / 27.0 - 0.25) * odd, (4.0 / 27.0) * (even + odd));
        let off = square * if one > two { one } else { two };
        // c/h, and (h/2)|a| + (h²/12)|j| by the sums of the coordinates.
        let (x, y) = (x + square * (1.0 / 24.0) * q[0], y + square * (1.0 / 24.0) * q[1]);
        let length = x * x + y * y;
        let bend = (p[0] + middle * q[0]).abs() + (p[1] + middle * q[1]).abs();
        let spread = width * (0.5 * bend + width * (1.0 / 12.0) * (q[0].abs() + q[1].abs()));
        let bound = 1.0001 * off * off / length;
        let bound = if 4.0 * spread * spread <= length { bound } else { f32::INFINITY };
        if width > 0.0 { bound } else { 0.0 }
    }
}

/// What a cubic's derivatives are scaled by.
#[inline(never)]
fn taxi_size(piece: &Piece) -> f64 {
    let [_, b, p, q] = piece.coefficients();
    let size = taxi(b) + taxi(p) + taxi(q);
    if size > f64::MIN_POSITIVE { size } else { f64::MIN_POSITIVE }
}

/// The bound of the distance between a piece and its chord.
fn bound(piece: &Piece, lo: f64, hi: f64) -> f64 {
    let (start, end, h) = (piece.jet(lo), piece.jet(hi), hi - lo);
    let chord = end.position - start.position;
    squared_bound(chord, start.first * h, end.first * h).sqrt() + piece.cubic_gap(lo, hi)
}

/// The squared bound of the distance between a chord and the cubic with those ends and end derivatives.
#[inline]
fn squared_bound(chord: Vector, leaving: Vector, arriving: Vector) -> f64 {
    let length = square(chord);
    let (alpha, beta) = (cross(leaving, chord), -cross(arriving, chord));
    let (a, b) = (alpha.abs(), beta.abs());
    let even = 0.125 * (a + b) + (4.0 / 27.0 - 0.125) * (a - b).abs();
    let odd = (4.0 / 27.0) * if a > b { a } else { b };
    let off = if alpha * beta >= 0.0 { even } else { odd };
    let (first, last) = (dot(leaving, chord), dot(arriving, chord));
    let least = if first < last { first } else { last };
    let most = if first > last { first } else { last };
    let across = off * off / length;
    let (start, end) = (square(leaving - chord), square(arriving - chord));
    let parametric = 0.0625 * if start > end { start } else { end };
    // The order of the comparisons makes a chord of length 0, with its 0/0, fall back on the parameters.
    if least >= 0.0 && most <= 3.0 * length && across < parametric { across } else { parametric }
}

/// Halves a chord until its parts are good, writes the points between and returns the largest bound.
#[cold]
fn halve(piece: &Piece, lo: f64, hi: f64, tolerance: f64, out: &mut Vec<f64>) -> Result<f64> {
    let mut stack = [(0.0, 0.0); MOST_HALVINGS];
    stack[0] = (lo, hi);
    let (mut open, mut worst) = (1, 0.0_f64);
    while open > 0 {
        open -= 1;
        let (from, to) = stack[open];
        let bound = bound(piece, from, to);
        let middle = 0.5 * (from + to);
        if bound > tolerance && open + 2 <= MOST_HALVINGS && middle > from && middle < to {
            stack[open] = (middle, to);
            stack[open + 1] = (from, middle);
            open += 2;
            continue;
        }
        worst = worst.max(bound);
        if to < hi {
            if out.len() / 2 >= MOST_OUTPUT_POINTS {
                return Err(beyond(out.len() / 2 + 1));
            }
            let p = piece.position(to);
            out.extend([p.x, p.y]);
        }
    }
    Ok(worst)
}
