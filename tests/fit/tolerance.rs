//! A larger tolerance asks for fewer knots, near the noise as well; and what is asked for is kept at every scale.
#![cfg(not(target_arch = "wasm32"))]

use crate::support::curves::Random;
use expline::curve::NearestFinder;
use expline::fit::{Ask, Fit, FitStatus, Options, fit};
use expline::numerics::Point;

const TURN: f64 = core::f64::consts::TAU;

/// Points evenly far apart along a closed polyline.
fn evenly(corners: &[Point], count: usize) -> Vec<Point> {
    let next = |i: usize| corners[(i + 1) % corners.len()];
    let length: f64 = (0..corners.len()).map(|i| (next(i) - corners[i]).norm()).sum();
    let (mut i, mut before) = (0, 0.0);
    let at = |k: usize| {
        let wanted = length * k as f64 / count as f64;
        while before + (next(i) - corners[i]).norm() < wanted {
            before += (next(i) - corners[i]).norm();
            i += 1;
        }
        let step = next(i) - corners[i];
        corners[i] + step * ((wanted - before) / step.norm())
    };
    (0..count).map(at).collect()
}

/// A star of five points, and a smooth outline with three waves.
fn outline(smooth: bool) -> Vec<Point> {
    let count = if smooth { 2000 } else { 10 };
    let place = |j: usize| {
        let a = TURN * (j as f64 / count as f64 - 0.25);
        let radius = match (smooth, j % 2) {
            (true, _) => 150.0 + 30.0 * libm::cos(3.0 * a),
            (false, 0) => 180.0,
            (false, _) => 75.0,
        };
        Point::new(libm::cos(a), libm::sin(a)) * radius
    };
    (0..count).map(place).collect()
}

fn noisy(points: &[Point], sigma: f64, seed: u64) -> Vec<Point> {
    let mut random = Random::new(1_000_003 * seed + 77);
    random.noisy(points, sigma)
}

/// The square of a point's distance from an edge.
fn beside(a: Point, b: Point, point: Point) -> f64 {
    let (way, chord) = (point - a, b - a);
    let along = (way.dot(&chord) / chord.norm_squared().max(1e-300)).clamp(0.0, 1.0);
    (way - chord * along).norm_squared()
}

/// The largest distance of a point from a curve, by chords of it: never too small by more than they are short.
fn farthest(fitted: &Fit, points: &[Point]) -> f64 {
    let (_, end) = fitted.curve.domain();
    // Corners are places, too: chords would cut them.
    let mut joints: Vec<f64> = fitted.knots.iter().map(|knot| knot.t).chain([0.0, end]).collect();
    joints.sort_by(f64::total_cmp);
    let between = |pair: &[f64]| {
        let (from, step) = (pair[0], (pair[1] - pair[0]) / 400.0);
        (0..=400).map(move |i| from + step * f64::from(i))
    };
    let at = |t: f64| fitted.curve.evaluate(t.min(end), 0).expect("fine");
    let places: Vec<Point> = joints.windows(2).flat_map(between).map(at).collect();
    let near = |p: &Point| places.windows(2).map(|e| beside(e[0], e[1], *p)).fold(f64::INFINITY, f64::min);
    points.iter().map(near).fold(0.0, f64::max).sqrt()
}

/// With how many lines between points the outline is met, each as long as it can be: more than the fewest are.
fn lines(points: &[Point], tolerance: f64) -> usize {
    let at = |m: usize| points[m % points.len()];
    let (mut from, mut lines) = (0, 0);
    while from < points.len() {
        let meets =
            |to: &usize| (from + 1..*to).all(|m| beside(at(from), at(*to), at(m)) <= tolerance * tolerance);
        let last = (from + 60).min(points.len());
        from = (from + 1..=last).rev().find(meets).unwrap_or(from + 1);
        lines += 1;
    }
    lines
}

