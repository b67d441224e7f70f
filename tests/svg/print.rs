//! Curves become path data that draws them: within the tolerance, measured honestly.

#![allow(
    clippy::panic,
    clippy::print_stdout,
    reason = "tests stop with what they found and print the worst seen"
)]

use crate::support;
use crate::support::curves::Random;
use crate::support::drawing::{self, drawing};
use crate::support::printing::{Point, distance, extent, options, print, random_curve, read, within};
use crate::support::unboxed;
use expline::curve::HermiteOptions;
use expline::svg::{PrintOptions, parse_path, to_path_d};
use expline::{Error, HermiteCurve, Space};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn any_curve_is_drawn_within_its_deviation_and_that_within_the_tolerance() {
    let mut random = Random::new(5);
    let (mut worst_share, mut tightest) = (0.0_f64, 0.0_f64);
    for round in 0..40 {
        let curve = random_curve(&mut random);
        let extent = extent(&curve);
        let tolerance = extent * [1e-1, 1e-2, 1e-3, 1e-4][round % 4];
        for (arcs, relative) in [(true, false), (true, true), (false, false)] {
            let options = PrintOptions { tolerance, decimals: None, arcs, relative };
            let printed = print(&curve, &options);
            assert!(printed.deviation <= tolerance, "round {round}: {} > {tolerance}", printed.deviation);
            let measured = distance(&curve, &printed.d);
            assert!(
                measured <= within(&printed, extent),
                "round {round}: {measured} > {} in {}",
                printed.deviation,
                printed.d
            );
            worst_share = worst_share.max(printed.deviation / tolerance);
            tightest = tightest.max(measured / printed.deviation);
        }
    }
    println!(
        "deviation up to {worst_share:.3} of the tolerance; measured up to {tightest:.3} of the deviation"
    );
}

#[test]
fn degenerate_and_extreme_curves_keep_to_the_tolerance_and_can_be_read_again() {
    let mut random = Random::new(14);
    for case in 0..400 {
        let curve = support::curves::random_curve(&mut random, case);
        let tolerance = extent(&curve) * [1e-2, 1e-5][case % 2];
        for (arcs, decimals) in [(true, None), (false, None), (true, Some(17))] {
            if tolerance == 0.0 {
                continue;
            }
            let printed = print(&curve, &PrintOptions { tolerance, decimals, arcs, relative: true });
            assert!(printed.deviation <= tolerance, "case {case}: {} > {tolerance}", printed.deviation);
            let back = parse_path(&printed.d).unwrap_or_else(|error| panic!("case {case}: {error}"));
            assert_eq!((back.truncation, back.subpaths), (None, 1), "case {case}: {}", printed.d);
        }
    }
}

#[test]
fn few_decimals_give_an_honest_larger_deviation() {
    let mut random = Random::new(6);
    for round in 0..12 {
        let curve = random_curve(&mut random);
        for decimals in 0..6 {
            for relative in [false, true] {
                let unit = 10.0_f64.powi(-(decimals as i32));
                let options =
                    PrintOptions { tolerance: 1e-3, decimals: Some(decimals), arcs: true, relative };
                let printed = print(&curve, &options);
                if drawing(&printed.d).is_empty() {
                    // The curve is smaller than the last decimal.
                    assert!(extent(&curve) <= unit, "{printed:?}");
                    continue;
                }
                let truth = distance(&curve, &printed.d);
                assert!(
                    truth <= within(&printed, extent(&curve)),
                    "round {round}, {decimals}: {truth} > {}",
                    printed.deviation
                );
                assert!(
                    printed.deviation <= 1e-3 + 4.0 * unit,
                    "round {round}, {decimals}: {}",
                    printed.deviation
                );
            }
        }
    }
}

#[test]
fn rounding_does_not_add_up_along_the_path() {
    let d = (0..3000).fold(String::from("M0 0"), |d, _| d + "l.33333 .33333");
    let printed = print(&read(&d), &PrintOptions { decimals: Some(2), relative: true, ..options() });
    let (pieces, _) = drawing(&printed.d).remove(0);
    let end = pieces.last().map(|piece| piece.at(1.0)).expect("it has pieces");
    assert!((end - Point::repeat(999.99)).norm() <= 0.0071, "ends at {end}");
    assert!(printed.deviation <= 0.0072, "{}", printed.deviation);
}

