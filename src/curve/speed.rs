//! Integrals of the speed, by Gauss–Legendre sums whose error is proved.
//!
//! ```text
//! |∫ − sum of n nodes| ≤ (64/15)·M·ρ⁻²ⁿ/(1 − ρ⁻²)
//! ```
//!
//! where ρ is the sum of the half-axes of an ellipse around the interval in which the speed is analytic, and M its
//! largest modulus there [Trefethen, theorem 19.3]. The speed √((x′ + iy′)(x′ − iy′)) is singular only where a factor
//! vanishes: at the two roots of a quadratic, for every segment of every space. So the largest ellipse is known.

use super::piece::{HERMITE, Jet, Piece, panels};
use crate::numerics::Vector;
use crate::numerics::plane::{larger, norm, smaller, square, taxi};
use crate::numerics::quadrature::{EIGHT, Rule, SIXTEEN, THIRTY_TWO, TWELVE, TWENTY, TWENTY_FOUR};

/// The rules, by the index that [`rule_index`] gives.
pub(super) const RULES: [&Rule; 6] = [&EIGHT, &TWELVE, &SIXTEEN, &TWENTY, &TWENTY_FOUR, &THIRTY_TWO];
/// Lengths are computed to this share of a segment's largest at best: rounding makes more digits meaningless.
pub(super) const ROUNDING: f64 = 1e-15;
/// Halvings of an interval after which what is left counts as nothing.
const MOST_HALVINGS: usize = 60;
/// Intervals of one piece at most: two cusps take some hundred.
pub(super) const MOST_INTERVALS: usize = 8192;
/// How many cubics choose their rules together, as vector code.
const BLOCK: usize = 8;
/// Ellipses are not taken larger than this half-axis: fewer than eight nodes are never used.
const LARGEST_AXIS: f64 = 8.0;

/// Discs around a polynomial's interval on which its speed may be analytic, in half widths.
const DISCS: [f64; 8] = [LARGEST_AXIS, 5.5, 4.0, 3.0, 2.4, 1.9, 1.5, 1.25];

/// Adds up the lengths of pieces; cubics are taken in blocks.
pub(super) struct LengthSum {
    tolerance: f64,
    total: f64,
    count: usize,
    /// Twice the speed's polynomial in s = 2y: r′ = v₀ + v₁s + v₂s², x and y of each.
    velocity: [[f64; BLOCK]; 6],
    /// The same, scaled to about 1.
    scaled: [[f32; BLOCK]; 6],
    /// A bound of |v₀|, |v₁|, |v₂| each.
    sizes: [[f64; BLOCK]; 3],
}

impl LengthSum {
    /// An empty sum; every piece's length will be within `tolerance`.
    #[inline(always)]
    pub(super) fn new(tolerance: f64) -> Self {
        // Zeros would be filled in by a call of the engine's.
        let ones = [1.0; BLOCK];
        Self {
            tolerance,
            total: 0.0,
            count: 0,
            velocity: [ones; 6],
            scaled: [[1.0; BLOCK]; 6],
            sizes: [ones; 3],
        }
    }

    /// Adds a piece.
    #[inline]
    pub(super) fn add(&mut self, piece: &Piece) {
        self.total += piece_length(piece, -0.5, 0.5, self.tolerance);
    }

    /// Adds the cubic with these derivatives in the middle.
    #[inline]
    pub(super) fn add_cubic(&mut self, b: Vector, p: Vector, q: Vector) {
        let k = self.count % BLOCK;
        let (p, q) = (p * 0.5, q * 0.125);
        let sizes = [taxi(b), taxi(p), taxi(q)];
        let scale = 1.0 / (sizes[0] + sizes[1] + sizes[2]);
        for (i, value) in [b.x, b.y, p.x, p.y, q.x, q.y].into_iter().enumerate() {
            self.velocity[i][k] = value;
            self.scaled[i][k] = (value * scale) as f32;
        }
        for (i, size) in sizes.into_iter().enumerate() {
            self.sizes[i][k] = size;
        }
        self.count = k + 1;
        if self.count == BLOCK {
            self.flush();
        }
    }

