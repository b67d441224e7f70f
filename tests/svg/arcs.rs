//! Arcs of circles and ellipses become arcs of path data, and stay within the tolerance.

#![allow(clippy::print_stdout, reason = "tests print the worst seen")]

use core::f64::consts::{PI, TAU};

use crate::support::curves::Random;
use crate::support::drawing::{Piece, drawing};
use crate::support::printing::{Point, distance, extent, options, print, reprinted, within};
use expline::curve::HermiteOptions;
use expline::svg::PrintOptions;
use expline::{HermiteCurve, Space};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn circles_and_ellipses_are_two_arcs() {
    for count in [2, 3, 4, 5, 8, 12] {
        let circle =
            HermiteCurve::ellipse(Point::new(50.0, 60.0), Point::new(40.0, 40.0), 0.0, count).expect("valid");
        let printed = print(&circle, &options());
        assert!(printed.d.chars().all(|c| "MAZ .-0123456789".contains(c)), "{}", printed.d);
        assert_eq!(drawing(&printed.d)[0].0.len(), 3, "two arcs and Z for {count}: {}", printed.d);
        assert!(printed.deviation <= 0.02 && distance(&circle, &printed.d) <= 0.02, "{count}: {printed:?}");
        let ellipse =
            HermiteCurve::ellipse(Point::new(1.0, 2.0), Point::new(30.0, 7.0), 0.4, count).expect("valid");
        let printed = print(&ellipse, &options());
        assert_eq!(drawing(&printed.d)[0].0.len(), 3, "two arcs and Z for {count}: {}", printed.d);
        assert!(printed.deviation <= 0.02 && distance(&ellipse, &printed.d) <= 0.02, "{count}: {printed:?}");
    }
}

#[test]
fn awkward_circles_are_still_arcs() {
    let mut random = Random::new(8);
    let mut worst = 0.0_f64;
    for _ in 0..300 {
        let radii = Point::new(3.0 + 40.0 * random.symmetric().abs(), 3.0 + 40.0 * random.symmetric().abs());
        let radii = if random.below(2) == 0 { Point::repeat(radii.x) } else { radii };
        let curve =
            HermiteCurve::ellipse(random.vector(100.0), radii, 3.0 * random.symmetric(), 2 + random.below(5))
                .expect("valid");
        for (decimals, tolerance) in
            [(None, 0.02), (None, 1e-5), (Some(1), 0.02), (Some(4), 0.02), (Some(17), 0.02)]
        {
            let printed = print(&curve, &PrintOptions { tolerance, decimals, ..options() });
            let (pieces, _) = &drawing(&printed.d)[0];
            assert!(
                pieces.len() <= 5 && !pieces.iter().any(|p| matches!(p, Piece::Cubic(_))),
                "{}",
                printed.d
            );
            let unit = decimals.map_or(0.0, |decimals| 10.0_f64.powi(-(decimals as i32)));
            assert!(printed.deviation <= tolerance.max(3.0 * unit), "{}: {}", printed.deviation, printed.d);
            if decimals == Some(4) {
                worst = worst.max(printed.deviation);
            }
        }
    }
    println!("ellipses with 4 decimals: worst deviation {worst:.1e}");
}

#[test]
fn arcs_of_every_sweep_are_one_arc_or_two() {
    for k in 1..72 {
        let sweep = TAU * f64::from(k) / 72.0;
        for start in [0.0, 0.3, 2.0] {
            for (radii, rotation) in [(Point::new(20.0, 20.0), 0.0), (Point::new(31.0, 12.0), 0.7)] {
                let curve =
                    HermiteCurve::arc(Point::new(7.1, 3.3), radii, rotation, start, sweep).expect("valid");
                let printed = print(&curve, &PrintOptions { tolerance: 1e-3, ..options() });
                let (pieces, _) = &drawing(&printed.d)[0];
                assert!(pieces.iter().all(|piece| matches!(piece, Piece::Arc(..))), "{}", printed.d);
                let most = if sweep < 0.97 * PI || (sweep > 1.03 * PI && sweep < 5.6) { 1 } else { 2 };
                assert!(pieces.len() <= most, "{sweep}: {}", printed.d);
                assert!(printed.deviation <= 1e-3, "{sweep}: {printed:?}");
                let measured = distance(&curve, &printed.d);
                assert!(measured <= within(&printed, 60.0), "{sweep}: {measured} > {}", printed.deviation);
            }
        }
    }
}

