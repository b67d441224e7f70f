//! A curve is what its data say: golden values, interpolation, smoothness, and errors that name the argument.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::support::golden;
use expline::{HermiteCurve, HermiteOptions, Space};
use nalgebra::Vector2;
use serde::Deserialize;

type Point = Vector2<f64>;

fn vectors(values: &[f64]) -> Vec<Point> {
    values.chunks_exact(2).map(|v| Point::new(v[0], v[1])).collect()
}

fn square() -> Vec<Point> {
    vectors(&[0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0])
}

#[derive(Deserialize)]
struct GoldenCurve {
    name: String,
    w0: f64,
    points: Vec<Vec<f64>>,
    tangents: Vec<Vec<f64>>,
    t: Vec<f64>,
    r: Vec<Vec<f64>>,
    dr: Vec<Vec<f64>>,
    d2r: Vec<Vec<f64>>,
}

#[derive(Deserialize)]
struct Golden {
    curves: Vec<GoldenCurve>,
}

#[test]
fn closed_curves_agree_with_fifty_digits() {
    let golden: Golden = golden::parse(include_str!("../golden/splines/curves.json"));
    let planar = |rows: &[Vec<f64>]| rows.iter().map(|row| Point::new(row[0], row[1])).collect::<Vec<_>>();
    for case in &golden.curves {
        let curve = HermiteCurve::new(HermiteOptions {
            points: planar(&case.points),
            tangents: planar(&case.tangents),
            closed: true,
            omega: vec![case.w0],
            ..HermiteOptions::default()
        })
        .expect("golden curves are valid");
        // Values and first derivatives to 4e-15 of the largest, second to 1e-14: a few roundings of the terms.
        for (order, expected, most) in [(0, &case.r, 4e-15), (1, &case.dr, 4e-15), (2, &case.d2r, 1e-14)] {
            let largest = expected.iter().flatten().fold(1.0_f64, |largest, v| largest.max(v.abs()));
            for (&t, expected) in case.t.iter().zip(planar(expected)) {
                let error = (curve.evaluate(t, order).expect("closed") - expected).norm() / largest;
                assert!(error <= most, "{}: derivative {order} at {t} is off by {error:e}", case.name);
            }
        }
    }
}

#[test]
fn a_curve_goes_through_its_points_with_its_tangents_to_the_last_bit() {
    for space in [Space::Trigonometric, Space::Hyperbolic, Space::Polynomial] {
        let curve = HermiteCurve::new(HermiteOptions {
            points: square(),
            tangents: vectors(&[1.0, 2.0, -3.0, 0.1, 0.7, 0.3, 5.0, -2.0]),
            closed: true,
            space: Some(space),
            ..HermiteOptions::default()
        })
        .expect("valid");
        for i in 0..4 {
            assert_eq!(curve.evaluate(i as f64, 0), Ok(curve.points()[i]), "point {i}");
            assert_eq!(curve.evaluate(i as f64, 1), Ok(curve.tangents()[i]), "tangent {i}");
        }
        assert_eq!(curve.evaluate(-0.0, 0), Ok(curve.points()[0]), "minus zero is zero");
        assert_eq!(curve.evaluate(4.0, 0), Ok(curve.points()[0]), "once round");
        assert_eq!(curve.evaluate(-1e-300, 0), Ok(curve.points()[0]), "a hair before the start is the start");
    }
}

#[test]
fn a_cycloid_is_exact_with_its_cusps() {
    // (t − sin t, 1 − cos t): the tangents vanish at multiples of 2π, where the cusps are.
    let points = (0..=8).map(|k| f64::from(k) * FRAC_PI_2).map(|t| Point::new(t - t.sin(), 1.0 - t.cos()));
    let tangents = (0..=8).map(|k| f64::from(k) * FRAC_PI_2).map(|t| Point::new(1.0 - t.cos(), t.sin()));
    let curve = HermiteCurve::new(HermiteOptions {
        points: points.collect(),
        tangents: tangents.collect(),
        omega: vec![1.0],
        lengths: vec![FRAC_PI_2; 8],
        ..HermiteOptions::default()
    })
    .expect("valid");
    for i in 0..=1000 {
        let t = curve.domain().1 * f64::from(i) / 1000.0;
        let error = (curve.evaluate(t, 0).expect("inside") - Point::new(t - t.sin(), 1.0 - t.cos())).norm();
        assert!(error < 1e-14, "t = {t}: {error:e}");
    }
}

