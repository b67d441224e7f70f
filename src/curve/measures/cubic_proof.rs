//! The proof of how far a cubic is from an arc.
//!
//! Parameters are matched: a polynomial σ of degree 6 through the feet takes the cubic's s to the arc's y, onto
//! and monotone, so E(s) = c(s) − r(σ(s)) bounds the distance both ways. E is entire. Its Chebyshev coefficients beyond
//! the tenth add up to at most 2M·ρ⁻¹⁰/(ρ − 1) with M = max|E| on the ellipse of half-axis sum ρ [Trefethen, theorem
//! 8.1], and a polynomial of degree 10 is at most 1/cos(π/8) of its largest value at 40 Chebyshev points [Ehlich and
//! Zeller, 1964]. So 40 values of E bound it everywhere; where that misses the tolerance by less than what it may be
//! too large by, 160 do, with degree 16.

use core::f64::consts::FRAC_PI_2;

use super::cubic_fit::{Candidate, Cubic, cubic_at};
use crate::curve::piece::Piece;
use crate::numerics::angle::sin_cos;
use crate::numerics::plane::{norm, square};

/// Degree of σ.
const DEGREE: usize = 6;
/// cos(πk/6), k = 0 … 3.
const COSINES: [f64; 4] = [1.0, 0.866_025_403_784_438_6, 0.5, 0.0];

/// Chebyshev points at which E is looked at.
struct Looks {
    count: u32,
    /// Chebyshev coefficients beyond this one are bounded, not looked at.
    degree: u32,
    /// 1/cos(degree·π/2·count), rounded up.
    between: f64,
}

const LOOKS: [Looks; 2] =
    [Looks { count: 40, degree: 10, between: 1.0824 }, Looks { count: 160, degree: 16, between: 1.0125 }];

/// A proved bound of the distance between the cubic and the arc, both ways; infinite where the proof does not succeed.
pub(super) fn prove(piece: &Piece, candidate: &Candidate, tolerance: f64) -> f64 {
    let (cubic, [lo, hi]) = (&candidate.cubic, candidate.ends());
    let middle = 0.5 * (lo + hi);
    let mut feet = [hi - middle, 0.0, 0.0, 0.0, 0.0, 0.0, lo - middle];
    for (j, foot) in (1..DEGREE).zip(&mut feet[1..]) {
        *foot = candidate.foot(piece, 0.5 + 0.5 * cosine(j)).at - middle;
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
    // The first is half as far from the end as they are apart.
    let (mut sine, mut cosine) = sin_cos(FRAC_PI_2 / f64::from(looks.count));
    let (turn_sine, turn_cosine) = (2.0 * sine * cosine, (cosine - sine) * (cosine + sine));
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
fn tail(piece: &Piece, cubic: &Cubic, sigma: &[f64; DEGREE + 1], middle: f64, degree: u32) -> f64 {
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
        // Exact: these are whole numbers below 2⁵³ or powers of two.
        let power = (0..degree).fold(1.0, |power, _| power * rho);
        least = least.min(2.0 * largest / (power * (rho - 1.0)));
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