    pub(super) fn finish(&mut self) -> f64 {
        self.flush();
        self.total
    }

    fn flush(&mut self) {
        let mut axes = [0.0; BLOCK];
        let v = &self.scaled;
        for (k, axis) in axes.iter_mut().enumerate() {
            *axis = single_half_axis([v[0][k], v[1][k]], [v[2][k], v[3][k]], [v[4][k], v[5][k]]);
        }
        let mut index = [0.0; BLOCK];
        for (k, index) in index.iter_mut().enumerate() {
            let axis = f64::from(axes[k]);
            let largest = self.sizes[0][k] + axis * (self.sizes[1][k] + axis * self.sizes[2][k]);
            *index = rule_index(axis, largest, 0.5, larger(self.tolerance, ROUNDING * largest));
        }
        for pair in 0..self.count.div_ceil(2).min(BLOCK / 2) {
            let (one, two) = (index[2 * pair], index[2 * pair + 1]);
            let lengths = RULES.get(larger(one, two) as usize).map(|rule| self.pair_speeds(pair, rule));
            for side in 0..2 {
                let k = 2 * pair + side;
                if k < self.count {
                    self.total += lengths.map_or_else(|| self.cubic_length(k), |lengths| 0.5 * lengths[side]);
                }
            }
        }
        self.count = 0;
    }

    #[cold]
    fn cubic_length(&self, k: usize) -> f64 {
        let at = |i: usize| Vector::new(self.velocity[2 * i][k], self.velocity[2 * i + 1][k]);
        interval_length(&Piece::cubic(at(0), at(1) * 2.0, at(2) * 8.0), -0.5, 0.5, self.tolerance)
    }

    /// Σ wᵢ|r′(xᵢ/2)| of two cubics side by side.
    #[inline]
    fn pair_speeds(&self, pair: usize, rule: &Rule) -> [f64; 2] {
        let lanes = |i: usize| [self.velocity[i][2 * pair], self.velocity[i][2 * pair + 1]];
        let (bx, by, px, py, qx, qy) = (lanes(0), lanes(1), lanes(2), lanes(3), lanes(4), lanes(5));
        let mut total = [0.0; 2];
        for &(x, weight) in rule {
            for k in 0..2 {
                let (even_x, odd_x) = (bx[k] + x * x * qx[k], x * px[k]);
                let (even_y, odd_y) = (by[k] + x * x * qy[k], x * py[k]);
                let (ahead_x, ahead_y) = (even_x + odd_x, even_y + odd_y);
                let (behind_x, behind_y) = (even_x - odd_x, even_y - odd_y);
                total[k] += weight
                    * ((ahead_x * ahead_x + ahead_y * ahead_y).sqrt()
                        + (behind_x * behind_x + behind_y * behind_y).sqrt());
            }
        }
        total
    }
}

/// A bound of the speed within `reach` of the jet, complex parameters included; for cubics one without square roots.
#[inline]
fn largest_speed(piece: &Piece, jet: &Jet, at: f64, reach: f64) -> f64 {
    if piece.is_cubic() {
        return taxi(jet.first) + reach * (taxi(jet.second) + 0.5 * reach * taxi(jet.third));
    }
    piece.within(jet, at, reach)[1]
}

/// The length of a piece between two parameters, within `tolerance`.
#[inline(never)]
pub(super) fn piece_length(piece: &Piece, lo: f64, hi: f64, tolerance: f64) -> f64 {
    if !piece.is_decaying() {
        return interval_length(piece, lo, hi, tolerance);
    }
    decaying_length(piece, lo, hi, tolerance)
}

/// The same where the piece has layers at its ends, panel by panel.
#[cold]
#[inline(never)]
fn decaying_length(piece: &Piece, lo: f64, hi: f64, tolerance: f64) -> f64 {
    let mut total = 0.0;
    panels(piece, &mut |from, to| {
        let (from, to) = (larger(from, lo), smaller(to, hi));
        if from < to {
            total += interval_length(piece, from, to, tolerance / 24.0);
        }
    });
    total
}

