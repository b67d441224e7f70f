//! What every kind of curve can do, asked of interpolating, patched and B-spline curves: closed forms and dense sums.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use core::f64::consts::{PI, TAU};
use expline::generator::{Root, Roots};
use expline::numerics::Point;
use expline::svg::{PrintOptions, to_path_d};
use expline::{Curve, HermiteCurve, InterpolatingCurve, LocalCurve};

/// `count` points of a circle about (3, 1).
fn circle(count: usize, radius: f64) -> InterpolatingCurve {
    let mut points = Vec::new();
    for k in 0..count {
        let angle = TAU * k as f64 / count as f64;
        points.extend([3.0 + radius * libm::cos(angle), 1.0 + radius * libm::sin(angle)]);
    }
    InterpolatingCurve::new(points, 2, true, None).expect("a circle")
}

/// A closed curve of no special shape through eight points.
fn wavy(roots: Option<Roots>) -> InterpolatingCurve {
    let mut points = Vec::new();
    for k in 0..8 {
        let angle = TAU * f64::from(k) / 8.0;
        let radius = 20.0 + 7.0 * libm::cos(3.0 * angle) + f64::from(k % 3);
        points.extend([radius * libm::cos(angle), 0.7 * radius * libm::sin(angle)]);
    }
    InterpolatingCurve::new(points, 2, true, roots).expect("a curve")
}

#[test]
fn a_circle_of_points_is_measured_as_a_circle() {
    for (count, radius) in [(3, 2.0), (5, 10.0), (16, 0.5)] {
        let coarse = circle(count, radius);
        let fine = coarse.refine(3, 2, 2).expect("finer");
        let patched = LocalCurve::new(coarse.clone()).refine_at(0.7, 3, 0.4).expect("room");
        for curve in [&coarse as &dyn Curve, &fine, &patched] {
            let size = 1e-12 * radius;
            assert!((curve.length(1e-13 * radius).expect("a length") - TAU * radius).abs() < 10.0 * size);
            assert!((curve.area().expect("closed") - PI * radius * radius).abs() < 10.0 * size * radius);
            assert!((curve.centroid().expect("closed") - Point::new(3.0, 1.0)).norm() < 10.0 * size);
            let bounds = curve.bounds();
            assert!((bounds.max_x - 3.0 - radius).abs() < size && (bounds.min_y - 1.0 + radius).abs() < size);
            let far = curve.nearest(Point::new(3.0 + 4.0 * radius, 1.0 - 3.0 * radius));
            assert!((far.distance - 4.0 * radius).abs() < 10.0 * size, "{}", far.distance);
            let bend = curve.curvature(0.37).expect("in the domain").expect("moving");
            assert!((bend * radius - 1.0).abs() < 1e-9);
        }
    }
}

#[test]
fn a_circle_of_points_becomes_a_hermite_circle_and_is_printed_as_arcs() {
    let curve = circle(5, 2.0);
    let (hermite, deviation) = curve.to_hermite(1e-6).expect("a plane curve");
    assert_eq!(deviation, 0.0);
    let ellipse = hermite.as_ellipse(1e-9).expect("a circle");
    assert!((ellipse.radii.x - 2.0).abs() < 1e-12 && (ellipse.sweep - TAU).abs() < 1e-12);
    for k in 0..50 {
        let t = 0.1 * f64::from(k);
        let (one, two) = (hermite.evaluate(t, 0).expect("closed"), curve.evaluate(t, 0).expect("closed"));
        assert!((one.x - two[0]).abs() + (one.y - two[1]).abs() < 1e-13);
    }
    let printed = to_path_d(&curve, &PrintOptions::default()).expect("a path");
    assert_eq!(printed.d, "M5 1A2 2 0 0 1 1 1 2 2 0 0 1 5 1Z");
}

#[test]
fn cubics_and_hyperbolas_become_hermite_curves_exactly_and_others_within_a_tolerance() {
    let exact = [Roots::polynomials(3).expect("four"), Roots::hyperbola(0.8).expect("three")];
    for roots in exact {
        let curve = wavy(Some(roots));
        let (hermite, deviation) = curve.to_hermite(1e-3).expect("a plane curve");
        assert_eq!(deviation, 0.0);
        assert!((hermite.length(1e-10).expect("it") - curve.length(1e-10).expect("it")).abs() < 1e-9);
    }
    for roots in [Roots::polynomials(5).expect("six"), Roots::harmonics(8, 3).expect("seven")] {
        let curve = wavy(Some(roots));
        let (hermite, deviation) = curve.to_hermite(1e-3).expect("a plane curve");
        assert!(deviation > 0.0 && deviation <= 1e-3);
        let apart = farthest(&curve, &hermite);
        assert!(apart <= deviation + 1e-12, "{apart} of {deviation}");
    }
}

