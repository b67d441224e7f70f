//! Deletion that heals: one segment in place of two, as near to both as the space allows.

use core::f64::consts::{PI, TAU};

use super::HermiteCurve;
use super::deviation::{deviation_of, two_way_deviation};
use crate::curve::Segment;
use crate::error::{Error, Result};
use crate::generator::{Basis, Space};
use crate::limits::{LARGEST_FREQUENCY, POLE_MARGIN};
use crate::numerics::{Point, Vector};
use nalgebra::Matrix2;

/// Places on each of the two old segments that the new one is fitted to.
const PLACES: usize = 24;
/// Rounds of foot points and least squares; they converge linearly and fast, most stop after three.
const ROUNDS: usize = 12;

impl HermiteCurve {
    /// The curve without point i, and how far it is from the old one.
    ///
    /// The two segments at the point become one whose parameter length is their sum. The directions of the
    /// tangents at its ends stay, their lengths are fitted (nothing on the far side of the neighbours changes).
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
                deviation = deviation_of(&[self.nth_segment(gone)], &[self.nth_segment(kept)]);
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
        let share = first.length / (first.length + second.length * ratio);
        // Where the parameters agree there is nothing to look for; it also bounds the distance from above.
        let mut deviation = 0.0_f64;
        for [x, target_x, target_y] in places(old, share) {
            deviation = deviation.max((merged.position(x) - Point::new(target_x, target_y)).norm());
        }
        if deviation > 1e-13 * size {
            deviation = two_way_deviation(old, &[merged]);
            let fitted = fit(old, merged, share);
            let fitted_deviation = two_way_deviation(old, &[fitted]);
            if fitted_deviation < deviation {
                (merged, deviation) = (fitted, fitted_deviation);
            }
        }
        Self { omega, leaving: merged.leaving, arriving: merged.arriving, deviation }
    }
}

/// The segment whose end speeds make it nearest to the old ones, by least squares across the curve (D 7.3).
fn fit<'a>(old: &[Segment; 2], mut merged: Segment<'a>, share: f64) -> Segment<'a> {
    let leaving = heading(&old[0], 0.0);
    let arriving = heading(&old[1], 1.0);
    let (mut out, mut inn) = (merged.leaving.norm(), merged.arriving.norm());
    let mut places = places(old, share);
    for _ in 0..ROUNDS {
        merged.leaving = leaving * out;
        merged.arriving = arriving * inn;
        let (mut normal_matrix, mut right) = (Matrix2::zeros(), Vector::zeros());
        for [x, target_x, target_y] in &mut places {
            let target = Point::new(*target_x, *target_y);
            *x = merged.foot(target, merged.foot(target, *x));
            let velocity = merged.velocity(*x);
            let speed = velocity.norm();
            if speed == 0.0 {
                continue;
            }
            let across = Vector::new(-velocity.y, velocity.x) / speed;
            let weights = merged.basis.weights(*x, 0);
            let row = Vector::new(
                across.dot(&leaving) * weights.leaving * merged.length,
                across.dot(&arriving) * weights.arriving * merged.length,
            );
            normal_matrix += row * row.transpose();
            right += row * across.dot(&(target - merged.position(*x)));
        }
        // A trace of damping: collinear tangents leave a speed undetermined.
        let damping = 1e-12 * normal_matrix.trace();
        let damped = normal_matrix + Matrix2::from_diagonal_element(damping);
        let Some(inverse) = damped.try_inverse() else { break };
        let step = inverse * right;
        (out, inn) = ((out + step.x).max(0.0), (inn + step.y).max(0.0));
        if step.norm() <= 1e-14 * (out + inn) {
            break;
        }
    }
    Segment { leaving: leaving * out, arriving: arriving * inn, ..merged }
}

/// Places on the old segments, x and y, after the x in the merged segment that they would have if the first one were this share of the whole.
#[inline(never)]
fn places(old: &[Segment; 2], share: f64) -> [[f64; 3]; 2 * PLACES] {
    let mut places = [[0.0; 3]; 2 * PLACES];
    for (k, place) in places.iter_mut().enumerate() {
        let x = (k % PLACES + 1) as f64 / (PLACES + 1) as f64;
        let (segment, from, to) = if k < PLACES { (&old[0], 0.0, share) } else { (&old[1], share, 1.0) };
        let point = segment.position(x);
        *place = [from + (to - from) * x, point.x, point.y];
    }
    places
}

/// The direction in which a segment leaves x = 0 or arrives at x = 1, also where its speed is 0 there.
#[inline(never)]
fn heading(segment: &Segment, x: f64) -> Vector {
    let towards_inside = if x == 0.0 { 1.0 } else { -1.0 };
    let chord = segment.end - segment.start;
    for direction in [segment.velocity(x), segment.acceleration(x) * towards_inside, chord] {
        let size = direction.norm();
        if size > 1e-12 * chord.norm() / segment.length.max(1.0) && size > 0.0 {
            return direction / size;
        }
    }
    Vector::zeros()
}
