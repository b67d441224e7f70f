//! One cubic Bézier curve for one arc, and the proof of its distance.
//!
//! The cubic shares the ends and the tangent directions of the arc; the lengths of its two handles are free, and are
//! chosen so that it crosses the arc at two places, which for a short arc makes the three lobes of the error equal:
//! s²(1 − s)²((s − ½)² − x) is least for x = 0.026 446. The error is of the sixth order in the width.
//!
//! The proof matches parameters: a polynomial σ of degree 6 through exact feet takes the cubic's s to the arc's y, onto
//! and monotone, so E(s) = c(s) − r(σ(s)) bounds the distance both ways. E is entire. Its Chebyshev coefficients beyond the
//! tenth add up to at most 2M·ρ⁻¹⁰/(ρ − 1) with M = max|E| on the ellipse of half-axis sum ρ [Trefethen, theorem 8.1], and
//! a polynomial of degree 10 is at most 1/cos(π/8) of its largest value at 40 Chebyshev points [Ehlich and Zeller, 1964].
//! So 40 values of E bound it everywhere; where that misses the tolerance by less than what it may be too large by, 160
//! do, with degree 16.

use crate::curve::piece::{Jet, Piece};
use crate::numerics::plane::{cross, dot, norm, square};
use crate::numerics::{Point, Vector};

/// Where the cubic crosses the arc: ½ ± √0.026 446.
const CROSSINGS: [f64; 2] = [0.337_377, 0.662_623];
/// Where the three lobes of the error are highest.
const LOBES: [f64; 3] = [0.1823, 0.5, 0.8177];
/// Degree of σ.
const DEGREE: usize = 6;
/// cos(πk/6), k = 0 … 3.
const COSINES: [f64; 4] = [1.0, 0.866_025_403_784_438_6, 0.5, 0.0];
/// Chebyshev points at which E is looked at.
struct Looks {
    count: usize,
    /// Chebyshev coefficients beyond this one are bounded, not looked at.
    degree: i32,
    /// 1/cos(degree·π/2·count), rounded up.
    between: f64,
    /// Sine and cosine of π/2·count, and of π/count.
    first: [f64; 2],
    turn: [f64; 2],
}

const LOOKS: [Looks; 2] = [
    Looks {
        count: 40,
        degree: 10,
        between: 1.0824,
        first: [0.03925981575906861, 0.9992290362407229],
        turn: [0.07845909572784494, 0.996917333733128],
    },
    Looks {
        count: 160,
        degree: 16,
        between: 1.0125,
        first: [0.009817319337149617, 0.999951808959328],
        turn: [0.0196336924606283, 0.9998072404820648],
    },
];

/// A cubic near an arc.
pub(super) type Cubic = [Point; 4];

/// The point of a cubic.
pub(super) fn cubic_at(cubic: &Cubic, s: f64) -> Point {
    let z = 1.0 - s;
    let (start, end) = (cubic[0] * z + cubic[1] * (3.0 * s), cubic[2] * (3.0 * z) + cubic[3] * s);
    start * (z * z) + end * (s * s)
}

/// The cubic with the ends and the end derivatives of the arc.
pub(super) fn hermite_cubic(piece: &Piece, lo: f64, hi: f64) -> Cubic {
    let (from, to, third) = (piece.jet(lo), piece.jet(hi), (hi - lo) / 3.0);
    [from.position, from.position + from.first * third, to.position - to.first * third, to.position]
}

/// The cubic that crosses the arc twice; the one with the end derivatives where there is none.
pub(super) fn fit(piece: &Piece, lo: f64, hi: f64) -> Cubic {
    let plain = hermite_cubic(piece, lo, hi);
    crossing_cubic(piece, lo, hi, &plain).unwrap_or(plain)
}

