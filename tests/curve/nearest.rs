//! The nearest point is never missed.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::{Random, random_curve};
use crate::support::tolerance::NEAREST;
use expline::curve::NearestFinder;
use expline::numerics::Point;
use expline::{Curve, HermiteCurve, HermiteOptions, InterpolatingCurve};

/// Dense sampling of every segment, each local minimum then narrowed by golden-section search: slow and plain.
fn brute_force(curve: &HermiteCurve, place: Point) -> f64 {
    let distance = |t: f64| (curve.evaluate(t, 0).expect("t is in the domain") - place).norm();
    let mut best = f64::INFINITY;
    for pair in curve.knots().windows(2) {
        let count = 400;
        let step = (pair[1] - pair[0]) / count as f64;
        let at = |k: usize| if k == count { pair[1] } else { pair[0] + step * k as f64 };
        let mut sampled: Vec<f64> = (0..=count).map(|k| distance(at(k))).collect();
        sampled.push(f64::INFINITY);
        for k in 0..=count {
            best = best.min(sampled[k]);
            if (k == 0 || sampled[k] <= sampled[k - 1]) && sampled[k] <= sampled[k + 1] {
                best = best.min(golden(&distance, at(k.saturating_sub(1)), at((k + 1).min(count))));
            }
        }
    }
    best
}

fn golden(f: &impl Fn(f64) -> f64, mut lo: f64, mut hi: f64) -> f64 {
    for _ in 0..60 {
        let (a, b) = (lo + 0.381_966 * (hi - lo), lo + 0.618_034 * (hi - lo));
        if f(a) < f(b) { hi = b } else { lo = a }
    }
    f(0.5 * (lo + hi))
}

#[test]
fn nearest_point_is_never_missed_on_random_curves_of_every_space() {
    let mut random = Random::new(7);
    for case in 0..400 {
        let curve = random_curve(&mut random, case);
        let size = curve.bounds().extent().max(1e-300);
        let finder = NearestFinder::new(&curve);
        for query in 0..6 {
            let spread = [2.0, 2.0, 3.0, 0.5, 30.0, 1e4][query];
            let mut place = Point::new(random.symmetric(), random.symmetric()) * (spread * size);
            if query == 3 {
                let (_, end) = curve.domain();
                place = curve.evaluate(end * random.unit(), 0).expect("inside the domain");
            }
            let found = finder.nearest(place);
            let truth = brute_force(&curve, place);
            // Coordinates of curve and place are rounded by their own size, wherever both are.
            let scale = size + place.norm() + found.point.norm();
            let excess = (found.distance - truth) / scale;
            assert!(excess <= NEAREST, "case {case}.{query}: {} instead of {truth}", found.distance);
            let there = curve.evaluate(found.t, 0).expect("t is in the domain");
            assert!((there - found.point).norm() <= NEAREST * scale, "case {case}: t and point disagree");
            let distance = (there - place).norm();
            assert!((distance - found.distance).abs() <= NEAREST * scale, "case {case}: wrong distance");
        }
    }
}

#[test]
fn places_on_a_cubic_are_on_it_wherever_it_turns_sharply() {
    let mut random = Random::new(11);
    let mut cubics = vec![[0.5, -207.008_89, 0.0, 100.0, 0.0, -35.0, -1.25, 0.5]];
    cubics.extend((0..60).map(|_| core::array::from_fn(|_| 200.0 * random.symmetric())));
    for (case, [ax, ay, bx, by, cx, cy, dx, dy]) in cubics.into_iter().enumerate() {
        let (start, end) = (Point::new(ax, ay), Point::new(dx, dy));
        let curve = HermiteCurve::new(HermiteOptions {
            points: vec![start, end],
            tangents: vec![(Point::new(bx, by) - start) * 3.0, Point::zeros()],
            tangents_in: vec![Point::zeros(), (end - Point::new(cx, cy)) * 3.0],
            closed: false,
            omega: vec![0.0],
            ..HermiteOptions::default()
        })
        .expect("a cubic");
        let (finder, size) = (NearestFinder::new(&curve), curve.bounds().extent());
        for k in 0..=5000 {
            let place = curve.evaluate(f64::from(k) / 5000.0, 0).expect("t is in the domain");
            let found = finder.nearest(place);
            assert!(found.distance <= NEAREST * size, "{case}: {} at {k} of 5000", found.distance);
        }
    }
}

