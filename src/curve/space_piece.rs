//! One piece of a curve in space, a polynomial.
//!
//! Everything rests on Taylor's formula about the middle of an interval: the first three derivatives there and a bound
//! of the fourth bound what the curve can do around it, for complex parameters as well.

use super::speed::{MOST_INTERVALS, ROUNDING, RULES, rule_index};

/// The most intervals that are open at once while a length is added up.
const STACK: usize = 60;
/// Ellipses in which the speed may be analytic, by their larger half-axis.
const AXES: [f64; 5] = [8.0, 4.0, 2.5, 1.7, 1.3];

/// A vector of space.
pub(super) type Triple = [f64; 3];

pub(super) fn dot(u: &Triple, v: &Triple) -> f64 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}

pub(super) fn norm(v: &Triple) -> f64 {
    dot(v, v).sqrt()
}

/// u + v·scale.
pub(super) fn along(u: &Triple, v: &Triple, scale: f64) -> Triple {
    [u[0] + v[0] * scale, u[1] + v[1] * scale, u[2] + v[2] * scale]
}

/// A piece of a curve in space: coefficients of ascending powers of y in [−1/2, 1/2].
pub(super) struct SpacePiece {
    powers: Vec<Triple>,
}

impl SpacePiece {
    /// The piece with these coefficients, all coordinates of each in turn.
    pub(super) fn polynomial(coefficients: &[f64]) -> Self {
        Self { powers: coefficients.as_chunks().0.to_vec() }
    }

    /// The point and its first three derivatives.
    #[inline(never)]
    pub(super) fn jet(&self, y: f64) -> [Triple; 4] {
        let mut jet = [[0.0; 3]; 4];
        for power in self.powers.iter().rev() {
            jet[3] = along(&jet[2], &jet[3], y);
            jet[2] = along(&jet[1], &jet[2], y);
            jet[1] = along(&jet[0], &jet[1], y);
            jet[0] = along(power, &jet[0], y);
        }
        for (derivative, factor) in jet.iter_mut().zip([1.0, 1.0, 2.0, 6.0]) {
            *derivative = derivative.map(|x| x * factor);
        }
        jet
    }

    pub(super) fn position(&self, y: f64) -> Triple {
        self.jet(y)[0]
    }

    pub(super) fn speed(&self, y: f64) -> f64 {
        norm(&self.jet(y)[1])
    }

    /// A bound of |r⁗| for all complex y of at most this modulus.
    pub(super) fn fourth(&self, radius: f64) -> f64 {
        self.fourth_of(radius, &norm)
    }

    /// The same of a part of r: what is as large as its powers are.
    #[inline(never)]
    pub(super) fn fourth_of(&self, radius: f64, size: &dyn Fn(&Triple) -> f64) -> f64 {
        let mut sum = 0.0;
        // Powers below the fourth have no fourth derivative.
        for (k, power) in self.powers.iter().enumerate().skip(4).rev() {
            let k = k as f64;
            sum = sum * radius + k * (k - 1.0) * (k - 2.0) * (k - 3.0) * size(power);
        }
        sum
    }

    /// Two corners of a box that holds the piece.
    pub(super) fn corners(&self) -> [Triple; 2] {
        let (mut around, mut share) = ([0.0; 3], 1.0);
        // The first power is the middle of the box; each other one reaches |y|ⁿ ≤ 2⁻ⁿ of itself away from it.
        for power in self.powers.iter().skip(1) {
            share *= 0.5;
            around = along(&around, &power.map(f64::abs), share);
        }
        [-1.0, 1.0].map(|side| along(&self.position(0.0), &around, side))
    }

    /// A bound of |r″| on the whole piece.
    pub(super) fn bend(&self) -> f64 {
        let [_, _, second, third] = self.jet(0.0);
        norm(&second) + 0.5 * norm(&third) + 0.125 * self.fourth(0.5)
    }

    /// A bound of |r| on the whole piece.
    pub(super) fn size(&self) -> f64 {
        self.powers.iter().map(norm).sum()
    }

    /// The curvature, without a sign; `None` where the speed is below that share of the piece's size.
    pub(super) fn curvature(&self, y: f64, share: f64) -> Option<f64> {
        let [_, first, second, _] = self.jet(y);
        // The first power is where the piece is, and no part of how large it is.
        let size: f64 = self.powers.iter().skip(1).map(norm).sum();
        let speed = norm(&first);
        if speed <= share * size {
            return None;
        }
        // What of the second derivative is across the first.
        let across = along(&second, &first, -dot(&first, &second) / (speed * speed));
        let bend = norm(&across) / (speed * speed);
        bend.is_finite().then_some(bend)
    }

    /// The length from lo to hi.
    ///
    /// Where |r′(u) − r′(m)| stays below (√2 − 1)·|r′(m)| on a disc, r′·r′ has no zero there and the speed is analytic
    /// (D 10.2).
    pub(super) fn length(&self, lo: f64, hi: f64, tolerance: f64) -> f64 {
        let mut stack = [(0.0, 0.0); STACK];
        stack[0] = (lo, hi);
        let (mut open, mut seen, mut total) = (1, 0, 0.0);
        let density = 0.5 * tolerance / (hi - lo).max(f64::MIN_POSITIVE);
        while open > 0 {
            open -= 1;
            seen += 1;
            let (lo, hi) = stack[open];
            let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
            let [_, first, second, third] = self.jet(middle);
            let speed = norm(&first);
            let mut index = RULES.len();
            let mut most = speed;
            for axis in AXES {
                let reach = axis * half;
                let fourth = self.fourth(middle.abs() + reach);
                let change = reach * (norm(&second) + 0.5 * reach * (norm(&third) + reach * fourth / 3.0));
                most = speed + change;
                let within = (density * (hi - lo)).max(ROUNDING * half * most);
                if change < 0.414 * speed {
                    index = index.min(rule_index(axis, most, half, within) as usize);
                }
            }
            // Specks that close in on a cusp.
            if 2.0 * half * most <= tolerance / 16.0 {
                index = 0;
            }
            let dividable = open + 2 <= STACK && seen < MOST_INTERVALS && middle > lo && middle < hi;
            if index >= RULES.len() && dividable {
                stack[open] = (middle, hi);
                stack[open + 1] = (lo, middle);
                open += 2;
                continue;
            }
            for &(x, weight) in RULES[index.min(RULES.len() - 1)] {
                total += half * weight * (self.speed(middle + half * x) + self.speed(middle - half * x));
            }
        }
        total
    }
}
