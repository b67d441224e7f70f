//! Length, area, bounds and curvature against closed forms and dense sums.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::{Random, random_curve};
use crate::support::tolerance::{AREA, BOUNDS, LENGTH};
use crate::support::unboxed;
use core::f64::consts::{PI, TAU};
use expline::numerics::{Point, Vector};
use expline::{Curve, Error, HermiteCurve, HermiteOptions, Space};

fn circle(radius: f64, count: usize) -> HermiteCurve {
    HermiteCurve::ellipse(Point::new(1.0, 2.0), Point::new(radius, radius), 0.2, count).expect("a circle")
}

#[test]
fn circle_has_its_length_area_centre_and_curvature() {
    for count in [2, 3, 4, 5, 16, 100] {
        let circle = circle(3.0, count);
        let length = circle.length(1e-12).expect("a length");
        assert!((length - 6.0 * PI).abs() < 6.0 * PI * LENGTH, "{count}: length {length}");
        let area = circle.area().expect("closed");
        assert!((area - 9.0 * PI).abs() < 9.0 * PI * AREA, "{count}: area {area}");
        let centre = circle.centroid().expect("closed");
        assert!((centre - Point::new(1.0, 2.0)).norm() < 10.0 * AREA, "{count}: centre {centre}");
        for k in 0..40 {
            let bend = circle.curvature(k as f64 * 0.1).expect("closed").expect("moving");
            assert!((bend - 1.0 / 3.0).abs() < 1e-13, "{count}: curvature {bend}");
        }
    }
}

#[test]
fn bounds_of_an_ellipse_are_its_extremes() {
    // Not turned, its extremes are in the middle of pieces, where halves of an interval meet.
    for (count, turn) in
        [2, 3, 4, 7].into_iter().flat_map(|n| [0.0, 0.5 * PI, 0.7, -2.0].map(|turn| (n, turn)))
    {
        let (a, b): (f64, f64) = (5.0, 2.0);
        let ellipse =
            HermiteCurve::ellipse(Point::new(10.0, -4.0), Point::new(a, b), turn, count).expect("an ellipse");
        let half_width = (a * turn.cos()).hypot(b * turn.sin());
        let half_height = (a * turn.sin()).hypot(b * turn.cos());
        let box_ = ellipse.bounds();
        for (got, truth) in [
            (box_.min_x, 10.0 - half_width),
            (box_.max_x, 10.0 + half_width),
            (box_.min_y, -4.0 - half_height),
            (box_.max_y, -4.0 + half_height),
        ] {
            assert!((got - truth).abs() < BOUNDS * 15.0, "{count} points, {turn}: {got} instead of {truth}");
        }
    }
}

#[test]
fn bounds_hold_every_sample_and_are_reached_on_random_curves() {
    let mut random = Random::new(3);
    for case in 0..600 {
        let curve = random_curve(&mut random, case);
        let found = curve.bounds();
        let (mut low, mut high) = (Point::repeat(f64::INFINITY), Point::repeat(f64::NEG_INFINITY));
        for pair in curve.knots().windows(2) {
            // Denser towards the ends, where hyperbolic segments turn.
            for k in 0..=2000 {
                let x = 0.5 - 0.5 * (PI * k as f64 / 2000.0).cos();
                let p = curve.evaluate((pair[0] + x * (pair[1] - pair[0])).min(pair[1]), 0).expect("inside");
                low = Point::new(low.x.min(p.x), low.y.min(p.y));
                high = Point::new(high.x.max(p.x), high.y.max(p.y));
            }
        }
        let size = found.extent().max(1e-300);
        for (inner, outer) in
            [(low.x, found.min_x), (low.y, found.min_y), (-high.x, -found.max_x), (-high.y, -found.max_y)]
        {
            let gap = (inner - outer) / size;
            // 2000 samples miss an extremum by about (1/2000)²; a false one would show.
            assert!(gap > -BOUNDS && gap < 1e-4, "case {case}: {inner} against {outer}");
        }
    }
}

