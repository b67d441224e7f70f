//! Points that are equally far apart along their curve: the curve says where they belong.
//!
//! Feet alone use nothing of what points say along the curve, and half of what they say is along it. Where they follow
//! one another evenly, the length of the curve gives them their parameters back, and all that they say counts (D 13.9).

mod drift;
mod spaced;

pub(super) use self::spaced::Spaced;
use super::breaks::HIGHEST;
use super::free_knots::{Located, in_order};
use super::look::taylor;
use super::spline::Spline;
use crate::numerics::plane::{larger, smaller};

/// Parts of a piece on which the length is a cubic of the parameter.
const PARTS: usize = 8;

/// The length from the first place of a curve to others.
struct Lengths {
    at: Vec<f64>,
    to: Vec<f64>,
    speed: Vec<f64>,
}

impl Lengths {
    /// Simpson's rule on the parts of every piece.
    fn new(spline: &Spline) -> Self {
        let spans = &spline.space.spans;
        let mut lengths = Self { at: Vec::new(), to: Vec::new(), speed: Vec::new() };
        let mut sum = 0.0;
        for (s, (span, piece)) in spans.iter().zip(spline.pieces()).enumerate() {
            let speed = |t: f64| {
                let along = taylor::<{ HIGHEST + 1 }>(&piece, (t - span.middle) / span.half)[1];
                along.norm() / span.half
            };
            let step = 2.0 * span.half / PARTS as f64;
            let mut before = speed(span.middle - span.half);
            for part in 0..PARTS {
                let t = span.middle - span.half + part as f64 * step;
                let after = speed(t + step);
                lengths.at.push(t);
                lengths.to.push(sum);
                lengths.speed.push(before);
                sum += step / 6.0 * (before + 4.0 * speed(t + 0.5 * step) + after);
                before = after;
            }
            if s + 1 == spans.len() {
                lengths.at.push(span.middle + span.half);
                lengths.to.push(sum);
                lengths.speed.push(before);
            }
        }
        lengths
    }

    fn total(&self) -> f64 {
        self.to[self.to.len() - 1]
    }

    /// The length to t, looked for from part `guess` on.
    fn length(&self, t: f64, guess: &mut usize) -> f64 {
        let i = place(&self.at, t, guess);
        let step = self.at[i + 1] - self.at[i];
        value(&self.cubic(i), if step > 0.0 { (t - self.at[i]) / step } else { 0.0 }).0
    }

    /// The parameter at a length.
    fn parameter(&self, length: f64, guess: &mut usize) -> f64 {
        let i = place(&self.to, length, guess);
        let (step, rise) = (self.at[i + 1] - self.at[i], self.to[i + 1] - self.to[i]);
        let mut u = if rise > 0.0 { ((length - self.to[i]) / rise).clamp(0.0, 1.0) } else { 0.0 };
        let cubic = self.cubic(i);
        for _ in 0..2 {
            let (value, slope) = value(&cubic, u);
            if slope > 0.3 * rise {
                u = (u + (length - value) / slope).clamp(0.0, 1.0);
            }
        }
        self.at[i] + u * step
    }

    /// The length on part i as a polynomial of u in [0, 1], in ascending powers.
    #[inline(always)]
    fn cubic(&self, i: usize) -> [f64; 4] {
        let step = self.at[i + 1] - self.at[i];
        let (start, rise) = (self.to[i], self.to[i + 1] - self.to[i]);
        let (first, last) = (step * self.speed[i], step * self.speed[i + 1]);
        [start, first, 3.0 * rise - 2.0 * first - last, first + last - 2.0 * rise]
    }
}

/// A cubic at u, and its derivative.
#[inline(always)]
fn value([start, first, square, cube]: &[f64; 4], u: f64) -> (f64, f64) {
    let value = start + u * (first + u * (square + u * cube));
    (value, first + u * (2.0 * square + u * 3.0 * cube))
}