#[test]
fn a_hyperbola_is_exact_in_the_hyperbolic_space() {
    let knots = [-1.5, -0.25, 0.5, 2.0_f64];
    let curve = HermiteCurve::new(HermiteOptions {
        points: knots.iter().map(|t| Point::new(t.cosh(), t.sinh())).collect(),
        tangents: knots.iter().map(|t| Point::new(t.sinh(), t.cosh())).collect(),
        space: Some(Space::Hyperbolic),
        omega: vec![1.0],
        lengths: knots.windows(2).map(|pair| pair[1] - pair[0]).collect(),
        ..HermiteOptions::default()
    })
    .expect("valid");
    for i in 0..=1000 {
        let t = 3.5 * f64::from(i) / 1000.0;
        let expected = Point::new((t - 1.5).cosh(), (t - 1.5).sinh());
        assert!((curve.evaluate(t, 0).expect("inside") - expected).norm() < 4e-15, "t = {t}");
    }
}

#[test]
fn a_frequency_that_is_almost_nothing_is_nothing() {
    for omega in [1e-8, 1e-155, f64::MIN_POSITIVE] {
        let [almost, cubic] = [omega, 0.0].map(|omega| {
            HermiteCurve::through(square(), true, Some(omega), Space::Trigonometric).expect("valid")
        });
        for i in 0..65 {
            let t = f64::from(i) / 16.0;
            let apart =
                (almost.evaluate(t, 0).expect("closed") - cubic.evaluate(t, 0).expect("closed")).norm();
            assert!(apart <= 1e-12, "omega = {omega:e}, t = {t}");
        }
    }
}

#[test]
fn the_stiffest_hyperbolic_curve_is_its_polygon() {
    let curve = HermiteCurve::through(square(), true, Some(1e4), Space::Hyperbolic).expect("the upper bound");
    let corners = square();
    for i in 0..=400 {
        let t = f64::from(i) / 100.0;
        let p = curve.evaluate(t, 0).expect("closed");
        assert!(p.iter().all(|c| c.is_finite()), "t = {t}");
        let k = (t as usize) % 4;
        let on_edge = corners[k] + (corners[(k + 1) % 4] - corners[k]) * (t - (t as usize) as f64);
        assert!((p - on_edge).norm() < 1e-3, "t = {t}: {p}");
    }
}

#[test]
fn degenerate_data_give_finite_curves() {
    let same = HermiteCurve::through(vec![Point::new(5.0, 5.0); 7], true, None, Space::Trigonometric)
        .expect("valid");
    let line: Vec<Point> = (0..50).map(|i| Point::new(f64::from(i), 2.0 * f64::from(i) + 1.0)).collect();
    let line = HermiteCurve::through(line, false, None, Space::Trigonometric).expect("valid");
    for i in 0..=100 {
        let t = f64::from(i) / 100.0;
        assert_eq!(same.evaluate(7.0 * t, 0), Ok(Point::new(5.0, 5.0)), "all points are one");
        let p = line.evaluate(49.0 * t, 0).expect("inside");
        assert!((2.0 * p.x + 1.0 - p.y).abs() < 1e-12, "t = {t}: {p}");
    }
}

#[test]
fn the_curve_through_points_has_a_continuous_second_derivative() {
    let points = vectors(&[0.0, 0.0, 3.0, 1.0, 4.0, 4.0, 2.0, 5.0, -1.0, 3.0]);
    for space in [Space::Trigonometric, Space::Hyperbolic, Space::Polynomial] {
        for closed in [true, false] {
            for omega in [None, Some(0.5), Some(2.0), Some(3.1), Some(4.5)] {
                let curve = HermiteCurve::through(points.clone(), closed, omega, space).expect("valid");
                assert_eq!(curve.points(), points, "it goes through its points");
                for i in 0..points.len() {
                    let arriving =
                        (i > 0).then(|| curve.segment(i - 1).expect("it is there").acceleration(1.0));
                    let leaving = (i < curve.segment_count())
                        .then(|| curve.segment(i).expect("it is there").acceleration(0.0));
                    let jump = match (arriving, leaving) {
                        (None, Some(start)) if closed => {
                            start - curve.segment(4).expect("it is there").acceleration(1.0)
                        }
                        (Some(a), Some(b)) => a - b,
                        (None, Some(end)) | (Some(end), None) => end,
                        (None, None) => Point::zeros(),
                    };
                    assert!(
                        jump.norm() < 1e-12 * 100.0,
                        "{space:?} {closed} {omega:?}: point {i} jumps by {jump}"
                    );
                }
            }
        }
    }
}

