//! Circles, ellipses and arcs are exact: measured against their equations, not against another curve.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use expline::{Error, HermiteCurve, HermiteOptions, Space};
use nalgebra::Vector2;

type Point = Vector2<f64>;

/// The largest |r(t) − c| / radius − 1 over many parameters.
fn roundness(curve: &HermiteCurve, center: Point, radius: f64) -> f64 {
    let (start, end) = curve.domain();
    (0..=4000)
        .map(|i| start + (end - start) * f64::from(i) / 4000.0)
        .map(|t| ((curve.evaluate(t, 0).expect("t lies in the domain") - center).norm() / radius - 1.0).abs())
        .fold(0.0, f64::max)
}

#[test]
fn a_circle_from_two_points_is_round_to_a_few_roundings() {
    let circle =
        HermiteCurve::ellipse(Point::zeros(), Point::new(5.0, 5.0), 0.0, 2).expect("two points suffice");
    let error = roundness(&circle, Point::zeros(), 5.0);
    assert!(error <= 2e-15, "radius is off by {error:e} of itself");
}

#[test]
fn circles_are_round_for_every_count() {
    for count in (2..=40).chain([64, 100, 1000, 4096]) {
        let center = Point::new(3.0, -1.0);
        let circle = HermiteCurve::ellipse(center, Point::new(2.0, 2.0), 0.3, count).expect("valid circle");
        let error = roundness(&circle, center, 2.0);
        assert!(error <= 3e-15, "{count} points: radius is off by {error:e} of itself");
    }
}

#[test]
fn a_turned_ellipse_satisfies_its_equation() {
    let (center, radii, rotation) = (Point::new(-20.0, 7.0), Point::new(12.0, 0.5), 1.1);
    for count in [2, 3, 5, 8, 17] {
        let ellipse = HermiteCurve::ellipse(center, radii, rotation, count).expect("valid ellipse");
        for i in 0..1000 {
            let t = count as f64 * f64::from(i) / 1000.0;
            let d = ellipse.evaluate(t, 0).expect("closed curves take any t") - center;
            let (u, v) = (
                (d.x * rotation.cos() + d.y * rotation.sin()) / radii.x,
                (d.y * rotation.cos() - d.x * rotation.sin()) / radii.y,
            );
            // One unit in the last place of the coordinates is 24 times as much across the short axis.
            assert!((u.hypot(v) - 1.0).abs() < 3e-13, "{count} points, t = {t}: {u}, {v}");
            let angle = TAU * f64::from(i) / 1000.0;
            assert!((u - angle.cos()).abs() < 1e-14, "the angle runs evenly");
        }
    }
}

#[test]
fn quarter_points_of_a_circle_are_exact() {
    let circle = HermiteCurve::ellipse(Point::zeros(), Point::new(7.0, 7.0), 0.0, 4).expect("valid circle");
    let expected = [(7.0, 0.0), (0.0, 7.0), (-7.0, 0.0), (0.0, -7.0)];
    for (point, (x, y)) in circle.points().iter().zip(expected) {
        assert_eq!((point.x, point.y), (x, y), "no cosine of a right angle is left over");
    }
    let turned =
        HermiteCurve::ellipse(Point::zeros(), Point::new(3.0, 2.0), FRAC_PI_2, 4).expect("valid ellipse");
    assert_eq!(turned.points()[0], Point::new(0.0, 3.0), "a quarter turn is exact");
}

#[test]
fn an_octagon_is_its_own_mirror_image_to_the_last_bit() {
    let circle = HermiteCurve::ellipse(Point::zeros(), Point::new(1.0, 1.0), 0.0, 24).expect("valid circle");
    let p = circle.points();
    for k in 1..24 {
        assert_eq!((p[k].x, p[k].y), (p[24 - k].x, -p[24 - k].y), "mirror image of point {k}");
    }
}

#[test]
fn arcs_follow_their_ellipse_both_ways() {
    for (start, sweep) in [(0.0, FRAC_PI_2), (0.3, -2.0), (2.0, PI), (-1.0, 5.0), (0.5, -TAU), (0.0, 1e-9)] {
        let (center, radii) = (Point::new(1.0, 2.0), Point::new(4.0, 3.0));
        let arc = HermiteCurve::arc(center, radii, 0.0, start, sweep).expect("valid arc");
        let (_, end) = arc.domain();
        assert!(arc.segment_count() <= 2, "one segment for every half turn that is begun");
        for i in 0..=100 {
            let t = f64::from(i) / 100.0;
            let angle = start + sweep * t;
            let expected = center + Point::new(4.0 * angle.cos(), 3.0 * angle.sin());
            let error = (arc.evaluate(end * t, 0).expect("in the domain") - expected).norm();
            assert!(error < 8e-15, "start {start}, sweep {sweep}, at {t}: {error:e}");
        }
    }
}

