//! What comes in: points checked, rid of repetitions, centred and scaled, so that everything after works near 1.

use crate::error::{Error, Result};
use crate::limits::{LARGEST_COORDINATE, check, too_many, with_room};
use crate::numerics::Point;

/// The most points that one fit takes.
pub const MOST_SAMPLES: usize = 500_000;
/// Bytes that a point takes until its fit begins, copies and sorted lists together: 125 were measured.
pub(super) const PER_POINT: usize = 160;
/// Ends closer than this part of the diagonal belong together.
const CLOSE: f64 = 0.03;
/// Points no farther apart than so many roundings of a drawing's size, and so many of where it lies, were computed for
/// one.
const OF_SIZE: f64 = 128.0;
const OF_PLACE: f64 = 4.0;

/// The points of one contour, ready to be fitted.
#[derive(Clone, Debug)]
pub struct Samples {
    /// The points, centred and scaled to about unit size, without repetitions.
    pub points: Vec<Point>,
    /// How many given points each of them stands for.
    pub weights: Vec<f64>,
    /// Which of them each given point became.
    pub place: Vec<u32>,
    /// The middle of the given points.
    pub center: Point,
    /// The given points are `center + scale·points`; a power of two.
    pub scale: f64,
    /// Whether the curve is closed.
    pub closed: bool,
    /// How far a given point is from the one that it became, at most: rounding.
    pub moved: f64,
}

impl Samples {
    /// How far it is from each point to the next, but for the way round from the last.
    pub(super) fn steps(&self) -> Vec<f64> {
        self.points.windows(2).map(|pair| (pair[1] - pair[0]).norm()).collect()
    }

    /// Checks the points and makes them ready. `closed` says whether the curve is; `None` finds out: ends closer than
    /// 3 % of the diagonal belong together. `keep` leaves repetitions alone, for parameters that count them.
    ///
    /// A point that equals the one before, up to rounding, is one with it and weighs more; so is a last point that
    /// equals the first of a closed curve.
    ///
    /// # Errors
    ///
    /// Fewer than two points (three on closed curves), more than 500,000, a coordinate that is not finite or beyond
    /// ±1e9, points that are all one.
    pub fn new(points: &[Point], closed: Option<bool>, keep: bool) -> Result<Self> {
        let needed = if closed == Some(true) { 3 } else { 2 };
        if points.len() < needed {
            return Err(Error::too_few("points", points.len(), needed));
        }
        if points.len() > MOST_SAMPLES {
            return Err(too_many("points", "maxFitSamples", MOST_SAMPLES, points.len()));
        }
        for (i, point) in points.iter().enumerate() {
            check("points", Some(2 * i), point.x, -LARGEST_COORDINATE, LARGEST_COORDINATE)?;
            check("points", Some(2 * i + 1), point.y, -LARGEST_COORDINATE, LARGEST_COORDINATE)?;
        }
        let (low, high) = box_of(points);
        let extent = high - low;
        let size = extent.x.max(extent.y);
        if size <= 0.0 {
            return Err(Error::degenerate("points", None, "all points are one"));
        }
        let closed = closed.unwrap_or_else(|| joins(points, extent.norm()));
        let (center, scale) = (low + extent * 0.5, power_of_two(size));
        let (lists, weights) = (with_room(points.len())?, with_room(points.len())?);
        let mut samples = Self {
            points: lists,
            weights,
            place: with_room(points.len())?,
            center,
            scale,
            closed,
            moved: 0.0,
        };
        let near = f64::EPSILON * (OF_SIZE + OF_PLACE * center.amax() / scale);
        for point in points {
            samples.take((point - center) / scale, keep, near);
        }
        if closed && !keep {
            samples.close(near);
        }
        let left = samples.points.len();
        if left < needed {
            return Err(Error::degenerate("points", None, "too few different points"));
        }
        Ok(samples)
    }

    fn take(&mut self, point: Point, keep: bool, near: f64) {
        match self.points.last() {
            Some(last) if !keep && (point - last).norm() <= near => {
                self.moved = self.moved.max((point - last).norm());
                let last = self.weights.len() - 1;
                self.weights[last] += 1.0;
            }
            _ => {
                self.points.push(point);
                self.weights.push(1.0);
            }
        }
        self.place.push(self.points.len() as u32 - 1);
    }

    /// Lets a last point that is the first one again go into it.
    fn close(&mut self, near: f64) {
        let last = self.points.len() - 1;
        let apart = (self.points[last] - self.points[0]).norm();
        if last > 0 && apart <= near {
            // Points that became the last one are as much farther from the first.
            self.moved += apart;
            self.points.truncate(last);
            let weight = self.weights[last];
            self.weights.truncate(last);
            self.weights[0] += weight;
            for place in self.place.iter_mut().rev().take_while(|place| **place == last as u32) {
                *place = 0;
            }
        }
    }

    /// Whether some points stand for several.
    pub fn is_weighted(&self) -> bool {
        self.weights.iter().any(|&weight| weight != 1.0)
    }
}

fn box_of(points: &[Point]) -> (Point, Point) {
    points.iter().fold((points[0], points[0]), |(low, high), p| (low.inf(p), high.sup(p)))
}

/// Whether the last point is near enough to the first for a closed curve.
fn joins(points: &[Point], diagonal: f64) -> bool {
    points.len() > 3 && (points[points.len() - 1] - points[0]).norm() <= CLOSE * diagonal
}

/// The power of two next below: dividing by it changes no digit.
fn power_of_two(size: f64) -> f64 {
    f64::from_bits(size.to_bits() & 0x7FF0_0000_0000_0000).max(f64::MIN_POSITIVE)
}
