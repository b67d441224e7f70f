//! Outlines that have their sides by their ends only, as flattened paths and polygons do, are followed along the sides;
//! few points are led through.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::Random;
use core::f64::consts::PI;
use expline::fit::{Ask, Fit, Fitter, Options, Parametrisation, Samples, fit, noise};
use expline::numerics::Point;

/// An arc in chords, from one angle to another.
fn arc(center: [f64; 2], radius: f64, angles: [f64; 2], chords: usize) -> Vec<Point> {
    let at = |i: usize| {
        let angle = angles[0] + (angles[1] - angles[0]) * i as f64 / chords as f64;
        Point::new(center[0] + radius * libm::cos(angle), center[1] + radius * libm::sin(angle))
    };
    (0..=chords).map(at).collect()
}

fn points(places: &[[f64; 2]]) -> Vec<Point> {
    places.iter().map(|[x, y]| Point::new(*x, *y)).collect()
}

/// Shapes of arcs in chords of 2 to 4, with sides of 20 to 200 between.
fn outlines() -> Vec<(&'static str, Vec<Point>)> {
    let quarter = |x: f64, y: f64, k: f64| arc([x, y], 20.0, [k * PI / 2.0, (k + 1.0) * PI / 2.0], 12);
    let half = arc([0.0, 0.0], 50.0, [-PI / 2.0, PI / 2.0], 40);
    let right = arc([100.0, 0.0], 30.0, [-PI / 2.0, PI / 2.0], 30);
    let left = arc([-100.0, 0.0], 30.0, [PI / 2.0, 1.5 * PI], 30);
    let corners = [[80.0, 40.0], [-80.0, 40.0], [-80.0, -40.0], [80.0, -40.0]];
    let rounded =
        corners.iter().zip([0.0, 1.0, 2.0, 3.0]).flat_map(|([x, y], k)| quarter(*x, *y, k)).collect();
    let key = arc([0.0, 0.0], 30.0, [0.4, 2.0 * PI - 0.4], 50);
    vec![
        ("half a disc", half.clone()),
        ("D", [half, points(&[[-40.0, 50.0], [-40.0, -50.0]])].concat()),
        ("rounded rectangle", rounded),
        ("stadium", [right, left].concat()),
        ("key", [key, points(&[[150.0, -11.7], [150.0, 11.7]])].concat()),
        ("pie", [points(&[[0.0, 0.0]]), arc([0.0, 0.0], 80.0, [0.2, 2.0], 40)].concat()),
    ]
}

/// The largest distance of the curve from the closed polygon.
fn astray(fit: &Fit, outline: &[Point]) -> f64 {
    let (start, end) = fit.curve.domain();
    let from_side = |place: Point, a: Point, b: Point| {
        let along = ((place - a).dot(&(b - a)) / (b - a).norm_squared()).clamp(0.0, 1.0);
        (place - a - (b - a) * along).norm()
    };
    let at = |i: usize| fit.curve.evaluate(start + (end - start) * i as f64 / 1000.0, 0).expect("within");
    let distance = |place: Point| {
        let sides =
            (0..outline.len()).map(|k| from_side(place, outline[k], outline[(k + 1) % outline.len()]));
        sides.fold(f64::INFINITY, f64::min)
    };
    (0..1000).map(|i| distance(at(i))).fold(0.0, f64::max)
}

fn closed() -> Options {
    Options { closed: Some(true), ..Options::default() }
}

#[test]
fn a_flattened_outline_is_followed_along_its_sides_wherever_its_list_begins() {
    // Without points on the sides these curves were up to 112 astray. A smoothing pulls inwards.
    for (name, outline) in outlines() {
        for (ask, most) in [(Ask::Noise, 1.0), (Ask::Tolerance(1.0), 1.2), (Ask::Smoothing(0.3), 2.0)] {
            for begin in [0, 3, 25] {
                let mut given = outline.clone();
                given.rotate_left(begin);
                let found = fit(&given, ask.clone(), &closed()).expect("it can be fitted");
                let off = astray(&found, &given);
                assert!(off < most, "{name}, {ask:?}, from point {begin}: {off} astray");
                assert!(found.max_error <= most, "{name}, {ask:?}: {}", found.max_error);
            }
        }
    }
}

