//! A curve with few knots keeps to the way of its points, between them and at its ends.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::Random;
use expline::fit::{Ask, Finish, Fit, FitStatus, Options, fit};
use expline::numerics::{Point, Vector};

/// A stroke whose direction wanders: as many points as a hand leaves, 3 apart.
fn stroke(seed: u64, count: usize) -> Vec<Point> {
    let (mut random, mut place, mut heading) = (Random::new(seed), Point::zeros(), 0.0);
    (0..count)
        .map(|_| {
            heading += 0.3 * random.normal();
            place += Vector::new(libm::cos(heading), libm::sin(heading)) * 3.0;
            place
        })
        .collect()
}

/// A wave drawn by a hand that stands still for a few points at a time.
fn hesitant(seed: u64, count: usize, still: usize) -> Vec<Point> {
    let mut random = Random::new(seed);
    (0..count)
        .map(|i| {
            let angle = 0.1 * (i / still) as f64;
            Point::new(20.0 * angle, 50.0 * libm::sin(angle)) + random.noise() * 0.006
        })
        .collect()
}

/// Places of the curve, its ends among them.
fn places(fitted: &Fit) -> Vec<Point> {
    let (start, end) = fitted.curve.domain();
    let at = |i: u32| start + (end - start) * (f64::from(i) / 3000.0);
    (0..=3000).map(|i| fitted.curve.evaluate(at(i), 0).expect("t is in the domain")).collect()
}