#[test]
fn length_agrees_with_a_dense_sum_on_random_curves() {
    let mut random = Random::new(5);
    for case in 0..300 {
        let curve = random_curve(&mut random, case);
        let size = curve.bounds().extent().max(1e-300);
        let length = curve.length(1e-9 * size).expect("a length");
        // Chords of 40 000 points per segment, denser at the ends, with Richardson's step: an independent sum.
        let chords = |count: usize| -> f64 {
            curve
                .knots()
                .windows(2)
                .map(|pair| {
                    let at = |k: usize| {
                        let x = 0.5 - 0.5 * (PI * k as f64 / count as f64).cos();
                        curve
                            .evaluate((pair[0] + x * (pair[1] - pair[0])).min(pair[1] - 1e-13 * pair[1]), 0)
                            .expect("inside")
                    };
                    (0..count).map(|k| (at(k + 1) - at(k)).norm()).sum::<f64>()
                })
                .sum()
        };
        let (coarse, fine) = (chords(4000), chords(8000));
        let truth = fine + (fine - coarse) / 3.0;
        assert!(
            (length - truth).abs() < 2e-6 * length + 1e-9 * size,
            "case {case}: {length} against {truth}"
        );
    }
}

#[test]
fn cusp_is_as_long_as_its_closed_form() {
    // x = t², y = t³ from −1 to 1: 2·((13√13 − 8)/27), a cusp in the middle.
    let cusp = HermiteCurve::new(HermiteOptions {
        points: vec![Point::new(1.0, -1.0), Point::new(1.0, 1.0)],
        tangents: vec![Vector::new(-2.0, 3.0), Vector::new(2.0, 3.0)],
        lengths: vec![2.0],
        space: Some(Space::Polynomial),
        ..HermiteOptions::default()
    })
    .expect("a cusp");
    let truth = 2.0 * (13.0 * 13.0_f64.sqrt() - 8.0) / 27.0;
    for tolerance in [1e-3, 1e-6, 1e-9, 1e-12, 1e-300] {
        let length = cusp.length(tolerance).expect("a length");
        assert!(
            (length - truth).abs() <= tolerance.max(truth * LENGTH),
            "{tolerance}: {length} is not {truth}"
        );
    }
    assert_eq!(cusp.curvature(1.0).expect("inside"), None, "a cusp has no curvature");
    let half = cusp.parameter_at_length(0.5 * truth, 1e-12).expect("inside");
    // Near the cusp the length grows like the square of the parameter: 1e-12 of length is 1e-6 of t.
    assert!((half - 1.0).abs() < 2e-6, "half of it is at {half}");
}

#[test]
fn curve_that_is_one_point_has_length_zero_and_no_curvature() {
    let curve = HermiteCurve::new(HermiteOptions {
        points: vec![Point::new(2.0, 2.0); 3],
        tangents: vec![Vector::zeros(); 3],
        ..HermiteOptions::default()
    })
    .expect("a degenerate curve");
    assert_eq!(curve.length(1e-9), Ok(0.0), "no length");
    assert_eq!(curve.curvature(0.7), Ok(None), "no curvature");
    assert_eq!(curve.parameter_at_length(0.0, 1e-9), Ok(0.0), "the start");
    let (points, deviation) = curve.flatten(0.1).expect("a polyline");
    assert!(points.iter().all(|&v| v == 2.0) && deviation == 0.0, "{points:?}");
    assert!(curve.to_cubics(0.1).expect("cubics").path.iter().all(|&v| v == 2.0), "all in one place");
}

#[test]
fn length_of_a_parameter_gives_the_parameter_back() {
    let mut random = Random::new(9);
    for case in 0..60 {
        let curve = random_curve(&mut random, case);
        let size = curve.bounds().extent().max(1e-300);
        let total = curve.length(1e-12 * size).expect("a length");
        let parameters = curve.sample_by_length(33, 1e-10 * size).expect("parameters");
        assert_eq!(parameters.len(), 33, "case {case}");
        assert!(parameters.is_sorted(), "case {case}: parameters go forward");
        let steps = if curve.is_closed() { 33.0 } else { 32.0 };
        for (k, &t) in parameters.iter().enumerate() {
            let single = curve
                .parameter_at_length((total * k as f64 / steps).min(total * (1.0 - 1e-15)), 1e-11 * size);
            let single = single.expect("inside");
            let gap =
                (curve.evaluate(t, 0).expect("inside") - curve.evaluate(single, 0).expect("inside")).norm();
            assert!(gap < 1e-9 * size, "case {case}: {t} against {single}");
        }
    }
}