#[test]
fn points_that_lie_evenly_on_an_ellipse_give_the_ellipse() {
    for count in 2..30 {
        let ellipse = HermiteCurve::ellipse(Point::new(4.0, 2.0), Point::new(5.0, 5.0), 0.3, count)
            .expect("valid ellipse");
        let points = ellipse.points().to_vec();
        let curve = HermiteCurve::through(points, true, None, Space::Trigonometric).expect("valid");
        for (found, expected) in curve.tangents().iter().zip(ellipse.tangents()) {
            assert!((found - expected).norm() < 1e-13, "{count} points: {found} and not {expected}");
        }
    }
}

#[test]
fn where_no_smooth_curve_is_unique_tangents_are_central_differences() {
    let curve = HermiteCurve::through(square(), true, Some(PI), Space::Trigonometric).expect("valid");
    assert_eq!(curve.tangents()[1], Point::new(0.5, 0.5), "half of point 2 minus point 0");
}

#[test]
fn invalid_curves_are_refused_by_name_and_place() {
    let options = |points: &[f64]| HermiteOptions {
        points: vectors(points),
        tangents: vectors(points),
        closed: true,
        ..HermiteOptions::default()
    };
    let valid = [0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0];
    let mut with_nan = valid;
    with_nan[5] = f64::NAN;
    let change = |change: &dyn Fn(&mut HermiteOptions)| {
        let mut changed = options(&valid);
        change(&mut changed);
        changed
    };
    for (options, code, argument) in [
        (options(&[]), "E_TOO_FEW_POINTS", "points"),
        (options(&[3.0, 4.0]), "E_TOO_FEW_POINTS", "points"),
        (options(&with_nan), "E_NOT_FINITE", "points"),
        (options(&[0.0, 0.0, 1_000_000_100.0, 0.0]), "E_RANGE", "points"),
        (options(&[-1e308, 0.0, 1e308, 0.0]), "E_RANGE", "points"),
        (change(&|o| o.tangents.truncate(1)), "E_LENGTH", "tangents"),
        (change(&|o| o.tangents_in = vec![Point::zeros()]), "E_LENGTH", "tangentsIn"),
        (change(&|o| o.omega = vec![-1.0]), "E_RANGE", "omega"),
        (change(&|o| o.omega = vec![TAU]), "E_RANGE", "omega"),
        (change(&|o| o.omega = vec![1.0, 1.0]), "E_LENGTH", "omega"),
        (change(&|o| o.omega = vec![f64::INFINITY]), "E_NOT_FINITE", "omega"),
        (change(&|o| o.lengths = vec![1.0; 3]), "E_LENGTH", "lengths"),
        // Of four points ω is π/2 where none is given: then the segment is at fault, else ω.
        (change(&|o| o.lengths = vec![1.0, 1.0, 4.0, 1.0]), "E_RANGE", "lengths"),
        (change(&|o| (o.omega, o.lengths) = (vec![TAU / 4.0], vec![1.0, 1.0, 4.0, 1.0])), "E_RANGE", "omega"),
        (change(&|o| o.lengths = vec![1.0, 1.0, 0.0, 1.0]), "E_DEGENERATE", "lengths"),
        (change(&|o| o.lengths = vec![1.0, 1.0, 1e-16, 1.0]), "E_DEGENERATE", "lengths"),
        (change(&|o| o.lengths = vec![1.0, f64::NAN, 1.0, 1.0]), "E_NOT_FINITE", "lengths"),
    ] {
        let error = HermiteCurve::new(options).expect_err("it is invalid");
        assert_eq!((error.code(), error.argument()), (code, Some(argument)), "{error}");
    }
    let error = HermiteCurve::new(options(&with_nan)).expect_err("it is invalid");
    assert!(error.to_string().contains("points[5]"), "{error}");
}

#[test]
fn parameters_outside_an_open_curve_are_refused_and_closed_curves_take_any() {
    let open = HermiteCurve::through(square(), false, None, Space::Trigonometric).expect("valid");
    for t in [-0.001, 3.0 + 4.0 * f64::EPSILON, 1e300] {
        let error = open.evaluate(t, 0).expect_err("outside");
        assert_eq!((error.code(), error.argument()), ("E_RANGE", Some("t")), "{error}");
    }
    assert_eq!(open.evaluate(f64::NAN, 0).expect_err("not finite").code(), "E_NOT_FINITE", "NaN");
    let error = open.evaluate(1.0, 3).expect_err("no such derivative");
    assert_eq!(error.argument(), Some("derivative"), "{error}");
    assert_eq!(open.evaluate(3.0, 0), Ok(open.points()[3]), "the end belongs to it");
    let closed = HermiteCurve::through(square(), true, None, Space::Trigonometric).expect("valid");
    for t in [-1e9, 1e15, 4.0, -4.0, 1e300] {
        let p = closed.evaluate(t, 0).expect("any t");
        assert!(p.iter().all(|c| c.is_finite()), "t = {t}");
    }
}