/// How far a place is from the lines between points that follow one another.
fn off(place: &Point, points: &[Point]) -> f64 {
    let from_line = |pair: &[Point]| {
        let (way, along) = (place - pair[0], pair[1] - pair[0]);
        let part = (way.dot(&along) / along.norm_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        (way - along * part).norm()
    };
    points.windows(2).map(from_line).fold(f64::INFINITY, f64::min)
}

/// How far the ends of an open curve are from the first and the last point.
fn beyond(points: &[Point], ask: Ask) -> f64 {
    let options = Options { closed: Some(false), ..Options::default() };
    let fitted = fit(points, ask.clone(), &options).expect("it can be fitted");
    assert_eq!(fitted.status, FitStatus::Converged, "{ask:?}");
    let curve = places(&fitted);
    let (start, end) = (curve[0], curve[curve.len() - 1]);
    // B-splines with ends begin and end at their first and last coefficient, which are about the middle of the points'
    // box.
    let (low, high) = points.iter().fold((points[0], points[0]), |(a, b), p| (a.inf(p), b.sup(p)));
    let (coefficients, middle) = (&fitted.parts[0].coefficients, (low + high) / 2.0);
    for (place, coefficient) in [(start, coefficients[0]), (end, coefficients[coefficients.len() - 1])] {
        // Four roundings of the drawing's size, and what cutting adds to them.
        assert!(
            (place - coefficient - middle).norm() < 1e-11 * (high - low).norm(),
            "{coefficient} for {place}"
        );
    }
    (start - points[0]).norm().max((end - points[points.len() - 1]).norm())
}

#[test]
fn an_open_curve_ends_where_its_points_end() {
    for (seed, tolerance) in [(1, 6.0), (2, 3.0), (3, 1.0), (4, 0.3)] {
        for points in [hesitant(seed, 290, 5), hesitant(seed, 210, 3), stroke(seed, 120)] {
            // The foot of the last point is the end, or that of a neighbour which is as near.
            let off = beyond(&points, Ask::Tolerance(tolerance));
            assert!(off <= 2.0 * tolerance, "{off} from the last point, tolerance {tolerance}");
        }
    }
}

#[test]
fn a_curve_through_noise_ends_where_its_points_end() {
    for seed in 0..12 {
        for (drawn, sigma) in [(stroke(seed, 60), 2.0), (hesitant(seed, 210, 3), 0.3)] {
            let mut random = Random::new(100 + seed);
            let points: Vec<Point> = drawn.iter().map(|p| p + random.noise() * sigma).collect();
            let off = beyond(&points, Ask::Noise);
            // Along the curve a last point may be off by its noise and its neighbours', each 3.3 σ in one case of a
            // thousand.
            assert!(off <= 2.0 * 3.3 * sigma, "seed {seed}: {off} from the last point, σ = {sigma}");
        }
    }
}

#[test]
fn a_curve_within_a_tolerance_runs_nowhere_else() {
    for seed in 0..12 {
        for (points, tolerance) in [(stroke(seed, 110), 0.45), (stroke(seed, 160), 2.0)] {
            let fitted =
                fit(&points, Ask::Tolerance(tolerance), &Options::default()).expect("it can be fitted");
            assert_eq!(fitted.status, FitStatus::Converged, "seed {seed}, tolerance {tolerance}");
            let mut way = points.clone();
            if fitted.curve.is_closed() {
                way.push(points[0]);
            }
            let apart = way.windows(2).map(|pair| (pair[1] - pair[0]).norm()).fold(0.0, f64::max);
            let farthest = places(&fitted).iter().map(|place| off(place, &way)).fold(0.0, f64::max);
            // Places are looked at in eighths of a piece, so between two of them a curve may be a little farther.
            let most = 1.15 * (tolerance + 0.5 * apart);
            assert!(farthest <= most, "seed {seed}: {farthest} of {most}");
        }
    }
}

#[test]
fn a_smoothing_holds_the_curve_between_its_points_too() {
    // Pruned by the sum of squares at the points alone, one of these swung 1,554 away from a drawing of 300 by 200.
    let mut away: f64 = 0.0;
    for seed in 0..10 {
        let mut random = Random::new(seed);
        let wave = |i: usize| {
            let t = i as f64 / 149.0;
            Point::new(300.0 * t, 150.0 + 100.0 * libm::sin(9.0 * t + seed as f64))
        };
        let points = random.noisy(&(0..150).map(wave).collect::<Vec<_>>(), 5.0);
        let steps = Finish { extreme: true, merge: true, slide: true, debias: true, prune: true };
        let options = Options { finish: steps, ..Options::default() };
        let found = fit(&points, Ask::Smoothing(0.1), &options).expect("it can be fitted");
        for place in places(&found) {
            away = away.max(points.iter().map(|p| (p - place).norm()).fold(f64::INFINITY, f64::min));
        }
    }
    // Four times what points are off, a tenth of the drawing, and a step between two points, with noise.
    assert!(away < 4.0 * 5.0 + 30.0 + 20.0, "{away} from the nearest point");
}

#[test]
fn a_noise_that_explains_nothing_takes_no_curve_out_of_the_drawing() {
    // From side to side at every point, or points in no order: hardly any lie between two knots, and nothing holds a
    // piece there. Twenty such pieces were taken out, and what was left swung up to 200 times as far as the points go.
    for (seed, count, aside, noise, closed) in [
        (1, 400, true, 0.0022, false),
        (2, 200, true, 0.006, false),
        (3, 400, false, 0.07, true),
        (4, 200, false, 0.01, false),
        (5, 400, true, 0.01, true),
        (8, 400, false, 0.02, false),
    ] {
        let mut random = Random::new(seed);
        let place = |i: usize| {
            if aside {
                Point::new(i as f64 / count as f64, (i % 2) as f64) + random.noise() * 0.01
            } else {
                Point::new(random.symmetric(), random.symmetric())
            }
        };
        let points: Vec<Point> = (0..count).map(place).collect();
        let options = Options { closed: Some(closed), noise: Some(noise), ..Options::default() };
        let fitted = fit(&points, Ask::Noise, &options).expect("it can be fitted");
        let far = places(&fitted).iter().map(|p| p.x.abs().max(p.y.abs())).fold(0.0, f64::max);
        // The points reach 1.05; what is a tenth of the drawing beyond does no harm.
        assert!(far < 1.25, "seed {seed}: {far}");
    }
}

#[test]
fn a_mean_square_is_kept_without_leaving_the_way_of_the_points() {
    // Two lists of five were left farther from their points than was asked for, though a curve can lead through them;
    // and some of the curves swung out of the drawing by up to six times its size.
    let mut random = Random::new(7);
    for count in [8, 12, 20, 35, 60, 100] {
        let wave = |i: usize| Point::new(300.0 * i as f64 / count as f64, 100.0 * libm::sin(0.9 * i as f64));
        let waves: Vec<Point> = (0..count).map(wave).collect();
        let scattered: Vec<Point> = (0..count).map(|_| random.vector(150.0)).collect();
        for (points, room) in [(&waves, 0.5), (&scattered, 1.0)] {
            for (degree, off) in [(1, 3.0), (1, 24.0), (2, 9.0), (3, 0.6), (3, 3.0), (3, 24.0)] {
                let options = Options { degrees: vec![degree], closed: Some(false), ..Options::default() };
                let found = fit(points, Ask::MeanSquare(off * off), &options).expect("it can be fitted");
                let what = format!("{count} points, degree {degree}, {off} off");
                assert_eq!(found.status, FitStatus::Converged, "{what}");
                assert!(found.qfe <= off * off * (1.0 + 1e-9), "{what}: {}", found.qfe);
                let (low, high) =
                    points.iter().fold((points[0], points[0]), |(a, b), p| (a.inf(p), b.sup(p)));
                let beyond = |place: &Point| (low - place).sup(&(place - high)).max();
                let beyond = places(&found).iter().map(beyond).fold(0.0, f64::max);
                // Between two points far apart a curve may bend outwards by as much as they are apart, beside the box
                // of waves by half of that.
                assert!(beyond < room * (high - low).max(), "{what}: {beyond} beyond the box");
            }
        }
    }
}

#[test]
fn a_mean_square_of_zero_is_the_curve_through_the_points() {
    let mut random = Random::new(11);
    for (count, degree, closed) in
        [(9, 1, false), (9, 3, true), (14, 2, false), (30, 3, false), (30, 5, true)]
    {
        let points: Vec<Point> = (0..count).map(|_| random.vector(100.0)).collect();
        let options = Options { degrees: vec![degree], closed: Some(closed), ..Options::default() };
        let found = fit(&points, Ask::MeanSquare(0.0), &options).expect("it can be fitted");
        // A pull of 1e-11 between neighbouring coefficients keeps the solution unique, and equations of degree 5 make a
        // thousand times of it.
        assert!(found.max_error < 1e-8 * 200.0, "{count} points, degree {degree}: {}", found.max_error);
    }
}

/// Ten clicks: an arch, a sharp turn, a wave; by other seeds not quite there.
fn clicked(seed: u64) -> Vec<Point> {
    let x = [150.0, 210.0, 270.0, 330.0, 390.0, 470.0, 560.0, 650.0, 730.0, 800.0];
    let y = [500.0, 400.0, 300.0, 400.0, 500.0, 430.0, 400.0, 430.0, 500.0, 400.0];
    let mut random = Random::new(seed);
    let off = if seed == 0 { 0.0 } else { 15.0 };
    x.iter().zip(y).map(|(&x, y)| Point::new(x, y) + random.noise() * off).collect()
}

#[test]
fn a_smoothing_of_a_few_clicks_leaves_their_way_by_no_more_than_half_a_step() {
    let steps = Finish { extreme: true, merge: true, slide: true, debias: true, prune: true };
    for seed in 0..8 {
        let points = clicked(seed);
        let apart = points.windows(2).map(|pair| (pair[1] - pair[0]).norm()).fold(0.0, f64::max);
        for (degrees, smoothing) in
            [1, 3, 4, 5, 6, 7].into_iter().flat_map(|s| [(vec![3], s), (vec![1, 3], s)])
        {
            let options = Options { degrees, closed: Some(false), finish: steps, ..Options::default() };
            let ask = Ask::Smoothing(0.1 * f64::from(smoothing));
            let fitted = fit(&points, ask, &options).expect("it can be fitted");
            let farthest = places(&fitted).iter().map(|place| off(place, &points)).fold(0.0, f64::max);
            // The curve of the optimum is a compromise: what its points are off on average is no swing.
            let most = 0.5 * apart + 2.0 * fitted.rms;
            assert!(farthest <= most, "seed {seed}, {smoothing}: {farthest} of {most}");
        }
    }
}
