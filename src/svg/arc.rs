//! The elliptical arc of SVG: from end points, radii and flags to the ellipse that a viewer draws.
//!
//! Everything happens in the frame in which the ellipse is the unit circle. There the half chord h has length
//! s = sin(sweep/2), the centre lies at ±cos(sweep/2) across it, and the directions to the ends are h − c and
//! −h − c: tangents need no angle, and a flat arc of a huge circle keeps all its digits (D 8.1).

use crate::numerics::angle::{quarter_turned, sin_cos};
use crate::numerics::{Point, Vector};
use core::f64::consts::{FRAC_PI_2, PI};

/// A sweep that is larger than π by rounding alone still makes one segment.
pub(super) const HALF_TURN: f64 = PI + 1e-6;

/// The parameters of an `A` command.
#[derive(Clone, Copy, Debug)]
pub(super) struct ArcCommand {
    /// Both radii; signs do not matter.
    pub(super) radii: Vector,
    /// From the x axis of the drawing to that of the ellipse, in degrees.
    pub(super) rotation: f64,
    /// The long way round.
    pub(super) large: bool,
    /// From x towards y.
    pub(super) positive: bool,
}

/// An ellipse's arc: `centre + u·cos θ + v·sin θ` for θ from the direction `first` on by `sweep`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arc {
    pub(super) center: Point,
    pub(super) u: Vector,
    pub(super) v: Vector,
    /// Unit vectors (cos θ, sin θ) at the start, the middle and the end.
    pub(super) first: Vector,
    pub(super) middle: Vector,
    pub(super) last: Vector,
    /// Signed, in radians, within ±2π.
    pub(super) sweep: f64,
}

impl Arc {
    /// What the command draws from `start` to `start + chord`.
    ///
    /// The chord must not be 0 and neither may a radius. `slack` is the relative uncertainty of the chord from
    /// rounding: a chord that equals the diameter within it makes an exact half turn, whose centre would else move
    /// by the square root of the rounding error (D 8.2).
    #[inline(never)]
    pub(super) fn new(start: Point, chord: Vector, command: &ArcCommand, slack: f64) -> Self {
        let radii = command.radii.abs();
        let (cos, sin) = if radii.x == radii.y { (1.0, 0.0) } else { cos_sin_degrees(command.rotation) };
        let half = chord * -0.5;
        let h = Vector::new((half.x * cos + half.y * sin) / radii.x, (half.y * cos - half.x * sin) / radii.y);
        let s = h.norm();
        let sign = if command.positive { 1.0 } else { -1.0 };
        // The centre lies on the left of the way from end to start for the short positive and the long negative arc.
        let side = if command.large == command.positive { -1.0 } else { 1.0 };
        let across = Vector::new(h.y, -h.x) * (side / s);
        let (h, c, scale, angle) = if s < 1.0 - slack {
            let distance = ((1.0 - s) * (1.0 + s)).sqrt();
            (h, across * distance, 1.0, libm::atan2(s, distance))
        } else {
            (h / s, Vector::zeros(), s, FRAC_PI_2)
        };
        let (u, v) = (Vector::new(cos, sin) * (radii.x * scale), Vector::new(-sin, cos) * (radii.y * scale));
        let sweep = if command.large { 2.0 * (PI - angle) } else { 2.0 * angle };
        // Seen from the centre, the middle of a long arc lies on the side of the centre, that of a short one opposite.
        let middle = if command.large { across } else { -across };
        Self {
            center: start + chord * 0.5 + u * c.x + v * c.y,
            u,
            v,
            first: h - c,
            middle,
            last: -h - c,
            sweep: sign * sweep,
        }
    }

    /// The point in the direction `e` of the unit circle.
    pub(super) fn point(&self, e: Vector) -> Point {
        self.center + self.u * e.x + self.v * e.y
    }

    /// dr/dθ there.
    pub(super) fn tangent(&self, e: Vector) -> Vector {
        self.v * e.x - self.u * e.y
    }
}

/// Cosine and sine of an angle in degrees, exact for whole quarter turns.
pub(super) fn cos_sin_degrees(degrees: f64) -> (f64, f64) {
    let quarters = (degrees / 90.0).round_ties_even();
    let rest = (degrees - 90.0 * quarters) * (PI / 180.0);
    let (sin, cos) = sin_cos(rest);
    quarter_turned(quarters, (cos, sin))
}
