//! The nearest point of a curve.

use super::HermiteCurve;
use super::piece::Piece;
use crate::numerics::Point;
use crate::numerics::roots::bracketed_root;

/// Distances that differ by less than this share of the curve's size count as equal.
const TIE: f64 = 1e-13;
/// The most intervals that are open at once.
const STACK: usize = 64;

/// The point of a curve that is nearest to a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Its parameter.
    pub t: f64,
    /// The point.
    pub point: Point,
    /// Its distance.
    pub distance: f64,
}

/// A curve prepared for many questions after its nearest point.
#[derive(Clone, Debug)]
pub struct NearestFinder {
    pieces: Vec<Piece>,
    knots: Vec<f64>,
    slack: f64,
}

impl HermiteCurve {
    /// The point of the curve that is nearest to `place`; of several equally near the one with the smallest t.
    pub fn nearest(&self, place: Point) -> Nearest {
        NearestFinder::new(self).nearest(place)
    }
}

impl NearestFinder {
    /// Prepares a curve; O(segments).
    pub fn new(curve: &HermiteCurve) -> Self {
        Self {
            pieces: curve.segments().map(|segment| Piece::new(&segment)).collect(),
            knots: curve.knots().to_vec(),
            slack: TIE * curve.bounds().extent(),
        }
    }

    /// The point of the curve that is nearest to `place`; of several equally near the one with the smallest t.
    pub fn nearest(&self, place: Point) -> Nearest {
        let mut best = Nearest { t: 0.0, point: place, distance: f64::INFINITY };
        for (i, piece) in self.pieces.iter().enumerate() {
            let mut found = (best.distance, f64::NAN);
            search(piece, place, self.slack, &mut found);
            if !found.1.is_nan() {
                let y = found.1;
                let t = self.knots[i] + (y + 0.5) * (self.knots[i + 1] - self.knots[i]);
                best = Nearest { t, point: piece.position(y), distance: found.0 };
            }
        }
        best
    }
}

/// Improves `best` (distance, y) by any nearer place on the piece.
fn search(piece: &Piece, place: Point, slack: f64, best: &mut (f64, f64)) {
    let mut stack = [(0.0, 0.0); STACK];
    stack[0] = (-0.5, 0.5);
    let mut open = 1;
    while open > 0 {
        open -= 1;
        let (lo, hi) = stack[open];
        let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        for y in [lo, middle, hi] {
            try_place(piece, place, slack, y, best);
        }
        let jet = piece.jet(middle);
        let e = jet.position - place;
        let (bend, jolt) = (piece.bend(lo, hi), piece.jolt(lo, hi));
        let speed = jet.first.norm() + bend * half;
        // f = |r − place|²: f(u) ≥ f₀ − |f₀′||u| + least(f″)u²/2 on the interval.
        let far = e.norm() + speed * half;
        let drift = half * (3.0 * speed * bend + far * jolt);
        let second = jet.first.norm_squared() + e.dot(&jet.second) - drift;
        let first = e.dot(&jet.first).abs();
        let lower = e.norm_squared() - 2.0 * first * half + second.min(0.0) * half * half;
        let reach = (best.0 - slack).max(0.0);
        if lower >= reach * reach {
            continue;
        }
        if second > 0.0 {
            let slope = |y: f64| {
                let jet = piece.jet(y);
                let e = jet.position - place;
                (e.dot(&jet.first), jet.first.norm_squared() + e.dot(&jet.second))
            };
            if slope(lo).0 < 0.0 && slope(hi).0 > 0.0 {
                let y = bracketed_root(lo, hi, true, middle, slope);
                try_place(piece, place, slack, y, best);
            }
            continue;
        }
        if open + 2 <= STACK && half > 1e-9 {
            stack[open] = (middle, hi);
            stack[open + 1] = (lo, middle);
            open += 2;
        }
    }
}

fn try_place(piece: &Piece, place: Point, slack: f64, y: f64, best: &mut (f64, f64)) {
    let distance = (piece.position(y) - place).norm();
    if distance < best.0 - slack || (best.1.is_nan() && distance < best.0 && best.0.is_infinite()) {
        *best = (distance, y);
    } else if distance < best.0 {
        // Nearer by a rounding only: keep the smaller parameter, but not a worse distance.
        best.0 = best.0.min(distance);
    }
}