#[test]
fn impossible_ellipses_are_refused_by_name() {
    let ellipse =
        |rx: f64, ry: f64, count| HermiteCurve::ellipse(Point::zeros(), Point::new(rx, ry), 0.0, count);
    for (result, code, argument) in [
        (ellipse(1.0, 1.0, 1), "E_TOO_FEW_POINTS", "count"),
        (ellipse(1.0, 1.0, 0), "E_TOO_FEW_POINTS", "count"),
        (ellipse(0.0, 1.0, 4), "E_RANGE", "radii"),
        (ellipse(1.0, -1.0, 4), "E_RANGE", "radii"),
        (ellipse(f64::NAN, 1.0, 4), "E_NOT_FINITE", "radii"),
        (ellipse(1e10, 1.0, 4), "E_RANGE", "radii"),
        (ellipse(1.0, 1.0, usize::MAX), "E_LIMIT", "count"),
        (HermiteCurve::arc(Point::zeros(), Point::new(1.0, 1.0), 0.0, 0.0, 0.0), "E_DEGENERATE", "sweep"),
        (HermiteCurve::arc(Point::zeros(), Point::new(1.0, 1.0), 0.0, 0.0, 7.0), "E_RANGE", "sweep"),
    ] {
        let error = result.expect_err("it is impossible");
        assert_eq!((error.code(), error.argument()), (code, Some(argument)), "{error}");
    }
    let error = ellipse(1.0, -1.0, 4).expect_err("a negative radius");
    assert!(error.to_string().starts_with("radii[1] is -1;"), "{error}");
}

#[test]
fn every_segment_of_an_ellipse_is_recognised_as_its_arc() {
    for count in [2, 3, 4, 7, 16, 64, 1000] {
        for (radii, rotation) in
            [((4.0, 3.0), 0.5), ((10.0, 0.1), -1.2), ((2.0, 2.0), 0.0), ((1.0, 5.0), 0.0)]
        {
            let (center, radii) = (Point::new(1.0, -6.0), Point::new(radii.0, radii.1));
            let ellipse = HermiteCurve::ellipse(center, radii, rotation, count).expect("valid ellipse");
            for (i, segment) in ellipse.segments().enumerate() {
                let arc = segment.as_ellipse_arc(1e-9).expect("it is an arc");
                assert!(
                    (arc.center - center).norm() < 1e-7,
                    "{count} points, segment {i}: centre {}",
                    arc.center
                );
                assert!(
                    (arc.sweep - TAU / count as f64).abs() < 1e-12,
                    "it runs from the first axis to the second"
                );
                for k in 0..=8 {
                    let x = f64::from(k) / 8.0;
                    let error = (arc.point(arc.start + arc.sweep * x) - segment.position(x)).norm();
                    assert!(error < 1e-12, "{count} points, segment {i}, x = {x}: {error:e}");
                }
            }
        }
    }
}

#[test]
fn an_ellipse_is_recognised_with_its_axes() {
    for count in [2, 3, 5, 12, 100, 1000] {
        for rotation in [0.0, 0.4, FRAC_PI_2, -1.3] {
            let (center, radii) = (Point::new(30.0, 4.0), Point::new(8.0, 2.0));
            let ellipse = HermiteCurve::ellipse(center, radii, rotation, count).expect("valid ellipse");
            for (curve, sense) in [(ellipse.clone(), 1.0), (ellipse.reversed(), -1.0)] {
                let found = curve.as_ellipse(1e-9).expect("it is an ellipse");
                assert!((found.center - center).norm() < 1e-9, "{count} points: {}", found.center);
                assert!((found.radii - radii).norm() < 1e-9, "{count} points: {}", found.radii);
                assert!((found.rotation - rotation).abs() < 1e-9, "{count} points: {}", found.rotation);
                assert_eq!(found.sweep, sense * TAU, "once round");
            }
        }
    }
    let arc = HermiteCurve::arc(Point::zeros(), Point::new(3.0, 2.0), 0.2, 1.0, -4.0).expect("valid arc");
    let found = arc.as_ellipse(1e-9).expect("it is an arc");
    assert!((found.start - 1.0).abs() < 1e-12 && (found.sweep + 4.0).abs() < 1e-12, "{found:?}");
}