#[test]
fn what_is_said_of_distances_is_said_of_the_given_points() {
    for (name, outline) in outlines() {
        let mut random = Random::new(7);
        let given = random.noisy(&outline, 0.3);
        let found = fit(&given, Ask::Tolerance(2.0), &closed()).expect("it can be fitted");
        assert_eq!(found.parameters.len(), given.len(), "{name}: one place for each");
        let off = |(point, t): (&Point, &f64)| (found.curve.evaluate(*t, 0).expect("within") - point).norm();
        let distances: Vec<f64> = given.iter().zip(&found.parameters).map(off).collect();
        let farthest = distances.iter().copied().fold(0.0, f64::max);
        let rms = (distances.iter().map(|d| d * d).sum::<f64>() / given.len() as f64).sqrt();
        // Both are of the same places, which are known to rounding; `max_error` has that rounding in it.
        assert!((found.max_error - farthest).abs() < 1e-9, "{name}: {} and {farthest}", found.max_error);
        assert!((found.rms - rms).abs() < 1e-9, "{name}: {} and {rms}", found.rms);
    }
}

#[test]
fn few_points_tell_nothing_about_noise_and_are_led_through() {
    let shapes = [
        points(&[[0.0, 0.0], [100.0, 0.0], [50.0, 80.0]]),
        points(&[[0.0, 0.0], [100.0, 0.0], [100.0, 30.0], [30.0, 30.0], [30.0, 100.0], [0.0, 100.0]]),
        points(&[
            [0.0, 0.0],
            [100.0, 0.0],
            [100.0, 20.0],
            [60.0, 20.0],
            [60.0, 90.0],
            [40.0, 90.0],
            [40.0, 20.0],
            [0.0, 20.0],
        ]),
    ];
    for shape in shapes {
        for degrees in [vec![1], vec![3], vec![1, 3]] {
            for round in [true, false] {
                let options = Options { closed: Some(round), degrees: degrees.clone(), ..Options::default() };
                let found = fit(&shape, Ask::Noise, &options).expect("it can be fitted");
                // A ten-thousandth of the drawing is worth no knot.
                assert!(
                    found.max_error < 0.02,
                    "{shape:?}, {degrees:?}, closed {round}: {}",
                    found.max_error
                );
            }
        }
    }
}

/// Points on rays, as far out as is said for each, turned by a third of a radian.
fn rays(radii: &[f64], count: usize) -> Vec<Point> {
    let at = |i: usize| {
        let (angle, radius) = (2.0 * PI * i as f64 / count as f64 + 0.3, radii[i % radii.len()]);
        Point::new(radius * libm::cos(angle), radius * libm::sin(angle))
    };
    (0..count).map(at).collect()
}

/// Polygons by their vertices, and how many of these are corners.
fn polygons() -> Vec<(&'static str, Vec<Point>, usize)> {
    let plus =
        [[1, 0], [2, 0], [2, 1], [3, 1], [3, 2], [2, 2], [2, 3], [1, 3], [1, 2], [0, 2], [0, 1], [1, 1]];
    let h = [[0, 0], [1, 0], [1, 2], [2, 2], [2, 0], [3, 0], [3, 5], [2, 5], [2, 3], [1, 3], [1, 5], [0, 5]];
    // Two vertices lie on a side.
    let arrow = [[0, 2], [6, 2], [6, 0], [10, 4], [6, 8], [6, 6], [0, 6], [0, 5], [0, 3]];
    let drawn = |places: &[[i32; 2]], unit: f64| {
        places.iter().map(|[x, y]| Point::new(unit * f64::from(*x), unit * f64::from(*y))).collect()
    };
    let house = (0..30).map(|i: i32| [(i + 1) / 2, [0, 3, 5, 4][(i / 2 % 4) as usize]]);
    let house: Vec<[i32; 2]> = house.chain([[15, -4], [0, -4]]).collect();
    vec![
        ("triangle", drawn(&[[0, 0], [5, 0], [2, 4]], 20.0), 3),
        ("square", drawn(&[[0, 0], [5, 0], [5, 5], [0, 5]], 20.0), 4),
        ("hexagon", rays(&[80.0], 6), 6),
        ("plus", drawn(&plus, 20.0), 12),
        ("H", drawn(&h, 20.0), 12),
        ("arrow", drawn(&arrow, 10.0), 7),
        ("star of 5", rays(&[100.0, 40.0], 10), 10),
        ("star of 8", rays(&[100.0, 40.0], 16), 16),
        ("wheel", rays(&[80.0, 80.0, 100.0, 100.0], 48), 48),
        ("house", drawn(&house, 10.0), 32),
    ]
}

