//! Polylines of curves of every kind: as near as was asked and as was said, with hardly more points than are needed.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::{Random, random_curve};
use core::f64::consts::PI;
use expline::numerics::{Point, Vector};
use expline::{Curve, HermiteCurve, HermiteOptions, Space};

/// The ends of the chords of a curve's polyline.
fn ends(curve: &HermiteCurve, polyline: &[f64]) -> Vec<Point> {
    let mut ends: Vec<Point> = polyline.chunks_exact(2).map(|p| Point::new(p[0], p[1])).collect();
    if curve.is_closed() {
        ends.push(ends[0]);
    }
    ends
}

/// The largest distance of many points of a curve, three for each chord or more, from its polyline.
fn farthest(curve: &HermiteCurve, polyline: &[f64]) -> f64 {
    let ends = ends(curve, polyline);
    let count = 4000.max(3 * ends.len());
    let (_, end) = curve.domain();
    let mut worst = 0.0_f64;
    for k in 0..=count {
        let place = curve.evaluate(end * (k as f64 / count as f64), 0).expect("inside");
        let mut least = f64::INFINITY;
        for pair in ends.windows(2) {
            let chord = pair[1] - pair[0];
            let share = (place - pair[0]).dot(&chord) / chord.norm_squared().max(1e-300);
            least = least.min((place - pair[0] - chord * share.clamp(0.0, 1.0)).norm_squared());
        }
        worst = worst.max(least);
    }
    worst.sqrt()
}

/// The largest distance of places on the chords from the curve; of many chords some.
fn astray(curve: &HermiteCurve, polyline: &[f64]) -> f64 {
    let ends = ends(curve, polyline);
    let step = ends.len().div_ceil(60);
    let mut worst = 0.0_f64;
    for pair in ends.windows(2).step_by(step) {
        for share in [0.25, 0.5, 0.75] {
            worst = worst.max(curve.nearest(pair[0] + (pair[1] - pair[0]) * share).distance);
        }
    }
    worst
}

/// Roundings of places and distances, as a share of the curve's size.
const ROUNDING: f64 = 1e-13;

#[test]
fn polylines_of_all_kinds_of_curves_are_as_near_as_they_are_said_to_be() {
    let mut random = Random::new(54);
    for case in 0..84 {
        let curve = random_curve(&mut random, case);
        let size = curve.bounds().extent();
        if size <= 1e-12 {
            continue;
        }
        for share in [0.7, 0.1, 1e-2, 1e-3, 1e-4, 1e-6] {
            let tolerance = share * size;
            let (polyline, deviation) = curve.flatten(tolerance).expect("a polyline");
            let what = format!("case {case}, {share}: {} points", polyline.len() / 2);
            assert!(deviation <= tolerance, "{what}: {deviation} for {tolerance}");
            let off = farthest(&curve, &polyline);
            assert!(off <= deviation + ROUNDING * size, "{what}: {off}, said to be {deviation}");
            let off = astray(&curve, &polyline);
            assert!(off <= deviation + ROUNDING * size, "{what}: chords are {off} off, not {deviation}");
        }
    }
}

