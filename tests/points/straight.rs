//! Straight sides come out straight where noise explains what a line leaves, and curves stay curves.
#![cfg(not(target_arch = "wasm32"))]

use crate::support::curves::Random;
use expline::fit::{Ask, Finish, Fit, Options, fit};
use expline::numerics::Point;

/// Normally distributed (Box and Muller), tails included.
fn normal(random: &mut Random) -> f64 {
    let radius = (-2.0 * random.unit().max(1e-300).ln()).sqrt();
    radius * (core::f64::consts::TAU * random.unit()).cos()
}

/// Points evenly along a closed polygon with sides of one length, noise added.
fn along(corners: &[Point], count: usize, sigma: f64, seed: u64) -> Vec<Point> {
    let mut random = Random::new(seed);
    let sides = corners.len();
    let place = |i: usize| {
        let at = i as f64 * sides as f64 / count as f64;
        let (side, share) = (at as usize, at.fract());
        corners[side] * (1.0 - share) + corners[(side + 1) % sides] * share
    };
    (0..count).map(|i| place(i) + Point::new(normal(&mut random), normal(&mut random)) * sigma).collect()
}

fn star() -> Vec<Point> {
    (0..10)
        .map(|j| {
            let angle = core::f64::consts::PI * (f64::from(j) / 5.0 - 0.5);
            Point::new(angle.cos(), angle.sin()) * if j % 2 == 0 { 180.0 } else { 75.0 }
        })
        .collect()
}

/// Lines of the curve; what rounding bends is none.
fn lines(fitted: &Fit) -> usize {
    fitted.curve.segments().filter(|segment| segment.as_line(1e-10)).count()
}

fn farthest(fitted: &Fit, corners: &[Point]) -> f64 {
    let off = |corner: &Point| {
        fitted.knots.iter().map(|knot| (knot.point - corner).norm()).fold(f64::INFINITY, f64::min)
    };
    corners.iter().map(off).fold(0.0, f64::max)
}

#[test]
fn the_sides_of_noisy_stars_are_straight() {
    let corners = star();
    let (mut straight, stars) = (0, 8);
    for seed in 0..stars {
        let points = along(&corners, 300, 1.5, 70 + seed);
        let fitted = fit(&points, Ask::Noise, &Options::default()).expect("it can be fitted");
        let (pieces, own) = (fitted.curve.segment_count(), lines(&fitted));
        straight += usize::from((pieces, own) == (10, 10));
        assert!(pieces <= 11 && own >= 8, "star {seed}: {own} lines of {pieces} pieces");
        // Thirty points of noise 1.5 on each of two sides tell to about one where they meet.
        let off = farthest(&fitted, &corners);
        assert!(off < 3.0, "star {seed}: a corner is off by {off}");
    }
    assert!(straight >= 6, "{straight} of {stars} have ten lines and nothing else");
}

#[test]
fn smoothing_a_star_by_corners_and_curves_leaves_straight_sides() {
    let corners = star();
    let finish = Finish { merge: true, slide: true, debias: true, prune: true, ..Finish::default() };
    let options = Options { degrees: vec![1, 3], finish, closed: Some(true), ..Options::default() };
    let points = along(&corners, 300, 1.5, 5);
    let convex = fit(&points, Ask::Smoothing(0.4), &Options { finish: Finish::default(), ..options.clone() })
        .expect("it can be fitted");
    let fitted = fit(&points, Ask::Smoothing(0.4), &options).expect("it can be fitted");
    assert_eq!((fitted.curve.segment_count(), lines(&fitted)), (10, 10));
    assert!(fitted.qfe <= convex.qfe, "{} for {}", fitted.qfe, convex.qfe);
    assert!(farthest(&fitted, &corners) < 3.0, "{}", farthest(&fitted, &corners));
}

#[test]
fn arcs_stay_curved() {
    // A circle of 200: an eighth of it is 15 beside its chord, noise 1.
    let mut random = Random::new(3);
    let points: Vec<Point> = (0..600)
        .map(|i| {
            let angle = core::f64::consts::TAU * f64::from(i) / 600.0;
            Point::new(angle.cos(), angle.sin()) * 200.0
                + Point::new(normal(&mut random), normal(&mut random))
        })
        .collect();
    for ask in [Ask::Noise, Ask::Tolerance(4.0), Ask::Tolerance(8.0)] {
        let fitted = fit(&points, ask.clone(), &Options::default()).expect("it can be fitted");
        assert_eq!(lines(&fitted), 0, "{ask:?}");
    }
}

#[test]
fn a_half_disc_has_one_straight_side() {
    // Its first point is at a corner: knots to both sides of it are neighbours all the same.
    for seed in 8..12 {
        half_disc(seed);
    }
}

fn half_disc(seed: u64) {
    let mut random = Random::new(seed);
    let arc = 200.0 * core::f64::consts::PI;
    let step = (arc + 400.0) / 500.0;
    let points: Vec<Point> = (0..500)
        .map(|i| {
            let along = f64::from(i) * step;
            let place = if along < arc {
                Point::new((along / 200.0).cos(), (along / 200.0).sin()) * 200.0
            } else {
                Point::new(along - arc - 200.0, 0.0)
            };
            place + Point::new(normal(&mut random), normal(&mut random)) * 0.5
        })
        .collect();
    let fitted = fit(&points, Ask::Noise, &Options::default()).expect("it can be fitted");
    assert_eq!(lines(&fitted), 1, "of {} pieces", fitted.curve.segment_count());
    let corners = [Point::new(200.0, 0.0), Point::new(-200.0, 0.0)];
    assert!(farthest(&fitted, &corners) < 0.5, "{}", farthest(&fitted, &corners));
}