#[test]
fn places_by_length_end_at_what_doubles_can_tell_apart() {
    let mut random = Random::new(11);
    for case in 0..84 {
        let curve = random_curve(&mut random, case);
        let size = curve.bounds().extent().max(1e-300);
        let finest = curve.sample_by_length(9, f64::from_bits(1)).expect("parameters");
        let fine = curve.sample_by_length(9, 1e-11 * size).expect("parameters");
        for (&t, &near) in finest.iter().zip(&fine) {
            let gap =
                (curve.evaluate(t, 0).expect("inside") - curve.evaluate(near, 0).expect("inside")).norm();
            assert!(gap < 1e-9 * size, "case {case}: {t} against {near}");
        }
    }
}

#[test]
fn lengths_scale_with_the_curve_down_to_what_counts_as_nothing() {
    // Two points in one place with opposite tangents: there and back, with cusps. Once this never came to an end below
    // 1e-85.
    let made = |space, omega, scale: f64| {
        HermiteCurve::new(HermiteOptions {
            points: vec![Point::zeros(); 2],
            tangents: vec![Vector::new(scale, scale), Vector::new(-scale, -0.5 * scale)],
            closed: true,
            space: Some(space),
            omega: vec![omega],
            ..HermiteOptions::default()
        })
        .expect("a curve")
    };
    for (space, omega) in [
        (Space::Trigonometric, PI),
        (Space::Hyperbolic, 3.0),
        (Space::Hyperbolic, 700.0),
        (Space::Polynomial, 0.0),
    ] {
        let whole = made(space, omega, 1.0).length(1e-10).expect("a length");
        for scale in [1e-20, 1e-40, 1e-49] {
            let length = made(space, omega, scale).length(1e-10 * scale).expect("a length");
            assert!(
                (length - whole * scale).abs() <= 1e-9 * whole * scale,
                "{space:?} {omega} {scale}: {length}"
            );
        }
        for scale in [1e-51, 1e-100, 1e-160, 1e-308] {
            let length = made(space, omega, scale).length(1e-10 * scale).expect("a length");
            assert!(length == 0.0, "{space:?} {omega} {scale}: {length}");
        }
    }
}

#[test]
fn bad_arguments_are_refused_with_their_names() {
    let circle = circle(1.0, 4);
    for tolerance in [0.0, -1.0] {
        for error in [
            circle.length(tolerance).map(drop),
            circle.flatten(tolerance).map(drop),
            circle.to_cubics(tolerance).map(drop),
            circle.sample_by_length(4, tolerance).map(drop),
        ] {
            assert!(
                matches!(unboxed(error), Err(Error::OutOfRange { argument: "tolerance", .. })),
                "not positive"
            );
        }
    }
    assert!(
        matches!(unboxed(circle.length(f64::NAN)), Err(Error::NotFinite { argument: "tolerance", .. })),
        "NaN"
    );
    assert!(
        matches!(
            unboxed(circle.parameter_at_length(TAU + 2.5e-9, 1e-9)),
            Err(Error::OutOfRange { argument: "length", .. })
        ),
        "beyond the end by more than two lengths within the tolerance can differ"
    );
    let line = HermiteCurve::new(HermiteOptions {
        points: vec![Point::zeros(), Point::new(1.0, 0.0)],
        tangents: vec![Vector::new(1.0, 0.0); 2],
        ..HermiteOptions::default()
    })
    .expect("a line");
    assert!(matches!(unboxed(line.area()), Err(Error::Degenerate { .. })), "an open curve has no area");
    assert!(matches!(unboxed(line.centroid()), Err(Error::Degenerate { .. })), "nor a centre");
}