#[test]
fn knots_fall_as_the_tolerance_rises_near_the_noise_too() {
    const LADDER: [f64; 9] = [1.0, 1.4, 1.8, 2.0, 2.3, 2.8, 3.5, 5.0, 8.0];
    for (case, sigma) in [1.0, 0.5, 0.25, 1.0, 0.5, 0.25].into_iter().enumerate() {
        let points = noisy(&evenly(&outline(case < 3), 200), sigma, case as u64);
        let mut least = usize::MAX;
        for steps in LADDER {
            let tolerance = steps * sigma;
            let fitted = fit(&points, Ask::Tolerance(tolerance), &Options::default()).expect("fits");
            let (pieces, far) = (fitted.curve.segment_count(), farthest(&fitted, &points));
            let what = format!("outline {case} at {steps} standard deviations: {pieces} pieces, {far} away");
            assert_eq!(fitted.status, FitStatus::Converged, "{what}");
            assert!(far <= 1.001 * tolerance && fitted.max_error <= tolerance, "{what}");
            // One more, for lines between points need not begin at the same one; and a little less than the tolerance.
            let most = lines(&points, 0.98 * tolerance) + 1;
            assert!(pieces <= most, "{what}, and {most} lines");
            // Two knots are what a search may miss.
            if steps >= 2.0 {
                assert!(pieces <= least.saturating_add(2), "{what}, and {least} before");
                least = least.min(pieces);
            }
        }
    }
}

#[test]
fn a_triangle_is_a_triangle_at_every_scale_and_place() {
    let corners = [Point::new(-1.0, -1.0), Point::new(1.0, -0.8), Point::new(0.1, 1.0)];
    let triangle = evenly(&corners, 240);
    for (scale, place) in [
        (1e-12, 0.0),
        (1e-6, 0.0),
        (1.0, 0.0),
        (1e8, 0.0),
        (1e9, 0.0),
        (50.0, 1e6),
        (50.0, 1e8),
        (50.0, 1e9 - 50.0),
    ] {
        let points: Vec<Point> = triangle.iter().map(|p| p * scale + Point::new(place, place)).collect();
        for ask in [Ask::Noise, Ask::Tolerance(1e-3 * scale)] {
            let options = Options { closed: Some(true), ..Options::default() };
            let fitted = fit(&points, ask.clone(), &options).expect("fits");
            let what = format!("{scale} about {place}, {ask:?}");
            assert_eq!(fitted.status, FitStatus::Converged, "{what}");
            assert_eq!(fitted.curve.segment_count(), 3, "{what}");
            let (far, digits) = (farthest(&fitted, &points), 4.0 * f64::EPSILON * (scale + place));
            // Corners between two points are cut by what noise may be taken for: a few ten-thousandths of the drawing.
            assert!(far <= 1e-2 * scale + digits, "{what}: {far}");
            assert!(far <= fitted.max_error * (1.0 + 1e-6) + digits, "{what}: {far} of {}", fitted.max_error);
            for point in fitted.curve.points() {
                assert!(point.x.abs() <= 1e9 && point.y.abs() <= 1e9, "{what}: {point}");
            }
        }
    }
}

/// The largest distance of a point from a curve, by search on the curve.
fn searched(fitted: &Fit, points: &[Point]) -> f64 {
    let finder = NearestFinder::new(&fitted.curve);
    points.iter().map(|p| finder.nearest(*p).distance).fold(0.0, f64::max)
}

/// As many points as a drawing has are met as near as is asked for, or as numbers can be; and where corners explain
/// them, by those.
#[test]
fn the_left_end_of_a_slider_goes_through_the_points() {
    let size = 360.0;
    for (count, smooth, sigma) in [(400, true, 0.0), (2400, true, 0.0), (2400, false, 0.0), (2400, true, 0.5)]
    {
        let points = noisy(&evenly(&outline(smooth), count), sigma, 5);
        for tolerance in [0.0, 1e-9 * size, 1e-6 * size] {
            let fitted = fit(&points, Ask::Tolerance(tolerance), &Options::default()).expect("fits");
            let (far, pieces) = (searched(&fitted, &points), fitted.curve.segment_count());
            let what =
                format!("{count}, {smooth}, noise {sigma}, within {tolerance}: {pieces} pieces, {far} away");
            assert!(far <= tolerance + 1e-12 * size, "{what}");
            assert!(fitted.max_error <= tolerance.max(1e-12 * size), "{what}: {}", fitted.max_error);
            assert_eq!(fitted.status == FitStatus::Converged, fitted.max_error <= tolerance, "{what}");
            assert!(pieces <= if smooth { count } else { 40 }, "{what}");
        }
    }
}

