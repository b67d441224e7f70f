//! Rough lines of many points, as coasts, courses of prices and hatchings are, within a tolerance.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::Random;
use expline::fit::{Ask, Fit, FitStatus, Options, fit};
use expline::numerics::Point;

const COUNT: usize = 4000;

/// A coast: the middle of every line is moved aside, half as far as the middles of lines twice as long, and a little
/// farther.
fn coast(seed: u64) -> Vec<Point> {
    let (mut random, mut aside) = (Random::new(seed), 250.0);
    let mut points = vec![Point::zeros(), Point::new(1000.0, 0.0)];
    while points.len() < COUNT {
        let mut finer = Vec::new();
        for pair in points.windows(2) {
            let by = Point::new(0.3 * random.normal(), random.normal()) * aside;
            finer.extend([pair[0], (pair[0] + pair[1]) * 0.5 + by]);
        }
        finer.extend(points.last());
        (points, aside) = (finer, aside * 0.62);
    }
    points.truncate(COUNT);
    points
}

/// A price from day to day.
fn course(seed: u64) -> Vec<Point> {
    let (mut random, mut price) = (Random::new(seed), 0.0);
    let mut day = |i: usize| {
        price += 3.0 * random.normal();
        Point::new(i as f64 * 0.25, price)
    };
    (0..COUNT).map(&mut day).collect()
}

/// Strokes up and down beside one another, by a hand that is not quite steady.
fn hatching(seed: u64) -> Vec<Point> {
    const LONG: usize = 20;
    let mut random = Random::new(seed);
    let mut place = |i: usize| {
        let (stroke, along) = ((i / LONG) as f64, (i % LONG) as f64 / (LONG - 1) as f64);
        let along = if (i / LONG) % 2 == 1 { 1.0 - along } else { along };
        Point::new(6.0 * stroke + 3.0 * along, 200.0 * along) + random.noise() * 0.4
    };
    (0..COUNT).map(&mut place).collect()
}

fn size_of(points: &[Point]) -> f64 {
    let (low, high) = points.iter().fold((points[0], points[0]), |(a, b), p| (a.inf(p), b.sup(p)));
    (high - low).max()
}

fn distance(point: &Point, from: &Point, to: &Point) -> f64 {
    let (way, along) = (point - from, to - from);
    let part = (way.dot(&along) / along.norm_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    (way - along * part).norm()
}

/// How many vertices Douglas and Peucker leave between the ends.
fn vertices(points: &[Point], tolerance: f64) -> usize {
    let (mut kept, mut left) = (0, vec![(0, points.len() - 1)]);
    while let Some((from, to)) = left.pop() {
        let far = |m: usize| distance(&points[m], &points[from], &points[to]);
        let farthest = (from + 1..to).max_by(|&a, &b| far(a).total_cmp(&far(b)));
        if let Some(m) = farthest.filter(|&m| far(m) > tolerance) {
            kept += 1;
            left.extend([(from, m), (m, to)]);
        }
    }
    kept
}

fn within(points: &[Point], tolerance: f64) -> Fit {
    let options = Options { closed: Some(false), ..Options::default() };
    let fitted = fit(points, Ask::Tolerance(tolerance), &options).expect("it can be fitted");
    assert_eq!(fitted.status, FitStatus::Converged, "{tolerance}: {}", fitted.max_error);
    assert!(fitted.max_error <= tolerance, "{} of {tolerance}", fitted.max_error);
    fitted
}

#[test]
fn a_rough_line_of_many_points_has_far_fewer_knots_than_a_polyline_has_vertices() {
    for (name, points, part, share) in [
        ("coast", coast(1), 0.01, 0.6),
        ("course", course(5), 0.01, 0.6),
        ("hatching", hatching(6), 0.03, 0.6),
    ] {
        let tolerance = part * size_of(&points);
        let (knots, corners) = (within(&points, tolerance).knots.len(), vertices(&points, tolerance));
        assert!((knots as f64) < share * corners as f64, "{name}: {knots} knots, {corners} vertices");
    }
}

#[test]
fn eight_rough_lines_have_less_than_two_fifths_of_the_knots_that_polylines_have_vertices() {
    let (mut knots, mut corners) = (0, 0);
    for points in (11..15).flat_map(|seed| [coast(seed), course(seed)]) {
        let tolerance = 0.012 * size_of(&points);
        knots += within(&points, tolerance).knots.len();
        corners += vertices(&points, tolerance);
    }
    assert!(5 * knots < 2 * corners, "{knots} knots, {corners} vertices");
}

#[test]
fn strokes_of_a_hatching_keep_a_tolerance_whatever_joins_them() {
    for seed in [6, 7] {
        let points = hatching(seed);
        within(&points, 0.003 * size_of(&points));
    }
}
