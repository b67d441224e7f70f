//! Path data is read exactly, and what cannot be read is said with its place.

#![allow(
    clippy::panic,
    clippy::print_stdout,
    reason = "tests stop with what they found and print the worst seen"
)]

use core::f64::consts::PI;

use crate::support::curves::Random;
use crate::support::drawing::{self, Piece, drawing};
use crate::support::{tolerance, unboxed};
use expline::svg::{ParsedPath, Truncation, parse_path};
use expline::{Error, HermiteCurve};
use nalgebra::Vector2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

type Point = Vector2<f64>;

fn read(d: &str) -> ParsedPath {
    let parsed = parse_path(d).unwrap_or_else(|error| panic!("{d:?}: {error}"));
    assert_eq!(parsed.truncation, None, "{d:?} makes sense to its end");
    parsed
}

fn curves(d: &str) -> Vec<HermiteCurve> {
    read(d).curves
}

fn only(d: &str) -> HermiteCurve {
    let mut curves = curves(d);
    assert_eq!(curves.len(), 1, "{d:?} is one curve");
    curves.remove(0)
}

fn at(curve: &HermiteCurve, t: f64) -> Point {
    curve.evaluate(t, 0).expect("t lies in the domain")
}

/// All that makes the curves, bit for bit, as text to compare.
fn bits(d: &str) -> String {
    let mut text = String::new();
    for curve in curves(d) {
        let numbers = |vectors: &[Point]| {
            vectors.iter().flat_map(|p| [p.x.to_bits(), p.y.to_bits()]).collect::<Vec<_>>()
        };
        let omega: Vec<u64> = curve.omega().iter().map(|w| w.to_bits()).collect();
        text += &format!(
            "{} {:?} {:?} {:?} {omega:?}\n",
            curve.is_closed(),
            numbers(curve.points()),
            numbers(curve.tangents()),
            numbers(curve.tangents_in())
        );
    }
    text
}

#[test]
fn every_spelling_of_the_same_path_gives_the_same_bits() {
    for (left, right) in [
        ("M0 0L10 0L10 20", "m0,0 l10,0 0,20"),
        ("M0 0L10 0L10 20", "M0 0 10 0 10 20"),
        ("M0 0L10 0L10 20", "m0 0 10 0 0 20"),
        ("M0 0L10 0L10 20", "M 0 0 H 10 V 20"),
        ("M0 0L10 0L10 20", "m0 0h10v20"),
        ("M0 0L10 0L10 20", " \t\r\n\x0cM\n0\t,\r0 \x0cL 10 , 0 , 10 , 20 "),
        ("M1 2H3 5 7V4 6", "M1 2L3 2L5 2L7 2L7 4L7 6"),
        ("M.5.5.5-.5", "M 0.5 0.5 L 0.5 -0.5"),
        ("M1e1 1E+1 2e-1-1e0", "M10 10L.2-1"),
        ("M+1+2+3+4", "M1 2L3 4"),
        ("M2e2.0 3 4", "M200 0L3 4"),
        ("M5. 5.L6.,7.", "M5 5L6 7"),
        ("M0 0C1 1 2 1 3 0 4-1 5-1 6 0", "M0 0C1 1 2 1 3 0C4-1 5-1 6 0"),
        ("M1 1c1 1 2 1 3 0", "M1 1C2 2 3 2 4 1"),
        ("M0 0C1 1 2 1 3 0S5-1 6 0", "M0 0C1 1 2 1 3 0C4-1 5-1 6 0"),
        ("M0 0C1 1 2 1 3 0s2-1 3 0", "M0 0C1 1 2 1 3 0C4-1 5-1 6 0"),
        ("M0 0S5-1 6 0", "M0 0C0 0 5-1 6 0"),
        ("M0 0L1 0S5-1 6 0", "M0 0L1 0C1 0 5-1 6 0"),
        ("M0 0Q3 3 6 0", "M0 0C2 2 4 2 6 0"),
        ("M0 0Q3 3 6 0T12 0", "M0 0Q3 3 6 0Q9-3 12 0"),
        ("M0 0q3 3 6 0t6 0t6 0", "M0 0Q3 3 6 0Q9-3 12 0Q15 3 18 0"),
        ("M0 0T6 0", "M0 0Q0 0 6 0"),
        ("M0 0C1 1 2 1 3 0T6 0", "M0 0C1 1 2 1 3 0Q3 0 6 0"),
        ("M0 0Q3 3 6 0S9 1 9 0", "M0 0Q3 3 6 0C6 0 9 1 9 0"),
        ("M200,120h-25a25,25 0 1125,25z", "M200,120h-25a25,25 0 1 1 25,25z"),
        ("M0 0a1 1 0 01.5.5", "M0 0a1 1 0 0 1 .5 .5"),
        ("M0 0a1 1 0 00-1-1 1 1 0 00-1-1", "M0 0a1,1,0,0,0,-1,-1a1,1,0,0,0,-1,-1"),
        ("M0 0A5 5 77 0 1 9 9", "M0 0A-5-5 0 0 1 9 9"),
        ("M0 0A5 0 77 0 1 9 9", "M0 0L9 9"),
        ("M1 1A5 5 0 1 1 1 1L2 2", "M1 1L2 2"),
        ("M0 0L1 0L1 1Z", "M0 0h1v1z"),
        ("M0 0L1 0L1 1L0 0Z", "M0 0h1v1z"),
        ("M3 4L5 4ZL9 9", "M3 4L5 4ZM3 4L9 9"),
        ("M3 4l2 0zm1 1l1 0", "M3 4L5 4ZM4 5L5 5"),
        ("M3 4l2 0z l0 1 z m1 1 l1 0", "M3 4L5 4ZM3 4L3 5ZM4 5L5 5"),
        ("M0 0L0 0L1 0L1 0L2 0", "M0 0L1 0L2 0"),
        ("M9 9M0 0L1 0M5 5", "M0 0L1 0"),
        ("M1,5 2,5 3,5", "M1 5L2 5L3 5"),
    ] {
        assert_eq!(bits(left), bits(right), "{left:?} and {right:?}");
    }
}