/// Where no smooth curve with few knots is so near, a polyline is: what is asked for is kept, and by no more pieces
/// than lines take.
#[test]
fn a_tolerance_below_the_noise_is_kept_however_many_points_there_are() {
    for (count, smooth) in [(600, false), (1000, true), (1800, false), (2600, true), (9000, true)] {
        let all = noisy(&evenly(&outline(smooth), count), 1.0, count as u64);
        for (tolerance, closed) in [(0.15, true), (0.5, false), (1.0, true), (1.7, false)] {
            let points = if closed { &all[..] } else { &all[..3 * count / 4] };
            let options = Options { closed: Some(closed), ..Options::default() };
            let fitted = fit(points, Ask::Tolerance(tolerance), &options).expect("fits");
            let (far, pieces) = (searched(&fitted, points), fitted.curve.segment_count());
            let what =
                format!("{count}, {smooth}, {closed}, within {tolerance}: {pieces} pieces, {far} away");
            assert!(far <= tolerance && fitted.max_error <= tolerance, "{what}: {}", fitted.max_error);
            assert_eq!(fitted.status, FitStatus::Converged, "{what}");
            assert_eq!(fitted.curve.is_closed(), closed, "{what}");
            let most = lines(points, 0.98 * tolerance) + 1;
            assert!(pieces <= most, "{what}, and {most} lines");
        }
    }
}

/// Points of which no smooth curve with few knots is near: a zigzag, a cloud in no order, and noise with repetitions.
fn rough(kind: usize, count: usize) -> Vec<Point> {
    let mut random = Random::new(31 * kind as u64 + 5);
    let place = |i: usize| match kind {
        0 => Point::new(5.0 * i as f64, if i.is_multiple_of(2) { 0.0 } else { 40.0 }),
        1 => Point::new(random.unit(), random.unit()) * 300.0,
        _ => Point::new(2.0 * libm::floor(i as f64 / 3.0), libm::floor(9.0 * random.unit())),
    };
    (0..count).map(place).collect()
}

/// The angles by which the curve turns at its points.
fn turns(fitted: &Fit) -> impl Iterator<Item = f64> {
    let (leaving, arriving) = (fitted.curve.tangents(), fitted.curve.tangents_in());
    arriving.iter().zip(leaving).map(|(a, b)| libm::atan2(a.x * b.y - a.y * b.x, a.dot(b)).abs())
}

#[test]
fn a_tolerance_is_kept_where_corners_may_not_be_or_not_slight_ones() {
    const LEAST: f64 = 0.5;
    for (kind, count) in [(0, 60), (1, 120), (2, 300)] {
        let points = rough(kind, count);
        for degree in [2, 3, 5] {
            for (closed, corners) in [(false, false), (true, false), (false, true), (true, true)] {
                let least_turn = if corners { LEAST } else { 0.0 };
                let options = Options {
                    degrees: vec![degree],
                    closed: Some(closed),
                    corners,
                    least_turn,
                    ..Options::default()
                };
                for tolerance in [0.02, 1.0] {
                    let fitted = fit(&points, Ask::Tolerance(tolerance), &options).expect("fits");
                    let what = format!("{kind}, degree {degree}, {closed}, {corners}, within {tolerance}");
                    assert_eq!(fitted.status, FitStatus::Converged, "{what}: {}", fitted.max_error);
                    let far = searched(&fitted, &points);
                    assert!(far <= tolerance && fitted.max_error <= tolerance, "{what}: {far}");
                    // Tangents of pieces as short as a tolerance are differences of coordinates near 300: of the rest
                    // of 1e-6 there are ten digits.
                    let turned = |turn: &f64| *turn < 1e-6 || corners && *turn > LEAST - 1e-6;
                    assert!(turns(&fitted).all(|turn| turned(&turn)), "{what}: a slight corner");
                }
            }
        }
    }
}