fn crossing_cubic(piece: &Piece, lo: f64, hi: f64, plain: &Cubic) -> Option<Cubic> {
    let (from, to, width) = (piece.jet(lo), piece.jet(hi), hi - lo);
    let chord = norm(to.position - from.position);
    let (leaving, first) = direction(from.first * width, from.second * (width * width), chord)?;
    let (arriving, last) = direction(to.first * width, to.second * (-width * width), chord)?;
    let (mut alpha, mut beta) = (first / 3.0, last / 3.0);
    let (most_alpha, most_beta) = (4.0 * alpha, 4.0 * beta);
    let mut feet = CROSSINGS.map(|s| lo + width * s);
    let mut cubic = *plain;
    for _ in 0..12 {
        cubic[1] = cubic[0] + leaving * alpha;
        cubic[2] = cubic[3] - arriving * beta;
        let mut rows = [[0.0; 3]; 2];
        for ((row, foot), &s) in rows.iter_mut().zip(&mut feet).zip(&CROSSINGS) {
            let c = cubic_at(&cubic, s);
            *foot = step_to_foot(piece, c, *foot, lo, hi);
            *foot = step_to_foot(piece, c, *foot, lo, hi);
            let jet = piece.jet(*foot);
            let tangent = jet.first / norm(jet.first);
            let z = 1.0 - s;
            *row = [
                3.0 * s * z * z * cross(tangent, leaving),
                -3.0 * s * s * z * cross(tangent, arriving),
                cross(tangent, c - jet.position),
            ];
        }
        let [[a, b, u], [c, d, v]] = rows;
        let determinant = a * d - b * c;
        let (step_alpha, step_beta) = ((b * v - d * u) / determinant, (c * u - a * v) / determinant);
        alpha += step_alpha;
        beta += step_beta;
        if !(alpha > 0.0 && alpha < most_alpha && beta > 0.0 && beta < most_beta) {
            return None;
        }
        if step_alpha.abs() + step_beta.abs() <= 1e-9 * chord {
            cubic[1] = cubic[0] + leaving * alpha;
            cubic[2] = cubic[3] - arriving * beta;
            return Some(cubic);
        }
    }
    None
}

/// The unit tangent at an end and the speed there; where the speed is zero the second derivative points the way.
fn direction(first: Vector, second: Vector, chord: f64) -> Option<(Vector, f64)> {
    let speed = norm(first);
    let acceleration = norm(second);
    if speed > 1e-6 * acceleration {
        return Some((first / speed, speed));
    }
    // Of the second derivative the sign at an end is that of the way into the arc, or out of it.
    let way = second / acceleration;
    if acceleration > 0.0 && way.x.is_finite() { Some((way, chord)) } else { None }
}

/// A Newton step from y towards the foot of a point on the arc.
#[inline(never)]
fn step_to_foot(piece: &Piece, point: Point, y: f64, lo: f64, hi: f64) -> f64 {
    let Jet { position, first, second, .. } = piece.jet(y);
    let e = point - position;
    let speed = square(first);
    // Beyond the centre of curvature the full Newton step would lead away.
    let next = y + dot(e, first) / (speed - dot(e, second)).max(0.25 * speed);
    if next > lo && next < hi { next } else { y }
}

/// The distance of the cubic at its three lobes: an estimate of the largest.
pub(super) fn estimate(piece: &Piece, cubic: &Cubic, lo: f64, hi: f64) -> f64 {
    let mut worst: f64 = 0.0;
    for s in LOBES {
        let c = cubic_at(cubic, s);
        let mut y = lo + (hi - lo) * s;
        for _ in 0..3 {
            y = step_to_foot(piece, c, y, lo, hi);
        }
        worst = worst.max(norm(c - piece.position(y)));
    }
    worst
}

/// A proved bound of the distance between the cubic and the arc, both ways; infinite where the proof does not succeed.
pub(super) fn prove(piece: &Piece, cubic: &Cubic, lo: f64, hi: f64, tolerance: f64) -> f64 {
    let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
    let mut feet = [0.0; DEGREE + 1];
    for (j, foot) in feet.iter_mut().enumerate() {
        let x = cosine(j);
        let mut y = middle + half * x;
        if j > 0 && j < DEGREE {
            let c = cubic_at(cubic, 0.5 + 0.5 * x);
            for _ in 0..4 {
                y = step_to_foot(piece, c, y, lo, hi);
            }
        }
        *foot = y - middle;
    }
    let sigma = chebyshev(&feet);
    let uneven: f64 = sigma.iter().enumerate().skip(2).map(|(k, c)| (k * k) as f64 * c.abs()).sum();
    if uneven.is_nan() || uneven >= sigma[1] {
        return f64::INFINITY;
    }
    let rounding = 4.0 * f64::EPSILON * cubic.iter().map(|p| p.x.abs() + p.y.abs()).fold(0.0, f64::max);
    let mut bound = f64::INFINITY;
    for looks in &LOOKS {
        let tail = tail(piece, cubic, &sigma, middle, looks.degree);
        let worst = largest_look(piece, cubic, &sigma, middle, looks);
        bound = looks.between * (worst + tail) + tail + rounding;
        if bound <= tolerance || worst > tolerance {
            break;
        }
    }
    if bound.is_finite() { bound } else { f64::INFINITY }
}