#[test]
fn empty_paths_and_lone_movetos_are_no_curves() {
    for (d, subpaths) in [
        ("", 0),
        (" \n", 0),
        ("M1 1", 1),
        ("M1 1Z", 1),
        ("M1 1ZZ", 1),
        ("M0 0m1 1m1 1z", 3),
        ("M1 1L1 1Z", 1),
        ("M1 1h0v0h0", 1),
    ] {
        let parsed = read(d);
        assert_eq!((parsed.subpaths, parsed.curves.len()), (subpaths, 0), "{d:?}");
    }
}

#[test]
fn lines_run_straight_at_constant_speed() {
    let curve = only("M1 2L5 10H-3V4");
    assert_eq!(curve.segment_count(), 3, "three lines, three segments");
    for i in 0..3 {
        let (from, to) = (curve.points()[i], curve.points()[i + 1]);
        for k in 0..=16 {
            let x = f64::from(k) / 16.0;
            let expected = from + (to - from) * x;
            assert!(
                (at(&curve, i as f64 + x) - expected).norm() <= tolerance::SMALL_DRAWING,
                "segment {i} at {x}"
            );
        }
    }
}

#[test]
fn cubics_and_quadratics_follow_their_bernstein_form() {
    let p = [Point::new(1.0, 2.0), Point::new(-3.0, 7.5), Point::new(11.0, 0.25), Point::new(4.0, -6.0)];
    let cubic = only("M1 2C-3 7.5 11 .25 4-6");
    let quadratic = only("M1 2Q-3 7.5 11 .25");
    for k in 0..=32 {
        let x = f64::from(k) / 32.0;
        let z = 1.0 - x;
        let expected =
            p[0] * (z * z * z) + p[1] * (3.0 * x * z * z) + p[2] * (3.0 * x * x * z) + p[3] * (x * x * x);
        assert!((at(&cubic, x) - expected).norm() <= tolerance::SMALL_DRAWING, "cubic at {x}");
        let expected = p[0] * (z * z) + p[1] * (2.0 * x * z) + p[2] * (x * x);
        assert!((at(&quadratic, x) - expected).norm() <= tolerance::SMALL_DRAWING, "quadratic at {x}");
    }
}

#[test]
fn unequal_handles_make_corners_and_reflected_ones_do_not() {
    let corner = only("M0 0C1 1 2 1 3 0C4 5 5-1 6 0");
    assert_ne!(corner.tangents()[1], corner.tangents_in()[1], "a corner stays one");
    let smooth = only("M.1.3C1.7 1.1 2.2 1.9 3.3.7S5.1-1.3 6.7 0");
    assert_eq!(smooth.tangents()[1], smooth.tangents_in()[1], "a smooth join stays one");
}