/// Corners that turn too little used to be made smooth one by one, for a knot on either side: 481 of 600 points.
#[test]
fn a_rough_line_has_no_more_knots_where_corners_must_turn_than_where_there_are_none() {
    const LEAST: f64 = 0.5;
    let line = |count: usize| {
        let place = |i: usize| {
            let a = TURN * i as f64 / count as f64;
            let wide = Point::new(libm::cos(a), libm::sin(a)) * 300.0;
            wide + Point::new(libm::cos(5.0 * a), libm::sin(3.0 * a)) * 80.0
        };
        (0..count).map(place).collect::<Vec<Point>>()
    };
    for count in [200, 600] {
        let points = noisy(&line(count), 1.0, 3);
        for tolerance in [1.0, 2.0] {
            let fitted = |corners: bool| {
                let least_turn = if corners { LEAST } else { 0.0 };
                let options = Options { closed: Some(false), corners, least_turn, ..Options::default() };
                fit(&points, Ask::Tolerance(tolerance), &options).expect("fits")
            };
            let (cornered, smooth) = (fitted(true), fitted(false));
            let what = format!("{count} points within {tolerance}");
            assert!(cornered.max_error <= tolerance, "{what}: {}", cornered.max_error);
            let [with, without] = [&cornered, &smooth].map(|fitted| fitted.knots.len());
            assert!(with <= without, "{what}: {with} knots, and {without} without corners");
            assert!(
                turns(&cornered).all(|turn| !(1e-6..LEAST - 1e-6).contains(&turn)),
                "{what}: a slight corner"
            );
        }
    }
}

#[test]
fn points_on_a_line_are_one_line_however_they_are_spread() {
    for power in [1, 2, 3, 6] {
        for degree in 1..=5 {
            let share = |i: i32| (f64::from(i) / 29.0).powi(power);
            let points: Vec<Point> = (0..30).map(|i| Point::new(300.0, 100.0) * share(i)).collect();
            let options = Options { degrees: vec![degree], ..Options::default() };
            let fitted = fit(&points, Ask::Tolerance(2.0), &options).expect("fits");
            assert_eq!(fitted.knots.len(), 0, "degree {degree}, spread by the power {power}");
            assert!(fitted.max_error <= 2.0, "degree {degree}, spread by the power {power}");
        }
    }
}

/// Knots that begin as corners are no way to round corners off: each round of that made three of one.
#[test]
fn corners_of_degree_two_are_rounded_off_by_no_more_knots_than_rounds_take() {
    let points = rough(1, 400);
    for tolerance in [3.0, 30.0] {
        let options = Options { degrees: vec![2], closed: Some(true), least_turn: 3.0, ..Options::default() };
        let fitted = fit(&points, Ask::Tolerance(tolerance), &options).expect("fits");
        assert_eq!(fitted.status, FitStatus::Converged, "within {tolerance}");
        // A round at every point has two ends.
        assert!(fitted.knots.len() <= 800, "within {tolerance}: {} knots", fitted.knots.len());
    }
}

/// Points at even angles of a spiral: by length those of its inner turns are many times closer than the others.
fn spiral(count: usize, seed: u64) -> Vec<Point> {
    let mut random = Random::new(seed);
    let turned = TURN * random.unit();
    let place = |i: usize| {
        let a = 40.0 * i as f64 / count as f64;
        Point::new(libm::cos(a + turned), libm::sin(a + turned)) * (5.0 * a)
    };
    let places: Vec<Point> = (0..count).map(place).collect();
    random.noisy(&places, 0.3)
}