#[test]
fn a_polygon_by_its_vertices_alone_is_that_polygon() {
    // Taken for noisy points of a curve these came back up to 100 astray, and within a tolerance up to 30.
    for (name, polygon, corners) in polygons() {
        for ask in [Ask::Noise, Ask::Tolerance(0.01)] {
            for begin in [0, 1] {
                let mut given = polygon.clone();
                given.rotate_left(begin);
                let found = fit(&given, ask.clone(), &closed()).expect("it can be fitted");
                let (off, pieces) = (astray(&found, &given), found.curve.segment_count());
                // No more than a corner that is worth no knot: a ten-thousandth of the drawing.
                assert!(off < 0.03, "{name}, {ask:?}, from point {begin}: {off} astray");
                assert_eq!(pieces, corners, "{name}, {ask:?}, from point {begin}");
                assert!(found.noise < 1e-9, "{name}, {ask:?}: it has no noise, {} was said", found.noise);
            }
        }
    }
}

#[test]
fn a_polyline_by_its_vertices_alone_is_kept_to_as_near_as_its_points() {
    for (name, polygon, _) in polygons() {
        let open = Options { closed: Some(false), ..Options::default() };
        let found = fit(&polygon, Ask::Tolerance(0.5), &open).expect("it can be fitted");
        // Where sides are followed by points an eighth of them apart, 1.3 to 15, a curve is free by about as much
        // between these.
        let off = astray(&found, &polygon);
        assert!(off < 2.0, "{name}: {off} astray");
        assert!(found.max_error <= 0.5, "{name}: {}", found.max_error);
    }
}

#[test]
fn samples_of_a_curve_are_not_taken_for_a_polygon() {
    for count in [8, 10, 13, 20, 40, 60] {
        for (noise, ask, most) in [
            (0.0, Ask::Noise, 4.0),
            (0.0, Ask::Tolerance(1.0), 4.0),
            (4.0, Ask::Noise, 16.0),
            (0.5, Ask::Tolerance(2.0), 6.0),
        ] {
            let mut random = Random::new(count as u64);
            let given = random.noisy(&rays(&[80.0], count), noise);
            let found = fit(&given, ask.clone(), &closed()).expect("it can be fitted");
            let (start, end) = found.curve.domain();
            let off = |i: usize| {
                let place =
                    found.curve.evaluate(start + (end - start) * i as f64 / 300.0, 0).expect("within");
                (place.norm() - 80.0).abs()
            };
            let worst = (0..300).map(off).fold(0.0, f64::max);
            assert!(worst < most, "{count} points, noise {noise}, {ask:?}: {worst} from the circle");
            let corners = found.knots.iter().filter(|knot| knot.degree == 1).count();
            assert!(4 * corners <= count, "{count} points, noise {noise}, {ask:?}: {corners} corners");
        }
    }
}