#[test]
fn a_closed_subpath_ends_where_it_starts() {
    let triangle = only("M0 0L1 0L1 1Z");
    assert!(triangle.is_closed(), "Z closes");
    assert_eq!(triangle.points().len(), 3, "the way back to the start is no further point");
    let merged = only("M.1.1l.1 0l.1.2l-.2-.2z");
    assert_eq!(merged.points().len(), 3, "a gap of one rounding is no closing line");
    assert!(!only("M0 0L1 0L1 1L0 0").is_closed(), "without Z the curve is open");
    let two = only("M0 0L1 1Z");
    assert_eq!((two.points().len(), two.segment_count()), (2, 2), "a closed curve of two points");
}

#[test]
fn a_command_of_no_extent_before_the_end_of_a_closed_subpath_changes_nothing() {
    let drawn = ["C10 10 0 10 0 0", "Q5 9 0 0", "C10 10 0 0 0 0", "L5 5L0 0", "A5 7 0 0 1 0 0", "L5 9T0 0"];
    for last in drawn {
        let plain = bits(&format!("M0 0L10 0{last}Z"));
        for nothing in
            ["L0 0", "h0", "v0", "l0 0", "c0 0 0 0 0 0", "q0 0 0 0", "a5 5 0 0 1 0 0", "a0 0 0 0 1 0 0"]
        {
            let same = bits(&format!("M0 0L10 0{last}{nothing}Z"));
            assert_eq!(same, plain, "{last}, then {nothing}");
        }
    }
    assert_eq!(bits("M0 0C6 3 0 9 0 0L0 0Z"), bits("M0 0C6 3 0 9 0 0Z"), "a loop of one segment");
}

#[test]
fn a_loop_of_one_segment_is_halved_where_it_was() {
    let curve = only("M0 0C6 3 0 9 0 0Z");
    assert_eq!((curve.points().len(), curve.is_closed()), (2, true), "two points, closed");
    for k in 0..=20 {
        let x = f64::from(k) / 20.0;
        let z = 1.0 - x;
        let expected = Point::new(6.0, 3.0) * (3.0 * x * z * z) + Point::new(0.0, 9.0) * (3.0 * x * x * z);
        assert!((at(&curve, 2.0 * x) - expected).norm() <= tolerance::SMALL_DRAWING, "at {x}");
    }
}

#[test]
fn arcs_follow_the_centre_parametrisation_of_the_specification() {
    let mut worst = 0.0_f64;
    for radii in [[5.0, 5.0], [6.0, 4.0], [20.0, 3.0], [300.0, 250.0], [1.0, 2.0]].map(Point::from) {
        for degrees in [0.0, 30.0, 90.0, -117.0, 405.0] {
            for end in [Point::new(4.0, 3.0), Point::new(-2.0, 0.5), Point::new(0.01, -0.02)] {
                for flags in 0..4 {
                    let (large, positive) = (flags & 1 == 1, flags & 2 == 2);
                    let (from, to) = (Point::new(0.5, 0.25), Point::new(0.5, 0.25) + end);
                    let flags = format!("{}{}", u8::from(large), u8::from(positive));
                    let d = format!("M.5.25A{} {} {degrees} {flags}{} {}", radii.x, radii.y, to.x, to.y);
                    let Some(truth @ Piece::Arc(_, grown, _, _, sweep)) =
                        drawing::arc(from, to, radii, degrees, large, positive)
                    else {
                        panic!("{d} is an arc");
                    };
                    let curve = only(&d);
                    assert_eq!(curve.segment_count(), if sweep.abs() > PI + 1e-6 { 2 } else { 1 }, "{d}");
                    for k in 0..=24 {
                        let x = f64::from(k) / 24.0;
                        let error = (at(&curve, x * curve.domain().1) - truth.at(x)).norm() / grown.amax();
                        worst = worst.max(error);
                        assert!(error <= tolerance::ARC, "{d} at {x}: {error:e}");
                    }
                }
            }
        }
    }
    println!("arcs: worst distance to the centre parametrisation {worst:.1e} of the radius");
}

#[test]
fn a_circle_that_arcs_close_is_round_where_it_closes() {
    for d in ["M10 5A5 5 0 0 1 0 5A5 5 0 0 1 10 5Z", "M10 5a5 5 0 0 1-10 0a5 5 0 0 1 10 0z"] {
        let curve = only(d);
        assert!(curve.is_closed() && curve.segment_count() == 2, "{d}");
        for k in 0..=64 {
            let radius = (at(&curve, f64::from(k) / 32.0) - Point::new(5.0, 5.0)).norm();
            assert!((radius - 5.0).abs() <= tolerance::SMALL_DRAWING, "{d}: {radius} after {k} of 64");
        }
    }
}

