//! A handful of clicks along an open curve tells corners and bends from one another.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::Random;
use core::f64::consts::PI;
use expline::fit::{Ask, Fit, Options, fit};
use expline::numerics::Point;

/// So many clicks along a curve, which are where a hand puts them: up to a third of a step beside even shares of it.
fn clicks(at: &dyn Fn(f64) -> Point, count: usize, seed: u64) -> Vec<Point> {
    let mut random = Random::new(seed);
    let last = (count - 1) as f64;
    let mut share = |i: usize| {
        let inside = i > 0 && i + 1 < count;
        (i as f64 + if inside { 0.33 * random.symmetric() } else { 0.0 }) / last
    };
    (0..count).map(|i| at(share(i))).collect()
}

/// The place at a share of the way along a polyline.
fn along(vertices: &[Point], share: f64) -> Point {
    let lengths: Vec<f64> = vertices.windows(2).map(|pair| (pair[1] - pair[0]).norm()).collect();
    let mut left = share * lengths.iter().sum::<f64>();
    for (pair, length) in vertices.windows(2).zip(&lengths) {
        if left <= *length {
            return pair[0] + (pair[1] - pair[0]) * (left / length);
        }
        left -= length;
    }
    vertices[vertices.len() - 1]
}

fn polyline(vertices: &[[f64; 2]]) -> Vec<Point> {
    vertices.iter().map(|[x, y]| Point::new(*x, *y)).collect()
}

fn followed(points: &[Point]) -> (Fit, Vec<Point>) {
    let found = fit(points, Ask::Noise, &Options { closed: Some(false), ..Options::default() })
        .expect("they can be fitted");
    let corners = found.knots.iter().filter(|knot| knot.degree == 1).map(|knot| knot.point).collect();
    (found, corners)
}

#[test]
fn clicks_along_a_bend_show_no_corner() {
    let spiral = |share: f64| {
        let (angle, radius) = (3.2 * PI * share, 20.0 + 100.0 * share);
        Point::new(radius * libm::cos(angle), radius * libm::sin(angle))
    };
    let arc = |share: f64| Point::new(100.0 * libm::cos(4.7 * share), 100.0 * libm::sin(4.7 * share));
    let parabola = |share: f64| Point::new(240.0 * share, 160.0 * (2.0 * share - 1.0) * (2.0 * share - 1.0));
    let wave = |share: f64| Point::new(300.0 * share, 60.0 * libm::sin(2.0 * PI * share));
    let bends: [(&str, &dyn Fn(f64) -> Point); 4] =
        [("spiral", &spiral), ("arc", &arc), ("parabola", &parabola), ("wave", &wave)];
    for (name, bend) in bends {
        for count in 9..16 {
            for seed in 0..6 {
                let (_, corners) = followed(&clicks(bend, count, seed));
                assert!(corners.is_empty(), "{name} of {count}, seed {seed}: {corners:?}");
            }
        }
    }
}

#[test]
fn clicks_along_straight_strokes_show_the_corners_between() {
    let strokes: [(&str, Vec<Point>); 3] = [
        ("V", polyline(&[[0.0, 0.0], [80.0, 160.0], [160.0, 0.0]])),
        ("check mark", polyline(&[[0.0, 70.0], [50.0, 130.0], [160.0, 0.0]])),
        ("Z", polyline(&[[0.0, 0.0], [150.0, 0.0], [0.0, 150.0], [150.0, 150.0]])),
    ];
    for (name, vertices) in strokes {
        // Three clicks a stroke: of fewer they may be those of a bend.
        for count in 3 * vertices.len()..16 {
            for seed in 0..6 {
                let points = clicks(&|share| along(&vertices, share), count, seed);
                let (_, corners) = followed(&points);
                let inner = &vertices[1..vertices.len() - 1];
                assert_eq!(corners.len(), inner.len(), "{name} of {count}, seed {seed}: {corners:?}");
                for (corner, vertex) in corners.iter().zip(inner) {
                    // Nobody clicked there: lines through the clicks on both sides meet in it, or the last click before
                    // it is taken for it, which is within a step.
                    let step = points.windows(2).map(|pair| (pair[1] - pair[0]).norm()).fold(0.0, f64::max);
                    let off = (corner - vertex).norm();
                    assert!(off < step, "{name} of {count}, seed {seed}: {off} of a step of {step}");
                }
            }
        }
    }
}

#[test]
fn clicks_at_the_vertices_of_a_zigzag_are_its_corners() {
    // A curve that bends is seen to bend at more than one point: where the way turns left and right at every click,
    // each is a corner.
    for seed in 0..12 {
        let mut random = Random::new(seed);
        let count = 9 + (seed % 4) as usize;
        let points: Vec<Point> = (0..count)
            .map(|i| {
                let (x, y) = (40.0 * i as f64, if i % 2 == 0 { 0.0 } else { 90.0 });
                Point::new(x + 10.0 * random.symmetric(), y + 10.0 * random.symmetric())
            })
            .collect();
        let (found, corners) = followed(&points);
        assert_eq!(corners.len(), count - 2, "seed {seed}");
        // A ten-thousandth of the drawing is worth no knot.
        assert!(found.max_error < 0.1, "seed {seed}: {}", found.max_error);
    }
}

#[test]
fn clicks_in_a_curve_between_corners_are_met_on_both_sides() {
    // Two half circles that meet in a point, whose sides bend: the curve is in one piece, near both.
    let bumps = |share: f64| {
        let angle = 2.0 * PI * share;
        let (center, turned) = if share < 0.5 { (50.0, angle) } else { (150.0, angle - PI) };
        Point::new(center - 50.0 * libm::cos(turned), -50.0 * libm::sin(turned))
    };
    for count in [9, 11, 13, 15] {
        let points: Vec<Point> = (0..count).map(|i| bumps(f64::from(i) / f64::from(count - 1))).collect();
        let (found, corners) = followed(&points);
        assert_eq!(corners.len(), 1, "{count} points: {corners:?}");
        assert!((corners[0] - Point::new(100.0, 0.0)).norm() < 1e-6, "{count} points: {corners:?}");
        let (start, end) = found.curve.domain();
        let place =
            |i: usize| found.curve.evaluate(start + (end - start) * i as f64 / 2000.0, 0).expect("within");
        // The way is 314 long; a two-thousandth of it is .16, at four times the mean speed .64.
        let longest = (1..=2000).map(|i| (place(i) - place(i - 1)).norm()).fold(0.0, f64::max);
        assert!(longest < 0.7, "{count} points: a gap of {longest}");
        let off = |place: Point| {
            let center = Point::new(if place.x < 100.0 { 50.0 } else { 150.0 }, 0.0);
            ((place - center).norm() - 50.0).abs()
        };
        // Half of what two points on an arc, 45° apart, are from the middle of their chord.
        let worst = (0..=2000).map(|i| off(place(i))).fold(0.0, f64::max);
        assert!(worst < 2.0, "{count} points: {worst} from the half circles");
    }
}
