//! What a fit says of itself in numbers is so, at the ends of what they can be.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::Random;
use expline::Error;
use expline::fit::{Ask, Finish, Fit, FitStatus, Options, fit};
use expline::numerics::Point;

fn circle(count: usize, center: Point) -> Vec<Point> {
    let angle = |m: usize| core::f64::consts::TAU * m as f64 / count as f64;
    (0..count).map(|m| center + Point::new(10.0 * angle(m).cos(), 10.0 * angle(m).sin())).collect()
}

fn fitted(points: &[Point], ask: Ask, degrees: &[usize], closed: bool) -> Fit {
    let options = Options { degrees: degrees.to_vec(), closed: Some(closed), ..Options::default() };
    fit(points, ask, &options).expect("it can be fitted")
}

#[test]
fn smoothing_is_said_where_the_slider_has_that_price_and_only_there() {
    let points = circle(60, Point::zeros());
    for degrees in [&[1][..], &[3], &[1, 3]] {
        for smoothing in [0.0, 0.3, 0.99, 1.0] {
            let asked = fitted(&points, Ask::Smoothing(smoothing), degrees, true);
            let again = fitted(&points, Ask::Lambda(asked.lambda.clone()), degrees, true);
            let said = again.smoothing.expect("the slider's own price");
            // Six powers of up to 10⁶, and a logarithm of their product.
            assert!((said - smoothing).abs() < 1e-12, "{degrees:?}: {said} for {smoothing}");
        }
        let most = fitted(&points, Ask::Smoothing(1.0), degrees, true).lambda;
        let beyond = most.iter().map(|lambda| 1.01 * lambda).collect();
        assert_eq!(
            fitted(&points, Ask::Lambda(beyond), degrees, true).smoothing,
            None,
            "{degrees:?}: beyond"
        );
    }
    let pair = fitted(&points, Ask::Smoothing(0.5), &[1, 3], true).lambda;
    for other in [vec![1.01 * pair[0], pair[1]], vec![pair[0], 1.01 * pair[1]]] {
        assert_eq!(fitted(&points, Ask::Lambda(other), &[1, 3], true).smoothing, None, "another ratio");
    }
}

#[test]
fn no_point_is_farther_than_the_largest_error_wherever_the_drawing_lies() {
    for offset in [0.0, 1e3, 1e6, 1e8] {
        let points = circle(40, Point::new(offset, -0.5 * offset));
        for degree in [1, 2, 3] {
            for ask in [Ask::Lambda(vec![0.0]), Ask::Smoothing(0.3), Ask::Tolerance(0.1)] {
                let fit = fitted(&points, ask.clone(), &[degree], true);
                for (point, t) in points.iter().zip(&fit.parameters) {
                    let far = (fit.curve.evaluate(*t, 0).expect("on the curve") - point).norm();
                    let what = format!("degree {degree} at {offset:e}, {ask:?}");
                    assert!(far <= fit.max_error, "{what}: {far:e}, said {:e}", fit.max_error);
                }
            }
        }
    }
}

/// Large steps and many of them, where a rounding of the parameter is a longer way than one of a coordinate.
#[test]
fn no_point_is_farther_than_the_largest_error_however_fast_the_curve_is() {
    for seed in 0..3 {
        let (mut random, mut place) = (Random::new(seed), Point::zeros());
        let mut points = Vec::new();
        for _ in 0..1051 {
            place += random.noise() * 3e6;
            points.push(place);
        }
        for degree in [1, 3] {
            let fit = fitted(&points, Ask::Tolerance(0.0), &[degree], false);
            for (point, t) in points.iter().zip(&fit.parameters) {
                let far = (fit.curve.evaluate(*t, 0).expect("on the curve") - point).norm();
                assert!(far <= fit.max_error, "degree {degree}: {far:e}, said {:e}", fit.max_error);
            }
            assert!(fit.max_error < 1e-3, "degree {degree}: {:e} is no rounding", fit.max_error);
        }
    }
}

#[test]
fn points_that_are_met_leave_no_gap() {
    let strokes = [
        vec![Point::new(0.0, 0.0), Point::new(1.0, 2.0), Point::new(3.0, 3.0), Point::new(7.0, 1.0)],
        (0..9).map(|m| Point::new(m as f64 / 3.0, 0.7 * m as f64 - 1.0)).collect(),
    ];
    for points in &strokes {
        for steps in [0, 1, 2, 3] {
            let finish =
                Finish { merge: steps > 0, slide: steps > 1, debias: steps > 2, ..Finish::default() };
            let options = Options { degrees: vec![3], closed: Some(false), finish, ..Options::default() };
            let fit = fit(points, Ask::Smoothing(0.5), &options).expect("it can be fitted");
            let what = format!("{} points, {steps} steps", points.len());
            assert_eq!((fit.status, fit.gap), (FitStatus::Converged, 0.0), "{what}: {:e}", fit.objective);
            // A billionth of a billionth of the drawing, squared.
            assert!(fit.objective < 1e-22, "{what}: {:e}", fit.objective);
            assert!(
                fit.changes.iter().all(|change| change.gap.unwrap_or(0.0) == 0.0),
                "{what}: {:?}",
                fit.changes
            );
        }
    }
}

#[test]
fn the_least_period_that_is_said_is_one_that_is_taken() {
    let points = circle(20, Point::zeros());
    let parameters: Vec<f64> = (0..20).map(f64::from).collect();
    let options = |period| Options {
        parameters: parameters.clone(),
        period: Some(period),
        closed: Some(true),
        ..Options::default()
    };
    let error =
        fit(&points, Ask::Smoothing(0.5), &options(19.0)).expect_err("the last point is the first one");
    let least = if let Error::OutOfRange { least, .. } = *error { least } else { 0.0 };
    assert!(least > 19.0, "19 was refused: {error}");
    assert!(fit(&points, Ask::Smoothing(0.5), &options(least)).is_ok(), "{least} is said to be the least");
}