#[test]
fn what_was_asked_before_changes_nothing_about_a_polygon() {
    let asks = [
        Ask::Smoothing(0.3),
        Ask::Tolerance(0.5),
        Ask::Noise,
        Ask::Tolerance(30.0),
        Ask::Tolerance(0.01),
        Ask::Lambda(vec![1.0, 1.0]),
        Ask::Noise,
    ];
    for (name, polygon, _) in polygons().into_iter().filter(|(name, ..)| ["H", "arrow"].contains(name)) {
        let mut fitter = Fitter::new(&polygon, &closed()).expect("they can be fitted");
        for ask in &asks {
            fitter.ask(ask.clone()).expect("it can be asked");
            while !fitter.step(1e6).expect("there is memory").done {}
            let (after, alone) = (fitter.fit().expect("found"), fit(&polygon, ask.clone(), &closed()));
            let alone = alone.expect("found");
            assert_eq!(after.curve.points(), alone.curve.points(), "{name}, {ask:?}");
            assert_eq!(after.noise, alone.noise, "{name}, {ask:?}");
        }
    }
}

/// Teeth up and down by turns, and the way back below them.
fn comb(teeth: i32) -> Vec<Point> {
    let tooth = |i: i32| [[2 * i, 0], [2 * i, 2], [2 * i + 1, 2], [2 * i + 1, 0]];
    let corners = (0..teeth).flat_map(tooth).chain([[2 * teeth - 1, -2], [0, -2]]);
    corners.map(|[x, y]| Point::new(10.0 * f64::from(x), 10.0 * f64::from(y))).collect()
}

#[test]
fn a_polygon_of_many_vertices_is_that_polygon() {
    // With 64 vertices and more these were taken for noise: two knots, and 11 to 35 astray.
    let shapes = [
        ("star of 32", rays(&[100.0, 40.0], 64)),
        ("star of 40", rays(&[100.0, 60.0], 80)),
        ("wheel", rays(&[80.0, 80.0, 100.0, 100.0], 160)),
        ("comb", comb(20)),
    ];
    for (name, polygon) in shapes {
        for begin in [0, 1] {
            let mut given = polygon.clone();
            given.rotate_left(begin);
            let found = fit(&given, Ask::Noise, &closed()).expect("it can be fitted");
            // Two corners of the comb that go straight on are none.
            let corners = given.len() - if name == "comb" { 2 } else { 0 };
            let off = astray(&found, &given);
            // A ten-thousandth of the drawing is worth no corner; the comb is 400 long.
            assert!(off < 0.06, "{name} from point {begin}: {off} astray");
            assert_eq!(found.curve.segment_count(), corners, "{name} from point {begin}");
        }
    }
}

#[test]
fn the_edge_of_a_disc_on_a_grid_is_round() {
    // Of its steps nearly all turn by right angles, left and right: by half a step from the circle, not a polygon.
    for radius in [20, 33] {
        let inside = |x: i32, y: i32| x * x + y * y < radius * radius;
        // With the inside to the left of each step.
        let (mut place, mut way, mut edge) = ([0, -radius + 1], [1, 0], Vec::new());
        while edge.is_empty() || place != [0, -radius + 1] {
            edge.push(Point::new(f64::from(place[0]), f64::from(place[1])));
            place = [place[0] + way[0], place[1] + way[1]];
            let cell = |across: i32| {
                let along = [way[0] - across * way[1], way[1] + across * way[0]];
                inside((2 * place[0] + along[0] - 1) / 2, (2 * place[1] + along[1] - 1) / 2)
            };
            way = match (cell(1), cell(-1)) {
                (true, true) => [way[1], -way[0]],
                (false, _) => [-way[1], way[0]],
                _ => way,
            };
        }
        assert!(edge.len() > 4 * radius as usize, "once round: {}", edge.len());
        let found = fit(&edge, Ask::Noise, &closed()).expect("it can be fitted");
        let knots = found.knots.len();
        assert!(knots <= 12, "radius {radius}: {knots} knots for {} points", edge.len());
        assert!(found.max_error < 1.5, "radius {radius}: {}", found.max_error);
    }
}

