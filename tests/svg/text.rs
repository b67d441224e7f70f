//! Path data has few characters, and comes back as it was.

#![allow(clippy::print_stdout, reason = "tests print the worst seen")]

use core::f64::consts::PI;

use crate::support::curves::Random;
use crate::support::drawing::{Piece, drawing};
use crate::support::printing::{
    Point, distance, extent, options, print, random_curve, read, reprinted, within,
};
use expline::HermiteCurve;
use expline::curve::HermiteOptions;
use expline::svg::{PrintOptions, parse_path};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[test]
fn numbers_are_plain_and_short() {
    let mut random = Random::new(7);
    for _ in 0..200 {
        let curve = random_curve(&mut random);
        for decimals in [None, Some(0), Some(3), Some(9), Some(16), Some(17)] {
            let d = print(&curve, &PrintOptions { decimals, relative: random.below(2) == 0, ..options() }).d;
            assert!(d.bytes().all(|b| b.is_ascii_digit() || b"MLHVCSQAZlhvcsqa -.e".contains(&b)), "{d}");
            let digits = |b: Option<&u8>| b.is_some_and(|b| b.is_ascii_digit() || *b == b'.');
            for (i, b) in d.bytes().enumerate().filter(|&(_, b)| b == b'0') {
                let (before, after) = (d.as_bytes().get(i.wrapping_sub(1)), d.as_bytes().get(i + 1));
                let leads = b == b'0' && !digits(before) && digits(after);
                assert!(!leads && before != Some(&b'-'), "a needless zero at {i} of {d}");
            }
            assert!(!d.contains("e+") && !d.contains("  "), "{d}");
            // Curves smaller than the last decimal are points.
            assert!(parse_path(&d).is_ok_and(|parsed| parsed.truncation.is_none()), "{d}");
        }
    }
}

/// The angles between each cubic's last handle and the next one's first, in degrees.
fn kinks(d: &str) -> Vec<f64> {
    let (pieces, _) = drawing(d).remove(0);
    let handles: Vec<[Point; 2]> = pieces
        .iter()
        .filter_map(|piece| match piece {
            Piece::Cubic([a, b, c, d]) => Some([b - a, d - c]),
            // What closes the path where its numbers add up to a rounding error.
            _ => None,
        })
        .collect();
    let kink = |k: usize| {
        let (before, after) = (handles[k][1], handles[(k + 1) % handles.len()][0]);
        before.perp(&after).atan2(before.dot(&after)).abs().to_degrees()
    };
    (0..handles.len()).map(kink).collect()
}

/// Handles of a tenth of a pixel are ten units of the usual grid, which alone would turn them by up to four degrees
/// each.
#[test]
fn the_grid_turns_no_smooth_joint_by_three_degrees() {
    let mut random = Random::new(23);
    let options = PrintOptions { decimals: Some(2), relative: true, ..options() };
    let (mut worst, mut all): (f64, Vec<f64>) = (0.0, Vec::new());
    for round in 0..100 {
        let angles = (0..6).map(|_| PI * random.symmetric()).collect::<Vec<_>>();
        let mut ways = |least: f64| -> Vec<Point> {
            let handle = |angle: &f64| {
                let length = 3.0 * (least + 0.5 * random.symmetric().abs());
                Point::new(angle.cos(), angle.sin()) * length
            };
            angles.iter().map(handle).collect()
        };
        let (tangents, tangents_in) = (ways(0.1), ways(0.1));
        let curve = HermiteCurve::new(HermiteOptions {
            points: (0..6).map(|_| random.vector(100.0)).collect(),
            tangents,
            tangents_in,
            closed: true,
            space: None,
            omega: vec![0.0; 6],
            lengths: Vec::new(),
        })
        .expect("a valid curve");
        let printed = print(&curve, &options);
        assert!(printed.deviation <= options.tolerance, "round {round}: {}", printed.deviation);
        if round < 5 {
            assert!(distance(&curve, &printed.d) <= within(&printed, extent(&curve)), "round {round}");
        }
        for kink in kinks(&printed.d) {
            assert!(kink < 3.0, "round {round}: {kink} degrees in {}", printed.d);
            worst = worst.max(kink);
            all.push(kink);
        }
    }
    all.sort_by(f64::total_cmp);
    println!(
        "kinks by two decimals: 95 of 100 below {:.2}, all below {worst:.2} degrees",
        all[all.len() * 95 / 100]
    );
}