#[test]
fn a_segment_of_nearly_a_full_turn_is_drawn_within_the_tolerance() {
    let (center, radii, start) = (Point::new(7.1, 3.3), Point::new(300.0, 200.0), 0.4_f64);
    for sweep in [4.6, 6.0, TAU - 3e-3, TAU - 2e-4, TAU - 8e-5, TAU - 1e-5, TAU - 2e-6] {
        let at = |angle: f64| center + Point::new(radii.x * angle.cos(), radii.y * angle.sin());
        let tangent = |angle: f64| Point::new(-radii.x * angle.sin(), radii.y * angle.cos()) * sweep;
        let curve = HermiteCurve::new(HermiteOptions {
            points: vec![at(start), at(start + sweep)],
            tangents: vec![tangent(start), tangent(start + sweep)],
            closed: false,
            omega: vec![sweep],
            ..HermiteOptions::default()
        })
        .expect("valid");
        for wanted in [1e-3, 0.1, 2.0] {
            let printed = print(&curve, &PrintOptions { tolerance: wanted, ..options() });
            assert!(printed.deviation <= wanted, "{sweep}, {wanted}: {printed:?}");
            let measured = distance(&curve, &printed.d);
            // So near the pole the last bits of the points move the curve by more than they say.
            assert!(measured <= wanted, "{sweep}, {wanted}: {measured}, {printed:?}");
        }
    }
}

/// The ellipse through three points that are nearly on a line: its tips turn within a few units of a coarse grid.
#[test]
fn flat_ellipses_are_drawn_within_the_tolerance() {
    let mut random = Random::new(31);
    let mut arcs = 0;
    for round in 0..400 {
        let (along, flat) = (random.vector(100.0), 10.0_f64.powi(-(round % 4)));
        let across = Point::new(-along.y, along.x) * flat;
        let points = (0..3).map(|_| random.vector(1.0)).map(|p| along * p.x + across * p.y).collect();
        let curve = HermiteCurve::through(points, true, None, Space::Trigonometric).expect("valid");
        let extent = extent(&curve);
        for share in [3e-2, 1e-2, 1e-3, 1e-5] {
            let wanted = share * extent;
            let printed = print(&curve, &PrintOptions { tolerance: wanted, ..options() });
            assert!(printed.deviation <= wanted, "{round}, {share}: {printed:?} > {wanted}");
            // Measuring takes most of the time.
            if round % 16 < 4 {
                let measured = distance(&curve, &printed.d);
                assert!(measured <= within(&printed, extent), "{round}, {share}: {measured}, {printed:?}");
            }
            arcs += usize::from(printed.d.contains('A'));
        }
    }
    assert!(arcs > 800, "{arcs} of 1600 are arcs");
}

/// A round corner keeps its radius wherever the grid puts its ends.
#[test]
fn arcs_keep_their_own_radii_on_a_coarse_grid() {
    let mut random = Random::new(7);
    let coarse = PrintOptions { decimals: Some(2), ..options() };
    for _ in 0..50 {
        let (center, angle) = (random.vector(100.0), PI * random.symmetric());
        let at = |angle: f64| center + Point::new(angle.cos(), angle.sin()) * 20.0;
        let (start, end) = (at(angle), at(angle + 0.4 * PI));
        let d = format!("M{} {}L{} {}A20 20 0 0 1 {} {}", center.x, center.y, start.x, start.y, end.x, end.y);
        let text = reprinted(&d, &coarse);
        assert!(text.contains("A20 20 0 0 1"), "{text}");
    }
}

#[test]
fn arcs_of_a_few_units_of_the_last_digit_are_drawn_no_farther_off_than_is_said() {
    let mut random = Random::new(46);
    let (mut arcs, mut worst) = (0, 0.0_f64);
    for case in 0..1000 {
        // In units of the last of three digits: long, thin, round, and smaller than one.
        let long = 0.001 * 10.0_f64.powf(2.0 * random.symmetric().abs());
        let radii = Point::new(long, long * 10.0_f64.powf(-2.0 * random.symmetric().abs()));
        let sweep = PI * random.symmetric();
        let (center, rotation, start) =
            (random.vector(0.01), PI * random.symmetric(), PI * random.symmetric());
        let Ok(curve) = HermiteCurve::arc(center, radii, rotation, start, sweep) else { continue };
        let printed = print(&curve, &PrintOptions { decimals: Some(3), ..options() });
        if drawing(&printed.d).first().is_none_or(|(pieces, _)| pieces.is_empty()) {
            continue;
        }
        arcs += usize::from(printed.d.contains('A'));
        let truth = distance(&curve, &printed.d);
        worst = worst.max(truth - printed.deviation);
        assert!(
            truth <= within(&printed, extent(&curve)),
            "case {case}: {truth} > {} in {}, of {radii}",
            printed.deviation,
            printed.d
        );
    }
    println!("{arcs} arcs, at most {worst:.1e} farther off than was said");
}
