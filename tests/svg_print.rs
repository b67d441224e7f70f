//! Curves become path data that draws them: within the tolerance, measured honestly, in few characters.

#![allow(
    clippy::panic,
    clippy::print_stdout,
    reason = "tests stop with what they found and print the worst seen"
)]

mod support;

use core::f64::consts::{PI, TAU};

use expline::curve::HermiteOptions;
use expline::svg::{PrintOptions, Printed, parse_path, to_path_d};
use expline::{Curve, Error, HermiteCurve, Space};
use nalgebra::Vector2;
use support::curves::Random;
use support::drawing::{self, Piece, Stretch, drawing};
use support::{tolerance, unboxed};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

type Point = Vector2<f64>;

fn options() -> PrintOptions {
    PrintOptions::default()
}

fn print(curve: &HermiteCurve, options: &PrintOptions) -> Printed {
    to_path_d(curve, options).expect("the options are valid")
}

fn read(d: &str) -> HermiteCurve {
    let mut parsed = parse_path(d).unwrap_or_else(|error| panic!("{d:?}: {error}"));
    assert_eq!((parsed.truncation, parsed.curves.len()), (None, 1), "{d:?} is one curve");
    parsed.curves.remove(0)
}

fn reprinted(d: &str, options: &PrintOptions) -> String {
    print(&read(d), options).d
}

/// The distance between the curve and what a viewer draws, both ways.
fn distance(curve: &HermiteCurve, d: &str) -> f64 {
    let segments: Vec<_> = curve.segments().collect();
    let truth: Vec<Stretch<'_>> =
        segments.iter().map(|segment| Box::new(|x| segment.position(x)) as Stretch<'_>).collect();
    drawing::distance(&truth, &drawing::stretches(&drawing(d)[0].0), tolerance::DRAWN * extent(curve))
}

fn random_curve(random: &mut Random) -> HermiteCurve {
    let space = [Space::Trigonometric, Space::Hyperbolic, Space::Polynomial][random.below(3)];
    let count = 2 + random.below(6);
    let closed = random.below(2) == 0;
    let size = 10.0_f64.powi(random.below(7) as i32 - 3);
    let offset = random.vector(size * 3.0);
    let segments = if closed { count } else { count - 1 };
    let vectors =
        |random: &mut Random, size: f64| (0..count).map(|_| random.vector(size)).collect::<Vec<_>>();
    let points = vectors(random, size).into_iter().map(|p| p + offset).collect();
    let tangents = vectors(random, 2.0 * size);
    let tangents_in = if random.below(2) == 0 { Vec::new() } else { vectors(random, 2.0 * size) };
    let omega = (0..segments).map(|_| [0.0, 0.5, 1.7, 3.0, 4.5][random.below(5)]).collect();
    let lengths = (0..segments).map(|_| [1.0, 0.5, 1.25][random.below(3)]).collect();
    HermiteCurve::new(HermiteOptions {
        points,
        tangents,
        tangents_in,
        closed,
        space: Some(space),
        omega,
        lengths,
    })
    .expect("a valid curve")
}

fn extent(curve: &HermiteCurve) -> f64 {
    let bounds = curve.bounds();
    (bounds.max_x - bounds.min_x).hypot(bounds.max_y - bounds.min_y)
}

/// What a measured distance may be.
fn within(printed: &Printed, extent: f64) -> f64 {
    printed.deviation * (1.0 + drawing::PRECISION) + 2.0 * tolerance::DRAWN * extent
}

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

/// Handles of a tenth of a pixel are ten units of the usual grid, which alone would turn them by up to four degrees each.
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
            read(&printed.d);
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
