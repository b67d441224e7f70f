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

/// A segment whose turning, as `turning` sums it, is so much more than that of the old ones has a loop that they have not.
const MORE_TURNING: f64 = 1.0;
/// Chords from which a segment's turning is read.
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
    /// The deviation is the largest distance between old and new segments, measured both ways at 97 places each and on from the farthest, uphill;
    /// at an end of an open curve, how far the segment taken away reaches from the one beside it.
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
struct Healed {
    omega: f64,
    leaving: Vector,
    arriving: Vector,
    deviation: f64,
}

impl Healed {
    fn new(old: &[Segment; 2], first_omega: f64, second_omega: f64) -> Self {
        let [first, second] = old;
        let space = first.basis.space();
        let length = first.length + second.length;
        // Of cubics the frequency means nothing, but is kept within what it may be.
        let angle = first_omega * first.length + second_omega * second.length;
        let most = if space == Space::Trigonometric { TAU - POLE_MARGIN } else { LARGEST_FREQUENCY };
        let omega = if angle > most {
            PI / length
        } else if first_omega == second_omega {
            first_omega
        } else {
            angle / length
        };
        // If both are pieces of one segment, their parameters run at speeds that match in the middle.
        let ratio = second.leaving.norm() / first.arriving.norm();
        let ratio = if ratio.is_finite() && ratio > 0.0 { ratio } else { 1.0 };
        let scale = if ratio == 1.0 { 1.0 } else { (first.length + second.length * ratio) / length };
        let basis = Basis::new(space, omega * length);
        let mut merged = Segment {
            start: first.start,
            end: second.end,
            leaving: first.leaving * scale,
            arriving: second.arriving * (scale / ratio),
            length,
            basis: &basis,
        };
        let size = (first.end - first.start).norm() + (second.end - second.start).norm();
        let places = places(old, first.length / (first.length + second.length * ratio));
        // Where the parameters agree there is nothing to look for; it also bounds the distance from above.
        let mut deviation = 0.0_f64;
        for [x, target_x, target_y] in places {
            deviation = deviation.max((merged.position(x) - Point::new(target_x, target_y)).norm());
        }
        if deviation > 1e-13 * size {
            let (plain, most) = (merged, turning(old) + MORE_TURNING);
            deviation = f64::INFINITY;
            let mut look = |candidate| {
                if turning(&[candidate]) <= most {
                    let apart = two_way_deviation(old, &[candidate], deviation);
                    if apart < deviation {
                        (merged, deviation) = (candidate, apart);
                    }
                }
                deviation
            };
            speeds::nearest(old, plain, &places, most, &mut look);
            look(plain);
            if deviation == f64::INFINITY {
                deviation = two_way_deviation(old, &[plain], deviation);
            }
        }
        Self { omega, leaving: merged.leaving, arriving: merged.arriving, deviation }
    }
}

/// How much segments turn, to and fro, from chord to chord: of each angle twice the tangent of its half, which is no less.
fn turning(segments: &[Segment]) -> f64 {
    let (mut sum, mut way) = (0.0, Vector::zeros());
    for segment in segments {
        let mut from = segment.start;
        for k in 1..=CHORDS {
            let to = segment.position(k as f64 / CHORDS as f64);
            let next = to - from;
            let (across, along) =
                ((way.x * next.y - way.y * next.x).abs(), way.norm() * next.norm() + way.dot(&next));
            if across > 0.0 {
                sum += 2.0 * across / along;
            }
            (way, from) = (next, to);
        }
    }
    sum
}
