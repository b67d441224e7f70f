//! Outlines that have their sides by their ends only, as flattened paths and polygons do, are followed along the sides; few points are led
//! through.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

mod support;

use core::f64::consts::PI;
use expline::fit::{Ask, Fit, Fitter, Options, fit};
use expline::numerics::Point;
use support::curves::Random;

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
        // Where sides are followed by points an eighth of them apart, 1.3 to 15, a curve is free by about as much between these.
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
