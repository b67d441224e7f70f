//! Cubic Bézier curves near a curve: the bound holds everywhere, and there are few of them.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::{Random, random_curve};
use expline::curve::{Cubics, NearestFinder};
use expline::numerics::{Point, Vector};
use expline::{Curve, HermiteCurve};

fn cubic_at(c: &[f64], s: f64) -> Point {
    let z = 1.0 - s;
    let weights = [z * z * z, 3.0 * z * z * s, 3.0 * z * s * s, s * s * s];
    (0..4).map(|i| Point::new(c[2 * i], c[2 * i + 1]) * weights[i]).sum()
}

/// The largest distance of dense samples of the cubics from the curve, by the curve's nearest points.
fn off_curve(curve: &HermiteCurve, cubics: &Cubics, count: usize) -> f64 {
    let finder = NearestFinder::new(curve);
    cubics
        .path
        .chunks_exact(8)
        .flat_map(|c| (0..=count).map(move |k| cubic_at(c, k as f64 / count as f64)))
        .map(|p| finder.nearest(p).distance)
        .fold(0.0, f64::max)
}

/// The largest distance of dense samples of the curve from a fine polyline of the cubics.
fn off_cubics(curve: &HermiteCurve, cubics: &Cubics, count: usize) -> f64 {
    let polyline: Vec<Point> = cubics
        .path
        .chunks_exact(8)
        .flat_map(|c| (0..=64).map(move |k| cubic_at(c, k as f64 / 64.0)))
        .collect();
    let (_, end) = curve.domain();
    (0..count)
        .map(|k| curve.evaluate(end * k as f64 / count as f64, 0).expect("inside"))
        .map(|p| {
            polyline
                .windows(2)
                .map(|pair| {
                    let chord = pair[1] - pair[0];
                    let share = ((p - pair[0]).dot(&chord) / chord.norm_squared()).clamp(0.0, 1.0);
                    let share = if share.is_nan() { 0.0 } else { share };
                    (pair[0] + chord * share - p).norm()
                })
                .fold(f64::INFINITY, f64::min)
        })
        .fold(0.0, f64::max)
}

#[test]
fn quarter_of_a_circle_is_one_cubic_with_the_least_error() {
    let circle = HermiteCurve::ellipse(Point::zeros(), Point::new(1.0, 1.0), 0.0, 4).expect("a circle");
    let cubics = circle.to_cubics(2.0e-4).expect("cubics");
    assert_eq!(cubics.path.len(), 4 * 8, "one for each quarter");
    let off = cubics
        .path
        .chunks_exact(8)
        .flat_map(|c| (0..=1000).map(move |k| (cubic_at(c, k as f64 / 1000.0).norm() - 1.0).abs()))
        .fold(0.0, f64::max);
    // The least error that a cubic with those ends and tangents can have is 1.9608e-4.
    assert!(off < 1.97e-4 && off > 1.95e-4, "off by {off:e}");
    assert!(cubics.deviation >= off && cubics.deviation <= 2.0e-4, "proved {:e}", cubics.deviation);
}

#[test]
fn circles_take_as_many_cubics_as_the_sixth_order_says() {
    for (tolerance, most) in [(1e-2, 4), (1e-3, 4), (1e-4, 6), (1e-6, 10), (1e-8, 22)] {
        let circle = HermiteCurve::ellipse(Point::zeros(), Point::new(1.0, 1.0), 0.0, 2).expect("a circle");
        let cubics = circle.to_cubics(tolerance).expect("cubics");
        assert!(cubics.deviation <= tolerance, "{tolerance}: proved {:e}", cubics.deviation);
        let count = cubics.path.len() / 8;
        assert!(count <= most, "{tolerance}: {count} cubics");
    }
}

#[test]
fn cubic_curves_are_converted_to_the_last_bit() {
    let mut random = Random::new(2);
    for case in (1..60).step_by(3) {
        let curve = random_curve(&mut random, case);
        let cubics = curve.to_cubics(1e-9 * curve.bounds().extent().max(1e-300)).expect("cubics");
        assert_eq!(cubics.path.len(), 8 * curve.segment_count(), "one for each segment");
        assert_eq!(cubics.deviation, 0.0, "exact");
    }
}

