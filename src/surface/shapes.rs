//! Shapes that are exact: quadrics and their kin, from a handful of points.

use core::f64::consts::TAU;

use super::axis::Direction;
use super::tensor::TensorSurface;
use crate::error::Result;
use crate::generator::{Root, Roots};
use crate::limits::{LARGEST_COORDINATE, check, with_room};
use crate::numerics::Vector3;
use crate::numerics::angle::{quarter_turned, sin_cos};
use crate::numerics::entire::{Stumpff, stumpff};

/// The most segments in one direction.
const MOST_SEGMENTS: usize = 1024;

fn closed(roots: Roots, count: usize) -> Direction {
    Direction { roots, count, closed: true, level: 0 }
}

/// An open direction of `intervals` units.
fn open(roots: Roots, intervals: usize) -> Direction {
    let count = intervals + 2 * roots.order() - 3;
    Direction { roots, count, closed: false, level: 0 }
}

fn check_segments(segments: [usize; 2], least: [usize; 2]) -> Result<()> {
    for (i, (count, least)) in segments.into_iter().zip(least).enumerate() {
        check("segments", Some(i), count as f64, least as f64, MOST_SEGMENTS as f64)?;
    }
    Ok(())
}

fn positive(argument: &'static str, value: f64) -> Result<()> {
    check(argument, None, value, f64::MIN_POSITIVE, LARGEST_COORDINATE)
}

impl TensorSurface {
    /// The surface through the values of a function at the parameters of its net's points.
    fn through(u: Direction, v: Direction, point: &dyn Fn(f64, f64) -> [f64; 3]) -> Result<Self> {
        let row = |direction: &Direction, i: usize| {
            let before = if direction.closed { 0 } else { direction.roots.order() - 2 };
            i as f64 - before as f64
        };
        let mut net = with_room(3 * u.count * v.count)?;
        for i in 0..u.count {
            for j in 0..v.count {
                net.extend(point(row(&u, i), row(&v, j)));
            }
        }
        Self::new(net, u, v)
    }

    /// A sphere about the origin: u runs round from the x axis, closed on \[0, `segments[0]`\], v from the south pole
    /// (0, 0, −r) to the north pole on \[0, `segments[1]`\]. Normals point outwards.
    ///
    /// # Errors
    ///
    /// `NotFinite` and `OutOfRange` for `radius`: positive, at most 1e9; `OutOfRange` for `segments`: 3 and 2 at least.
    ///
    /// # Source
    ///
    /// [SFBGU17, sec. 5], with v the other way, so that ∂ᵤσ × ∂ᵥσ points outwards.
    pub fn sphere(radius: f64, segments: [usize; 2]) -> Result<Self> {
        positive("radius", radius)?;
        Self::ellipsoid(Vector3::repeat(radius), segments)
    }

    /// An ellipsoid about the origin with its half axes along x, y and z; parameters as [`TensorSurface::sphere`].
    ///
    /// # Errors
    ///
    /// Those of [`TensorSurface::sphere`], for `radii`.
    pub fn ellipsoid(radii: Vector3, segments: [usize; 2]) -> Result<Self> {
        check_segments(segments, [3, 2])?;
        for (i, &radius) in radii.iter().enumerate() {
            check("radii", Some(i), radius, f64::MIN_POSITIVE, LARGEST_COORDINATE)?;
        }
        let [round, up] = segments;
        let u = closed(Roots::ellipse(round)?, round);
        let v = open(Roots::ellipse(2 * up)?, up);
        Self::through(u, v, &|k, l| {
            let (a, b) = (turn(k, round), turn(l, 2 * up));
            [radii.x * a.cos * b.sin, radii.y * a.sin * b.sin, -radii.z * b.cos]
        })
    }

    /// A torus about the z axis: u runs round the axis at distance `radius`, v round the tube of radius `tube`, both
    /// closed and as long as `segments` says. Normals point outwards.
    ///
    /// # Errors
    ///
    /// `NotFinite` and `OutOfRange` for `radius` and `tube`: positive, together at most 1e9, of which `tube` is told
    /// what is left; `OutOfRange` for `segments`: 3 at least.
    pub fn torus(radius: f64, tube: f64, segments: [usize; 2]) -> Result<Self> {
        check_segments(segments, [3, 3])?;
        positive("radius", radius)?;
        check("tube", None, tube, f64::MIN_POSITIVE, LARGEST_COORDINATE - radius)?;
        let [round, tubes] = segments;
        let u = closed(Roots::ellipse(round)?, round);
        let v = closed(Roots::ellipse(tubes)?, tubes);
        Self::through(u, v, &|k, l| {
            let (a, b) = (turn(k, round), turn(l, tubes));
            let from_axis = radius + tube * b.cos;
            [from_axis * a.cos, from_axis * a.sin, tube * b.sin]
        })
    }