#[test]
fn what_was_read_is_written_back_as_it_was() {
    for d in [
        "M10 10H90V50A20 20 0 0 1 70 70H40Q10 70 10 40Z",
        "M0 0 10 5 3 8Z",
        "M0 0C1 5 4 5 5 0S9-5 10 0",
        "M0 0Q3 3 6 0",
        "M1 1A5 3 20 1 0 4 4",
        "M.5.25-.5-.25",
    ] {
        assert_eq!(reprinted(d, &options()), d, "the text comes back as it was");
    }
}

#[test]
fn seventeen_decimals_bring_every_bit_back() {
    let exact = PrintOptions { decimals: Some(17), ..options() };
    let mut random = Random::new(9);
    let mut number = |size: f64| random.symmetric() * size;
    for round in 0..300 {
        let size = 10.0_f64.powi(round % 9 - 4);
        let mut d = format!("M{} {}", number(size), number(size));
        for k in 0..6 {
            let mut list =
                |count: usize| (0..count).map(|_| format!(" {}", number(size))).collect::<String>();
            d += &match (round + k) % 6 {
                0 => format!("L{}", list(2)),
                1 => format!("c{}", list(6)),
                2 => format!("S{}", list(4)),
                3 => format!("q{}", list(4)),
                4 => format!("t{}", list(2)),
                _ => format!("C{}", list(6)),
            };
        }
        d += if round % 2 == 0 { "" } else { "Z" };
        let curve = read(&d);
        let printed = print(&curve, &exact);
        let again = read(&printed.d);
        assert_eq!(curve.points(), again.points(), "points of {d}");
        assert_eq!(curve.tangents(), again.tangents(), "tangents of {d}\n{}", printed.d);
        assert_eq!(curve.tangents_in(), again.tangents_in(), "arriving tangents of {d}\n{}", printed.d);
        assert_eq!(print(&again, &exact).d, printed.d, "the second print is the first");
        assert!(printed.deviation <= 1e-15 * size * 10.0, "{}", printed.deviation);
    }
}

#[test]
fn what_was_printed_with_all_digits_is_read_and_printed_for_ever_after() {
    let mut random = Random::new(10);
    for _ in 0..300 {
        let exact = PrintOptions { decimals: Some(17), arcs: false, ..options() };
        let once = read(&print(&random_curve(&mut random), &exact).d);
        let again = read(&print(&once, &exact).d);
        assert_eq!(once.points(), again.points(), "points to the last bit");
        assert_eq!(once.tangents(), again.tangents(), "tangents to the last bit");
        assert_eq!(once.tangents_in(), again.tangents_in(), "arriving tangents to the last bit");
    }
}

#[test]
fn relative_commands_are_used_where_they_are_shorter() {
    let d = "M100 100L101 102L103 101L104 104";
    let relative = reprinted(d, &PrintOptions { relative: true, ..options() });
    assert_eq!(relative, "M100 100l1 2 2-1 1 3", "commands relative to the point before");
    let mut random = Random::new(11);
    for _ in 0..100 {
        let curve = random_curve(&mut random);
        let absolute = print(&curve, &options());
        let relative = print(&curve, &PrintOptions { relative: true, ..options() });
        assert!(relative.d.len() <= absolute.d.len(), "{} and {}", relative.d, absolute.d);
        assert!(
            (relative.deviation - absolute.deviation).abs() <= 1e-12 * (1.0 + absolute.deviation),
            "the same error either way"
        );
    }
}

#[test]
fn mirrored_handles_are_written_once() {
    let wave = (1..40).fold(String::from("M0 0C3 4 7 4 10 0"), |d, k| {
        d + &format!("S{} {} {} 0", 10 * k + 7, if k % 2 == 0 { 4 } else { -4 }, 10 * k + 10)
    });
    let printed = reprinted(&wave, &options());
    assert_eq!(printed.matches('C').count(), 1, "one cubic");
    assert_eq!(printed.matches('S').count(), 1, "and the letter once for all: {printed}");
}

#[test]
fn lines_too_short_to_be_written_do_not_change_what_is_mirrored() {
    let curve = read("M0 0C0 5 5 10 10 10L10.0001 10C10 10 20 10 20 0");
    let printed = print(&curve, &PrintOptions { decimals: Some(2), ..options() });
    let measured = distance(&curve, &printed.d);
    assert!(measured <= within(&printed, 20.0), "{measured}: {printed:?}");
}