#[test]
fn random_paths_are_drawn_as_a_plain_reader_draws_them() {
    let mut random = Random::new(12);
    let mut worst = 0.0_f64;
    for round in 0..600 {
        let d = random_path(&mut random);
        let parsed = read(&d);
        let mut drawn = drawing(&d);
        drawn
            .retain(|(pieces, _)| pieces.iter().any(|piece| !matches!(piece, Piece::Line([a, b]) if a == b)));
        assert_eq!(parsed.curves.len(), drawn.len(), "round {round}: {d}");
        for (curve, (pieces, closed)) in parsed.curves.iter().zip(&drawn) {
            assert_eq!(curve.is_closed(), *closed, "round {round}: {d}");
            // An arc bulges beyond its ends by up to two radii: its places are rounded by that size.
            let radius =
                |piece: &Piece| if let Piece::Arc(_, radii, ..) = piece { radii.amax() } else { 0.0 };
            let places = curve.points().iter().map(|p| p.amax());
            let extent = places.chain(pieces.iter().map(radius)).fold(1.0, f64::max);
            let mut segments = curve.segments();
            let closing = tolerance::DRAWN * extent;
            let drawn = |piece: &&Piece| match **piece {
                Piece::Line([a, b]) => (a - b).norm() > closing,
                Piece::Quadratic([a, b, c]) => a != b || b != c,
                Piece::Cubic([a, b, c, d]) => a != b || b != c || c != d,
                Piece::Arc(..) => true,
            };
            for piece in pieces.iter().filter(drawn) {
                let turns = matches!(piece, Piece::Arc(.., sweep) if sweep.abs() > PI + 1e-6);
                let parts = if turns { 2 } else { 1 };
                for part in 0..parts {
                    let segment =
                        segments.next().unwrap_or_else(|| panic!("round {round}: {d} has too few segments"));
                    for k in 0..=8 {
                        let x = f64::from(k) / 8.0;
                        let truth = piece.at((f64::from(part) + x) / f64::from(parts));
                        let error = (segment.position(x) - truth).norm() / extent;
                        worst = worst.max(error);
                        assert!(
                            error <= tolerance::DRAWN,
                            "round {round}: {d}: {error:e} at {x} of {piece:?}"
                        );
                    }
                }
            }
            assert!(segments.next().is_none(), "round {round}: {d} has too many segments");
        }
    }
    println!("random paths: worst distance to the plain reader {worst:.1e} of the size");
}

/// Valid path data with every command, spelled in many ways.
fn random_path(random: &mut Random) -> String {
    let mut d = String::new();
    let size = 10.0_f64.powi(random.below(5) as i32 - 1);
    for k in 0..3 + random.below(20) {
        let letter = if k == 0 { 'M' } else { char::from(b"MLHVCSQTAZLCQA"[random.below(14)]) };
        let count = match letter {
            'Z' => 0,
            'H' | 'V' => 1,
            'M' | 'L' | 'T' => 2,
            'S' | 'Q' => 4,
            'C' => 6,
            _ => 7,
        };
        d.push(if random.below(2) == 0 { letter } else { letter.to_ascii_lowercase() });
        for group in 0..if count == 0 { 0 } else { 1 + random.below(2) } {
            for i in 0..count {
                let digits = random.below(5);
                let value = size * random.symmetric();
                let text = match (letter, i) {
                    ('A', 0 | 1) => format!("{:.2}", value.abs() + 0.01),
                    ('A', 2) => format!("{:.1}", 360.0 * random.symmetric()),
                    ('A', 3 | 4) => random.below(2).to_string(),
                    _ if random.below(4) == 0 => format!("{value:.digits$e}"),
                    _ => format!("{value:.digits$}"),
                };
                let text = if random.below(2) == 0 {
                    text.replacen(
                        "0.",
                        ".",
                        usize::from(text.starts_with(['0', '-']) && !text.contains("00.")),
                    )
                } else {
                    text
                };
                let packed = letter == 'A' && (i == 4 || i == 5) && random.below(2) == 0;
                let first = i == 0 && group == 0;
                let separator = [" ", ",", " , ", "\n"][random.below(4)];
                let bare = text.starts_with('-') && random.below(2) == 0;
                d += if first || packed || bare { "" } else { separator };
                d += &text;
            }
        }
    }
    d
}