    /// A cylinder about the z axis, without lids: u runs round, v upwards from z = −height/2, as far as `segments`
    /// says. Normals point outwards.
    ///
    /// # Errors
    ///
    /// `NotFinite` and `OutOfRange` for `radius` and `height`: positive, at most 1e9; `OutOfRange` for `segments`: 3
    /// and 1 at least.
    pub fn cylinder(radius: f64, height: f64, segments: [usize; 2]) -> Result<Self> {
        check_segments(segments, [3, 1])?;
        positive("radius", radius)?;
        positive("height", height)?;
        let [round, up] = segments;
        let u = closed(Roots::ellipse(round)?, round);
        let v = open(Roots::polynomials(2)?, up);
        Self::through(u, v, &|k, l| {
            let a = turn(k, round);
            [radius * a.cos, radius * a.sin, height * (l / up as f64 - 0.5)]
        })
    }

    /// Steiner's Roman surface ½r²(cos a·sin 2b, sin a·sin 2b, sin 2a·cos² b): a = 2πu/m and b = 2πv/n for `segments` m
    /// and n, closed.
    ///
    /// It is covered four times over, and has no normal at its six pinch points. The root 0 is in both lists, so that
    /// moving the net moves the surface; [SFBGU17, sec. 5.1.1] leaves it out of one.
    ///
    /// # Errors
    ///
    /// `NotFinite` and `OutOfRange` for `r`: positive, at most 3e4; `OutOfRange` for `segments`: 5 at least.
    pub fn roman_surface(r: f64, segments: [usize; 2]) -> Result<Self> {
        check_segments(segments, [5, 5])?;
        check("r", None, r, f64::MIN_POSITIVE, 3e4)?;
        let [m, n] = segments;
        let u = closed(Roots::harmonics(m, 2)?, m);
        let im = 2.0 * TAU / n as f64;
        let twice = Roots::new(&[0.0, im, -im].map(|im| Root { re: 0.0, im }), "roots")?;
        Self::through(u, closed(twice, n), &|k, l| {
            let (a, b) = (turn(k, m), turn(l, n));
            let (sin_2a, sin_2b) = (2.0 * a.sin * a.cos, 2.0 * b.sin * b.cos);
            let half = 0.5 * r * r;
            [half * a.cos * sin_2b, half * a.sin * sin_2b, half * sin_2a * b.cos * b.cos]
        })
    }

    /// A piece of the hyperbolic paraboloid x²/a² − y²/b² = z/h: (a·p·cosh q, b·p·sinh q, h·p²) for p and q from −1 to
    /// 1, in as many steps as `segments` says.
    ///
    /// # Errors
    ///
    /// `NotFinite` and `OutOfRange` for `a`, `b` and `h`: positive, at most 1e8; `OutOfRange` for `segments`: 1 at
    /// least.
    ///
    /// # Source
    ///
    /// [SFBGU17, eq. F.1].
    pub fn hyperbolic_paraboloid([a, b, h]: [f64; 3], segments: [usize; 2]) -> Result<Self> {
        check_segments(segments, [1, 1])?;
        for (argument, value) in [("a", a), ("b", b), ("h", h)] {
            check(argument, None, value, f64::MIN_POSITIVE, 1e8)?;
        }
        let [m, n] = segments;
        let (step_u, step_v) = (2.0 / m as f64, 2.0 / n as f64);
        let u = open(Roots::polynomials(2)?, m);
        let v = open(Roots::hyperbola(step_v)?, n);
        Self::through(u, v, &|k, l| {
            let (p, q) = (k * step_u - 1.0, l * step_v - 1.0);
            let Stumpff { c0: cosh, c1, .. } = stumpff(-q * q);
            [a * p * cosh, b * p * q * c1, h * p * p]
        })
    }
}

/// Cosine and sine of k parts of a full turn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    pub(super) cos: f64,
    pub(super) sin: f64,
}

/// Of k parts of `count`; quarters are exact, so that poles are points.
pub(super) fn turn(k: f64, count: usize) -> Turn {
    let quarters = 4.0 * k / count as f64;
    let (cos, sin) = if quarters == quarters.floor() {
        quarter_turned(quarters, (1.0, 0.0))
    } else {
        let (sin, cos) = sin_cos(TAU * k / count as f64);
        (cos, sin)
    };
    Turn { cos, sin }
}
