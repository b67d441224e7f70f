//! Curves as people draw them, on whole numbers and with equal handles: what turns does so exactly in the middle of a
//! piece, where derivatives are 0 to the last bit. Random curves never get there.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::tolerance::NEAREST;
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use expline::numerics::{Point, Vector};
use expline::{Curve, HermiteCurve, HermiteOptions, Space};

const SAMPLES: usize = 4000;

/// From a point to its tangent.
type Handle = fn(Point) -> Vector;

/// Two points, a square on its corner and one on its side, with handles along, across and against the way round.
fn symmetric_curves() -> Vec<HermiteCurve> {
    let corners: [&[(f64, f64)]; 3] = [
        &[(10.0, 0.0), (-10.0, 0.0)],
        &[(10.0, 0.0), (0.0, 10.0), (-10.0, 0.0), (0.0, -10.0)],
        &[(10.0, 10.0), (-10.0, 10.0), (-10.0, -10.0), (10.0, -10.0)],
    ];
    let handles: [Handle; 5] = [
        |p| Vector::new(-p.y, p.x),
        |p| Vector::new(3.0 * p.y, -3.0 * p.x),
        |p| -p,
        |_| Vector::new(30.0, 0.0),
        |_| Vector::zeros(),
    ];
    let spaces = [
        (Space::Polynomial, 0.0),
        (Space::Trigonometric, FRAC_PI_2),
        (Space::Trigonometric, 3.0),
        (Space::Hyperbolic, 0.5),
        (Space::Hyperbolic, 3.0),
    ];
    let mut curves = Vec::new();
    for (corners, handle) in
        corners.iter().flat_map(|corners| handles.iter().map(move |handle| (corners, handle)))
    {
        let points: Vec<Point> = corners.iter().map(|&(x, y)| Point::new(x, y)).collect();
        for ((space, omega), closed) in spaces.iter().flat_map(|&space| [(space, true), (space, false)]) {
            let tangents = points.iter().map(|&p| handle(p)).collect();
            let omega = vec![omega; points.len() - usize::from(!closed)];
            let options = HermiteOptions {
                points: points.clone(),
                tangents,
                closed,
                space: Some(space),
                omega,
                ..Default::default()
            };
            curves.push(HermiteCurve::new(options).expect("a curve"));
        }
    }
    for (count, turn) in (2..8).flat_map(|count| [0.0, FRAC_PI_4, FRAC_PI_2].map(|turn| (count, turn))) {
        let radii = Vector::new(5.0, 2.0);
        curves.push(HermiteCurve::ellipse(Point::zeros(), radii, turn, count).expect("an ellipse"));
    }
    curves
}

fn dense(curve: &HermiteCurve) -> Vec<Point> {
    let (_, end) = curve.domain();
    (0..=SAMPLES)
        .map(|i| curve.evaluate((end * i as f64 / SAMPLES as f64).min(end), 0).expect("inside"))
        .collect()
}

#[test]
fn a_box_holds_every_sample_and_no_more_than_the_samples_reach() {
    for (i, curve) in symmetric_curves().iter().enumerate() {
        let (found, samples) = (curve.bounds(), dense(curve));
        let reach = |of: fn(&Point) -> f64| samples.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
        for (got, sampled) in [
            (found.max_x, reach(|p| p.x)),
            (found.max_y, reach(|p| p.y)),
            (-found.min_x, reach(|p| -p.x)),
            (-found.min_y, reach(|p| -p.y)),
        ] {
            // Samples miss an extreme by less than |p″| h²/8, and |p″| is below 700 here.
            assert!(got >= sampled - 1e-13 && got < sampled + 1e-4, "curve {i}: {got}, sampled {sampled}");
        }
    }
}

#[test]
fn nothing_is_nearer_than_the_nearest_point_to_places_of_symmetry() {
    let places = [(0.0, 0.0), (10.0, 0.0), (0.0, -10.0), (5.0, 5.0), (0.0, 20.0), (-20.0, -20.0)];
    for (i, curve) in symmetric_curves().iter().enumerate() {
        let samples = dense(curve);
        for place in places.map(|(x, y)| Point::new(x, y)) {
            let found = curve.nearest(place);
            let least = samples.iter().map(|p| (p - place).norm()).fold(f64::INFINITY, f64::min);
            assert!(
                found.distance <= least + NEAREST * 10.0,
                "curve {i}, {place}: {} and {least}",
                found.distance
            );
            let there = (curve.evaluate(found.t, 0).expect("inside") - place).norm();
            assert!(
                (there - found.distance).abs() <= NEAREST * 10.0,
                "curve {i}, {place}: {there} at its parameter"
            );
        }
    }
}

#[test]
fn lengths_and_areas_are_those_of_dense_polygons() {
    for (i, curve) in symmetric_curves().iter().enumerate() {
        let samples = dense(curve);
        let chords = samples.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum::<f64>();
        let length = curve.length(1e-9).expect("a length");
        // Each chord around a sharp turn loses about its own length, 0.03 at most, and others a millionth.
        assert!((length - chords).abs() < 1e-3, "curve {i}: {length} and {chords}");
        if curve.is_closed() {
            let doubled: f64 =
                samples.windows(2).map(|pair| pair[0].x * pair[1].y - pair[0].y * pair[1].x).sum();
            let area = curve.area().expect("closed");
            // Chords cut off |p″| h²/12 of their length each: 3e-3 of curves of length 100.
            assert!((area - 0.5 * doubled).abs() < 3e-3, "curve {i}: {area} and {}", 0.5 * doubled);
        }
    }
}
