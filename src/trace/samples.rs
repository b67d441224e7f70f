//! Evenly spaced places of a closed polyline, and what a few of them say about line, tangent and curvature.

use super::picture::blur::half_gaussian;
use crate::error::Result;
use crate::limits::with_room;
use crate::numerics::Point;
use crate::numerics::Vector;
use crate::numerics::plane::{cross, dot, norm, square};

/// Half a pixel between places: contours of pixels have no finer detail.
const SPACING: f64 = 0.5;

/// Places on each side that a tangent is taken from.
const ENOUGH: usize = 8;

/// A cubic is taken for the contour up to here, in pixels: the contour of exact coverage strays by a twenty-fifth.
const STRAY: f64 = 0.11;

/// A polyline at even distances.
#[derive(Debug)]
pub(super) struct Samples {
    /// The places; those of a closed polyline twice, so that every stretch of it lies in one piece.
    ring: Vec<Point>,
    count: usize,
    /// The distance between neighbours along the polyline.
    pub(super) spacing: f64,
    /// Whether the last place is followed by the first.
    pub(super) closed: bool,
}

/// A cubic near a place, in numbers of places before and after it.
struct Local {
    /// Where it is at the place, less the place.
    middle: Vector,
    slope: Vector,
    curve: Vector,
    twist: Vector,
}

/// A line through the middle of some places.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub(super) middle: Point,
    /// Of length 1, in the order of the places.
    pub(super) direction: Vector,
}

impl Samples {
    /// A closed polyline.
    ///
    /// # Errors
    ///
    /// `OutOfMemory` only.
    pub(super) fn new(polyline: &[Point]) -> Result<Self> {
        let back = [polyline[polyline.len() - 1], polyline[0]];
        let sides = || polyline.windows(2).chain([&back[..]]).map(|side| (side[0], side[1]));
        let length: f64 = sides().map(|(from, to)| norm(to - from)).sum();
        let count = ((length / SPACING).round() as usize).max(8);
        let spacing = length / count as f64;
        let mut points = with_room(2 * count)?;
        let (mut travelled, mut next) = (0.0, 0.0);
        sides().for_each(|(from, to)| {
            let way = to - from;
            let step = norm(way);
            while points.len() < count && next <= travelled + step {
                let share = if step > 0.0 { (next - travelled) / step } else { 0.0 };
                points.push(from + way * share);
                next = points.len() as f64 * spacing;
            }
            travelled += step;
        });
        while points.len() < count {
            points.push(polyline[0]);
        }
        points.extend_from_within(..);
        Ok(Self { ring: points, count, spacing, closed: true })
    }

    /// The closed polyline with every place at the mean of those around it, weighted by a Gaussian of so many pixels
    /// along the polyline.
    pub(super) fn evened(&self, deviation: f64) -> Result<Self> {
        let half = half_gaussian(deviation / self.spacing);
        let mean = |i: isize| {
            let here = self.at(i);
            let mut way = Vector::zeros();
            for (d, &weight) in (1..).zip(&half[1..]) {
                way += (self.at(i - d) - here + (self.at(i + d) - here)) * weight;
            }
            here + way
        };
        let mut places = with_room(self.count)?;
        places.extend((0..self.count as isize).map(mean));
        Self::new(&places)
    }

    /// An open polyline, both ends included.
    pub(super) fn open(polyline: &[Point]) -> Self {
        let length: f64 = polyline.windows(2).map(|pair| norm(pair[1] - pair[0])).sum();
        let count = ((length / SPACING).round() as usize).max(4);
        let spacing = length / count as f64;
        let mut points = Vec::with_capacity(count + 1);
        let mut travelled = 0.0;
        for pair in polyline.windows(2) {
            let step = norm(pair[1] - pair[0]);
            while points.len() < count && points.len() as f64 * spacing <= travelled + step {
                let share = if step > 0.0 { (points.len() as f64 * spacing - travelled) / step } else { 0.0 };
                points.push(pair[0] + (pair[1] - pair[0]) * share);
            }
            travelled += step;
        }
        while points.len() <= count {
            points.push(polyline[polyline.len() - 1]);
        }
        Self { ring: points, count: count + 1, spacing: spacing.max(1e-9), closed: false }
    }

    pub(super) fn len(&self) -> usize {
        self.count
    }

    /// Every place once.
    pub(super) fn places(&self) -> &[Point] {
        &self.ring[..self.count]
    }

    /// The place at a signed index, around the polyline; the ends of an open one go on for ever.
    #[inline]
    pub(super) fn at(&self, i: isize) -> Point {
        match self.ring.get(i as usize) {
            Some(&place) => place,
            None => self.beyond(i),
        }
    }

    #[cold]
    #[inline(never)]
    fn beyond(&self, i: isize) -> Point {
        let count = self.count as isize;
        let i = if self.closed { i.rem_euclid(count) } else { i.max(0).min(count - 1) };
        self.ring[i as usize]
    }