#[test]
fn a_polygon_is_followed_whatever_is_said_of_its_points() {
    // With any of these options the sides were left by up to half of the drawing.
    let shapes = ["plus", "H", "arrow", "star of 5"];
    for (name, polygon, corners) in polygons().into_iter().filter(|(name, ..)| shapes.contains(name)) {
        let count = polygon.len();
        let plain = closed();
        let times = (0..count).map(|i| 3.0 + 2.0 * i as f64 + 0.5 * (i % 3) as f64).collect();
        let options = [
            Options { weights: vec![1.0; count], ..plain.clone() },
            Options { weights: (0..count).map(|i| 1.0 + (i % 3) as f64).collect(), ..plain.clone() },
            Options { robust: true, ..plain.clone() },
            Options { parameters: times, ..plain.clone() },
            Options { parametrisation: Parametrisation::Index, ..plain.clone() },
            Options { parametrisation: Parametrisation::Chord, ..plain.clone() },
            Options { parametrisation: Parametrisation::Centripetal, ..plain.clone() },
            Options { parametrisation: Parametrisation::ArcLength, ..plain },
        ];
        for (i, options) in options.iter().enumerate() {
            for ask in [Ask::Noise, Ask::Tolerance(0.01)] {
                let found = fit(&polygon, ask.clone(), options).expect("it can be fitted");
                let off = astray(&found, &polygon);
                assert!(off < 0.03, "{name}, option {i}, {ask:?}: {off} astray");
                // Vertices that lie on a side may be knots where their parameters change the speed.
                let pieces = found.curve.segment_count();
                assert!(
                    (corners..=count).contains(&pieces),
                    "{name}, option {i}, {ask:?}: {pieces} for {corners}"
                );
                assert_eq!(found.parameters.len(), count, "{name}, option {i}: one place for each");
                assert!(found.outliers.is_empty(), "{name}, option {i}: nothing is far off");
            }
        }
    }
}

#[test]
fn given_parameters_are_those_of_the_curve_along_sides_as_well() {
    let (_, polygon, _) = polygons().into_iter().find(|(name, ..)| *name == "H").expect("it is there");
    let parameters: Vec<f64> = (0..12).map(|i| 3.0 + 2.0 * f64::from(i) + 0.5 * f64::from(i % 3)).collect();
    let options = Options { parameters: parameters.clone(), period: Some(40.0), ..closed() };
    let found = fit(&polygon, Ask::Tolerance(0.01), &options).expect("it can be fitted");
    let (start, end) = found.curve.domain();
    // A step is cut into eight, and counts for eight on the way; rounding is all that this leaves.
    assert!((end - start - 40.0).abs() < 1e-9, "one period: {}", end - start);
    for k in 1..12 {
        let way = (found.parameters[k] - found.parameters[0]).rem_euclid(40.0);
        let given = parameters[k] - parameters[0];
        // A curve within a hundredth may be as far from its vertex along a side of 20 and more.
        assert!((way - given).abs() < 0.01, "vertex {k} at {way} for {given}");
    }
}

#[test]
fn sides_of_a_few_tolerances_are_followed() {
    // Sides of ten: they were left by three to four tolerances.
    let shapes = polygons().into_iter().filter(|(name, ..)| ["H", "plus", "star of 5"].contains(name));
    for (name, polygon, _) in shapes {
        let long = (polygon[1] - polygon[0]).norm();
        let small: Vec<Point> = polygon.iter().map(|place| place * (10.0 / long)).collect();
        for tolerance in [2.0, 3.0] {
            let found = fit(&small, Ask::Tolerance(tolerance), &closed()).expect("it can be fitted");
            let off = astray(&found, &small);
            assert!(found.max_error <= tolerance, "{name}, {tolerance}: {}", found.max_error);
            // Between points an eighth of a side apart a curve is freer than at them.
            assert!(off < 1.5 * tolerance, "{name}, {tolerance}: {off} astray");
        }
    }
}