#[test]
fn narrow_turns_get_their_knots_where_points_are_close() {
    // Where a knot needed as much of the way as points are apart on average no tolerance was kept, and the answer had
    // 60 to 110 pieces: all but a polyline. Six turns take about three pieces each.
    for (count, tolerance) in [(100, 3.0), (120, 1.5), (120, 2.0), (150, 1.5), (150, 5.0), (200, 1.5)] {
        for seed in 1..=3 {
            let options = Options { closed: Some(false), ..Options::default() };
            let fitted = fit(&spiral(count, seed), Ask::Tolerance(tolerance), &options).expect("fitted");
            assert_eq!(fitted.status, FitStatus::Converged);
            assert!(fitted.max_error <= tolerance, "{} within {tolerance}", fitted.max_error);
            let pieces = fitted.knots.len() + 1;
            assert!(pieces <= 26, "{count} points within {tolerance}: {pieces} pieces");
        }
    }
}

#[test]
fn a_smooth_curve_has_few_pieces_where_a_search_misses_its_tolerance() {
    // A polyline with its vertices rounded off was the answer then, of 175 to 280 pieces.
    for (count, tolerance) in [(100, 1.0), (100, 2.0), (120, 3.0), (150, 1.4), (200, 1.0)] {
        for seed in 1..=3 {
            let options = Options { closed: Some(false), corners: false, ..Options::default() };
            let fitted = fit(&spiral(count, seed), Ask::Tolerance(tolerance), &options).expect("fitted");
            assert_eq!(fitted.status, FitStatus::Converged);
            assert!(fitted.max_error <= tolerance, "{} within {tolerance}", fitted.max_error);
            assert!(turns(&fitted).all(|turn| turn < 1e-6), "no corner was asked for");
            let pieces = fitted.knots.len() + 1;
            assert!(pieces <= 40, "{count} points within {tolerance}: {pieces} pieces");
        }
    }
}

/// How far the curve is from the lines between the points, at most: it may swing nowhere.
fn beyond_lines(fitted: &Fit, points: &[Point]) -> f64 {
    let (start, end) = fitted.curve.domain();
    let at = |i: u32| start + (end - start) * f64::from(i) / 4000.0;
    let far =
        |place: Point| points.windows(2).map(|e| beside(e[0], e[1], place)).fold(f64::INFINITY, f64::min);
    (0..=4000).map(|i| far(fitted.curve.evaluate(at(i), 0).expect("fine"))).fold(0.0, f64::max).sqrt()
}

#[test]
fn below_the_noise_a_curve_has_at_most_three_pieces_for_five_lines_and_follows_them() {
    // The polyline with the fewest vertices was the answer, with its vertices rounded off where corners may not be: of
    // these points up to four pieces for each that there is now.
    for (count, tolerance) in [(500, 0.5), (1000, 0.7), (1000, 1.5), (2600, 1.0)] {
        for corners in [true, false] {
            let points = &noisy(&evenly(&outline(true), count), 1.0, 3 * count as u64)[..9 * count / 10];
            let options = Options { closed: Some(false), corners, ..Options::default() };
            let fitted = fit(points, Ask::Tolerance(tolerance), &options).expect("fitted");
            assert_eq!(fitted.status, FitStatus::Converged);
            let (pieces, lines) = (fitted.curve.segment_count(), lines(points, 0.98 * tolerance));
            let what = format!(
                "{count} points within {tolerance}, corners {corners}: {pieces} pieces, {lines} lines"
            );
            assert!(searched(&fitted, points) <= tolerance, "{what}");
            assert!(5 * pieces <= 3 * lines, "{what}");
            let beyond = beyond_lines(&fitted, points);
            assert!(beyond <= 3.0 * tolerance, "{what}: {beyond} beside them");
        }
    }
}

/// A way that turns at random after each step of three.
fn walk(count: usize, seed: u64) -> Vec<Point> {
    let mut random = Random::new(seed);
    let (mut place, mut way) = (Point::zeros(), 0.0);
    let mut step = || {
        way += 0.3 * random.normal();
        place += Point::new(libm::cos(way), libm::sin(way)) * 3.0;
        place
    };
    (0..count).map(|_| step()).collect()
}

