//! The places that a fit gives its points on the curve, and the distances from there.
#![cfg(not(target_arch = "wasm32"))]

use crate::support::curves::Random;
use expline::fit::{Ask, Fit, Options, fit};
use expline::numerics::Point;

/// Points of some kind: a star with corners, a ring, a walk without aim, steps to and fro on a line.
fn points(kind: usize, count: usize, random: &mut Random) -> Vec<Point> {
    let mut walk = Point::zeros();
    (0..count)
        .map(|i| {
            let share = i as f64 / count as f64;
            let (sin, cos) = (core::f64::consts::TAU * share).sin_cos();
            let off = Point::new(random.symmetric(), random.symmetric());
            match kind {
                0 => {
                    let tip = (10.0 * share).fract();
                    Point::new(cos, sin) * (40.0 + 60.0 * (2.0 * tip - 1.0).abs()) + off
                }
                1 => Point::new(100.0 * cos, 70.0 * sin) + off * 5.0,
                2 => {
                    walk += off * 20.0;
                    walk
                }
                _ => Point::new(100.0 * share, 30.0 * share) + off * 10.0,
            }
        })
        .collect()
}

/// How strongly, by kind of strength: much too strongly included.
fn ask(of: usize, summands: usize) -> Ask {
    match of {
        0 => Ask::Noise,
        1 => Ask::Smoothing(0.9),
        2 => Ask::Lambda(vec![3000.0; summands]),
        _ => Ask::Tolerance(8.0),
    }
}

/// The distance from a point at t; a closed curve takes any t, an open one none outside.
fn distance(fit: &Fit, t: f64, point: Point) -> f64 {
    let (first, last) = fit.curve.domain();
    let t = if fit.curve.is_closed() { t } else { t.clamp(first, last) };
    (fit.curve.evaluate(t, 0).expect("t is in the domain") - point).norm()
}

#[test]
fn nowhere_around_its_place_is_the_curve_nearer_to_a_point() {
    let mut random = Random::new(11);
    for case in 0..256 {
        let (kind, closed, strength) = (case % 4, case / 4 % 2 == 0, case / 8 % 4);
        let degrees = [vec![1], vec![2], vec![3], vec![1, 3]][case / 32 % 4].clone();
        let points = points(kind, 30 + 10 * (case % 7), &mut random);
        let what =
            format!("case {case}: kind {kind}, closed {closed}, degrees {degrees:?}, strength {strength}");
        let ask = ask(strength, degrees.len());
        let fitted =
            fit(&points, ask, &Options { degrees, closed: Some(closed), ..Options::default() }).expect(&what);
        let (first, last) = fitted.curve.domain();
        let (mut largest, mut squares) = (0.0_f64, 0.0);
        for (&t, &point) in fitted.parameters.iter().zip(&points) {
            assert!(t >= first && t <= last, "{what}: a place at {t}, beyond {last}");
            let here = distance(&fitted, t, point);
            for step in [-1e-5, 1e-5] {
                let beside = distance(&fitted, t + step * (last - first), point);
                // What is left to win is a millionth of a millionth of the square; curves are known to 1e-13 of their
                // size.
                assert!(beside > here * (1.0 - 1e-9) - 1e-10, "{what}: {beside} beside a place at {here}");
            }
            largest = largest.max(here);
            squares += here * here;
        }
        let rms = (squares / points.len() as f64).sqrt();
        assert!((fitted.max_error - largest).abs() < 1e-9, "{what}: {} for {largest}", fitted.max_error);
        assert!((fitted.rms - rms).abs() < 1e-9, "{what}: a mean of {} for {rms}", fitted.rms);
    }
}

/// Points of a ring at parameters that begin with short steps and go on with long ones.
fn at_uneven_steps(closed: bool, random: &mut Random) -> (Vec<Point>, Options) {
    let mut t = 0.0;
    let (mut ring, mut parameters) = (Vec::new(), Vec::new());
    for i in 0..8 {
        let (sin, cos) = (0.7 * f64::from(i)).sin_cos();
        ring.push(Point::new(100.0 * cos, 100.0 * sin));
        parameters.push(t);
        t += if i < 4 { 1e-4 + 1e-5 * random.symmetric() } else { 1e4 + 1e3 * random.symmetric() };
    }
    let period = closed.then_some(t);
    (ring, Options { closed: Some(closed), parameters, period, ..Options::default() })
}

#[test]
fn places_are_as_near_as_is_said_where_long_steps_of_the_parameter_follow_short_ones() {
    // Handles of 10,000 times the size of the ring are rounded in the last digits of their own.
    const ROUNDING: f64 = 1e-11;
    let mut random = Random::new(5);
    for case in 0..40 {
        let (points, options) = at_uneven_steps(case % 2 == 0, &mut random);
        let fit = fit(&points, Ask::Tolerance(0.0), &options).expect("a fit");
        for (&t, &point) in fit.parameters.iter().zip(&points) {
            let off = distance(&fit, t, point);
            assert!(
                off <= fit.max_error + ROUNDING,
                "case {case}: {off:e} beyond {:e} at {t}",
                fit.max_error
            );
        }
        for knot in &fit.knots {
            let off = distance(&fit, knot.t, knot.point);
            assert!(
                off <= fit.max_error,
                "case {case}: a knot {off:e} beside the curve, {:e}",
                fit.max_error
            );
        }
    }
}
