//! What the promises about path data have in common.

#![allow(clippy::panic, reason = "tests stop with what they found")]

use expline::curve::HermiteOptions;
use expline::svg::{PrintOptions, Printed, parse_path, to_path_d};
use expline::{Curve, HermiteCurve, Space};
use nalgebra::Vector2;

use super::curves::Random;
use super::drawing::{self, Stretch, drawing};
use super::tolerance;

pub(crate) type Point = Vector2<f64>;

/// Options that nobody changed.
pub(crate) fn options() -> PrintOptions {
    PrintOptions::default()
}

/// The path data of a curve.
pub(crate) fn print(curve: &HermiteCurve, options: &PrintOptions) -> Printed {
    to_path_d(curve, options).expect("the options are valid")
}

/// The one curve of path data.
pub(crate) fn read(d: &str) -> HermiteCurve {
    let mut parsed = parse_path(d).unwrap_or_else(|error| panic!("{d:?}: {error}"));
    assert_eq!((parsed.truncation, parsed.curves.len()), (None, 1), "{d:?} is one curve");
    parsed.curves.remove(0)
}

/// Path data read and printed.
pub(crate) fn reprinted(d: &str, options: &PrintOptions) -> String {
    print(&read(d), options).d
}

/// The distance between the curve and what a viewer draws, both ways.
pub(crate) fn distance(curve: &HermiteCurve, d: &str) -> f64 {
    let segments: Vec<_> = curve.segments().collect();
    let truth: Vec<Stretch<'_>> =
        segments.iter().map(|segment| Box::new(|x| segment.position(x)) as Stretch<'_>).collect();
    drawing::distance(&truth, &drawing::stretches(&drawing(d)[0].0), tolerance::DRAWN * extent(curve))
}

/// A curve of up to seven points, of any space and size.
pub(crate) fn random_curve(random: &mut Random) -> HermiteCurve {
    let space = [Space::Trigonometric, Space::Hyperbolic, Space::Polynomial][random.below(3)];
    let count = 2 + random.below(6);
    let closed = random.below(2) == 0;
    let size = 10.0_f64.powi(random.below(7) as i32 - 3);
    let offset = random.vector(size * 3.0);
    let segments = if closed { count } else { count - 1 };
    let vectors =
        |random: &mut Random, size: f64| (0..count).map(|_| random.vector(size)).collect::<Vec<_>>();
    let points = vectors(random, size).into_iter().map(|p| p + offset).collect();
    let tangents = vectors(random, 2.0 * size);
    let tangents_in = if random.below(2) == 0 { Vec::new() } else { vectors(random, 2.0 * size) };
    let omega = (0..segments).map(|_| [0.0, 0.5, 1.7, 3.0, 4.5][random.below(5)]).collect();
    let lengths = (0..segments).map(|_| [1.0, 0.5, 1.25][random.below(3)]).collect();
    HermiteCurve::new(HermiteOptions {
        points,
        tangents,
        tangents_in,
        closed,
        space: Some(space),
        omega,
        lengths,
    })
    .expect("a valid curve")
}

/// The diagonal of its bounds.
pub(crate) fn extent(curve: &HermiteCurve) -> f64 {
    let bounds = curve.bounds();
    (bounds.max_x - bounds.min_x).hypot(bounds.max_y - bounds.min_y)
}

/// What a measured distance may be.
pub(crate) fn within(printed: &Printed, extent: f64) -> f64 {
    printed.deviation * (1.0 + drawing::PRECISION) + 2.0 * tolerance::DRAWN * extent
}