#[inline(never)]
fn interval_length(piece: &Piece, lo: f64, hi: f64, tolerance: f64) -> f64 {
    let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
    let jet = piece.jet(middle);
    let tolerance = larger(tolerance, ROUNDING * half * taxi(jet.first));
    let index =
        if piece.is_straight_on(lo, hi) { 0.0 } else { rule_for(piece, &jet, lo, hi, tolerance, 0.0) };
    match RULES.get(index as usize) {
        Some(rule) => half * speeds(piece, &jet, half, middle, rule),
        None => halved_length(piece, lo, hi, tolerance),
    }
}

/// The same where no rule is good enough: the interval is halved, towards cusps again and again.
#[cold]
fn halved_length(piece: &Piece, lo: f64, hi: f64, tolerance: f64) -> f64 {
    let tolerance =
        larger(larger(tolerance, ROUNDING * (hi - lo) * fastest(piece, lo, hi)), f64::MIN_POSITIVE);
    let mut total = 0.0;
    let mut stack = [(0.0, 0.0); MOST_HALVINGS];
    stack[0] = (lo, hi);
    let (mut open, mut seen) = (1, 0);
    // Half of the tolerance is shared by width, half is kept for the intervals that close in on cusps.
    let (density, speck) = (0.5 * tolerance / larger(hi - lo, f64::MIN_POSITIVE), tolerance / 16.0);
    while open > 0 {
        open -= 1;
        seen += 1;
        let (lo, hi) = stack[open];
        let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        let jet = piece.jet(middle);
        let index = rule_for(piece, &jet, lo, hi, density * (hi - lo), speck);
        match RULES.get(index as usize) {
            None if open + 2 <= MOST_HALVINGS && seen < MOST_INTERVALS && middle > lo && middle < hi => {
                stack[open] = (middle, hi);
                stack[open + 1] = (lo, middle);
                open += 2;
            }
            rule => total += half * speeds(piece, &jet, half, middle, rule.unwrap_or(&RULES[0])),
        }
    }
    total
}

/// A bound of the speed, not sharp.
pub(super) fn fastest(piece: &Piece, lo: f64, hi: f64) -> f64 {
    larger(taxi(piece.jet(lo).first), taxi(piece.jet(hi).first)) + (hi - lo) * piece.bend(lo, hi)
}

/// Σ wᵢ|r′(middle + half·xᵢ)|.
fn speeds(piece: &Piece, jet: &Jet, half: f64, middle: f64, rule: &Rule) -> f64 {
    if piece.is_cubic() {
        return cubic_speeds(jet.first, jet.second, jet.third, half, rule);
    }
    let mut sum = 0.0;
    for &(x, weight) in rule {
        let step = half * x;
        sum += weight * (norm(piece.jet(middle + step).first) + norm(piece.jet(middle - step).first));
    }
    sum
}

/// The same for a cubic with the derivatives b, p, q in the middle.
#[inline]
fn cubic_speeds(b: Vector, p: Vector, q: Vector, half: f64, rule: &Rule) -> f64 {
    let (second, third) = (p * half, q * (0.5 * half * half));
    let mut sum = [0.0; 2];
    for &(x, weight) in rule {
        let even = b + third * (x * x);
        let odd = second * x;
        let (along, across) = ([even.x + odd.x, even.x - odd.x], [even.y + odd.y, even.y - odd.y]);
        for side in 0..2 {
            sum[side] += weight * (along[side] * along[side] + across[side] * across[side]).sqrt();
        }
    }
    sum[0] + sum[1]
}