#[test]
fn half_turns_are_exact_half_turns_in_spite_of_rounding() {
    for d in [
        "M.3.1A1.1 1.1 0 0 1 2.5.1",
        "M.3.1a1.1 1.1 0 0 1 2.2 0",
        "M.1.7A.7.7 0 1 0 .1-.7",
        "M7.3 2.9a1.9 1.9 0 1 0-3.8 0",
    ] {
        let curve = only(d);
        assert_eq!(curve.omega(), [PI], "{d}");
    }
}

#[test]
fn radii_that_are_too_small_grow_until_they_reach() {
    let curve = only("M0 0A1 2 0 0 1 6 0");
    for k in 0..=20 {
        let p = at(&curve, f64::from(k) / 20.0);
        let residual = ((p.x - 3.0) / 3.0).powi(2) + (p.y / 6.0).powi(2) - 1.0;
        assert!(residual.abs() <= tolerance::ARC, "{residual:e}");
    }
}

#[test]
fn an_arc_whose_chord_counts_as_0_is_nothing() {
    for chord in ["1e-300 0", "1e-170 1e-170", "0 -1e-60", "0 0"] {
        assert_eq!(bits(&format!("M0 0A5 5 0 0 1 {chord}L3 3")), bits("M0 0L3 3"), "{chord}");
        assert_eq!(bits(&format!("M0 0a5 5 0 1 0 {chord}L3 3")), bits("M0 0L3 3"), "{chord}");
    }
}

#[test]
fn a_segment_between_points_that_count_as_one_is_left_out() {
    // What is smaller than 1e-50 counts as 0.
    let line = only("M-88 1V3e-113V2e-195v-1e-60H5");
    assert_eq!(line.points(), only("M-88 1V0H5").points());
    assert!(curves("M0 0V1e-60L2e-70 3e-80").is_empty(), "nothing is drawn");
}

#[test]
fn flat_arcs_of_huge_circles_keep_their_digits() {
    let curve = only("M0 0A1e8 1e8 0 0 1 10 10");
    assert!(curve.segment_count() <= 64, "an arc of a hundred million takes few segments");
    // The sagitta of a chord of 10√2 on a radius of 1e8: chord²/(8·radius).
    let sagitta = 200.0 / 8e8;
    let middle = at(&curve, 0.5);
    let offset = Point::new(5.0, 5.0) - middle;
    let height = offset.norm() - sagitta;
    assert!(height.abs() <= tolerance::SMALL_DRAWING, "off by {height:e}");
}

fn truncated(d: &str) -> (ParsedPath, Truncation) {
    let parsed = parse_path(d).unwrap_or_else(|error| panic!("{d:?}: {error}"));
    let truncation = parsed.truncation.unwrap_or_else(|| panic!("{d:?} stops early"));
    (parsed, truncation)
}

#[test]
fn text_that_makes_no_sense_ends_the_path_and_keeps_what_came_before() {
    // (text, subpaths, segments, unused from, senseless at, expected)
    for (d, subpaths, segments, offset, found, expected) in [
        ("M0 0L1 1 L2 foo", 1, 1, 10, 12, "a number"),
        ("M2e2.0 3", 1, 0, 7, 8, "a number"),
        ("M0 0\0L1 1", 1, 0, 4, 4, "a command"),
        ("M0 0L1 0Z 5 5", 1, 2, 10, 10, "a command"),
        ("M10 10 L foo", 1, 0, 9, 9, "a number"),
        ("M0 0L1 1,", 1, 1, 9, 9, "a number"),
        ("M0 0L1 1,Z", 1, 1, 9, 9, "a number"),
        ("M0 0,,1 1", 1, 0, 5, 5, "a number"),
        ("M0 0L,1 1", 1, 0, 5, 5, "a number"),
        ("M0 0L1 1 2", 1, 1, 9, 10, "a number"),
        ("M0 0a1 1 0 2 0 1 1", 1, 0, 5, 11, "a flag (0 or 1)"),
        ("M0 0L1 1X", 1, 1, 8, 8, "a command"),
        ("M0 0L1 1\u{a0}L2 2", 1, 1, 8, 8, "a command"),
        ("M0 0L1e 1", 1, 0, 5, 6, "a number"),
        ("M0 0L1 1h", 1, 1, 9, 9, "a number"),
        ("M0 0L1 1 L--2 2", 1, 1, 10, 10, "a number"),
        ("M0 0L1 1M2", 1, 1, 9, 10, "a number"),
    ] {
        let (parsed, truncation) = truncated(d);
        let count: usize = parsed.curves.iter().map(HermiteCurve::segment_count).sum();
        assert_eq!((parsed.subpaths, count), (subpaths, segments), "{d:?}");
        let Truncation { offset: at, found: what, expected: instead, .. } = truncation;
        assert_eq!((at, what, instead), (offset, found, expected), "{d:?}");
    }
}