#[test]
fn polylines_of_circles_have_hardly_more_points_than_are_needed() {
    for count in [2, 3, 4, 8] {
        let circle = HermiteCurve::ellipse(Point::new(3.0, -2.0), Vector::new(160.0, 160.0), 0.2, count)
            .expect("a circle");
        for tolerance in [8.0, 1.0, 0.1, 1e-2, 1e-3, 1e-5, 1e-6] {
            let (polyline, deviation) = circle.flatten(tolerance).expect("a polyline");
            // A chord's sagitta is r(1 − cos ½θ).
            let fewest = PI / libm::acos(1.0 - tolerance / 160.0);
            let points = (polyline.len() / 2) as f64;
            // Every part ends at a point, and wants one more at most; of two points a circle is four parts or more.
            let most = 1.05 * fewest + 2.0 * count.max(4) as f64;
            assert!(points <= most, "{count} points, {tolerance}: {points}, {fewest} would do");
            for place in polyline.chunks_exact(2) {
                let radius = (Point::new(place[0], place[1]) - Point::new(3.0, -2.0)).norm();
                assert!((radius - 160.0).abs() < 1e-12 * 160.0, "{place:?} is on the circle");
            }
            let ends = ends(&circle, &polyline);
            let widest = ends.windows(2).map(|pair| (pair[1] - pair[0]).norm()).fold(0.0, f64::max);
            let sagitta = 160.0 - (160.0_f64 * 160.0 - 0.25 * widest * widest).sqrt();
            assert!(sagitta <= deviation && deviation <= tolerance, "{tolerance}: {sagitta}, {deviation}");
            assert!(deviation <= 1.1 * sagitta + 1e-12, "{tolerance}: {deviation} is said of {sagitta}");
        }
    }
}

#[test]
fn nearly_straight_curves_are_as_near_to_their_polylines_as_was_asked() {
    for turn in 0..24 {
        let (sin, cos) = (0.26 * f64::from(turn) + 0.1).sin_cos();
        for bump in [1e-7, 1e-6, 1e-5, 1e-3] {
            let turned = |x: f64, y: f64| Vector::new(cos * x - sin * y, sin * x + cos * y);
            let curve = HermiteCurve::new(HermiteOptions {
                points: vec![turned(0.0, 0.0), turned(1.0, 0.0)],
                tangents: vec![turned(1.1, 4.0 * bump), turned(0.9, -3.0 * bump)],
                space: Some(Space::Polynomial),
                ..HermiteOptions::default()
            })
            .expect("a curve");
            for tolerance in [2e-9, 1e-7, 1e-4] {
                let (polyline, deviation) = curve.flatten(tolerance).expect("a polyline");
                let off = farthest(&curve, &polyline);
                assert!(off <= tolerance + 1e-15, "turn {turn}, bump {bump}: {off} for {tolerance}");
                assert!(off <= deviation + 1e-15, "turn {turn}, bump {bump}: {off}, said to be {deviation}");
                let fewest = (6.0 * bump / (8.0 * tolerance)).sqrt();
                let count = (polyline.len() / 2) as f64;
                assert!(
                    count <= 1.2 * fewest + 3.0,
                    "turn {turn}, bump {bump}: {count} points, {fewest} wanted"
                );
            }
        }
    }
}

#[test]
fn polylines_have_hardly_more_points_than_chords_of_equal_error_would() {
    let mut random = Random::new(5);
    for case in 0..60 {
        let curve = random_curve(&mut random, case);
        let size = curve.bounds().extent();
        if size <= 1e-9 {
            continue;
        }
        // A chord of a short arc is off by κ·ds²/8: the root of that, summed.
        let (tolerance, steps) = (1e-7 * size, 4000 * curve.segment_count());
        let step = curve.domain().1 / steps as f64;
        let chords = |k: usize| {
            let t = step * (k as f64 + 0.5);
            let at = |order| curve.evaluate(t, order).expect("inside");
            let (first, second) = (at(1), at(2));
            let turn = (first.x * second.y - first.y * second.x).abs();
            step * (turn / (8.0 * tolerance * first.norm().max(1e-300))).sqrt()
        };
        let fewest: f64 = (0..steps).map(chords).sum();
        let (polyline, deviation) = curve.flatten(tolerance).expect("a polyline");
        assert!(deviation <= tolerance, "case {case}: {deviation}");
        let count = (polyline.len() / 2) as f64;
        // And some where the curve turns round, of which straight ones may consist.
        let segments = curve.segment_count() as f64;
        if fewest < 50.0 * segments {
            continue;
        }
        let most = 1.12 * fewest + 24.0 * segments;
        assert!(count <= most, "case {case}: {count} points, {fewest} would do");
    }
}