#[test]
fn the_thinnest_ellipse_is_recognised_wherever_it_lies_and_begins_where_its_curve_does() {
    // Distances were measured along the longer axis, where roundings of a thin ellipse are long.
    for ratio in [1.0, 1e-3, 1e-6] {
        for far in [0.0, 10.0, 1e4] {
            for count in [2, 5, 40] {
                let (center, radii) = (Point::new(far, -0.6 * far), Point::new(3.0, 3.0 * ratio));
                let whole = HermiteCurve::ellipse(center, radii, 0.7, count).expect("valid ellipse");
                let end = whole.domain().1;
                let part = whole.trim(0.1 * end, 0.7 * end).expect("most of it");
                for curve in [whole.reversed(), part.reversed(), part, whole] {
                    let found = curve.as_ellipse(1e-9);
                    assert!(found.is_some(), "{ratio}, {far}, {count}: none");
                    let found = found.expect("it is an ellipse");
                    for k in 0..=8 {
                        let (start, end) = curve.domain();
                        let place =
                            curve.evaluate(start + (end - start) * f64::from(k) / 8.0, 0).expect("on it");
                        let off =
                            (found.point(found.start + found.sweep * f64::from(k) / 8.0) - place).norm();
                        // Of short arcs the centre is known to a thousand roundings of the coordinates.
                        assert!(off <= 3e-13 * (far + 3.0), "{ratio}, {far}, {count}, {k}: {off:e}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_circle_is_recognised_without_rotation() {
    for rotation in [0.0, 0.7, 2.0] {
        let circle =
            HermiteCurve::ellipse(Point::zeros(), Point::new(6.0, 6.0), rotation, 5).expect("valid circle");
        let found = circle.as_ellipse(1e-9).expect("it is a circle");
        assert_eq!(found.rotation, 0.0, "a circle has no axes");
        assert!((found.radii - Point::new(6.0, 6.0)).norm() < 1e-13, "{}", found.radii);
    }
}

#[test]
fn what_is_moved_is_not_an_ellipse_any_more() {
    let circle = HermiteCurve::ellipse(Point::zeros(), Point::new(5.0, 5.0), 0.0, 8).expect("valid circle");
    for by in [1e-6, 1e-3, 1.0] {
        let moved = circle.with_point(0, Point::new(5.0 + by, 0.0)).expect("valid");
        assert!(moved.as_ellipse(1e-9).is_none(), "moved by {by}");
        assert!(moved.as_ellipse(2.0 * by).is_some() || by > 0.5, "but within a tolerance of it");
    }
    let twice = HermiteCurve::arc(Point::zeros(), Point::new(1.0, 1.0), 0.0, 0.0, 1.0).expect("valid arc");
    let there_and_back = {
        let mut options = twice.to_options();
        options.closed = true;
        options.lengths.push(options.lengths[0]);
        options.omega.push(options.omega[0]);
        options.tangents[1] = -options.tangents[1];
        options.tangents_in[0] = -options.tangents_in[0];
        HermiteCurve::new(options).expect("valid")
    };
    assert!(there_and_back.as_ellipse(1e-9).is_none(), "it does not go round");
}

#[test]
fn straight_segments_are_lines_and_arcs_are_not() {
    for space in [Space::Trigonometric, Space::Hyperbolic, Space::Polynomial] {
        let line = |tangent: Point, omega: f64| {
            HermiteCurve::new(HermiteOptions {
                points: vec![Point::new(1.0, 1.0), Point::new(4.0, 5.0)],
                tangents: vec![tangent, tangent],
                space: Some(space),
                omega: vec![omega],
                ..HermiteOptions::default()
            })
            .expect("valid segment")
        };
        for omega in [0.0, 1.0, 3.0] {
            for speed in [0.0, 0.5, 1.0, 1.7] {
                let curve = line(Point::new(3.0, 4.0) * speed, omega);
                assert!(
                    curve.segment(0).expect("it is there").as_line(1e-12),
                    "speed {speed}, omega {omega}"
                );
            }
            assert!(
                !line(Point::new(3.0, 4.001), omega).segment(0).expect("it is there").as_line(1e-6),
                "it bends a little"
            );
            assert!(
                !line(Point::new(-3.0, -4.0), omega).segment(0).expect("it is there").as_line(0.01),
                "it runs backwards first"
            );
        }
        assert!(
            line(Point::new(3.0, 4.0), 1.0).segment(0).expect("it is there").as_ellipse_arc(1e-9).is_none(),
            "a line is no arc"
        );
    }
}

#[test]
fn an_ellipse_says_which_radius_or_coordinate_is_wrong() {
    let refused = |x: f64, first: f64, second: f64| {
        HermiteCurve::ellipse(Point::new(0.0, x), Point::new(first, second), 0.0, 4).map_err(|error| *error)
    };
    assert!(matches!(
        refused(0.0, -1.0, 1.0),
        Err(Error::OutOfRange { argument: "radii", index: Some(0), .. })
    ));
    assert!(matches!(
        refused(0.0, 1.0, -1.0),
        Err(Error::OutOfRange { argument: "radii", index: Some(1), .. })
    ));
    assert!(matches!(
        refused(2e9, 1.0, 1.0),
        Err(Error::OutOfRange { argument: "center", index: Some(1), .. })
    ));
}
