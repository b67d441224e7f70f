//! A curve with few knots keeps to the way of its points, between them and at its ends.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

mod support;

use expline::fit::{Ask, Fit, FitStatus, Options, fit};
use expline::numerics::{Point, Vector};
use support::curves::Random;

/// A stroke whose direction wanders: as many points as a hand leaves, 3 apart.
fn stroke(seed: u64, count: usize) -> Vec<Point> {
    let (mut random, mut place, mut heading) = (Random::new(seed), Point::zeros(), 0.0);
    (0..count)
        .map(|_| {
            heading += 0.3 * random.normal();
            place += Vector::new(libm::cos(heading), libm::sin(heading)) * 3.0;
            place
        })
        .collect()
}

/// A wave drawn by a hand that stands still for a few points at a time.
fn hesitant(seed: u64, count: usize, still: usize) -> Vec<Point> {
    let mut random = Random::new(seed);
    (0..count)
        .map(|i| {
            let angle = 0.1 * (i / still) as f64;
            Point::new(20.0 * angle, 50.0 * libm::sin(angle)) + random.noise() * 0.006
        })
        .collect()
}

/// Places of the curve, its ends among them.
fn places(fitted: &Fit) -> Vec<Point> {
    let (start, end) = fitted.curve.domain();
    let at = |i: u32| start + (end - start) * (f64::from(i) / 3000.0);
    (0..=3000).map(|i| fitted.curve.evaluate(at(i), 0).expect("t is in the domain")).collect()
}

/// How far a place is from the lines between points that follow one another.
fn off(place: &Point, points: &[Point]) -> f64 {
    let from_line = |pair: &[Point]| {
        let (way, along) = (place - pair[0], pair[1] - pair[0]);
        let part = (way.dot(&along) / along.norm_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        (way - along * part).norm()
    };
    points.windows(2).map(from_line).fold(f64::INFINITY, f64::min)
}

#[test]
fn an_open_curve_ends_where_its_points_end() {
    for (seed, tolerance) in [(1, 6.0), (2, 3.0), (3, 1.0), (4, 0.3)] {
        for points in [hesitant(seed, 290, 5), hesitant(seed, 210, 3), stroke(seed, 120)] {
            let options = Options { closed: Some(false), ..Options::default() };
            let fitted = fit(&points, Ask::Tolerance(tolerance), &options).expect("it can be fitted");
            assert_eq!(fitted.status, FitStatus::Converged, "seed {seed}, tolerance {tolerance}");
            let curve = places(&fitted);
            let ends = [(curve[0], points[0]), (curve[curve.len() - 1], points[points.len() - 1])];
            for (end, point) in ends {
                // The foot of the last point is the end, or that of a neighbour which is as near.
                let beyond = (end - point).norm();
                assert!(beyond <= 2.0 * tolerance, "{beyond} from the last point, tolerance {tolerance}");
            }
        }
    }
}

#[test]
fn a_curve_within_a_tolerance_runs_nowhere_else() {
    for seed in 0..12 {
        for (points, tolerance) in [(stroke(seed, 110), 0.45), (stroke(seed, 160), 2.0)] {
            let fitted =
                fit(&points, Ask::Tolerance(tolerance), &Options::default()).expect("it can be fitted");
            assert_eq!(fitted.status, FitStatus::Converged, "seed {seed}, tolerance {tolerance}");
            let mut way = points.clone();
            if fitted.curve.is_closed() {
                way.push(points[0]);
            }
            let apart = way.windows(2).map(|pair| (pair[1] - pair[0]).norm()).fold(0.0, f64::max);
            let farthest = places(&fitted).iter().map(|place| off(place, &way)).fold(0.0, f64::max);
            // Places are looked at in eighths of a piece, so between two of them a curve may be a little farther.
            let most = 1.15 * (tolerance + 0.5 * apart);
            assert!(farthest <= most, "seed {seed}: {farthest} of {most}");
        }
    }
}
