//! Points in, a curve out: whatever is asked, and whatever the points are.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::Random;
use crate::support::unboxed;
use expline::fit::{Ask, Finish, Fit, FitStatus, Fitter, Norm, Options, fit};
use expline::numerics::Point;

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
    let places = (0..=count).map(|i| (start + (end - start) * f64::from(i) / f64::from(count)).min(end));
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
fn what_is_refused_leaves_what_was_asked_before_as_it_was() {
    let points = noisy_circle(80, 100.0, 1.0, 5);
    let refused = [
        Ask::Tolerance(-1.0),
        Ask::Smoothing(2.0),
        Ask::Lambda(vec![f64::NAN]),
        Ask::Lambda(Vec::new()),
        Ask::MeanSquare(f64::INFINITY),
    ];
    for ask in asks() {
        let mut fitter = Fitter::new(&points, &cubic()).expect("a circle can be fitted");
        fitter.ask(ask.clone()).expect("it can be asked for");
        while !fitter.step(1e6).expect("there is memory").done {}
        let before = fitter.fit().expect("there is a curve");
        for bad in &refused {
            assert!(fitter.ask(bad.clone()).is_err(), "{bad:?}");
        }
        assert!(fitter.step(1e6).expect("there is memory").done, "{ask:?} is over");
        assert_eq!(fitter.fit().map(|fit| fit.curve), Ok(before.curve), "{ask:?}");
    }
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
fn curves_that_end_beside_their_first_points_are_cut_off_there_with_their_knots() {
    // Of points so unlike in size that the curve runs on beyond their feet. Where no piece was asked to be straight,
    // the pieces that were cut off were looked for in a list of none.
    let tiny_and_large = [
        [(-0.007, 0.008), (-0.8, 0.0), (0.01, 0.06), (-0.06, 0.02), (700.0, 800.0), (-0.008, -0.007)]
            .as_slice(),
        [(600.0, -100.0), (-0.8, -0.4), (200.0, -200.0)].as_slice(),
    ]
    .concat();
    let points: Vec<Point> = tiny_and_large.into_iter().map(|(x, y)| Point::new(x, y)).collect();
    for most in 0..=20 {
        let options = Options {
            degrees: vec![5],
            closed: Some(false),
            most_iterations: Some(most),
            ..Options::default()
        };
        let fitted = fit(&points, Ask::Tolerance(0.01), &options).expect("it can be fitted");
        assert!(finite(&fitted), "after {most} iterations");
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
fn no_price_and_weights_a_million_times_apart_end_as_they_say() {
    for count in [30, 200] {
        let place = |i: usize| {
            let a = 0.1 * i as f64;
            let ripple = Point::new(libm::sin(31.0 * a), 3.0 * libm::cos(77.0 * a));
            Point::new(20.0 * a, 50.0 * libm::sin(a)) + ripple
        };
        let points: Vec<Point> = (0..count).map(place).collect();
        for (low, high) in [(1e-3, 1.0), (1e-6, 1.0), (1e-6, 1e6)] {
            let weights: Vec<f64> = (0..count).map(|i| if i % 3 == 0 { high } else { low }).collect();
            for (degree, closed) in [1, 2, 3, 5].into_iter().flat_map(|d| [(d, false), (d, true)]) {
                let options = Options {
                    degrees: vec![degree],
                    closed: Some(closed),
                    weights: weights.clone(),
                    ..Options::default()
                };
                let fitted = fit(&points, Ask::Lambda(vec![0.0]), &options).expect("it can be fitted");
                let what = format!("{count}, {low} to {high}, degree {degree}, closed {closed}");
                let reached = fitted.gap <= options.gap;
                assert_eq!(fitted.status == FitStatus::Converged, reached, "{what}: {}", fitted.gap);
                // There is a curve through all points: a ten-millionth of the drawing is nothing in the squares of
                // weight 1e-3.
                if low >= 1e-3 {
                    assert!(reached && fitted.max_error <= 5e-6, "{what}: {}", fitted.max_error);
                }
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

fn asked(fitter: &mut Fitter, ask: &Ask) -> Fit {
    fitter.ask(ask.clone()).expect("a good question");
    while !fitter.step(1e6).expect("memory").done {}
    fitter.fit().expect("a curve")
}

/// Every number that says what the curve is, bit by bit.
fn bits(fit: &Fit) -> Vec<u64> {
    let mut numbers = vec![fit.objective, fit.gap, fit.qfe, fit.max_error, fit.rms];
    for knot in &fit.knots {
        numbers.extend([knot.t, knot.point.x, knot.point.y, knot.jump.x, knot.jump.y]);
    }
    numbers.extend(fit.parts.iter().flat_map(|part| part.coefficients.iter().flat_map(|c| [c.x, c.y])));
    numbers.extend(&fit.parameters);
    numbers.iter().map(|number| number.to_bits()).collect()
}

/// A star with noise, open or closed, and options that go through degrees, norms and what is made of an optimum.
fn various(case: usize) -> (Vec<Point>, Options) {
    let count = [60, 150, 90][case % 3];
    let place = |i: usize| {
        let angle = core::f64::consts::TAU * i as f64 / count as f64;
        Point::new(libm::cos(angle), libm::sin(angle)) * (100.0 + 30.0 * libm::cos(5.0 * angle))
    };
    let points: Vec<Point> = (0..count).map(place).collect();
    let gridless = Finish { merge: true, slide: true, ..Finish::default() };
    let options = Options {
        degrees: [vec![3], vec![1, 3], vec![2], vec![4], vec![1]][case % 5].clone(),
        closed: Some(case % 4 < 2),
        norm: if case.is_multiple_of(2) { Norm::L2 } else { Norm::L1 },
        finish: [Finish::default(), gridless, Finish { debias: true, prune: true, ..gridless }][case / 2 % 3],
        ..Options::default()
    };
    (Random::new(case as u64).noisy(&points, 1.0), options)
}

#[test]
fn the_same_question_has_the_same_bits_whatever_was_asked_before() {
    for case in 0..15 {
        let (points, options) = various(case);
        let new = || Fitter::new(&points, &options).expect("good points");
        let asks = [Ask::Smoothing(0.5), Ask::Smoothing(0.52), Ask::Lambda(vec![9.0; options.degrees.len()])];
        let alone: Vec<Vec<u64>> = asks.iter().map(|ask| bits(&asked(&mut new(), ask))).collect();
        let mut fitter = new();
        for of in [0, 1, 0, 0, 2, 1] {
            assert!(bits(&asked(&mut fitter, &asks[of])) == alone[of], "{case}: {:?}", asks[of]);
            // What is left half-way leaves nothing behind.
            fitter.ask(Ask::Smoothing(0.3)).expect("a good question");
            let _ = fitter.step(0.0).expect("memory");
        }
    }
}

#[test]
fn curves_to_be_seen_at_once_agree_within_the_gap_whatever_was_asked_before() {
    for case in 0..15 {
        let (points, mut options) = various(case);
        (options.gap, options.finish) = (1e-3, Finish::default());
        let mut fitter = Fitter::new(&points, &options).expect("good points");
        for smoothing in [0.5, 0.52, 0.3, 0.5, 0.31] {
            let ask = Ask::Smoothing(smoothing);
            let [warm, cold] = [asked(&mut fitter, &ask), fit(&points, ask, &options).expect("a curve")];
            // Both are above the optimum, by no more than their gaps.
            let apart = (warm.objective - cold.objective).abs();
            let most = (warm.gap * warm.objective).max(cold.gap * cold.objective);
            assert!(apart <= most * (1.0 + 1e-9), "{case}: {apart:e} apart, {most:e} at {smoothing}");
        }
    }
}

#[test]
fn a_search_has_the_same_bits_after_curves_that_were_to_be_seen_at_once() {
    for case in 0..5 {
        let (points, mut options) = various(case);
        options.gap = 1e-2;
        for ask in [Ask::Tolerance(4.0), Ask::Noise, Ask::MeanSquare(2.0)] {
            let mut fitter = Fitter::new(&points, &options).expect("good points");
            let _ = asked(&mut fitter, &Ask::Smoothing(0.5));
            let alone = fit(&points, ask.clone(), &options).expect("a curve");
            assert!(bits(&asked(&mut fitter, &ask)) == bits(&alone), "{case}: {ask:?}");
        }
    }
}

#[test]
fn weights_that_may_be_given_may_be_given_with_robust_too() {
    let far = |i: usize| Point::new(i as f64, if i == 50 { 80.0 } else { 0.0 });
    let points: Vec<Point> = (0..100).map(far).collect();
    let options = Options {
        degrees: vec![1],
        closed: Some(false),
        robust: true,
        weights: vec![1e-6; 100],
        ..Options::default()
    };
    for ask in [Ask::Smoothing(0.3), Ask::Noise, Ask::Tolerance(1.0)] {
        assert!(
            finite(&fit(&points, ask.clone(), &options).expect("the least weight is allowed")),
            "{ask:?}"
        );
    }
}

#[test]
fn a_curve_through_points_is_found_on_a_grid_that_is_much_finer_too() {
    let points: Vec<Point> =
        (0..6).map(|i| Point::new(20.0 * f64::from(i), (100.0 - 40.0 * f64::from(i)).abs())).collect();
    for degree in 1..=5 {
        for parameters in [vec![], vec![0.0, 1.0, 2.0, 3.0, 3.5, 4.0]] {
            let options = Options {
                degrees: vec![degree],
                closed: Some(false),
                parameters,
                grid_size: Some(1000),
                ..Options::default()
            };
            let fitted = fit(&points, Ask::Lambda(vec![0.0]), &options).expect("it can be fitted");
            assert_eq!(fitted.status, FitStatus::Converged, "degree {degree}");
            assert!(fitted.max_error <= 1e-6, "degree {degree}: {}", fitted.max_error);
        }
    }
}

#[test]
fn points_that_share_parameters_are_met_as_nearly_as_one_curve_can() {
    let points: Vec<Point> = (0..6).map(|i| Point::new(f64::from(i), f64::from(i % 2))).collect();
    let options = Options {
        degrees: vec![3],
        closed: Some(false),
        parameters: vec![0.0, 5.0, 5.0, 10.0, 10.0, 15.0],
        grid_size: Some(1000),
        ..Options::default()
    };
    let fitted = fit(&points, Ask::Lambda(vec![0.0]), &options).expect("it can be fitted");
    // Two pairs one step apart in both coordinates: half a square each from their middles.
    assert!((fitted.data_term - 2.0).abs() <= 1e-9, "{}", fitted.data_term);
}

#[test]
fn a_mean_square_is_kept_at_the_parameters_by_straight_pieces_too() {
    for (count, degree, target) in [(20, 2, 0.01), (24, 2, 0.01), (25, 2, 0.01), (30, 2, 0.01)] {
        let rise = if usize::is_multiple_of(count, 2) { 0.0 } else { 0.3 };
        let place = |i: usize| Point::new(1.0, rise) * (100.0 * libm::sin(0.7 * i as f64));
        let points: Vec<Point> = (0..count).map(place).collect();
        let options =
            Options { degrees: vec![degree], closed: Some(false), noise: Some(0.0), ..Options::default() };
        let fitted = fit(&points, Ask::MeanSquare(target), &options).expect("it can be fitted");
        let kept = fitted.qfe <= target * (1.0 + 1e-9);
        assert_eq!(fitted.status == FitStatus::Converged, kept, "{count} points: {}", fitted.qfe);
    }
}
