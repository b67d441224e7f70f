//! Exact circles, ellipses and arcs: points and tangents that the trigonometric space reproduces.
//!
//! r(t) = c + a·cos(ωt)·u + b·sin(ωt)·v lies in span{1, t, cos ωt, sin ωt}, so its points and derivatives at the
//! knots are all that a curve needs; two points make a whole circle (ω = π).

use core::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI, TAU};

use super::{HermiteCurve, HermiteOptions};
use crate::error::{Error, Result};
use crate::limits::{LARGEST_COORDINATE, MOST_POINTS, check, too_many, with_room};
use crate::numerics::angle::{quarter_turned, sin_cos};
use crate::numerics::{Point, Vector};

impl HermiteCurve {
    /// An ellipse from `count` points, exact for every count from 2 up.
    ///
    /// Point k lies at the angle 2πk/count from the first axis; the ellipse runs from the first axis towards the
    /// second, `rotation` turns both (radians).
    ///
    /// # Accuracy
    ///
    /// Within 2e-15 of the size everywhere (`tests/curve/ellipses.rs`). Points at multiples of a quarter turn are
    /// exact.
    ///
    /// # Errors
    ///
    /// Radii that are not positive, numbers that are not finite or beyond ±1e9, fewer than 2 points.
    pub fn ellipse(center: Point, radii: Vector, rotation: f64, count: usize) -> Result<Self> {
        let frame = Frame::new(center, radii, rotation)?;
        if count < 2 {
            return Err(Error::too_few("count", count, 2));
        }
        if count > MOST_POINTS {
            return Err(too_many("count", "maxPoints", MOST_POINTS, count));
        }
        frame.curve(TAU / count as f64, count, &mut |k| turn(k, count), true)
    }

    /// An open arc of an ellipse from angle `start` over `sweep`, both in radians from the first axis.
    ///
    /// It has one segment for every half turn that is begun; a negative sweep runs backwards. A sweep of ±2π is
    /// the whole ellipse as an open curve.
    ///
    /// # Errors
    ///
    /// As for [`HermiteCurve::ellipse`]; a sweep of 0 is degenerate, one beyond ±2π out of range.
    pub fn arc(center: Point, radii: Vector, rotation: f64, start: f64, sweep: f64) -> Result<Self> {
        let frame = Frame::new(center, radii, rotation)?;
        check("start", None, start, -LARGEST_COORDINATE, LARGEST_COORDINATE)?;
        check("sweep", None, sweep, -TAU, TAU)?;
        if sweep == 0.0 {
            return Err(Error::degenerate("sweep", None, "an arc of no extent"));
        }
        let segments = if sweep.abs() > PI { 2 } else { 1 };
        let step = sweep / segments as f64;
        frame.curve(step, segments + 1, &mut |k| direction(start + step * k as f64), false)
    }
}

/// An ellipse's centre and half axes.
struct Frame {
    center: Point,
    first: Vector,
    second: Vector,
}

impl Frame {
    fn new(center: Point, radii: Vector, rotation: f64) -> Result<Self> {
        let most = LARGEST_COORDINATE;
        for (argument, index, value, least) in [
            ("center", Some(0), center.x, -most),
            ("center", Some(1), center.y, -most),
            ("radii", Some(0), radii.x, f64::MIN_POSITIVE),
            ("radii", Some(1), radii.y, f64::MIN_POSITIVE),
            ("rotation", None, rotation, -most),
        ] {
            check(argument, index, value, least, most)?;
        }
        let (cos, sin) = direction(rotation);
        let (first, second) = (Vector::new(cos, sin) * radii.x, Vector::new(-sin, cos) * radii.y);
        Ok(Self { center, first, second })
    }

    /// The curve through the points in the directions (cos, sin) that `unit` gives, `step` radians apart.
    fn curve(
        &self,
        step: f64,
        count: usize,
        unit: &mut dyn FnMut(usize) -> (f64, f64),
        closed: bool,
    ) -> Result<HermiteCurve> {
        let (mut points, mut tangents) = (with_room(count)?, with_room(count)?);
        for k in 0..count {
            let (cos, sin) = unit(k);
            points.push(self.center + (self.first * cos + self.second * sin));
            tangents.push((self.second * cos - self.first * sin) * step);
        }
        let omega = vec![step.abs()];
        HermiteCurve::new(HermiteOptions { points, tangents, closed, omega, ..HermiteOptions::default() })
    }
}

/// (cos, sin) of k/n of a turn: reduced in whole numbers, so that symmetric points are mirror images to the last
/// bit and quarter turns are exact.
pub(super) fn turn(k: usize, n: usize) -> (f64, f64) {
    let (k, n) = ((k % n) as u64, n as u64);
    let quarter = 4 * k / n;
    let rest = 4 * k - quarter * n;
    let (mirrored, part) = if 2 * rest > n { (true, n - rest) } else { (false, rest) };
    let (cos, sin) = if 2 * part == n {
        (FRAC_1_SQRT_2, FRAC_1_SQRT_2)
    } else {
        let angle = FRAC_PI_2 * (part as f64 / n as f64);
        cos_sin(angle)
    };
    quarter_turned(quarter as f64, if mirrored { (sin, cos) } else { (cos, sin) })
}

/// (cos, sin) of an angle, exact where it is the double nearest to a multiple of a quarter turn.
pub(super) fn direction(angle: f64) -> (f64, f64) {
    let quarters = (angle / FRAC_PI_2).round_ties_even();
    if quarters.abs() < 1e6 && (angle - quarters * FRAC_PI_2).abs() <= f64::EPSILON * angle.abs() {
        return quarter_turned(quarters, (1.0, 0.0));
    }
    cos_sin(angle)
}

fn cos_sin(angle: f64) -> (f64, f64) {
    let (sin, cos) = sin_cos(angle);
    (cos, sin)
}