#[test]
fn places_on_a_curve_that_nearly_runs_over_itself_are_on_it() {
    let mut random = Random::new(3);
    for case in 0..200 {
        let mut vector = || Point::new(random.symmetric(), random.symmetric());
        let (p, q, leaving, arriving) = (vector(), vector(), vector(), vector());
        // Back again beside itself, farther off than what counts as equally near.
        let off = vector() * [3e-13, 1e-12, 1e-11, 1e-10][case % 4];
        let curve = HermiteCurve::new(HermiteOptions {
            points: vec![p, q, p + off],
            tangents: vec![leaving, -arriving, -leaving],
            tangents_in: vec![leaving, arriving, -leaving],
            closed: false,
            omega: vec![0.0],
            ..HermiteOptions::default()
        })
        .expect("a cubic, there and back");
        let finder = NearestFinder::new(&curve);
        // Two ties, and some roundings of coordinates up to 2.
        let within = 2e-13 * curve.bounds().extent() + 8.0 * f64::EPSILON;
        for k in 0..=500 {
            let place = curve.evaluate(2.0 * f64::from(k) / 500.0, 0).expect("t is in the domain");
            let found = finder.nearest(place);
            assert!(found.distance <= within, "{case}: {:e} at {k} of 500", found.distance);
        }
    }
}

#[test]
fn centre_of_a_circle_is_answered_with_the_smallest_parameter() {
    for count in [2, 3, 4, 7, 16] {
        let circle =
            HermiteCurve::ellipse(Point::new(3.0, -2.0), Point::new(5.0, 5.0), 0.3, count).expect("a circle");
        let found = circle.nearest(Point::new(3.0, -2.0));
        assert!((found.distance - 5.0).abs() < NEAREST * 10.0, "radius is {}", found.distance);
        assert!(found.t == 0.0, "{count} points: t = {}", found.t);
    }
}

#[test]
fn curve_that_is_one_point_is_answered_with_that_point() {
    let p = Point::new(4.0, 5.0);
    let curve = HermiteCurve::new(HermiteOptions {
        points: vec![p; 3],
        tangents: vec![Point::zeros(); 3],
        ..HermiteOptions::default()
    })
    .expect("a degenerate curve");
    let found = curve.nearest(Point::new(7.0, 9.0));
    assert!(found.t == 0.0 && found.point == p && found.distance == 5.0, "{found:?}");
}

#[test]
fn a_curve_smaller_than_its_rounding_far_from_the_origin_is_asked_without_end_of_halving() {
    let (v, count) = (-434_798_886.533_826_6, 37);
    // Sixteen roundings of the coordinates.
    let within = 16.0 * f64::EPSILON * -v;
    let speck = HermiteCurve::new(HermiteOptions {
        points: vec![Point::new(v, v); count],
        tangents: vec![Point::new(1e-9, 1e-9); count],
        closed: false,
        omega: vec![1.0],
        ..HermiteOptions::default()
    })
    .expect("a speck");
    let finder = NearestFinder::new(&speck);
    let in_space = InterpolatingCurve::new(vec![v; 3 * count], 3, false, None).expect("a speck");
    for (dx, dy) in [(0.0, 0.0), (0.0, 1e-3), (1.0, -2.0), (1e4, 0.0), (-v, -v)] {
        let place = Point::new(v + dx, v + dy);
        let truth = (place - Point::new(v, v)).norm();
        assert!((finder.nearest(place).distance - truth).abs() <= within, "{dx}, {dy}");
        let found = in_space.nearest_in_space([v + dx, v + dy, v]);
        assert!((found.distance - truth).abs() <= within, "{dx}, {dy} in space");
    }
}

#[test]
fn from_what_is_no_place_nothing_is_at_a_finite_distance_and_the_answer_comes_at_once() {
    let circle = HermiteCurve::ellipse(Point::zeros(), Point::new(2.0, 1.0), 0.0, 4).expect("an ellipse");
    let ring = [1.0, 0.0, 0.0, 0.0, 1.0, 0.5, -1.0, -1.0, 1.0];
    let in_space = InterpolatingCurve::new(ring.to_vec(), 3, true, None).expect("a ring");
    let (nan, far) = (f64::NAN, f64::INFINITY);
    for (x, y) in [
        (nan, 1.0),
        (1.0, nan),
        (nan, nan),
        (far, 0.0),
        (far, -far),
        (-far, nan),
        (1e155, 0.0),
        (0.0, -1e300),
    ] {
        let found = circle.nearest(Point::new(x, y));
        // A number that is none equals nothing: its bits do.
        let same = |a: f64, b: f64| a.to_bits() == b.to_bits();
        assert!(found.t == 0.0 && found.distance == far, "{x}, {y}: {found:?}");
        assert!(same(found.point.x, x) && same(found.point.y, y), "{x}, {y}: {found:?}");
        for place in [[x, y, 0.0], [0.0, x, y]] {
            let found = in_space.nearest_in_space(place);
            assert!(found.t == 0.0 && found.distance == far, "{place:?}: {found:?}");
            assert!((0..3).all(|k| same(found.point[k], place[k])), "{place:?}: {found:?}");
        }
    }
}