#[test]
fn few_clean_points_of_a_curve_are_not_noisy() {
    // What fourth differences leave of so coarse a curve was taken for noise: up to 1.9 astray, with corners.
    for count in 12..=40 {
        for begin in [0.0, 0.37] {
            let at = |i: usize| 2.0 * PI * (i as f64 + begin) / count as f64;
            let circle: Vec<Point> =
                (0..count).map(|i| Point::new(100.0 * libm::cos(at(i)), 100.0 * libm::sin(at(i)))).collect();
            let found = fit(&circle, Ask::Noise, &closed()).expect("it can be fitted");
            let (start, end) = found.curve.domain();
            let off = |i: usize| {
                let place =
                    found.curve.evaluate(start + (end - start) * i as f64 / 500.0, 0).expect("within");
                (place.norm() - 100.0).abs()
            };
            let worst = (0..500).map(off).fold(0.0, f64::max);
            // Noise of a thousandth of the drawing, .2, is allowed for, and twice that is as far as a point may be.
            assert!(worst < 0.4, "{count} points from {begin}: {worst} from the circle");
            assert!(found.noise <= 0.2 + 1e-9, "{count} points: {}", found.noise);
            let corners = found.knots.iter().filter(|knot| knot.degree == 1).count();
            assert_eq!(corners, 0, "{count} points from {begin}");
        }
    }
}

#[test]
fn the_noise_of_few_points_is_still_told() {
    // Sixth and eighth differences of white noise say the same as fourth ones: the median over a hundred lists tells
    // how much less the least of the three is.
    for count in [12, 20, 40, 60] {
        for closed in [true, false] {
            let turn = if closed { 2.0 * PI } else { 3.0 };
            let clean: Vec<Point> = (0..count)
                .map(|i| turn * f64::from(i) / f64::from(count))
                .map(|angle| Point::new(100.0 * libm::cos(angle), 60.0 * libm::sin(angle)))
                .collect();
            let level = |seed: u64| {
                let given = Random::new(seed).noisy(&clean, 4.0);
                let samples = Samples::new(&given, Some(closed), false).expect("they are points");
                noise(&samples) * samples.scale
            };
            let mut levels: Vec<f64> = (0..100).map(level).collect();
            levels.sort_by(f64::total_cmp);
            // A median of a dozen sizes is within a third of what many would say, mostly.
            assert!((3.0..5.0).contains(&levels[50]), "{count} points, closed {closed}: {}", levels[50]);
            assert!(levels[5] > 1.0, "{count} points, closed {closed}: {}", levels[5]);
        }
    }
}

/// Points of an ellipse 200 long, evenly by their angle or by length, turned.
fn ellipse(count: usize, ratio: f64, begin: f64, even: bool, turned: f64) -> Vec<Point> {
    const FINE: usize = 4000;
    let at = |angle: f64| Point::new(100.0 * libm::cos(angle), 100.0 * ratio * libm::sin(angle));
    let dense: Vec<Point> = (0..=FINE).map(|i| at(2.0 * PI * i as f64 / FINE as f64)).collect();
    let mut lengths = vec![0.0];
    for pair in dense.windows(2) {
        lengths.push(lengths[lengths.len() - 1] + (pair[1] - pair[0]).norm());
    }
    let place = |i: usize| {
        let share = (i as f64 + begin) / count as f64;
        let point = if even {
            dense[lengths.partition_point(|length| *length < share * lengths[FINE])]
        } else {
            at(2.0 * PI * share)
        };
        let (cosine, sine) = (libm::cos(turned), libm::sin(turned));
        Point::new(cosine * point.x - sine * point.y, sine * point.x + cosine * point.y)
    };
    (0..count).map(place).collect()
}

/// How many corners a closed curve near these points has.
fn corners(points: &[Point], ask: Ask) -> usize {
    let found = fit(points, ask, &closed()).expect("it can be fitted");
    found.knots.iter().filter(|knot| knot.degree == 1).count()
}

