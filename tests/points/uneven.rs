//! Fits of noisy points that lie anywhere along their curve: what spacing does by chance is no shape.
#![cfg(not(target_arch = "wasm32"))]

use core::f64::consts::TAU;

use crate::support::curves::Random;
use expline::fit::{Ask, Fit, Options, fit};
use expline::numerics::Point;

const CASES: u64 = 12;
/// The standard deviation of the noise, a hundredth of the circle's radius.
const SIGMA: f64 = 1.0;

/// `count` noisy points of a closed way, at places that are drawn anywhere along it, one after the other.
fn anywhere(place: impl Fn(f64) -> Point, count: usize, seed: u64) -> Vec<Point> {
    let mut random = Random::new(seed);
    let mut shares: Vec<f64> = (0..count).map(|_| random.unit()).collect();
    shares.sort_by(f64::total_cmp);
    let truth: Vec<Point> = shares.into_iter().map(place).collect();
    random.noisy(&truth, SIGMA)
}

fn circle(share: f64) -> Point {
    let (sin, cos) = libm::sincos(TAU * share);
    Point::new(100.0 * cos, 100.0 * sin)
}

/// The corners of a star with five tips, whose sides are all equally long.
fn tips() -> [Point; 10] {
    core::array::from_fn(|j| {
        let (sin, cos) = libm::sincos(TAU * j as f64 / 10.0);
        Point::new(cos, sin) * if j.is_multiple_of(2) { 120.0 } else { 50.0 }
    })
}

fn star(share: f64) -> Point {
    let (corners, at) = (tips(), 10.0 * share);
    let side = at as usize % 10;
    corners[side] + (corners[(side + 1) % 10] - corners[side]) * at.fract()
}

fn fitted(points: &[Point]) -> Fit {
    let options = Options { closed: Some(true), ..Options::default() };
    fit(points, Ask::Noise, &options).expect("it can be fitted")
}

#[test]
fn a_noisy_circle_is_a_few_cubics_wherever_its_points_lie() {
    for count in [200, 500, 1000] {
        let (mut knots, mut corners, mut square) = (0.0, 0.0, 0.0);
        for seed in 0..CASES {
            let fitted = fitted(&anywhere(circle, count, seed));
            let end = fitted.curve.domain().1;
            let off = |i: usize| {
                let place = fitted.curve.evaluate(end * i as f64 / 500.0, 0).expect("t is in the domain");
                (place.norm() - 100.0) / SIGMA
            };
            knots += fitted.knots.len() as f64 / CASES as f64;
            corners += fitted.knots.iter().filter(|knot| knot.degree == 1).count() as f64 / CASES as f64;
            square += (0..500).map(|i| off(i) * off(i)).sum::<f64>() / (500.0 * CASES as f64);
        }
        assert!(knots <= 8.0, "{knots} knots for {count} points");
        assert!(corners <= 1.5, "{corners} corners for {count} points");
        // Eight knots are 24 numbers, and each takes a point's share of the noise; a fourth more for where knots are
        // not best.
        assert!(square.sqrt() <= 1.25 * (24.0 / count as f64).sqrt(), "rms {} for {count}", square.sqrt());
    }
}

#[test]
fn a_noisy_star_keeps_its_corners_wherever_its_points_lie() {
    for count in [500, 1000] {
        let (mut knots, mut off) = (0.0, 0.0);
        for seed in 0..CASES {
            let fitted = fitted(&anywhere(star, count, seed));
            knots += fitted.knots.len() as f64 / CASES as f64;
            for tip in tips() {
                let sharp = fitted.knots.iter().filter(|knot| knot.degree == 1);
                let nearest = sharp.map(|knot| (knot.point - tip).norm()).fold(20.0, f64::min);
                off += nearest / (10 * CASES) as f64;
            }
        }
        assert!(knots <= 11.0, "{knots} knots for {count} points");
        // A side of 50 points is known to a fourth of σ at its ends, and they meet at 38° at the tips.
        assert!(off <= SIGMA, "corners are off by {off}");
    }
}