/// The index of the smallest rule whose error on [lo, hi], with the jet in the middle, is at most `tolerance`; beyond
/// the last where the interval must be halved.
fn rule_for(piece: &Piece, jet: &Jet, lo: f64, hi: f64, tolerance: f64, speck: f64) -> f64 {
    let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
    let axis = half_axis(piece, jet, middle, half);
    // What is not a number has no singularity.
    let axis = if axis < LARGEST_AXIS { larger(axis, 1.0) } else { LARGEST_AXIS };
    let largest = largest_speed(piece, jet, middle, axis * half);
    if 2.0 * half * largest <= speck { 0.0 } else { rule_index(axis, largest, half, tolerance) }
}

/// The index from the ellipse's larger half-axis in units of `half` and the largest modulus of the speed in it.
///
/// A rule with n nodes is good where ρ²ⁿ is at least `needed`. All comparisons, no branch.
#[inline]
pub(super) fn rule_index(axis: f64, largest: f64, half: f64, tolerance: f64) -> f64 {
    let rho = axis + larger(0.0, axis * axis - 1.0).sqrt();
    let second = rho * rho;
    // The bound, multiplied out: nothing is divided.
    let needed = (64.0 / 15.0) * largest * half * second;
    let allowed = (second - 1.0) * tolerance;
    let fourth = second * second;
    let eighth = fourth * fourth;
    let sixteenth = eighth * eighth;
    let twice = sixteenth * sixteenth;
    let short = |power: f64| if power * allowed < needed { 1.0 } else { 0.0 };
    short(sixteenth)
        + short(sixteenth * eighth)
        + short(twice)
        + short(twice * eighth)
        + short(twice * sixteenth)
        + short(twice * twice)
}

/// The larger half-axis, in units of `half`, of the largest ellipse with foci ±half in which the speed is analytic.
///
/// With z = x + iy and τ = tan(wu/2)/(w/2), z′ = b + p·sin(wu)/w + q·(1 − cos wu)/w² is zero where
/// (q/2 + w²b/4)τ² + pτ + b = 0; the conjugate's zeros lie in the mirror. A polynomial's velocity has no zero on a disc
/// where it stays nearer to b than b is to 0 (D 10.2).
fn half_axis(piece: &Piece, jet: &Jet, middle: f64, half: f64) -> f64 {
    let (b, p, q, rate) = (jet.first, jet.second, jet.third, piece.rate());
    if piece.is_polynomial() {
        let still = |axis: &f64| {
            let [_, speed] = piece.within(jet, middle, axis * half);
            speed < 2.0 * norm(b)
        };
        return DISCS.into_iter().find(still).unwrap_or(1.0);
    }
    let rate = if HERMITE { rate } else { 0.0 };
    let [lead, s, constant] = root_parts(b, p, q * 0.5 + b * (0.25 * rate), half);
    nearer(axis_through(s, lead, rate, half), axis_through(constant, s, rate, half))
}

/// The smaller half-axis; one that is not a number stands for no singularity.
#[inline]
fn nearer(one: f64, two: f64) -> f64 {
    if one < two || two.is_nan() { one } else { two }
}