/// The largest distance of a place on one curve to the nearest one on the other.
fn farthest(from: &dyn Curve, to: &HermiteCurve) -> f64 {
    let finder = expline::curve::NearestFinder::new(to);
    let parameters = from.sample_by_length(2000, 1e-6).expect("parameters");
    assert_eq!(parameters.len(), 2000, "one for each point");
    let points = from.points_by_length(2000, 1e-6).expect("points");
    points.chunks_exact(2).map(|p| finder.nearest(Point::new(p[0], p[1])).distance).fold(0.0, f64::max)
}

#[test]
fn lengths_and_areas_are_those_of_dense_polygons() {
    let mixed = Roots::union(&[Roots::ellipse(8).expect("three"), Roots::hyperbola(1.5).expect("three")]);
    for roots in [None, Some(Roots::polynomials(6).expect("seven")), Some(mixed.expect("five"))] {
        let curve = wavy(roots);
        let count = 80_000;
        let points = curve.sample(count, 0).expect("points");
        let at = |k: usize| Point::new(points[2 * (k % count)], points[2 * (k % count) + 1]);
        let (mut length, mut area) = (0.0, 0.0);
        for k in 0..count {
            length += (at(k + 1) - at(k)).norm();
            area += 0.5 * at(k).perp(&at(k + 1));
        }
        assert!((curve.length(1e-9).expect("it") - length).abs() < 1e-6);
        assert!((curve.area().expect("closed") - area).abs() < 1e-5);
    }
}

/// How many chords within a tolerance a curve wants: a chord of parameter width h is h²/8·|r′ × r″|/|r′| away.
fn chords_wanted(curve: &InterpolatingCurve, tolerance: f64) -> f64 {
    const STEPS: u32 = 20_000;
    let (start, end) = curve.domain();
    let step = (end - start) / f64::from(STEPS);
    let mut sum = 0.0;
    for k in 0..STEPS {
        let t = start + (f64::from(k) + 0.5) * step;
        let [first, second] = [1, 2].map(|order| curve.evaluate(t, order).expect("a derivative"));
        let turning = (first[0] * second[1] - first[1] * second[0]).abs();
        sum += (turning / first[0].hypot(first[1])).sqrt();
    }
    sum * step / (8.0 * tolerance).sqrt()
}

#[test]
fn polylines_have_hardly_more_points_than_the_bend_of_the_curve_wants() {
    for roots in [Roots::ellipse(8), Roots::polynomials(3), Roots::polynomials(5), Roots::harmonics(8, 2)] {
        let curve = wavy(Some(roots.expect("roots")));
        for tolerance in [1e-2, 1e-4] {
            let (polyline, _) = curve.flatten(tolerance).expect("a polyline");
            // 2 % more, and one that is begun in each of two pieces between points.
            let most = 1.02 * chords_wanted(&curve, tolerance) + 16.0;
            let count = (polyline.len() / 2) as f64;
            assert!(count <= most, "{count} of {most} within {tolerance}");
        }
    }
}

#[test]
fn a_helix_has_its_length_curvature_and_nearest_points() {
    let pair = [0.0, 0.5, -0.5].map(|im| Root { re: 0.0, im });
    let roots = Roots::new(&[pair[0], pair[0], pair[1], pair[2]], "roots").expect("a list");
    let mut points = Vec::new();
    for k in 0..12 {
        let angle = 0.5 * f64::from(k);
        points.extend([2.0 * libm::cos(angle), 2.0 * libm::sin(angle), 0.3 * f64::from(k)]);
    }
    let helix = InterpolatingCurve::new(points, 3, false, Some(roots)).expect("a helix");
    let speed = 1.09_f64.sqrt();
    assert!((helix.length(1e-11).expect("it") - 11.0 * speed).abs() < 1e-10);
    assert!((helix.parameter_at_length(4.2 * speed, 1e-11).expect("it") - 4.2).abs() < 1e-10);
    let bend = helix.curvature(3.3).expect("in the domain").expect("moving");
    assert!((bend - 0.5 / 1.09).abs() < 1e-10);
    let found = helix.nearest_in_space([0.0, 0.0, 1.5]);
    assert!((found.t - 5.0).abs() < 1e-5 && (found.distance - 2.0).abs() < 1e-11);
    let bounds = helix.bounds();
    assert!(
        bounds.min_z.abs() < 1e-12
            && (bounds.max_z - 3.3).abs() < 1e-12
            && (bounds.max_x - 2.0).abs() < 1e-12
    );
    let (polyline, deviation) = helix.flatten(1e-3).expect("a polyline");
    assert!(polyline.len().is_multiple_of(3) && deviation <= 1e-3);
    let cubics = helix.to_cubics(1e-6).expect("cubics");
    assert!(cubics.path.len().is_multiple_of(12) && cubics.deviation <= 1e-6);
    assert!(helix.area().is_err() && helix.to_hermite(1e-3).is_err());
    assert!(to_path_d(&helix, &PrintOptions::default()).is_err());
}
