//! What a fit finds out about its points: their noise, their parameters, whether they close.
#![cfg(not(target_arch = "wasm32"))]

use crate::support::curves::Random;
use expline::fit::{
    Ask, FitStatus, Fitter, Options, Parametrisation, Samples, fit, is_regular, noise, parametrise,
};
use expline::numerics::Point;

/// Normally distributed, nearly: the sum of twelve uniform numbers.
fn normal(random: &mut Random) -> f64 {
    (0..12).map(|_| random.unit()).sum::<f64>() - 6.0
}

/// An ellipse of half axes 200 and 120 at `count` parameters, with noise.
fn ellipse(count: usize, sigma: f64, jitter: f64, seed: u64) -> Vec<Point> {
    let mut random = Random::new(seed);
    (0..count)
        .map(|k| {
            let share = (k as f64 + jitter * random.symmetric()) / count as f64;
            let angle = core::f64::consts::TAU * share;
            let off = Point::new(normal(&mut random), normal(&mut random)) * sigma;
            Point::new(200.0 * angle.cos(), 120.0 * angle.sin()) + off
        })
        .collect()
}

#[test]
fn the_noise_is_found_within_a_tenth() {
    for (count, sigma) in [(300, 0.5), (300, 2.0), (1000, 1.0), (5000, 0.1)] {
        for seed in 0..4 {
            let samples = Samples::new(&ellipse(count, sigma, 0.0, seed), Some(true), false).expect("fine");
            let found = noise(&samples) * samples.scale;
            // A median of 300 numbers that overlap has a standard deviation of about 6 %.
            assert!((found / sigma - 1.0).abs() < 0.2, "{count} points, {sigma}: {found}");
        }
    }
    let clean = Samples::new(&ellipse(300, 0.0, 0.0, 1), Some(true), false).expect("fine");
    assert!(noise(&clean) * clean.scale < 1e-3, "clean points have none");
}

#[test]
fn uneven_points_are_not_taken_for_even_ones() {
    let regular = |points: &[Point]| is_regular(&Samples::new(points, Some(true), false).expect("fine"));
    assert!(regular(&ellipse(400, 0.0, 0.0, 1)), "clean and even in the angle");
    assert!(regular(&ellipse(400, 1.0, 0.0, 1)), "noisy and even");
    assert!(!regular(&ellipse(400, 0.1, 0.45, 1)), "jittered by nearly half a step");
    // Anywhere along it, with noise that hides steps from differences of neighbours.
    let hidden = |seed: u64| {
        let mut random = Random::new(seed);
        let mut shares: Vec<f64> = (0..500).map(|_| random.unit()).collect();
        shares.sort_by(f64::total_cmp);
        let place = |share: f64| {
            let (sin, cos) = libm::sincos(core::f64::consts::TAU * share);
            Point::new(200.0 * cos, 120.0 * sin)
        };
        let truth: Vec<Point> = shares.into_iter().map(place).collect();
        random.noisy(&truth, 2.0)
    };
    for seed in 0..12 {
        assert!(regular(&ellipse(500, 2.0, 0.0, seed)), "noise {seed}: as noisy, and even");
    }
    // Over ten steps chance adds up to 2.1 times the noise, whose median fifty stretches tell to a sixth: one of some
    // may pass.
    let taken = (0..12).filter(|&seed| regular(&hidden(seed))).count();
    assert!(taken <= 2, "{taken} of 12 were taken for even: spacing adds up over many steps");
}

/// A wave of a few noisy points to each unit, of which two stretches are missing.
fn wave_with_gaps(random: &mut Random) -> Vec<Point> {
    let kept = (0..300).filter(|i| !(80..=140).contains(i) && !(200..=215).contains(i));
    let truth: Vec<Point> =
        kept.map(f64::from).map(|i| Point::new(4.0 * i, 120.0 * libm::sin(i / 25.0))).collect();
    random.noisy(&truth, 1.5)
}