#[test]
fn options_out_of_range_are_refused() {
    let line = read("M0 0L1 1");
    let with = |tolerance, decimals| {
        unboxed(to_path_d(&line, &PrintOptions { tolerance, decimals, ..options() })).err()
    };
    assert!(
        matches!(with(0.0, None), Some(Error::OutOfRange { argument: "tolerance", .. })),
        "zero is no tolerance"
    );
    assert!(
        matches!(with(-1.0, None), Some(Error::OutOfRange { argument: "tolerance", .. })),
        "a negative tolerance"
    );
    assert!(
        matches!(with(f64::NAN, None), Some(Error::NotFinite { argument: "tolerance", .. })),
        "NaN is no tolerance"
    );
    assert!(
        matches!(with(f64::INFINITY, None), Some(Error::NotFinite { argument: "tolerance", .. })),
        "infinity is no tolerance"
    );
    assert!(
        matches!(with(1.0, Some(18)), Some(Error::OutOfRange { argument: "decimals", .. })),
        "18 decimals"
    );
    let many = with(1.0, Some(400));
    let refused = matches!(many, Some(Error::OutOfRange { argument: "decimals", value: 400.0, .. }));
    assert!(refused, "400 decimals");
    assert_eq!(with(1e-300, None), None, "the least tolerance is raised");
}

#[test]
fn extreme_sizes_are_drawn_to_their_size() {
    for size in [1e-12, 1e-6, 1e6, 1e8] {
        let circle =
            HermiteCurve::ellipse(Point::zeros(), Point::new(size, 0.7 * size), 0.3, 3).expect("valid");
        for decimals in [None, Some(17)] {
            let printed = print(&circle, &PrintOptions { tolerance: 1e-4 * size, decimals, ..options() });
            assert!(printed.deviation <= 1e-4 * size, "{size}: {printed:?}");
            assert!(read(&printed.d).is_closed(), "{size}: {printed:?}");
        }
        let coarse = print(&circle, &PrintOptions { decimals: Some(0), ..options() });
        assert!(coarse.deviation <= size.mul_add(2.0, 3.0), "{coarse:?}");
    }
}

#[test]
fn a_small_drawing_far_from_the_origin_is_as_near_as_was_asked() {
    let far = Point::new(2e6, -1e6);
    let options = PrintOptions { tolerance: 1e-6, arcs: false, ..options() };
    for omega in [0.5, 1.7, 3.0] {
        let curve = HermiteCurve::new(HermiteOptions {
            points: [(0.0, 0.0), (1.0, 0.5), (0.3, 2.0)].map(|(x, y)| far + Point::new(x, y)).to_vec(),
            tangents: vec![Point::new(2.0, 0.5), Point::new(0.5, 2.0), Point::new(-2.0, 0.0)],
            tangents_in: Vec::new(),
            closed: true,
            space: Some(Space::Trigonometric),
            omega: vec![omega; 3],
            lengths: Vec::new(),
        })
        .expect("a valid curve");
        let printed = print(&curve, &options);
        assert!(printed.deviation <= options.tolerance, "omega {omega}: {}", printed.deviation);
        // Places out there are told apart to 2e-10, and a point and its image are some of these off.
        let measured = distance(&curve, &printed.d);
        assert!(
            measured <= options.tolerance * (1.0 + drawing::PRECISION) + 1e-9,
            "omega {omega}: {measured}"
        );
    }
}

#[test]
fn the_deviation_is_tight_enough_to_be_shown() {
    let circle =
        HermiteCurve::ellipse(Point::new(39.53, 77.7), Point::new(61.7, 61.7), 0.0, 3).expect("valid");
    for (curve, tolerance, decimals) in [(&circle, 0.02, 1), (&circle, 0.02, 3)] {
        let printed = print(curve, &PrintOptions { tolerance, decimals: Some(decimals), ..options() });
        let measured = distance(curve, &printed.d);
        println!("{:.3e} reported, {measured:.3e} measured: {}", printed.deviation, printed.d);
        assert!(measured >= 0.8 * printed.deviation, "{measured} of {}", printed.deviation);
    }
}
