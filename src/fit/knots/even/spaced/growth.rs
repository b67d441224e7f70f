//! How the length from a curve's first place to another grows with its coefficients.

use crate::fit::knots::breaks::HIGHEST;
use crate::fit::knots::even::PARTS;
use crate::fit::knots::look::{Piece, taylor};
use crate::fit::knots::space::{Polynomial, derivative};
use crate::fit::knots::spline::Spline;
use crate::numerics::Vector;

/// One number for each coordinate of each coefficient of a piece: x₀, y₀, x₁, …
pub(super) type Local = [f64; 2 * (HIGHEST + 1)];

/// A place on a curve: the unit vector along, and what it moves by with the coefficients of its piece.
pub(super) struct Place {
    pub(super) u: f64,
    pub(super) along: Vector,
    pub(super) shares: [f64; HIGHEST + 1],
}

impl Place {
    /// At t.
    pub(super) fn new(spline: &Spline, piece: &Piece, s: usize, t: f64) -> Self {
        let (span, basis) = (&spline.space.spans[s], &spline.space.basis[s]);
        let u = (t - span.middle) / span.half;
        let first = taylor::<{ HIGHEST + 1 }>(piece, u)[1];
        let length = first.norm();
        let along = if length > 0.0 { first / length } else { Vector::new(1.0, 0.0) };
        let share = |basis: &Polynomial| basis.iter().rev().fold(0.0, |sum, c| sum * u + c);
        Self { u, along, shares: basis.each_ref().map(share) }
    }
}

/// A part of a piece: the growth from the piece's start to its ends, and how fast it rises there, by the part's length.
#[derive(Clone, Debug)]
pub(super) struct Part {
    ends: [Local; 2],
    slopes: [Local; 2],
}

impl Part {
    /// The growth at u in [0, 1] from the powers 1, u, u² and u³, or the sum over some places from the sums of these.
    #[inline(never)]
    pub(super) fn sum(&self, powers: &[f64; 4]) -> Local {
        let ([start, end], [first, last], [one, u, square, cube]) = (&self.ends, &self.slopes, powers);
        core::array::from_fn(|i| {
            let rise = end[i] - start[i];
            let (two, three) = (3.0 * rise - 2.0 * first[i] - last[i], first[i] + last[i] - 2.0 * rise);
            start[i] * one + first[i] * u + two * square + three * cube
        })
    }
}

/// Growths of a curve.
pub(super) struct Growths {
    pub(super) pieces: Vec<Piece>,
    pub(super) parts: Vec<Part>,
    /// Those from the first place to where each piece starts, and to the last place, by all coefficients and one more.
    pub(super) before: Vec<Vec<f64>>,
}

/// The growths of a curve whose pieces are parted at these places, by Simpson's rule.
pub(super) fn of(spline: &Spline, at: &[f64]) -> Growths {
    let (space, pieces) = (&spline.space, spline.pieces());
    let mut whole = vec![0.0; 2 * space.count + 1];
    let (mut parts, mut before) = (Vec::with_capacity(at.len()), vec![whole.clone()]);
    for (s, piece) in pieces.iter().enumerate() {
        let mut start = [0.0; 2 * (HIGHEST + 1)];
        let from = s * PARTS;
        let mut first = rise(spline, piece, s, at[from]);
        for ends in at[from..=from + PARTS].windows(2) {
            let step = ends[1] - ends[0];
            let (middle, last) =
                (rise(spline, piece, s, ends[0] + 0.5 * step), rise(spline, piece, s, ends[1]));
            let simpson = |i: usize| step / 6.0 * (first[i] + 4.0 * middle[i] + last[i]);
            let end: Local = core::array::from_fn(|i| start[i] + simpson(i));
            let slopes = [first.map(|x| step * x), last.map(|x| step * x)];
            parts.push(Part { ends: [start, end], slopes });
            (start, first) = (end, last);
        }
        for i in 0..=space.breaks.degree {
            let index = 2 * space.index(s, i);
            whole[index] += start[2 * i];
            whole[index + 1] += start[2 * i + 1];
        }
        before.push(whole.clone());
    }
    Growths { pieces, parts, before }
}

/// By how much the speed at t rises.
fn rise(spline: &Spline, piece: &Piece, s: usize, t: f64) -> Local {
    let (space, span) = (&spline.space, &spline.space.spans[s]);
    let u = (t - span.middle) / span.half;
    let first = taylor::<{ HIGHEST + 1 }>(piece, u)[1];
    let length = first.norm();
    let along = if length > 0.0 { first / length } else { Vector::zeros() };
    let mut rise = [0.0; 2 * (HIGHEST + 1)];
    for (rise, basis) in rise.chunks_exact_mut(2).zip(&space.basis[s]).take(space.breaks.degree + 1) {
        let share = derivative(basis, space.breaks.degree, u, span.half, 1);
        (rise[0], rise[1]) = (share * along.x, share * along.y);
    }
    rise
}