#[test]
fn points_with_gaps_are_not_taken_for_even_ones() {
    let regular = |points: &[Point]| is_regular(&Samples::new(points, Some(false), false).expect("fine"));
    for seed in 0..12 {
        assert!(!regular(&wave_with_gaps(&mut Random::new(seed))), "noise {seed}: two stretches are missing");
        let whole = &ellipse(400, 1.0, 0.0, seed)[..390];
        assert!(regular(whole), "noise {seed}: nothing is missing");
        let missing: Vec<Point> =
            whole.iter().enumerate().filter(|(i, _)| i / 20 != 9).map(|(_, &p)| p).collect();
        assert!(!regular(&missing), "noise {seed}: twenty points are missing");
        // A single point far off is no gap, and neither is one that is missing.
        let mut pulled = whole.to_vec();
        pulled[40].y += 90.0;
        pulled.remove(200);
        assert!(regular(&pulled), "noise {seed}: a point far off");
    }
}

#[test]
fn a_smoothing_of_points_with_gaps_stays_by_the_points_and_runs_on_between_them() {
    for (seed, degrees) in (0..6).flat_map(|seed| [(seed, vec![3]), (seed, vec![1, 3])]) {
        let points = wave_with_gaps(&mut Random::new(seed));
        for smoothing in [0.2, 0.4] {
            let options = Options { degrees: degrees.clone(), ..Options::default() };
            let found = fit(&points, Ask::Smoothing(smoothing), &options).expect("it can be fitted");
            let which = format!("noise {seed}, degrees {degrees:?}, smoothing {smoothing}");
            assert!(found.rms < 3.0, "{which}: {} is twice the noise, of a wave of 120", found.rms);
            // Where a gap's length was shared by the steps around it, the curve went to and fro beside it, by 29 in the
            // worst case.
            let mut farthest = f64::NEG_INFINITY;
            let mut back = 0.0_f64;
            for i in 0..=3000 {
                let t = found.curve.domain().1 * f64::from(i) / 3000.0;
                let x = found.curve.evaluate(t, 0).expect("within").x;
                farthest = farthest.max(x);
                back = back.max(farthest - x);
            }
            assert!(back < 1.5, "{which}: it goes back by {back}, and the noise is 1.5");
        }
    }
}

#[test]
fn parameters_ascend_and_end_where_they_should() {
    for kind in [
        Parametrisation::Index,
        Parametrisation::Chord,
        Parametrisation::Centripetal,
        Parametrisation::ArcLength,
    ] {
        for closed in [true, false] {
            let samples = Samples::new(&ellipse(200, 1.0, 0.4, 3), Some(closed), false).expect("fine");
            let (parameters, end) = parametrise(&samples, kind, noise(&samples));
            assert_eq!(parameters.len(), 200, "{kind:?}");
            assert_eq!(parameters[0], 0.0, "{kind:?}");
            assert!(parameters.windows(2).all(|pair| pair[0] <= pair[1]), "{kind:?}, closed {closed}");
            let last = parameters[199];
            assert!(if closed { last < end } else { (last - end).abs() < 1e-9 }, "{kind:?}: {last} of {end}");
        }
    }
}

#[test]
fn clean_uneven_points_on_a_line_have_their_own_places_as_chord_parameters() {
    let mut random = Random::new(9);
    let mut places: Vec<f64> = (0..50).map(|_| random.unit() * 100.0).collect();
    places.sort_by(f64::total_cmp);
    let points: Vec<Point> = places.iter().map(|&x| Point::new(3.0 * x, 4.0 * x)).collect();
    let samples = Samples::new(&points, Some(false), false).expect("fine");
    let (parameters, end) = parametrise(&samples, Parametrisation::Chord, 0.0);
    let length = places[49] - places[0];
    for (t, x) in parameters.iter().zip(&places) {
        // Each is a sum of 50 roundings.
        assert!((t / end - (x - places[0]) / length).abs() < 1e-13, "{t} for {x}");
    }
}

#[test]
fn ends_that_meet_make_a_closed_curve() {
    let round = ellipse(200, 0.5, 0.0, 4);
    let open: Vec<Point> = round[..150].to_vec();
    let is_closed = |points: &[Point]| Fitter::new(points, &Options::default()).expect("fine").is_closed();
    assert!(is_closed(&round), "a whole ellipse");
    assert!(!is_closed(&open), "three quarters of one");
    let mut twice = round.clone();
    twice.push(round[0]);
    let options = Options { degrees: vec![3], closed: Some(true), ..Options::default() };
    let (one, other) = (fit(&round, Ask::Noise, &options), fit(&twice, Ask::Noise, &options));
    let (one, other) = (one.expect("fine"), other.expect("fine"));
    assert_eq!(one.knots.len(), other.knots.len(), "the first point given again at the end is one with it");
    assert_eq!(other.parameters[0], other.parameters[200], "and has its parameter");
}