/// max|c(s) − r(σ(s))| at the Chebyshev points.
fn largest_look(piece: &Piece, cubic: &Cubic, sigma: &[f64; DEGREE + 1], middle: f64, looks: &Looks) -> f64 {
    let ([turn_sine, turn_cosine], [mut sine, mut cosine]) = (looks.turn, looks.first);
    let mut worst: f64 = 0.0;
    for _ in 0..looks.count {
        let (mut one, mut two) = (0.0, 0.0);
        for &c in sigma[1..].iter().rev() {
            (one, two) = (2.0 * cosine * one - two + c, one);
        }
        let y = middle + sigma[0] + cosine * one - two;
        worst = worst.max(square(cubic_at(cubic, 0.5 + 0.5 * cosine) - piece.position(y)));
        (sine, cosine) = (sine * turn_cosine + cosine * turn_sine, cosine * turn_cosine - sine * turn_sine);
    }
    worst.sqrt()
}

/// What the Chebyshev coefficients of E beyond that degree add up to at most.
fn tail(piece: &Piece, cubic: &Cubic, sigma: &[f64; DEGREE + 1], middle: f64, degree: i32) -> f64 {
    let jet = piece.jet(middle);
    let [p0, p1, p2, p3] = *cubic;
    let constant = norm((p0 + p3 + (p1 + p2) * 3.0) * 0.125 - jet.position);
    let linear = norm((p3 - p0 + p2 - p1) * 0.375);
    let second = norm((p0 - p1 - p2 + p3) * 0.375);
    let third = norm((p3 - p0 + (p1 - p2) * 3.0) * 0.125);
    let mut least = f64::INFINITY;
    for rho in [3.0_f64, 4.0, 6.0, 9.0, 16.0, 32.0] {
        // |Tₖ| is at most (ρᵏ + ρ⁻ᵏ)/2 on the ellipse.
        let reach = 0.5 * (growths(sigma, rho) + growths(sigma, 1.0 / rho));
        let [arc, _] = piece.within(&jet, middle, reach);
        let x = 0.5 * (rho + 1.0 / rho);
        let largest = arc + constant + x * (linear + x * (second + x * third));
        least = least.min(2.0 * largest / (rho.powi(degree) * (rho - 1.0)));
    }
    least
}

/// Σ|cₖ|ρᵏ.
#[inline(never)]
fn growths(sigma: &[f64], rho: f64) -> f64 {
    sigma.iter().rev().fold(0.0, |sum, c| sum * rho + c.abs())
}

/// cos(πj/6).
#[inline(never)]
fn cosine(j: usize) -> f64 {
    match j % 12 {
        j @ 0..=3 => COSINES[j],
        j @ 4..=6 => -COSINES[6 - j],
        j @ 7..=9 => -COSINES[j - 6],
        j => COSINES[12 - j],
    }
}

/// Chebyshev coefficients of the polynomial with these values at cos(πj/6).
fn chebyshev(values: &[f64; DEGREE + 1]) -> [f64; DEGREE + 1] {
    let mut coefficients = [0.0; DEGREE + 1];
    for (k, coefficient) in coefficients.iter_mut().enumerate() {
        for (j, value) in values.iter().enumerate() {
            let weight = if j == 0 || j == DEGREE { 0.5 } else { 1.0 };
            *coefficient += weight * value * cosine(j * k) * (2.0 / DEGREE as f64);
        }
        if k == 0 || k == DEGREE {
            *coefficient *= 0.5;
        }
    }
    coefficients
}