#[test]
fn a_rough_way_takes_half_of_the_pieces_that_lines_take() {
    for (count, tolerance) in [(300, 1.0), (1500, 1.0), (1500, 3.0), (3000, 2.0)] {
        for corners in [true, false] {
            let points = walk(count, count as u64);
            let options = Options { closed: Some(false), corners, ..Options::default() };
            let fitted = fit(&points, Ask::Tolerance(tolerance), &options).expect("fitted");
            assert_eq!(fitted.status, FitStatus::Converged);
            let (pieces, lines) = (fitted.curve.segment_count(), lines(&points, 0.98 * tolerance));
            let what = format!(
                "{count} points within {tolerance}, corners {corners}: {pieces} pieces, {lines} lines"
            );
            assert!(searched(&fitted, &points) <= tolerance, "{what}");
            assert!(2 * pieces <= lines, "{what}");
        }
    }
}

/// Points evenly far apart along a cubic from (0, 0) to (200, 0).
fn along_a_cubic(count: usize, random: &mut Random) -> Vec<Point> {
    let [a, b] = [50.0, 150.0].map(|x| Point::new(x, 0.0) + random.vector(50.0));
    let at = |t: f64| {
        let u = 1.0 - t;
        (a * u + b * t) * (3.0 * u * t) + Point::new(200.0, 0.0) * (t * t * t)
    };
    let fine: Vec<Point> = (0..=20_000).map(|i| at(f64::from(i) / 20_000.0)).collect();
    let mut lengths = vec![0.0];
    lengths.extend(fine.windows(2).scan(0.0, |sum, pair| {
        *sum += (pair[1] - pair[0]).norm();
        Some(*sum)
    }));
    let step = lengths[20_000] / (count - 1) as f64;
    (0..count).map(|i| fine[lengths.partition_point(|&l| l < step * i as f64).min(20_000)]).collect()
}

/// The speed of a cubic changes by up to forty times, and points by length do not show it. Between two of the fine
/// points lies less than .02, and the curve turns by less than 1e-6 of that.
#[test]
fn a_line_that_is_one_cubic_comes_back_as_one_however_its_points_are_spread() {
    let mut random = Random::new(50);
    for case in 0..60 {
        let points = along_a_cubic([40, 120, 900][case % 3], &mut random);
        for tolerance in [0.1, 0.5] {
            let options = Options { closed: Some(false), ..Options::default() };
            let fitted = fit(&points, Ask::Tolerance(tolerance), &options).expect("fitted");
            assert_eq!(fitted.knots.len(), 0, "case {case}, tolerance {tolerance}");
            assert!(fitted.max_error < 0.05, "case {case}: {} off at {tolerance}", fitted.max_error);
        }
    }
}

/// Points by length ask for knots where the speed changes, in noise as well; points that slide do not. A cubic has
/// eight numbers, of which two only say how fast it is: six take a point's share of the noise across.
#[test]
fn noisy_points_of_one_cubic_need_no_knot() {
    let mut random = Random::new(51);
    let (mut knots, mut share, cases) = (0, 0.0, 48);
    for case in 0..cases {
        let clean = along_a_cubic([40, 120, 900][case % 3], &mut random);
        let sigma = [0.3, 1.0][case % 2];
        let options = Options { closed: Some(false), ..Options::default() };
        let fitted = fit(&random.noisy(&clean, sigma), Ask::Noise, &options).expect("fitted");
        let finder = NearestFinder::new(&fitted.curve);
        knots += fitted.knots.len();
        let off = |p: &Point| finder.nearest(*p).distance / sigma;
        share += clean.iter().map(|p| off(p) * off(p)).sum::<f64>() / (6 * cases) as f64;
    }
    assert!(knots <= 2, "{knots} knots in {cases} lines");
    // With the two knots each that points by length ask for, twelve numbers take their share.
    assert!(share < 1.3, "{share} times what the numbers of a cubic cost");
}