/// A star of five tips, and points on it `step` apart: on every side alike, or for as long as the way goes, from one
/// side to the next.
fn star() -> Vec<Point> {
    let corner = |j: usize| {
        let angle = core::f64::consts::TAU * (j as f64 / 10.0 - 0.25);
        let radius = if j.is_multiple_of(2) { 120.0 } else { 50.0 };
        Point::new(200.0 + radius * libm::cos(angle), 150.0 + radius * libm::sin(angle))
    };
    (0..=10).map(corner).collect()
}

fn walked(corners: &[Point], step: f64) -> Vec<Point> {
    let (mut points, mut ahead) = (Vec::new(), 0.0);
    for side in corners.windows(2) {
        let way = side[1] - side[0];
        while ahead < way.norm() {
            points.push(side[0] + way * (ahead / way.norm()));
            ahead += step;
        }
        ahead -= way.norm();
    }
    points
}

#[test]
fn a_contour_that_comes_back_to_its_first_point_up_to_rounding_ends_there() {
    let corners = star();
    let side = (corners[1] - corners[0]).norm();
    let mut fine = walked(&corners[..10], side / 16.0);
    fine.extend(walked(&corners[9..], side / 16.0));
    fine.push(corners[10]);
    for points in [corners, fine] {
        let last = points.len() - 1;
        assert!(points[last] != points[0], "a whole turn is rounded");
        let mut exact = points.clone();
        exact[last] = exact[0];
        let small = Ask::Tolerance(0.5);
        for ask in [small.clone(), Ask::Noise, Ask::Smoothing(0.3), Ask::Lambda(vec![10.0, 100.0])] {
            let [one, other] = [&exact, &points].map(|points| fit(points, ask.clone(), &Options::default()));
            let (one, other) = (one.expect("fine"), other.expect("fine"));
            assert_eq!(one.curve.points(), other.curve.points(), "{ask:?} of {last}: the same curve");
            assert_eq!(other.parameters[last], other.parameters[0], "{ask:?}: at one place");
        }
        // Nearer than any drawing is drawn, and farther than what is rounding: a point of its own.
        for away in [1e-13, 1e-12, 1e-9, 1e-6] {
            let mut points = points.clone();
            points[last] = points[0] + Point::new(240.0 * away, 0.0);
            let options = Options { degrees: vec![1], ..Options::default() };
            for options in [options, Options::default()] {
                let found = fit(&points, small.clone(), &options).expect("fine");
                assert_eq!(found.status, FitStatus::Converged, "{last}, {away}");
                assert!(found.max_error <= 0.5, "{last}, {away}: {}", found.max_error);
                let lambda = vec![10.0; options.degrees.len()];
                assert!(fit(&points, Ask::Lambda(lambda), &options).is_ok(), "{last}, {away}");
            }
        }
    }
}

#[test]
fn a_contour_may_close_with_a_step_of_any_length() {
    let corners = star();
    let length: f64 = corners.windows(2).map(|side| (side[1] - side[0]).norm()).sum();
    for count in [157.0, 200.0] {
        // What is left for the last step, as a part of the others.
        for part in [1e-5, 0.01, 0.1, 0.4, 0.7, 1.0, 2.0] {
            let step = length / (count - 1.0 + part);
            let mut points = walked(&corners, step);
            points.truncate(count as usize);
            let options = Options { closed: Some(true), ..Options::default() };
            let found = fit(&points, Ask::Noise, &options).expect("fine");
            assert_eq!(found.knots.len(), 10, "{count} points, {part} of a step");
            for corner in &corners {
                let away = |knot: &expline::fit::Knot| (knot.point - corner).norm();
                let nearest = found.knots.iter().map(away).fold(f64::INFINITY, f64::min);
                // Corners between two points are where lines on both sides meet: what is no noise is a ten-thousandth
                // of the drawing, and a line through 15 points is known to half of that.
                assert!(nearest < 0.05, "{count} points, {part} of a step: {nearest} from a corner");
            }
        }
    }
}