    /// How many places span a distance.
    pub(super) fn steps(&self, distance: f64) -> isize {
        (distance / self.spacing).round() as isize
    }

    /// Places `first` to `last` around the polyline, both included, at most once around; what is beyond the end of an
    /// open one is left out.
    pub(super) fn stretch(&self, first: isize, last: isize) -> &[Point] {
        let count = self.count as isize;
        let start = match first {
            _ if !self.closed || (0..count).contains(&first) => first,
            // A division takes as long as a short stretch.
            _ if (-count..0).contains(&first) => first + count,
            _ => first.rem_euclid(count),
        };
        let inside = |i: isize| (i.max(0) as usize).min(self.ring.len());
        let end = inside(start + last + 1 - first);
        &self.ring[inside(start).min(end)..end]
    }

    /// What is so many places before, at and after every place, from the first one on that has so many before it
    /// without going round; nothing where they would meet.
    pub(super) fn surroundings(&self, reach: usize) -> [&[Point]; 3] {
        let rounds = if 2 * reach > self.count { 0 } else { self.count.min(self.ring.len() - 2 * reach) };
        [0, 1, 2].map(|k| self.ring.get(k * reach..k * reach + rounds).unwrap_or_default())
    }

    /// The place and the tangent at index i, from a cubic in the distance: over as much on both sides, from `least` up
    /// to `most` places, as the cubic stays near to.
    pub(super) fn smoothed(&self, i: isize, least: isize, most: isize) -> (Point, Vector) {
        let mut reach = least.max(3);
        let mut found = self.cubic(i, reach);
        loop {
            let next = (reach * 3 / 2).max(reach + 1);
            if next > most {
                break;
            }
            let wider = self.cubic(i, next);
            if self.strays(i, next, &wider) {
                break;
            }
            (reach, found) = (next, wider);
        }
        (self.at(i) + found.middle, unit(found.slope))
    }

    /// The cubic over ± `reach` places.
    #[inline(never)]
    fn cubic(&self, i: isize, reach: isize) -> Local {
        // Symmetric: even and odd coefficients do not depend on each other.
        let mut sums = [Vector::zeros(); 4];
        let (mut second, mut fourth, mut sixth) = (0.0, 0.0, 0.0);
        let here = self.at(i);
        let mut n = 1.0;
        for d in (1..=reach).step_by(stride(reach)) {
            n += 2.0;
            let (x, after, before) = (d as f64, self.at(i + d) - here, self.at(i - d) - here);
            let (even, odd, xx) = (after + before, after - before, x * x);
            sums[0] += even;
            sums[1] += odd * x;
            sums[2] += even * xx;
            sums[3] += odd * (xx * x);
            second += 2.0 * xx;
            fourth += 2.0 * xx * xx;
            sixth += 2.0 * xx * xx * xx;
        }
        let curve = (sums[2] - sums[0] * (second / n)) / (fourth - second * second / n);
        let middle = (sums[0] - curve * second) / n;
        let twist = (sums[3] - sums[1] * (fourth / second)) / (sixth - fourth * fourth / second).max(1e-9);
        let slope = (sums[1] - twist * fourth) / second;
        Local { middle, slope, curve, twist }
    }

    /// Whether a place of the contour is far from the cubic over it. The outermost most often are.
    #[inline(never)]
    fn strays(&self, i: isize, reach: isize, &Local { middle, slope, curve, twist }: &Local) -> bool {
        let (here, stride) = (self.at(i), stride(reach) as isize);
        let mut d = -reach;
        while d <= reach {
            let x = d as f64;
            let off = self.at(i + d) - here - middle - (slope + curve * x + twist * (x * x)) * x;
            if square(off).sqrt() > STRAY {
                return true;
            }
            d += stride;
        }
        false
    }

    /// Whether the size of the curvature at place i is surely from `least` to `most`: the angle is at least its sine
    /// and at most its tangent, and no angle has to be known.
    pub(super) fn bends_between(&self, i: isize, reach: isize, [least, most]: [f64; 2]) -> bool {
        const SURELY: f64 = 1e-9;
        let (before, after) = (self.at(i) - self.at(i - reach), self.at(i + reach) - self.at(i));
        let lengths = [norm(before), norm(after)];
        let (sine, cosine) = (cross(before, after).abs(), dot(before, after));
        let mean = (0.5 * (lengths[0] + lengths[1])).max(1e-9);
        sine * (1.0 - SURELY) >= least * mean * lengths[0] * lengths[1]
            && sine * (1.0 + SURELY) <= most * mean * cosine
    }