/// The part of an ascending list that a value is in.
fn place(list: &[f64], value: f64, guess: &mut usize) -> usize {
    let last = list.len() - 2;
    let mut i = (*guess).min(last);
    while i < last && value >= list[i + 1] {
        i += 1;
    }
    while i > 0 && value < list[i] {
        i -= 1;
    }
    *guess = i;
    i
}

/// Points that are equally far apart along a curve.
struct Spread {
    lengths: Lengths,
    /// The length from one to the next, and to the first one.
    step: f64,
    lead: f64,
    closed: bool,
}

impl Spread {
    /// So many points, the first one at the length `lead` of a closed curve.
    fn from(spline: &Spline, count: usize, lead: f64) -> Option<Self> {
        let lengths = Lengths::new(spline);
        let total = lengths.total();
        let known = total > 0.0 && total.is_finite() && count >= 3;
        let closed = spline.space.breaks.closed;
        let steps = if closed { count } else { count.saturating_sub(1) };
        known.then(|| Self { lengths, step: total / steps as f64, lead, closed })
    }

    /// `located` has the feet of the points.
    fn new(spline: &Spline, located: &Located) -> Option<Self> {
        let mut spread = Self::from(spline, located.points.len(), 0.0)?;
        if spread.closed {
            let off = spread.off(located, spline.space.breaks.end);
            spread.lead = off[0] + off.iter().map(|one| one - off[0]).sum::<f64>() / off.len() as f64;
        }
        Some(spread)
    }

    /// By what length each point's foot is ahead of where its number puts it; on closed curves to the round that is
    /// nearest to the first one.
    #[inline(never)]
    fn off(&self, located: &Located, end: f64) -> Vec<f64> {
        let (total, start, mut guess, mut first) = (self.lengths.total(), self.lengths.at[0], 0, 0.0);
        let one = |(m, &foot): (usize, &f64)| {
            let t = if self.closed && foot < start { foot + end } else { foot };
            let off = self.lengths.length(t, &mut guess) - self.lead - self.step * m as f64;
            if m == 0 {
                first = off;
            }
            if self.closed { off - total * libm::round((off - first) / total) } else { off }
        };
        located.parameters.iter().enumerate().map(one).collect()
    }

    /// How often a point of this number is round a closed curve.
    fn turns(&self, number: f64) -> f64 {
        if self.closed { libm::floor((self.lead + self.step * number) / self.lengths.total()) } else { 0.0 }
    }

    /// The parameter of a point of this number as pieces count it.
    fn parameter(&self, number: f64, guess: &mut usize) -> f64 {
        let length = self.lead + self.step * number - self.turns(number) * self.lengths.total();
        self.lengths.parameter(length, guess)
    }
}

/// Parameters that are equally far apart along the curve, ascending from 0, and the breaks that belong to them: on
/// closed curves all parameters are shifted, so that the first point has 0. `located` has the feet of the points.
pub(super) fn by_length(spline: &Spline, located: &Located) -> Option<(Vec<f64>, super::breaks::Breaks)> {
    let spread = Spread::new(spline, located)?;
    let mut breaks = spline.space.breaks.clone();
    let (end, count, mut guess) = (breaks.end, located.points.len(), 0);
    if !breaks.closed {
        let at = |m: usize| smaller(larger(spread.parameter(m as f64, &mut guess), 0.0), end);
        return Some(((0..count).map(at).collect(), breaks));
    }
    let start = spread.parameter(0.0, &mut guess);
    let mut before = 0.0_f64;
    let parameters = (0..count).map(|m| {
        let t = spread.parameter(m as f64, &mut guess) - start;
        let t = if m == 0 {
            0.0
        } else if t < 0.0 {
            t + end
        } else {
            t
        };
        // Rounding must not turn two of them round.
        before = before.max(t).min(end * (1.0 - f64::EPSILON));
        before
    });
    let parameters = parameters.collect();
    for t in &mut breaks.at {
        *t -= start;
    }
    in_order(&mut breaks);
    Some((parameters, breaks))
}
