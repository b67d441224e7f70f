//! The experiments of [LDAU22], made again on contours that ship with the tests.
#![cfg(not(target_arch = "wasm32"))]

use crate::support::contours::contour;
use expline::fit::{Ask, Finish, Norm, Options, fit};
use expline::numerics::Point;

fn turned(points: &[Point], degrees: f64) -> Vec<Point> {
    let (sin, cos) = degrees.to_radians().sin_cos();
    points.iter().map(|p| Point::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y)).collect()
}

/// The paper's figure 2: degree 1 and λ = 700 on a grid of 256 steps.
fn figure_two(norm: Norm, degrees: f64) -> (usize, Vec<f64>, f64) {
    let options = Options {
        degrees: vec![1],
        closed: Some(true),
        norm,
        grid_size: Some(256),
        gap: 1e-9,
        ..Options::default()
    };
    let points = turned(&contour("polygon488_snr47"), degrees);
    let fitted = fit(&points, Ask::Lambda(vec![700.0]), &options).expect("it can be fitted");
    let lengths = fitted.curve.lengths().to_vec();
    (fitted.knots.len(), lengths, fitted.objective)
}

#[test]
fn knots_stay_where_they_are_when_the_points_are_turned() {
    let (count, lengths, objective) = figure_two(Norm::L2, 0.0);
    for degrees in [10.0, 40.0, 73.0] {
        let (again, turned, other) = figure_two(Norm::L2, degrees);
        assert_eq!(again, count, "{degrees} degrees");
        assert!((other / objective - 1.0).abs() < 1e-7, "{degrees} degrees: {other} for {objective}");
        for (a, b) in lengths.iter().zip(&turned) {
            assert!((a - b).abs() < 1e-9, "{degrees} degrees: a knot moved from {a} to {b}");
        }
    }
}

#[test]
fn with_the_sum_of_coordinates_knots_depend_on_the_angle() {
    let (_, lengths, objective) = figure_two(Norm::L1, 0.0);
    let (_, turned, other) = figure_two(Norm::L1, 40.0);
    assert!(lengths != turned, "other knots");
    assert!((other / objective - 1.0).abs() > 1e-3, "another objective");
}

#[test]
fn more_smoothing_needs_fewer_knots_and_fits_less() {
    // 2714 points of a contour: every segment of a polygon through the 488 divided.
    let corners = contour("polygon488_snr47");
    let points: Vec<Point> = (0..2714)
        .map(|k| {
            let place = 488.0 * f64::from(k) / 2714.0;
            let (i, share) = (place as usize, place.fract());
            corners[i] * (1.0 - share) + corners[(i + 1) % 488] * share
        })
        .collect();
    let mut before = (usize::MAX, 0.0);
    for smoothing in [0.4, 0.55, 0.7, 0.85] {
        let finish = Finish { merge: true, ..Finish::default() };
        let options =
            Options { degrees: vec![3], closed: Some(true), gap: 1e-5, finish, ..Options::default() };
        let fitted = fit(&points, Ask::Smoothing(smoothing), &options).expect("it can be fitted");
        let now = (fitted.knots.len(), fitted.qfe);
        assert!(now.0 < before.0, "{} knots at {smoothing}, {} before", now.0, before.0);
        assert!(now.1 > before.1, "mean square {} at {smoothing}, {} before", now.1, before.1);
        before = now;
    }
}
