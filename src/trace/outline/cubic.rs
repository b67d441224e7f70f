//! One cubic through two given points.

mod fit;

pub(in crate::trace) use self::fit::Fitted;
use crate::numerics::plane::taxi;
use crate::numerics::{Point, Vector};

/// A cubic by its ends and the way from each end to its control point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::trace) struct Cubic {
    pub(in crate::trace) start: Point,
    /// First control point less start.
    pub(in crate::trace) leaving: Vector,
    /// End less second control point.
    pub(in crate::trace) arriving: Vector,
    pub(in crate::trace) end: Point,
}

/// What is known of the tangent at an end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::trace) enum Tangent {
    /// Nothing.
    Free,
    /// Its direction, of length 1, along the curve.
    Along(Vector),
}

impl Cubic {
    pub(in crate::trace) const fn bernstein(t: f64) -> [f64; 4] {
        let u = 1.0 - t;
        [u * u * u, 3.0 * u * u * t, 3.0 * u * t * t, t * t * t]
    }

    pub(in crate::trace) fn point(&self, t: f64) -> Point {
        let [_, b, c, d] = Self::bernstein(t);
        self.start + (self.end - self.start) * (c + d) + self.leaving * b - self.arriving * c
    }

    /// The part between two parameters; where it ends with the whole, to the last bit.
    #[inline(never)]
    pub(in crate::trace) fn part(&self, from: f64, to: f64) -> Self {
        let share = to - from;
        let (start, leaving) = if from == 0.0 {
            (self.start, self.leaving)
        } else {
            (self.point(from), self.velocity(from) / 3.0)
        };
        let (end, arriving) =
            if to == 1.0 { (self.end, self.arriving) } else { (self.point(to), self.velocity(to) / 3.0) };
        Self { start, leaving: leaving * share, arriving: arriving * share, end }
    }

    /// The way between its control points.
    pub(in crate::trace) fn middle(&self) -> Vector {
        self.end - self.start - self.leaving - self.arriving
    }

    /// How far it is along its control polygon by rows and columns: at least as many borders of pixels as it crosses,
    /// but for those at its ends.
    pub(in crate::trace) fn taxi_length(&self) -> f64 {
        taxi(self.leaving) + taxi(self.middle()) + taxi(self.arriving)
    }

    pub(in crate::trace) fn velocity(&self, t: f64) -> Vector {
        let u = 1.0 - t;
        (self.leaving * (u * u) + self.middle() * (2.0 * u * t) + self.arriving * (t * t)) * 3.0
    }
}