#[test]
fn bound_holds_between_samples_on_random_curves_of_every_space() {
    let mut random = Random::new(31);
    for case in 0..150 {
        let curve = random_curve(&mut random, case);
        let size = curve.bounds().extent().max(1e-300);
        for share in [1e-2, 1e-4, 1e-6] {
            let cubics = curve.to_cubics(share * size).expect("cubics");
            assert!(cubics.deviation <= share * size * (1.0 + 1e-12), "case {case}: tolerance kept");
            let count = cubics.path.len() / 8;
            assert!(count < 600 * curve.segment_count(), "case {case}: {count} cubics");
            let off = off_curve(&curve, &cubics, 40);
            assert!(off <= cubics.deviation + 1e-12 * size, "case {case}: {off:e} > {:e}", cubics.deviation);
            for pair in cubics.path.chunks_exact(8).collect::<Vec<_>>().windows(2) {
                assert_eq!(pair[0][6..], pair[1][..2], "case {case}: pieces meet");
            }
        }
        let cubics = curve.to_cubics(1e-2 * size).expect("cubics");
        let off = off_cubics(&curve, &cubics, 200);
        // The polyline of 64 chords for each cubic is itself up to 1e-3 of the size away from it.
        assert!(off <= cubics.deviation + 2e-3 * size, "case {case}: the curve is {off:e} away");
    }
}

#[test]
fn long_hyperbolic_segments_with_zero_speed_take_few_cubics() {
    use expline::{HermiteOptions, Space};
    let points = vec![Point::new(0.0, 0.0), Point::new(1.0, 0.0), Point::new(1.0, 1.0), Point::new(0.0, 1.0)];
    for omega in [10.0, 200.0, 1e4] {
        let curve = HermiteCurve::new(HermiteOptions {
            points: points.clone(),
            tangents: vec![Point::zeros(); 4],
            space: Some(Space::Hyperbolic),
            omega: vec![omega],
            ..HermiteOptions::default()
        })
        .expect("within the limits");
        let cubics = curve.to_cubics(0.01).expect("cubics");
        assert!(cubics.deviation <= 0.01 && cubics.path.len() == 3 * 8, "{omega}: {}", cubics.path.len() / 8);
    }
}

/// A hyperbolic segment that leaves and arrives in the same direction, so that it bends one way and then the other.
fn inflected() -> HermiteCurve {
    use expline::{HermiteOptions, Space};
    let steep = Vector::new(90.0, 260.0);
    HermiteCurve::new(HermiteOptions {
        points: vec![Point::new(0.0, 0.0), Point::new(100.0, 10.0)],
        tangents: vec![steep; 2],
        space: Some(Space::Hyperbolic),
        omega: vec![2.0],
        closed: false,
        ..HermiteOptions::default()
    })
    .expect("within the limits")
}

#[test]
fn inflections_take_as_many_cubics_as_the_sixth_order_says() {
    let count = |tolerance: f64| inflected().to_cubics(tolerance).expect("cubics").path.len() / 8;
    let (few, many) = (count(1e-3), count(1e-3 / 4096.0));
    // 4096 is 4⁶; with an error of the fourth order, as with a third of the derivatives, it would be 8 times as many.
    assert!(many <= 4 * few + 2, "{few} within 1e-3, {many} within 2.4e-7");
}

/// How many cubics a curve takes from one end to the other if each reaches as far as it can.
fn as_far_as_they_reach(curve: &HermiteCurve, tolerance: f64) -> usize {
    let one = |from: f64, to: f64| {
        curve.trim(from, to).expect("a part").to_cubics(tolerance).expect("cubics").path.len() == 8
    };
    let (mut from, mut count) = (0.0, 0);
    while from < 1.0 {
        let (mut reached, mut beyond) = (from, 1.0);
        if one(from, 1.0) {
            return count + 1;
        }
        while beyond - reached > 1e-3 * (beyond - from) {
            let middle = 0.5 * (reached + beyond);
            if one(from, middle) { reached = middle } else { beyond = middle }
        }
        (from, count) = (reached, count + 1);
    }
    count
}

#[test]
fn hardly_any_smooth_curve_could_do_with_fewer_cubics() {
    use expline::Space;
    let mut random = Random::new(9);
    let (mut taken, mut least) = (0, 0);
    for (space, omega) in [
        (Space::Trigonometric, 1.5),
        (Space::Trigonometric, 3.0),
        (Space::Trigonometric, 5.0),
        (Space::Hyperbolic, 2.0),
        (Space::Hyperbolic, 6.0),
    ] {
        let points = (0..6).map(|_| random.vector(100.0)).collect();
        let curve = HermiteCurve::through(points, false, Some(omega), space).expect("a curve");
        for segment in 1..4 {
            let part = curve.trim(f64::from(segment), f64::from(segment) + 1.0).expect("a segment");
            for tolerance in [1e-2, 1e-4, 1e-6] {
                taken += part.to_cubics(tolerance).expect("cubics").path.len() / 8;
                least += as_far_as_they_reach(&part, tolerance);
            }
        }
    }
    // Around inflections the error is no power of the width, so that even parts are hard to find, and halves are taken.
    assert!(taken * 10 <= least * 11, "{taken} cubics, {least} would do");
}
