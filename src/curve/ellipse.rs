//! Exact circles, ellipses and arcs: points and tangents that the trigonometric space reproduces.
//!
//! r(t) = c + a·cos(ωt)·u + b·sin(ωt)·v lies in span{1, t, cos ωt, sin ωt}, so its points and derivatives at the
//! knots are all that a curve needs; two points make a whole circle (ω = π).

use core::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI, TAU};

use super::hermite::{HermiteCurve, HermiteOptions};
use super::limits::{LARGEST_COORDINATE, MOST_POINTS, too_many};
use crate::error::{Error, Result};
use crate::generator::Space;
use crate::numerics::angle::sin_cos;
use crate::numerics::{Point, Vector};

impl HermiteCurve {
    /// An ellipse from `count` points, exact for every count from 2 up.
    ///
    /// Point k lies at the angle 2πk/count from the first axis; the ellipse runs from the first axis towards the
    /// second, `rotation` turns both (radians).
    ///
    /// # Accuracy
    ///
    /// Within 2e-15 of the size everywhere (`tests/ellipses.rs`). Points at multiples of a quarter turn are exact.
    ///
    /// # Errors
    ///
    /// Radii that are not positive, numbers that are not finite or beyond ±1e9, fewer than 2 points.
    pub fn ellipse(center: Point, radii: Vector, rotation: f64, count: usize) -> Result<Self> {
        let frame = Frame::new(center, radii, rotation)?;
        if count < 2 {
            return Err(Error::TooFewPoints { argument: "count", got: count, needed: 2 });
        }
        if count > MOST_POINTS {
            return Err(too_many("count", "maxPoints", MOST_POINTS, count));
        }
        let omega = TAU / count as f64;
        let (points, tangents) = (0..count).map(|k| frame.place(turn(k, count), omega)).unzip();
        Self::new(HermiteOptions {
            points,
            tangents,
            closed: true,
            space: Some(Space::Trigonometric),
            omega: vec![omega],
            ..HermiteOptions::default()
        })
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
        check_within("start", start, LARGEST_COORDINATE)?;
        check_within("sweep", sweep, TAU)?;
        if sweep == 0.0 {
            return Err(Error::Degenerate { argument: "sweep", index: None, reason: "an arc of no extent" });
        }
        let segments = if sweep.abs() > PI { 2 } else { 1 };
        let step = sweep / f64::from(segments);
        let angles = (0..=segments).map(|k| direction(start + step * f64::from(k)));
        let (points, tangents) = angles.map(|unit| frame.place(unit, step)).unzip();
        Self::new(HermiteOptions {
            points,
            tangents,
            space: Some(Space::Trigonometric),
            omega: vec![step.abs()],
            ..HermiteOptions::default()
        })
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
        check_within("center", center.x, LARGEST_COORDINATE)?;
        check_within("center", center.y, LARGEST_COORDINATE)?;
        for (index, &radius) in radii.iter().enumerate() {
            check_within("radii", radius, LARGEST_COORDINATE)?;
            if radius <= 0.0 {
                let (index, least) = (Some(index), f64::MIN_POSITIVE);
                let most = LARGEST_COORDINATE;
                return Err(Error::OutOfRange { argument: "radii", index, value: radius, least, most });
            }
        }
        check_within("rotation", rotation, LARGEST_COORDINATE)?;
        let (cos, sin) = direction(rotation);
        Ok(Self {
            center,
            first: Vector::new(radii.x * cos, radii.x * sin),
            second: Vector::new(-radii.y * sin, radii.y * cos),
        })
    }

    /// The point in the direction (cos, sin) and its derivative when the angle moves at `speed`.
    fn place(&self, (cos, sin): (f64, f64), speed: f64) -> (Point, Vector) {
        let offset = self.first * cos + self.second * sin;
        (self.center + offset, (self.second * cos - self.first * sin) * speed)
    }
}

fn check_within(argument: &'static str, value: f64, most: f64) -> Result<()> {
    if !value.is_finite() {
        return Err(Error::NotFinite { argument, index: None });
    }
    if value.abs() > most {
        return Err(Error::OutOfRange { argument, index: None, value, least: -most, most });
    }
    Ok(())
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
    quarter_turns(quarter, if mirrored { (sin, cos) } else { (cos, sin) })
}

/// (cos, sin) of an angle, exact where it is the double nearest to a multiple of a quarter turn.
pub(super) fn direction(angle: f64) -> (f64, f64) {
    let quarters = libm::round(angle / FRAC_PI_2);
    if quarters.abs() < 1e6 && (angle - quarters * FRAC_PI_2).abs() <= f64::EPSILON * angle.abs() {
        return quarter_turns((quarters as i64).rem_euclid(4) as u64, (1.0, 0.0));
    }
    cos_sin(angle)
}

fn cos_sin(angle: f64) -> (f64, f64) {
    let (sin, cos) = sin_cos(angle);
    (cos, sin)
}

fn quarter_turns(quarters: u64, (cos, sin): (f64, f64)) -> (f64, f64) {
    match quarters {
        0 => (cos, sin),
        1 => (-sin, cos),
        2 => (-cos, -sin),
        _ => (sin, -cos),
    }
}
