//! Sums over the points of every piece: all that least squares needs to know of them.

use super::Located;
use crate::fit::knots::breaks::HIGHEST;
use crate::fit::knots::space::{Polynomial, STIFF, Space};

/// Sums over the points of one piece.
#[derive(Clone, Copy, Debug, Default)]
pub(in super::super) struct Moments {
    pub(in super::super) count: usize,
    powers: [f64; 2 * HIGHEST + 1],
    pub(super) x: Polynomial,
    pub(super) y: Polynomial,
    pub(super) square: f64,
    /// What the square of every coefficient above the second costs: more than points would ever pay, on pieces that are
    /// to be straight.
    pub(super) stiff: f64,
}

impl Moments {
    /// Σ w·a(u)·uʲ for all j: with the coefficients of another polynomial its scalar product is Σ w·a(u)·b(u), and what
    /// bending costs.
    pub(super) fn weighted(&self, degree: usize, a: &Polynomial) -> Polynomial {
        // Loops of a length that is known are unrolled.
        if degree < 4 { self.weighted_of::<4>(a) } else { self.weighted_of::<{ HIGHEST + 1 }>(a) }
    }

    #[inline(always)]
    fn weighted_of<const T: usize>(&self, a: &Polynomial) -> Polynomial {
        let mut sums = [0.0; HIGHEST + 1];
        for (i, a) in a[..T].iter().enumerate() {
            for (sum, power) in sums[..T].iter_mut().zip(&self.powers[i..i + T]) {
                *sum += a * power;
            }
        }
        if self.stiff > 0.0 {
            for (sum, a) in sums[2..T].iter_mut().zip(&a[2..T]) {
                *sum += self.stiff * a;
            }
        }
        sums
    }
}

/// The scalar product of two lists of coefficients: what is above their degree is 0.
#[inline(always)]
pub(in super::super) fn product(a: &Polynomial, b: &Polynomial) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The sums of every piece, in one pass.
pub(super) fn gather(space: &Space, data: &Located) -> Vec<Moments> {
    let mut moments = match space.breaks.degree {
        3 => gathered(space, data, 3),
        degree => gathered(space, data, degree),
    };
    if !space.breaks.straight.is_empty() {
        let whole: f64 = moments.iter().map(|sums| sums.powers[0]).sum();
        let stiff = STIFF * whole / moments.len() as f64;
        let straight = (0..moments.len()).filter(|&s| space.breaks.is_straight(s));
        straight.for_each(|s| moments[s].stiff = stiff);
    }
    moments
}

#[inline(always)]
fn gathered(space: &Space, data: &Located, degree: usize) -> Vec<Moments> {
    let mut moments = vec![Moments::default(); space.spans.len()];
    let (mut s, mut m) = (0, 0);
    while m < data.points.len() {
        let (found, first) = space.find(data.parameters[m], s);
        s = found;
        let span = &space.spans[s];
        let (low, high) = (span.middle - span.half, span.middle + span.half);
        let shift = if first > data.parameters[m] { space.breaks.end } else { 0.0 };
        let mut sums = moments[s];
        let mut t = first;
        // The points that follow are mostly on the same piece.
        loop {
            let point = data.points[m];
            let u = (t - span.middle) / span.half;
            let weight = data.weight(m);
            sums.count += 1;
            sums.square += weight * point.norm_squared();
            let mut power = weight;
            for k in 0..=degree {
                sums.powers[k] += power;
                sums.x[k] += power * point.x;
                sums.y[k] += power * point.y;
                power *= u;
            }
            for sum in &mut sums.powers[degree + 1..=2 * degree] {
                *sum += power;
                power *= u;
            }
            m += 1;
            match data.parameters.get(m) {
                Some(next) if m < data.points.len() && next + shift >= low && next + shift < high => {
                    t = next + shift;
                }
                _ => break,
            }
        }
        moments[s] = sums;
    }
    moments
}
