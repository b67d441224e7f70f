//! Points in, a curve out: whatever is asked, and whatever the points are.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

mod support;

use expline::fit::{Ask, Fit, FitStatus, Fitter, Options, fit};
use expline::numerics::Point;
use support::curves::Random;
use support::unboxed;

fn noisy_circle(count: usize, radius: f64, sigma: f64, seed: u64) -> Vec<Point> {
    let mut random = Random::new(seed);
    (0..count)
        .map(|k| {
            let angle = core::f64::consts::TAU * k as f64 / count as f64;
            let noise = random.noise() * sigma;
            Point::new(libm::cos(angle), libm::sin(angle)) * radius + noise
        })
        .collect()
}

fn asks() -> [Ask; 5] {
    [Ask::Noise, Ask::Tolerance(0.01), Ask::Smoothing(0.4), Ask::Lambda(vec![1e-3]), Ask::Lambda(vec![1e12])]
}

fn finite(fit: &Fit) -> bool {
    let (start, end) = fit.curve.domain();
    let count = 200;
    let places = (0..=count).map(|i| start + (end - start) * f64::from(i) / f64::from(count));
    places.into_iter().all(|t| fit.curve.evaluate(t, 0).is_ok_and(|p| p.x.is_finite() && p.y.is_finite()))
        && fit.max_error.is_finite()
        && fit.qfe.is_finite()
}

fn cubic() -> Options {
    Options { degrees: vec![3], ..Options::default() }
}

/// The largest distance by dense sampling, which shares nothing with the projection.
fn farthest(fit: &Fit, points: &[Point]) -> f64 {
    let (start, end) = fit.curve.domain();
    let count = 20_000;
    let at = |i: usize| start + (end - start) * i as f64 / count as f64;
    let curve: Vec<Point> =
        (0..=count).map(|i| fit.curve.evaluate(at(i), 0).expect("t is in the domain")).collect();
    points.iter().fold(0.0, |most: f64, point| {
        let nearest = curve.iter().fold(f64::INFINITY, |least: f64, p| least.min((p - point).norm_squared()));
        most.max(nearest.sqrt())
    })
}

#[test]
fn every_way_to_ask_gives_a_finite_curve_at_every_scale() {
    for scale in [1e-12, 1e-3, 1.0, 1e8] {
        let points = noisy_circle(120, scale, 0.01 * scale, 3);
        for ask in asks() {
            let fitted = fit(&points, ask.clone(), &cubic()).expect("a circle can be fitted");
            assert!(finite(&fitted), "{ask:?} at {scale}");
        }
    }
}

#[test]
fn a_tolerance_is_kept_and_the_bound_is_no_less_than_the_distance() {
    let points = noisy_circle(300, 100.0, 0.2, 5);
    for tolerance in [8.0, 2.0, 1.0] {
        let fitted = fit(&points, Ask::Tolerance(tolerance), &cubic()).expect("a circle can be fitted");
        assert_eq!(fitted.status, FitStatus::Converged, "tolerance {tolerance}");
        assert!(fitted.max_error <= tolerance, "{} for {tolerance}", fitted.max_error);
        // The samples of the curve are 0.03 apart, so a sampled distance is too large by 0.03²/(8·0.3) at most.
        let sampled = farthest(&fitted, &points);
        assert!(fitted.max_error >= sampled - 1e-3, "{} below {sampled}", fitted.max_error);
    }
}

#[test]
fn points_that_stand_still_or_run_back_are_fitted() {
    let mut still: Vec<Point> = (0..300).map(|_| Point::new(1.0, 2.0)).collect();
    still.extend((0..200).map(|i| Point::new(1.0 + 0.1 * f64::from(i), 2.0)));
    let back: Vec<Point> =
        (0..200).map(|i| Point::new(f64::from(if i < 100 { i } else { 200 - i }), 0.0)).collect();
    for points in [still, back] {
        for ask in asks() {
            let fitted = fit(&points, ask.clone(), &cubic()).expect("a line can be fitted");
            assert!(finite(&fitted), "{ask:?}");
        }
    }
}

#[test]
fn two_or_three_points_are_a_fit_too() {
    for count in 2..8 {
        let points: Vec<Point> = (0..count).map(|i| Point::new(f64::from(i), f64::from(i * i))).collect();
        for ask in [Ask::Noise, Ask::Tolerance(0.1)] {
            let fitted = fit(&points, ask.clone(), &cubic()).expect("few points can be fitted");
            assert!(finite(&fitted), "{count} points, {ask:?}");
            assert!(fitted.max_error < 0.11, "{count} points, {ask:?}: {}", fitted.max_error);
        }
    }
}