    /// The turning per pixel at place i over ± `reach` places.
    pub(super) fn curvature(&self, i: isize, reach: isize) -> f64 {
        let (before, after) = (self.at(i) - self.at(i - reach), self.at(i + reach) - self.at(i));
        let angle = libm::atan2(cross(before, after), dot(before, after));
        angle / (0.5 * (norm(before) + norm(after))).max(1e-9)
    }
}

/// Few places on each side say as much: neighbours of a contour err alike.
fn stride(reach: isize) -> usize {
    (reach as usize).div_ceil(ENOUGH).max(1)
}

/// The vector at length 1; along x where it has none.
pub(super) fn unit(v: Vector) -> Vector {
    let length = norm(v);
    if length > 1e-12 { v / length } else { Vector::new(1.0, 0.0) }
}

/// The angle from one direction to another, in (−π, π].
pub(super) fn turn(from: Vector, to: Vector) -> f64 {
    libm::atan2(cross(from, to), dot(from, to))
}

/// The line that is nearest to the places in the mean square.
pub(super) fn line_through(points: &[Point]) -> Line {
    Moments::of(points).line()
}

/// What places say of the line through them, summed up from the first one on. Places that follow can be added.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moments {
    first: Point,
    last: Point,
    count: usize,
    sum: Vector,
    xx: f64,
    xy: f64,
    yy: f64,
}

impl Moments {
    pub(super) fn of(points: &[Point]) -> Self {
        let first = points[0];
        let none = Self { first, last: first, count: 0, sum: Vector::zeros(), xx: 0.0, xy: 0.0, yy: 0.0 };
        none.with(points)
    }

    /// With the places that follow.
    #[inline]
    pub(super) fn with(mut self, points: &[Point]) -> Self {
        // Seen from the first place the sums are as exact as about the middle, which is not known yet.
        for p in points {
            let d = p - self.first;
            self.sum += d;
            self.xx += d.x * d.x;
            self.xy += d.x * d.y;
            self.yy += d.y * d.y;
        }
        self.count += points.len();
        self.last = points.last().copied().unwrap_or(self.last);
        self
    }

    /// The middle, and a vector at twice the angle of the larger moment: its coordinates and its length.
    #[inline]
    fn axis(&self) -> (Point, [f64; 3]) {
        let Self { first, sum, .. } = *self;
        let mean = sum * (1.0 / self.count as f64);
        let (xx, yy) = (self.xx - sum.x * mean.x, self.yy - sum.y * mean.y);
        let (a, b) = (xx - yy, 2.0 * (self.xy - sum.x * mean.y));
        (first + mean, [a, b, (a * a + b * b).sqrt()])
    }

    /// The line that is nearest in the mean square.
    pub(super) fn line(&self) -> Line {
        let (middle, [a, b, length]) = self.axis();
        Line { middle, direction: principal_axis(a, b, length, self.last - self.first) }
    }

    /// Whether none of some places is farther than `most` from the line that is nearest to all in the mean square; the
    /// last ones are looked at first.
    #[inline]
    pub(super) fn is_line(&self, points: &[Point], most: f64) -> bool {
        let (middle, [a, b, length]) = self.axis();
        let axis = half_angle(a, b, length, self.last - self.first);
        // Of any length: of both sides of the inequality the squares are compared.
        let (level, bound) = (cross(axis, middle), most * most * square(axis));
        points.iter().rev().all(|&p| {
            let off = cross(axis, p) - level;
            off * off <= bound
        })
    }
}

/// The direction of the larger moment, on the side of a way: half the angle of (a, b) = (xx − yy, 2xy), whose length is
/// given, without angles.
#[inline]
pub(super) fn principal_axis(a: f64, b: f64, length: f64, way: Vector) -> Vector {
    let axis = unit(half_angle(a, b, length, way));
    if dot(way, axis) < 0.0 { -axis } else { axis }
}

/// A vector at half the angle of (a, b), whose length is given; where that is 0, the other one.
#[inline]
fn half_angle(a: f64, b: f64, length: f64, other: Vector) -> Vector {
    if length < 1e-300 {
        other
    } else if a >= 0.0 {
        Vector::new(length + a, b)
    } else {
        Vector::new(b, length - a)
    }
}

impl Line {
    /// How far a point is to the left, with y down to the right.
    pub(super) fn offset(&self, p: Point) -> f64 {
        cross(self.direction, p - self.middle)
    }

    /// The place on the line that is nearest to a point.
    pub(super) fn nearest(&self, p: Point) -> Point {
        self.middle + self.direction * dot(self.direction, p - self.middle)
    }

    /// Where two lines meet, if they are not nearly parallel.
    pub(super) fn meets(&self, other: &Self) -> Option<Point> {
        let sine = cross(self.direction, other.direction);
        if sine.abs() < 0.05 {
            return None;
        }
        Some(self.middle + self.direction * (cross(other.middle - self.middle, other.direction) / sine))
    }
}