/// A way as a hand draws it on a screen: it wanders, and its places are whole numbers.
fn by_hand(way: &[Point], seed: u64) -> Vec<Point> {
    let (mut random, mut astray, mut points) = (Random::new(seed), Point::zeros(), Vec::new());
    for pair in way.windows(2) {
        let steps = ((pair[1] - pair[0]).norm() / 6.0).round().max(1.0);
        for k in 0..steps as usize {
            astray = astray * 0.85 + Point::new(normal(&mut random), normal(&mut random)) * 0.5;
            let place = pair[0] + (pair[1] - pair[0]) * (k as f64 / steps) + astray;
            points.push(Point::new(place.x.round(), place.y.round()));
        }
    }
    points
}

/// How much the curve turns at each of its corners.
fn turns(fitted: &Fit) -> Vec<f64> {
    let segments: Vec<_> = fitted.curve.segments().collect();
    let turn = |(before, after): (usize, usize)| {
        let (a, b) = (segments[before].arriving, segments[after].leaving);
        (a.x * b.y - a.y * b.x).atan2(a.dot(&b)).abs()
    };
    let last = segments.len() - 1;
    let seam = fitted.curve.is_closed().then_some((last, 0));
    // What rounding turns is none.
    (0..last).map(|i| (i, i + 1)).chain(seam).map(turn).filter(|turn| *turn > 1e-6).collect()
}

#[test]
fn a_curve_turns_at_corners_by_no_less_than_is_asked_for() {
    let turn_of = |i: usize| core::f64::consts::TAU * i as f64 / 70.0;
    let wave = (0..80).map(|i| Point::new(8.0 * f64::from(i), 90.0 * (f64::from(i) / 10.0).sin())).collect();
    let oval = (0..=70).map(|i| Point::new(180.0 * turn_of(i).cos(), 90.0 * turn_of(i).sin())).collect();
    let zigzag = (0..6).map(|i| Point::new(100.0 * f64::from(i), 200.0 * f64::from(i % 2))).collect();
    let ways: [(&str, Vec<Point>, bool, usize); 3] =
        [("wave", wave, false, 0), ("oval", oval, true, 0), ("zigzag", zigzag, false, 4)];
    for (name, way, closed, corners) in ways {
        let points = by_hand(&way, 11);
        for ask in [Ask::Tolerance(2.0), Ask::Tolerance(1.5), Ask::Noise] {
            let options = Options { closed: Some(closed), least_turn: 0.5, ..Options::default() };
            let fitted = fit(&points, ask.clone(), &options).expect("it can be fitted");
            let turns = turns(&fitted);
            assert!(turns.iter().all(|turn| *turn >= 0.5), "{name}, {ask:?}: {turns:?}");
            assert_eq!(turns.len(), corners, "{name}, {ask:?}: {turns:?}");
            if let Ask::Tolerance(tolerance) = ask {
                assert!(fitted.max_error <= tolerance, "{name}, {ask:?}: {}", fitted.max_error);
            }
        }
    }
}

#[test]
fn an_open_curve_without_knots_is_one_segment() {
    let points: Vec<Point> = (0..30).map(|i| Point::new(3.0, 4.0) * f64::from(i)).collect();
    let open = Options { closed: Some(false), ..Options::default() };
    for ask in [Ask::Noise, Ask::Tolerance(0.01)] {
        let fitted = fit(&points, ask.clone(), &open).expect("it can be fitted");
        assert_eq!((fitted.knots.len(), fitted.curve.segment_count()), (0, 1), "{ask:?}");
        assert!(
            fitted.curve.points().iter().zip([points[0], points[29]]).all(|(a, b)| (a - b).norm() < 1e-7)
        );
    }
}

#[test]
fn an_open_stroke_that_is_one_line_needs_no_corners_for_that() {
    for (count, bend) in [(2, 0.0), (3, 0.0), (3, 0.2), (7, 0.1), (60, 0.1)] {
        let points: Vec<Point> =
            (0..count).map(|i| Point::new(f64::from(i), bend * f64::from(i % 2))).collect();
        for degrees in [vec![2], vec![3], vec![5], vec![1, 3]] {
            for (corners, least_turn) in [(false, 0.0), (true, 0.5)] {
                let options = Options {
                    closed: Some(false),
                    degrees: degrees.clone(),
                    corners,
                    least_turn,
                    ..Options::default()
                };
                let fitted = fit(&points, Ask::Tolerance(0.5), &options).expect("it can be fitted");
                let what = format!("{count} points, degrees {degrees:?}, corners {corners}");
                assert!(fitted.max_error <= 0.5, "{what}: {}", fitted.max_error);
                assert!(fitted.knots.is_empty(), "{what}: {:?}", fitted.knots);
            }
        }
    }
}