#[test]
fn what_is_wrong_with_the_points_is_named() {
    let code = |points: &[Point], options: &Options| match unboxed(Fitter::new(points, options)) {
        Ok(_) => "",
        Err(error) => error.code(),
    };
    let one = Point::new(1.0, 1.0);
    assert_eq!(code(&[], &cubic()), "E_TOO_FEW_POINTS", "none");
    assert_eq!(code(&[one], &cubic()), "E_TOO_FEW_POINTS", "one");
    assert_eq!(code(&[one; 200], &cubic()), "E_DEGENERATE", "all equal");
    assert_eq!(code(&[one, Point::new(f64::NAN, 0.0)], &cubic()), "E_NOT_FINITE", "NaN");
    assert_eq!(code(&[one, Point::new(0.0, 1e10)], &cubic()), "E_RANGE", "too far");
    let fine = [one, Point::new(2.0, 1.0), Point::new(2.0, 2.0), Point::new(1.0, 2.0)];
    let with =
        |degrees: Vec<usize>, parameters: Vec<f64>| Options { degrees, parameters, ..Options::default() };
    assert_eq!(code(&fine, &with(vec![6], vec![])), "E_RANGE", "degree 6");
    assert_eq!(code(&fine, &with(vec![3, 1], vec![])), "E_DEGENERATE", "degrees that fall");
    let fit_with = |parameters: Vec<f64>| match unboxed(fit(&fine, Ask::Noise, &with(vec![3], parameters))) {
        Ok(_) => "",
        Err(error) => error.code(),
    };
    assert_eq!(fit_with(vec![0.0, 0.5, 0.4, 1.0]), "E_DEGENERATE", "parameters that fall");
    assert_eq!(fit_with(vec![0.5; 4]), "E_DEGENERATE", "equal parameters");
    let asked = |ask: Ask| match unboxed(fit(&fine, ask, &cubic())) {
        Ok(_) => "",
        Err(error) => error.code(),
    };
    assert_eq!(asked(Ask::Lambda(vec![-1.0])), "E_RANGE", "λ below 0");
    assert_eq!(asked(Ask::Lambda(vec![1e300])), "E_RANGE", "λ beyond 1e12");
    assert_eq!(asked(Ask::Tolerance(f64::INFINITY)), "E_NOT_FINITE", "an infinite tolerance");
    assert_eq!(asked(Ask::Smoothing(1.5)), "E_RANGE", "smoothing beyond 1");
}

#[test]
fn the_same_points_give_the_same_bits_in_one_go_and_in_steps() {
    let points = noisy_circle(200, 1.0, 0.01, 1);
    for ask in asks() {
        let whole = fit(&points, ask.clone(), &cubic()).expect("a circle can be fitted");
        let mut fitter = Fitter::new(&points, &cubic()).expect("the points are fine");
        fitter.ask(Ask::Noise).expect("nothing is wrong with that");
        fitter.step(1.0).expect("there is memory");
        fitter.ask(ask.clone()).expect("nothing is wrong with that");
        while !fitter.step(1.0).expect("there is memory").done {
            assert!(finite(&fitter.fit().expect("there is a curve at any time")), "{ask:?} on the way");
        }
        let stepped = fitter.fit().expect("there is a curve");
        assert_eq!(whole.curve.points(), stepped.curve.points(), "{ask:?}");
    }
}

#[test]
fn no_price_at_all_gives_a_curve_through_the_points() {
    let points = noisy_circle(200, 1.0, 0.01, 1);
    let uneven: Vec<f64> = (0..200).map(|k| f64::from(k) + 0.4 * libm::sin(f64::from(k * k))).collect();
    for degree in 1..=5 {
        for closed in [true, false] {
            for parameters in [Vec::new(), uneven.clone()] {
                let given = !parameters.is_empty();
                let options =
                    Options { degrees: vec![degree], closed: Some(closed), parameters, ..Options::default() };
                let fitted = fit(&points, Ask::Lambda(vec![0.0]), &options).expect("it can be fitted");
                let what = format!("degree {degree}, closed {closed}, given parameters {given}");
                assert_eq!(fitted.status, FitStatus::Converged, "{what}");
                assert!(fitted.max_error <= 1e-6, "{what}: {}", fitted.max_error);
                assert_eq!(fitted.lambda, [0.0], "{what}");
            }
        }
    }
}

#[test]
fn a_fitter_comes_back_from_no_price_at_all() {
    let points = noisy_circle(200, 1.0, 0.01, 1);
    let mut fitter = Fitter::new(&points, &cubic()).expect("the points are fine");
    let solve = |fitter: &mut Fitter, lambda: f64| {
        fitter.ask(Ask::Lambda(vec![lambda])).expect("λ is fine");
        while !fitter.step(1e6).expect("there is memory").done {}
        fitter.fit().expect("there is a curve")
    };
    let first = solve(&mut fitter, 10.0);
    assert!(solve(&mut fitter, 0.0).max_error <= 1e-6, "through the points");
    let again = solve(&mut fitter, 10.0);
    assert!((first.objective - again.objective).abs() <= 2e-6 * first.objective, "{}", again.objective);
}