#[test]
fn few_clean_points_of_an_ellipse_have_no_corner() {
    // Corners are cheap where points are few: two of five had some without a strength, three of four within a
    // ten-thousandth.
    for count in [9, 12, 15, 20, 28, 40] {
        for ratio in [0.3, 0.5, 0.8] {
            for (begin, even, turned) in
                [(0.0, false, 0.0), (0.5, false, 0.4), (0.25, true, 1.2), (0.5, true, 2.2)]
            {
                let points = ellipse(count, ratio, begin, even, turned);
                for ask in [Ask::Noise, Ask::Tolerance(0.02), Ask::Tolerance(1.0)] {
                    let found = corners(&points, ask.clone());
                    assert_eq!(found, 0, "{count} points, {ratio}, from {begin}, by length: {even}, {ask:?}");
                }
            }
        }
    }
}

#[test]
fn corners_of_few_points_are_corners_all_the_same() {
    // Two arcs of 69° and of 103° with tips of 111° and of 77°, which are points or lie between two; and half a disc.
    let lens = |half: f64, count: usize, begin: f64| -> Vec<Point> {
        let place = |i: usize| {
            let way = 2.0 * (i as f64 + begin) / count as f64;
            let (angle, up) = (half * (2.0 * (way % 1.0) - 1.0), if way < 1.0 { 1.0 } else { -1.0 });
            let (x, y) = (-100.0 * libm::sin(angle), 100.0 * (libm::cos(angle) - libm::cos(half)));
            Point::new(up * x, up * y)
        };
        (0..count).map(place).collect()
    };
    for count in [16, 24, 36, 48] {
        for (half, begin) in [(0.6, 0.0), (0.9, 0.0), (0.6, 0.5), (0.9, 0.5)] {
            let found = corners(&lens(half, count, begin), Ask::Tolerance(1.0));
            assert_eq!(found, 2, "arcs of {half} each way, {count} points from {begin}");
        }
    }
}

/// The points of an open curve, with steps of all lengths: a click of a mouse is where a hand puts it.
fn clicks(at: impl Fn(f64) -> Point, count: usize, seed: u64) -> Vec<Point> {
    let mut random = Random::new(seed);
    let last = (count - 1) as f64;
    let mut place = |i: usize| {
        let inside = i > 0 && i + 1 < count;
        at((i as f64 + if inside { 0.35 * random.symmetric() } else { 0.0 }) / last)
    };
    (0..count).map(&mut place).collect()
}

#[test]
fn a_dozen_clicks_along_an_open_curve_are_followed() {
    // Bends and steps of all lengths were taken for noise: a spiral of ten points was 42 astray, two waves became a
    // line.
    let spiral = |share: f64| {
        let (angle, radius) = (3.2 * PI * share, 20.0 + 100.0 * share);
        Point::new(radius * libm::cos(angle), radius * libm::sin(angle))
    };
    let waves = |share: f64| Point::new(240.0 * share, 40.0 * libm::sin(4.0 * PI * share + 0.7));
    let zigzag = |share: f64| {
        let corners = [[0.0, 160.0], [20.0, 0.0], [80.0, 120.0], [140.0, 0.0], [160.0, 160.0]];
        let side = ((4.0 * share) as usize).min(3);
        let [from, to] = [side, side + 1].map(|corner| Point::new(corners[corner][0], corners[corner][1]));
        from + (to - from) * (4.0 * share - side as f64)
    };
    let drawings: [&dyn Fn(f64) -> Point; 3] = [&spiral, &waves, &zigzag];
    for (number, drawing) in drawings.iter().enumerate() {
        for count in [9, 10, 11] {
            for seed in 0..6 {
                let points = clicks(drawing, count, seed);
                let options = Options { closed: Some(false), ..Options::default() };
                let found = fit(&points, Ask::Noise, &options).expect("it can be fitted");
                // What is told as noise is 3 % of some 240 at most, and a point is off by four times that at most.
                assert!(
                    found.max_error < 29.0,
                    "drawing {number}, {count} points, seed {seed}: {}",
                    found.max_error
                );
            }
        }
    }
}
