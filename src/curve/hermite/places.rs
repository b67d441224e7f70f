//! Where the samples of a uniform sampling lie: which segment, and where in it.

use super::HermiteCurve;
use crate::numerics::lists::steps;

/// The parameters i·end/steps, i = 0 … count − 1.
///
/// With segments of one length, places are worked out in whole numbers: the same places recur in every segment to
/// the last bit when the samples divide evenly among them.
pub(super) struct Places {
    /// From sample to sample, in t.
    pub(super) step: f64,
    /// How many samples there are.
    pub(super) count: usize,
    end: f64,
    steps: f64,
    /// Number of segments, if all have one length.
    even: Option<u64>,
    /// Samples on each of them, if they divide evenly; else 0.
    each: usize,
}

/// Factor, divisor and offset of places on one segment.
pub(super) type Run = [f64; 3];

/// Where sample i is, as [`Places::place`] of twice i.
#[inline(always)]
pub(super) fn place([factor, divisor, offset]: Run, i: usize) -> f64 {
    i as f64 * factor / divisor - offset
}

impl Places {
    pub(super) fn new(curve: &HermiteCurve, count: usize) -> Self {
        let (_, end) = curve.domain();
        let steps = steps(count, curve.is_closed()) as f64;
        let even = curve.is_even().then_some(curve.segment_count() as u64);
        let segments = curve.segment_count() as u64;
        let each =
            if (steps as u64).is_multiple_of(segments) { (steps as u64 / segments) as usize } else { 0 };
        Self { step: end / steps, count, end, steps, even, each }
    }

    /// The segment of sample i; at a knot the one that starts there.
    pub(super) fn segment_of(&self, curve: &HermiteCurve, i: usize) -> usize {
        let last = curve.segment_count() - 1;
        match self.even {
            Some(segments) => {
                ((i as u64).saturating_mul(segments) / self.steps as u64).min(last as u64) as usize
            }
            None => {
                let t = self.t(i);
                curve.knots().partition_point(|&knot| knot <= t).saturating_sub(1).min(last)
            }
        }
    }

    /// The first sample at or beyond the start of segment s.
    #[inline(never)]
    pub(super) fn first_sample(&self, curve: &HermiteCurve, s: usize) -> usize {
        if let Some(segments) = self.even {
            return match self.each {
                0 => (s as u64 * self.steps as u64).div_ceil(segments) as usize,
                each => s * each,
            };
        }
        let knot = curve.knots()[s];
        let mut i = (knot * self.steps / self.end).ceil() as usize;
        while i > 0 && self.t(i - 1) >= knot {
            i -= 1;
        }
        while self.t(i) < knot {
            i += 1;
        }
        i
    }

    /// Where in segment s sample half/2 is, in shares of [`Places::unit`]; odd `half` are halfway between two samples.
    #[inline]
    pub(super) fn place(&self, curve: &HermiteCurve, s: usize, half: usize) -> f64 {
        match self.even {
            Some(segments) => half as f64 * segments as f64 - 2.0 * s as f64 * self.steps,
            None => 0.5 * half as f64 * self.end / self.steps - curve.knots()[s],
        }
    }

    /// How places on segment s follow from the number of the sample: [`place`].
    pub(super) fn run(&self, curve: &HermiteCurve, s: usize) -> Run {
        match self.even {
            Some(segments) => [2.0 * segments as f64, 1.0, 2.0 * s as f64 * self.steps],
            None => [self.end, self.steps, curve.knots()[s]],
        }
    }

    /// The whole of segment s in the unit of [`Places::place`].
    pub(super) fn unit(&self, curve: &HermiteCurve, s: usize) -> f64 {
        if self.even.is_some() { 2.0 * self.steps } else { curve.lengths()[s] }
    }

    /// Whether sample i is the start of segment s.
    pub(super) fn is_at_knot(&self, curve: &HermiteCurve, s: usize, i: usize) -> bool {
        match self.even {
            Some(segments) => i as f64 * segments as f64 == s as f64 * self.steps,
            None => self.t(i) == curve.knots()[s],
        }
    }

    fn t(&self, i: usize) -> f64 {
        i as f64 * self.end / self.steps
    }
}