#[test]
fn several_contours_share_one_noise_level() {
    let contours: Vec<Vec<Point>> = (0..3).map(|seed| ellipse(200, 1.0, 0.0, seed)).collect();
    let fits = expline::fit::fit_all(&contours, &Ask::Noise, &Options::default()).expect("fine");
    assert_eq!(fits.len(), 3, "one fit for each");
    assert!(fits.iter().all(|fit| fit.noise.to_bits() == fits[0].noise.to_bits()), "the same noise for all");
}

#[test]
fn outliers_that_count_little_leave_the_curve_alone() {
    let mut points = ellipse(400, 0.5, 0.0, 2);
    for m in [37, 120, 121, 250, 333] {
        points[m] *= 1.3;
    }
    let options = |robust| Options { degrees: vec![3], closed: Some(true), robust, ..Options::default() };
    // Distance from the ellipse along rays: close enough to the true one for a bound.
    let worst = |robust| {
        let fitted = fit(&points, Ask::Noise, &options(robust)).expect("fine");
        let (_, end) = fitted.curve.domain();
        let off = |i: u32| {
            let p = fitted.curve.evaluate(end * f64::from(i) / 2000.0, 0).expect("t is in the domain");
            let radius = Point::new(p.x / 200.0, p.y / 120.0).norm();
            (1.0 - 1.0 / radius).abs() * p.norm()
        };
        (fitted.outliers, (0..2000).map(off).fold(0.0_f64, f64::max))
    };
    let (outliers, far) = worst(true);
    assert_eq!(outliers, [37, 120, 121, 250, 333], "they are reported");
    assert!(far < 1.5, "the curve is off by {far}");
    let (_, without) = worst(false);
    assert!(without > 2.0 * far, "without it, by {without}");
}

#[test]
fn one_point_however_far_off_is_named_and_leaves_the_curve_alone() {
    let noise = 0.5;
    for (open, at) in [(false, 37), (false, 0), (true, 37)] {
        for away in [300.0, 1e4, 1e6, 1e8] {
            let mut points = ellipse(400, noise, 0.0, 2);
            points.truncate(if open { 300 } else { 400 });
            points[at] = Point::new(away, away);
            for given in [None, Some(noise)] {
                let robust =
                    Options { closed: Some(!open), robust: true, noise: given, ..Options::default() };
                let fitted = fit(&points, Ask::Noise, &robust).expect("fine");
                assert_eq!(fitted.outliers, [at], "{away:e}: it is named");
                // As far as it is from the ellipse, to the size of that.
                assert!(
                    (fitted.max_error - points[at].norm()).abs() < 250.0,
                    "{away:e}: {}",
                    fitted.max_error
                );
                let (_, end) = fitted.curve.domain();
                let off = |i: u32| {
                    let p =
                        fitted.curve.evaluate(end * f64::from(i) / 2000.0, 0).expect("t is in the domain");
                    let radius = Point::new(p.x / 200.0, p.y / 120.0).norm();
                    (1.0 - 1.0 / radius).abs() * p.norm()
                };
                let far = (0..2000).map(off).fold(0.0_f64, f64::max);
                assert!(far < 3.0 * noise, "{away:e}: the curve is off by {far}");
                let kept = fit(&points, Ask::Tolerance(4.0), &robust).expect("fine");
                assert!(kept.max_error <= 4.0, "{away:e}: a tolerance is one for all points");
            }
        }
    }
}

#[test]
fn beside_one_point_far_off_the_others_are_still_a_shape() {
    let noise = 0.5;
    for away in [1e4, 1e6, 1e8] {
        let mut points = ellipse(400, noise, 0.0, 2);
        points[37] = Point::new(away, away);
        let options = Options { closed: Some(true), ..Options::default() };
        let fitted = fit(&points, Ask::Noise, &options).expect("fine");
        // Beside the size of all, the ellipse is nearly nothing; it is what 399 of 400 points say.
        assert!(fitted.rms < 3.0 * noise, "{away:e}: rms {} with {} knots", fitted.rms, fitted.knots.len());
    }
}