/// A lower bound of the half-axis for b + p·s + q·s² on [−1, 1], in single precision: half the digits, a quarter of the
/// time.
///
/// Roundings of 6e-8 of the discriminant move a root by at most 8e-4 of its distance, and the half-axis by no more.
#[inline]
fn single_half_axis(b: [f32; 2], p: [f32; 2], q: [f32; 2]) -> f32 {
    let z_x = p[0] * p[0] - p[1] * p[1] - 4.0 * (q[0] * b[0] - q[1] * b[1]);
    let z_y = 2.0 * p[0] * p[1] - 4.0 * (q[0] * b[1] + q[1] * b[0]);
    let large = (0.5 * ((z_x * z_x + z_y * z_y).sqrt() + z_x.abs())).sqrt();
    let small = 0.5 * z_y / if large > f32::MIN_POSITIVE { large } else { f32::MIN_POSITIVE };
    let (root_x, root_y) = if z_x >= 0.0 { (large, small) } else { (small, large) };
    let side = if root_x * p[0] + root_y * p[1] < 0.0 { 0.5 } else { -0.5 };
    // −(p ± root)/2 on the side that does not cancel: the roots are s/q and b/s.
    let s = if side > 0.0 {
        [0.5 * (root_x - p[0]), 0.5 * (root_y - p[1])]
    } else {
        [-0.5 * (root_x + p[0]), -0.5 * (root_y + p[1])]
    };
    let axis = |n: [f32; 2], d: [f32; 2]| {
        let scale = 0.25 / (d[0] * d[0] + d[1] * d[1]);
        let (ahead_x, ahead_y) = (n[0] - d[0], n[1] - d[1]);
        let (behind_x, behind_y) = (n[0] + d[0], n[1] + d[1]);
        ((ahead_x * ahead_x + ahead_y * ahead_y) * scale).sqrt()
            + ((behind_x * behind_x + behind_y * behind_y) * scale).sqrt()
    };
    let (one, two) = (axis(s, q), axis(b, s));
    // Not a number where both vanish: there is no singularity then.
    let least = if one < two || two.is_nan() { one } else { two } * 0.998;
    let least = if least > 1.0 { least } else { 1.0 };
    if least < LARGEST_AXIS as f32 { least } else { LARGEST_AXIS as f32 }
}

/// The roots of lead·τ² + p·τ + b, in units of `half`, are second/first and third/second of what is returned.
#[inline]
fn root_parts(b: Vector, p: Vector, lead: Vector, half: f64) -> [Vector; 3] {
    let (lead, constant) = (lead * half, b / half);
    let z = product(p, p) - product(lead, constant) * 4.0;
    // A complex square root, on the side of p.
    let large = (0.5 * (norm(z) + z.x.abs())).sqrt();
    let small = 0.5 * z.y / larger(f64::MIN_POSITIVE, large);
    let root = if z.x >= 0.0 { Vector::new(large, small) } else { Vector::new(small, large) };
    let side = if root.x * p.x + root.y * p.y < 0.0 { -1.0 } else { 1.0 };
    [lead, (p + root * side) * -0.5, constant]
}

/// The half-axis of the ellipse through the u with tan(wu/2)/(w/2) = half·numerator/denominator, in units of `half`.
/// Not a number where both vanish: there is no singularity then.
#[inline]
fn axis_through(numerator: Vector, denominator: Vector, rate: f64, half: f64) -> f64 {
    let (n, d) = if rate == 0.0 {
        (numerator, denominator)
    } else {
        (preimage(numerator, denominator, rate, rate.abs().sqrt() * half), Vector::new(1.0, 0.0))
    };
    // (|z − 1| + |z + 1|)/2 for z = n/d.
    let scale = 1.0 / square(d);
    0.5 * ((square(n - d) * scale).sqrt() + (square(n + d) * scale).sqrt())
}

/// That u where w is not 0; `reach` is w·half.
#[inline(never)]
fn preimage(numerator: Vector, denominator: Vector, rate: f64, reach: f64) -> Vector {
    // tan v = ζ: v = (1/2i)·log((1 + iζ)/(1 − iζ)); tanh v = ζ: v = (1/2)·log((1 + ζ)/(1 − ζ)).
    let zeta = numerator * (0.5 * reach);
    let turned = if rate > 0.0 { Vector::new(-zeta.y, zeta.x) } else { zeta };
    let (above, below) = (denominator + turned, denominator - turned);
    let quotient = product(above, Vector::new(below.x, -below.y));
    // Beyond 34 the logarithm is of a rounding: the singularity is at least that far away.
    let size = 0.5 * libm::log(square(above) / square(below));
    let log = Vector::new(size.clamp(-34.0, 34.0), libm::atan2(quotient.y, quotient.x)) / reach;
    if rate > 0.0 { Vector::new(log.y, -log.x) } else { log }
}

/// The product of two complex numbers.
#[inline]
fn product(u: Vector, v: Vector) -> Vector {
    Vector::new(u.x * v.x - u.y * v.y, u.x * v.y + u.y * v.x)
}