#[test]
fn text_of_which_nothing_makes_sense_is_an_error_with_its_place() {
    for (d, offset, expected) in [
        ("L1 1", 0, "a moveto (M or m)"),
        ("MNaN NaNaNaN NaN NaN 1 0 NaN NaNZ", 1, "a number"),
        ("none", 0, "a moveto (M or m)"),
        ("  10 10", 2, "a moveto (M or m)"),
        ("M", 1, "a number"),
        ("M1", 2, "a number"),
        ("M,1 1", 1, "a number"),
        ("\u{feff}M0 0", 0, "a moveto (M or m)"),
    ] {
        assert_eq!(unboxed(parse_path(d)).err(), Some(Error::PathSyntax { offset, expected }), "{d:?}");
    }
}

#[test]
fn numbers_beyond_the_range_are_refused_by_name_and_place() {
    for (d, place) in [
        ("M1e999 0L1 1", 1),
        ("M1e308 0l1e308 0l1e308 0", 1),
        ("M0 0A1e300 1e300 0 0 1 10 10", 5),
        ("M1e999 0L1 1Z", 1),
        ("M0 0L1 1L2000000000 0", 9),
        ("M9e8 0l9e8 0", 7),
        ("M0 0A1e-300 1 0 0 1 10 10", 5),
        ("M0 0A8e-301 90 0 1 0 3 -5", 5),
    ] {
        match unboxed(parse_path(d)) {
            Err(Error::OutOfRange { argument: "d", index: Some(index), value, most: 1e9, .. }) => {
                assert_eq!(index, place, "{d:?}");
                assert!(value.abs() > 1e9, "{d:?}: {value} is named");
            }
            other => panic!("{d:?} gives {other:?}"),
        }
    }
    // All of their control points are in the range.
    for d in ["M9e8 0Q-9e8 0 0 0", "M0 0C1e9 0 0 0 0 0", "M-1e9 0L1e9 0"] {
        assert_eq!(unboxed(parse_path(d)).map(|path| path.curves.len()), Ok(1), "{d:?}");
    }
}

#[test]
fn limits_are_checked_before_the_work() {
    let limit = |d: &str| match unboxed(parse_path(d)) {
        Err(Error::LimitExceeded { argument: "d", limit, .. }) => limit,
        other => panic!("{:?} …", other.map(|parsed| parsed.subpaths)),
    };
    assert_eq!(limit(&format!("M0 0{}", "L1 1".repeat(10_000_000))), "maxPathBytes", "forty megabytes");
    assert_eq!(limit(&"M1 1".repeat(1_000_000)), "maxSubpaths", "a million subpaths");
    assert_eq!(
        limit(&format!("M0 0h{}", "1 2 ".repeat(1_100_000))),
        "maxPoints",
        "two million points and more"
    );
}

#[test]
fn a_million_segments_are_one_curve() {
    let curve = only(&format!("M0 0{}", "L1 2L3 5".repeat(500_000)));
    assert_eq!(curve.segment_count(), 1_000_000, "a million lines");
}

#[test]
fn no_text_makes_a_number_that_is_not_finite() {
    // Every text of three tokens out of these, which are the ones that parsers trip over.
    let tokens = [
        "M",
        "L",
        "a",
        "Z",
        "1",
        "-.5",
        "1e9",
        "1e-320",
        "0",
        ",",
        "01",
        "e5",
        "s",
        "t0 0",
        "q1 1 2 2",
        "A1 1 0 0 1",
        "\0",
    ];
    for a in tokens {
        for b in tokens {
            for c in tokens {
                for d in
                    [format!("M0 0 {a}{b}{c}"), format!("M0 0 {a} {b} {c} 5 5"), format!("{a}{b} {c} 1 1 z")]
                {
                    let Ok(parsed) = parse_path(&d) else { continue };
                    for curve in &parsed.curves {
                        let (start, end) = curve.domain();
                        for t in [start, 0.3 * end, 0.5 * end, end] {
                            let p = at(curve, t);
                            assert!(p.x.is_finite() && p.y.is_finite(), "{d:?} at {t}");
                        }
                    }
                }
            }
        }
    }
}
