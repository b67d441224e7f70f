//! Deletion that heals: one segment in place of two, as near to both as the space allows.

use core::f64::consts::{PI, TAU};

use super::HermiteCurve;
use super::deviation::{deviation_of, two_way_deviation};
use crate::curve::Segment;
use crate::error::{Error, Result};
use crate::generator::{Basis, Space};
use crate::limits::{LARGEST_FREQUENCY, POLE_MARGIN};
use crate::numerics::{Point, Vector};
use places::places;

mod places;
mod speeds;

/// A segment whose turning, as `turning` sums it, is so much more than that of the old ones has a loop that they have
/// not.
const MORE_TURNING: f64 = 1.0;
/// Chords from which a segment's turning is read, and along which places are laid on it.
const CHORDS: usize = 32;

impl HermiteCurve {
    /// The curve without point i, and how far it is from the old one.
    ///
    /// The two segments at the point become one whose parameter length is their sum. The directions of the
    /// tangents at its ends stay, their lengths are chosen so that what is farthest away is nearly as near as it can be
    /// without a loop, and no shorter than a tenth of the way for each unit of the parameter, unless the old ones were
    /// (nothing on the far side changes).
    /// Two pieces of one segment, and two arcs of one ellipse, become what they were: inserting a point and
    /// removing it gives the old curve back. Removing an end of an open curve takes its segment away.
    ///
    /// # Accuracy
    ///
    /// The deviation is the largest distance between old and new segments, measured both ways at 97 places each and on
    /// from the farthest, uphill; at an end of an open curve, how far the segment taken away reaches from the one
    /// beside it.
    ///
    /// # Errors
    ///
    /// An index beyond the last point; too few points if there are 2.
    pub fn remove(&self, i: usize) -> Result<(Self, f64)> {
        self.check_index(i)?;
        let left = self.points().len() - 1;
        if left < 2 {
            return Err(Error::too_few("points", left + 1, 3));
        }
        let segments = self.segment_count();
        let (before, after) = (if i == 0 { segments - 1 } else { i - 1 }, i);
        let mut deviation = 0.0;
        let curve = self.changed(&mut |data| {
            let at = if !self.is_closed() && (i == 0 || i == left) {
                let (gone, kept) = if i == 0 { (0, 1) } else { (before, before - 1) };
                deviation = deviation_of(&[self.nth_segment(gone)], &[self.nth_segment(kept)], f64::INFINITY);
                gone
            } else {
                let old = [self.nth_segment(before), self.nth_segment(after)];
                let healed = Healed::new(&old, self.omega()[before], self.omega()[after]);
                data.tangents[before] = healed.leaving;
                data.tangents_in[self.next(i)] = healed.arriving;
                data.omega[before] = healed.omega;
                data.lengths[before] = old[0].length + old[1].length;
                deviation = healed.deviation;
                after
            };
            for list in [&mut data.points, &mut data.tangents, &mut data.tangents_in] {
                list.remove(i);
            }
            for list in [&mut data.omega, &mut data.lengths] {
                list.remove(at);
            }
        })?;
        Ok((curve, deviation))
    }
}

/// The segment that replaces two (D 7.2).
#[derive(Clone, Copy)]
struct Healed {
    omega: f64,
    leaving: Vector,
    arriving: Vector,
    deviation: f64,
}

impl Healed {
    fn new(old: &[Segment; 2], first_omega: f64, second_omega: f64) -> Self {
        let [first, second] = old;
        let length = first.length + second.length;
        let omega = joint_frequency(old, first_omega, second_omega);
        // If both are pieces of one segment, their parameters run at speeds that match in the middle.
        let ratio = second.leaving.norm() / first.arriving.norm();
        let ratio = if ratio.is_finite() && ratio > 0.0 { ratio } else { 1.0 };
        let scale = if ratio == 1.0 { 1.0 } else { (first.length + second.length * ratio) / length };
        let basis = Basis::new(first.basis.space(), omega * length);
        let merged = Segment {
            start: first.start,
            end: second.end,
            leaving: first.leaving * scale,
            arriving: second.arriving * (scale / ratio),
            length,
            basis: &basis,
        };
        let size = (first.end - first.start).norm() + (second.end - second.start).norm();
        // Far from the origin places round by more than that.
        let rounding = 4.0 * f64::EPSILON * (first.start.norm() + second.end.norm());
        let places = places(old, first.length / (first.length + second.length * ratio));
        // Where the parameters agree there is nothing to look for; it also bounds the distance from above.
        let mut deviation = 0.0_f64;
        for [x, target_x, target_y] in places {
            deviation = deviation.max((merged.position(x) - Point::new(target_x, target_y)).norm());
        }
        let Segment { leaving, arriving, .. } = merged;
        let mut healed = Self { omega, leaving, arriving, deviation };
        if deviation > 1e-13 * size + rounding {
            healed.deviation = f64::INFINITY;
            let mut best = Best { old, most: turning(&[&way(first), &way(second)]) + MORE_TURNING, healed };
            speeds::nearest(&merged, &places, &mut best);
            best.look(&merged);
            healed = best.healed;
            if healed.deviation == f64::INFINITY {
                healed.deviation = two_way_deviation(old, &[merged], f64::INFINITY);
            }
        }
        healed
    }
}

/// The ω with which the angle of both segments is run through, or half a turn where one segment cannot.
fn joint_frequency([first, second]: &[Segment; 2], first_omega: f64, second_omega: f64) -> f64 {
    let length = first.length + second.length;
    // Of cubics the frequency means nothing, but is kept within what it may be.
    let angle = first_omega * first.length + second_omega * second.length;
    let round = first.basis.space() == Space::Trigonometric;
    if angle > if round { TAU - POLE_MARGIN } else { LARGEST_FREQUENCY } {
        PI / length
    } else if first_omega == second_omega {
        first_omega
    } else {
        angle / length
    }
}

/// The nearest of the segments that were looked at so far.
struct Best<'a> {
    old: &'a [Segment<'a>; 2],
    /// What turns by more is left out.
    most: f64,
    healed: Healed,
}

impl Best<'_> {
    #[inline(never)]
    fn look(&mut self, candidate: &Segment) {
        if turning(&[&way(candidate)]) <= self.most {
            let apart = two_way_deviation(self.old, &[*candidate], self.healed.deviation);
            if apart < self.healed.deviation {
                let Segment { leaving, arriving, .. } = *candidate;
                self.healed = Healed { leaving, arriving, deviation: apart, ..self.healed };
            }
        }
    }
}

/// The ends of the chords of a segment.
#[inline(never)]
fn way(segment: &Segment) -> [Point; CHORDS + 1] {
    // Made from what is computed: a list of zeros would be filled in first.
    core::array::from_fn(|k| segment.position(k as f64 / CHORDS as f64))
}

/// How much segments turn, to and fro, from chord to chord: of each angle four times the tangent of its quarter, which
/// is no less, and little more even where a bend lies between two chords that the old segments show in many.
#[inline(never)]
fn turning(ways: &[&[Point]]) -> f64 {
    let (mut sum, mut last) = (0.0, Vector::zeros());
    for way in ways {
        for pair in way.windows(2) {
            let next = pair[1] - pair[0];
            let (across, along) =
                ((last.x * next.y - last.y * next.x).abs(), last.norm() * next.norm() + last.dot(&next));
            if across > 0.0 {
                sum += 4.0 * across / (along + (along * along + across * across).sqrt());
            }
            last = next;
        }
    }
    sum
}
