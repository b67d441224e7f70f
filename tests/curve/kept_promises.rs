//! Promises about numbers that were broken once: what a removal moves, places by length, lines far from the origin,
//! areas that cancel, digits that come back.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::Random;
use crate::support::unboxed;
use expline::curve::{LengthTable, NearestFinder};
use expline::svg::{PrintOptions, parse_path, to_path_d};
use expline::{Curve, Error, HermiteCurve, HermiteOptions, Space};
use nalgebra::Vector2;

type Point = Vector2<f64>;

fn pairs(numbers: &[f64]) -> Vec<Point> {
    numbers.chunks_exact(2).map(|pair| Point::new(pair[0], pair[1])).collect()
}

fn curve(space: Space, points: &[f64], tangents: &[f64], closed: bool, omega: &[f64]) -> HermiteCurve {
    let options = HermiteOptions {
        points: pairs(points),
        tangents: pairs(tangents),
        closed,
        space: Some(space),
        omega: omega.to_vec(),
        ..HermiteOptions::default()
    };
    HermiteCurve::new(options).expect("finite")
}

fn path(d: &str) -> HermiteCurve {
    parse_path(d).expect("path data").curves.remove(0)
}

/// The largest distance of points of `from` to the curve `to`, which finds the nearest point itself.
fn directed(from: &HermiteCurve, to: &HermiteCurve) -> f64 {
    let points = from.sample(4001).expect("few enough");
    pairs(&points).into_iter().map(|p| to.nearest(p).distance).fold(0.0, f64::max)
}

#[test]
fn what_a_removal_moves_is_the_distance_of_the_curves_also_where_feet_lie_across_the_point() {
    let mut random = Random::new(1);
    let mut removals = vec![(
        path(
            "M75.9336 70.5226C54.5377 55.6709 56.1189 43.0525 62.0446 43.0955C67.9703 43.1385 78.2405 55.8429 74.2228 91.6366",
        ),
        1,
    )];
    for _ in 0..40 {
        // A cubic cut in two by de Casteljau, written with three decimals.
        let p: Vec<Point> =
            (0..4).map(|_| Point::new(random.symmetric(), random.symmetric()) * 50.0).collect();
        let t = 0.5 + 0.3 * random.symmetric();
        let mix = |a: Point, b: Point| a + (b - a) * t;
        let (a, b, c) = (mix(p[0], p[1]), mix(p[1], p[2]), mix(p[2], p[3]));
        let (d, e) = (mix(a, b), mix(b, c));
        let all = [p[0], a, d, mix(d, e), e, c, p[3]];
        let text: Vec<String> = all.iter().map(|p| format!("{:.3} {:.3}", p.x, p.y)).collect();
        removals.push((path(&format!("M{}C{}", text[0], text[1..].join(" "))), 1));
    }
    let ring = HermiteCurve::ellipse(Point::zeros(), Point::new(100.0, 60.0), 0.0, 8).expect("in range");
    let rounded = PrintOptions { decimals: Some(2), arcs: false, ..PrintOptions::default() };
    removals.push((path(&to_path_d(&ring, &rounded).expect("finite").d), 3));
    for (k, (curve, i)) in removals.iter().enumerate() {
        let (healed, deviation) = curve.remove(*i).expect("enough points");
        let truth = directed(curve, &healed).max(directed(&healed, curve));
        // 97 places a segment miss little of the largest distance; rounding is 1e-13 of the size.
        assert!(
            deviation <= 1.05 * truth + 1e-11 && deviation >= 0.9 * truth - 1e-11,
            "{k}: {deviation} {truth}"
        );
    }
}

#[test]
fn cubics_whose_frequency_means_nothing_are_healed_however_large_it_is() {
    let points = [0.0, 0.0, 1.0, 1.0, 2.0, 0.0];
    let hill = curve(Space::Polynomial, &points, &[1.0, 1.0, 1.0, 0.0, 1.0, -1.0], false, &[6000.0]);
    let (healed, _) = hill.remove(1).expect("enough points");
    assert_eq!(healed.points().len(), 2, "one segment is left");
}

/// Length up to each of many parameters, by chords of the curve itself.
fn lengths(curve: &HermiteCurve, steps: usize) -> Vec<f64> {
    let points = pairs(&curve.sample(steps + 1).expect("few enough"));
    let mut sum = 0.0;
    let mut all = vec![0.0];
    for pair in points.windows(2) {
        sum += (pair[1] - pair[0]).norm();
        all.push(sum);
    }
    all
}

/// How far points evenly spread by length are from where they should be along the curve, at most.
fn misplaced(curve: &HermiteCurve, count: usize, tolerance: f64) -> f64 {
    const STEPS: usize = 40_000;
    let (lengths, points) = (lengths(curve, STEPS), pairs(&curve.sample(STEPS + 1).expect("few enough")));
    let total = lengths[STEPS];
    let places = curve.sample_by_length(count, tolerance).expect("in range");
    let even = places.iter().map(|&t| curve.evaluate(t, 0).expect("inside"));
    let mut worst = 0.0_f64;
    for (i, point) in even.enumerate() {
        let place = total * i as f64 / (count - 1) as f64;
        let k = lengths.partition_point(|&length| length < place).clamp(1, STEPS);
        let share = (place - lengths[k - 1]) / (lengths[k] - lengths[k - 1]).max(f64::MIN_POSITIVE);
        worst = worst.max((points[k - 1] + (points[k] - points[k - 1]) * share - point).norm());
    }
    worst
}

#[test]
fn points_evenly_by_length_are_where_they_should_be_within_the_tolerance() {
    let line = [0.0, 0.0, 1.0, 0.0];
    let cubic = |points: &[f64], tangents: &[f64]| curve(Space::Polynomial, points, tangents, false, &[]);
    let mut cases = vec![
        (cubic(&[30.0, 38.0, 17.0, 41.0], &[87.0, 126.0, 42.0, 69.0]), 17, 1e-3),
        (cubic(&[15.0, 22.0, 12.0, 96.0], &[-90.0, -135.0, -81.0, 3.0]), 17, 1e-2),
        (cubic(&line, &[0.5, 0.0, -2.5, 0.0]), 20, 1e-6),
        (
            curve(
                Space::Trigonometric,
                &[0.0, 0.0, 1.0, 0.1],
                &[1.541_019_975_237_548_7, 4.237_804_931_903_259, 9.246_119_851_425_291, -0.9],
                false,
                &[3.852_549_938_093_871],
            ),
            33,
            1e-5,
        ),
    ];
    let mut random = Random::new(7);
    for _ in 0..200 {
        let mut whole = || (50.0 + 50.0 * random.symmetric()).round();
        let points = [whole(), whole(), whole(), whole()];
        let tangents: Vec<f64> = (0..4).map(|_| 3.0 * (whole() - 50.0)).collect();
        cases.push((cubic(&points, &tangents), 17, 1e-2));
    }
    for (k, (curve, count, tolerance)) in cases.iter().enumerate() {
        // Chords of 40,000 steps are 1e-9 of the length short, more at a cusp.
        let slack = 1e-5 * curve.length(1e-9).expect("in range");
        let off = misplaced(curve, *count, *tolerance);
        assert!(off <= tolerance + 0.1 * slack.min(*tolerance), "{k}: {off} of {tolerance}");
    }
}

#[test]
fn points_evenly_by_length_follow_one_another_however_wide_the_tolerance_is() {
    let mut random = Random::new(9);
    for case in 0..60 {
        let mut eight = || (0..4).map(|_| (100.0 * random.symmetric()).round()).collect::<Vec<f64>>();
        let (points, tangents) = (eight(), eight().iter().map(|v| 3.0 * v).collect::<Vec<f64>>());
        let curve = curve(Space::Polynomial, &points, &tangents, false, &[]);
        let length = curve.length(1e-9).expect("in range");
        for tolerance in [1e-2, 1e-1, 1.0, 10.0].map(|share| share * length) {
            let places = curve.sample_by_length(40, tolerance).expect("in range");
            assert!(places.is_sorted(), "{case}: {places:?} at {tolerance}");
            // Chords of 40,000 steps are far less than a thousandth of the length short.
            assert!(misplaced(&curve, 40, tolerance) <= tolerance + 1e-3 * length, "{case} at {tolerance}");
        }
    }
}

#[test]
fn the_length_of_a_curve_is_a_length_on_it() {
    let mut random = Random::new(3);
    for tolerance in [1e-9, 1e-3, 4.0] {
        for _ in 0..2000 {
            let mut text = String::from("M0 0");
            for _ in 0..1 + (random.symmetric().abs() * 3.9) as usize {
                let six: Vec<String> = (0..6).map(|_| format!("{:.0}", 100.0 * random.symmetric())).collect();
                text += &format!("C{}", six.join(" "));
            }
            let curve = path(&text);
            let length = curve.length(tolerance).expect("in range");
            let t = curve.parameter_at_length(length, tolerance);
            let (_, end) = curve.domain();
            assert!(t.is_ok_and(|t| t <= end), "{text} at {tolerance}");
        }
    }
    let line = path("M0 0H100");
    let beyond = unboxed(line.parameter_at_length(101.0, 0.01));
    assert!(matches!(beyond, Err(Error::OutOfRange { argument: "length", .. })), "{beyond:?}");
}

#[test]
fn an_ellipse_of_very_many_points_is_printed_as_two_arcs() {
    let ring = HermiteCurve::ellipse(Point::zeros(), Point::new(2.0, 1.0), 0.0, 100_000).expect("in range");
    let printed = to_path_d(&ring, &PrintOptions::default()).expect("finite");
    assert_eq!(printed.d, "M2 0A2 1 0 0 1-2 0 2 1 0 0 1 2 0Z");
}

#[test]
fn a_dot_is_printed_with_the_digits_that_its_coordinates_have() {
    let points = [500.0, 200.0, 500.0, 200.0];
    let tangents = [1e-20, -5e-20, -1e-20, 5.3e-20];
    let dot = curve(Space::Trigonometric, &points, &tangents, false, &[core::f64::consts::PI]);
    let finest = PrintOptions { tolerance: 1e-50, ..PrintOptions::default() };
    assert!(to_path_d(&dot, &finest).expect("finite").d.len() < 200, "a few cubics");
    let points = [500.0, 500.0, 500.0 + 1e-6, 500.0];
    let small = curve(Space::Trigonometric, &points, &[0.0, 1e-6, 0.0, -3e-6], false, &[2.0]);
    let fine = PrintOptions { tolerance: 1e-15, ..PrintOptions::default() };
    let printed = to_path_d(&small, &fine).expect("finite");
    let last_place = 500.0 * f64::EPSILON;
    assert!(
        printed.d.len() < 4000 && printed.deviation > 0.5 * last_place,
        "{}: {}",
        printed.d.len(),
        printed.deviation
    );
}

#[test]
fn a_curve_far_from_the_origin_is_a_line_only_within_the_tolerance_and_what_it_bends_is_said() {
    for (points, tangents, tolerance) in [
        ([999_999_000.0, 0.0, 999_999_000.001, 0.0], [1e-3, 2e-4, 1e-3, -2e-4], 1e-5),
        ([5e6, 0.0, 5e6 + 1e-6, 0.0], [1e-6, 6e-7, 1e-6, -6e-7], 1e-8),
    ] {
        let bow = curve(Space::Polynomial, &points, &tangents, false, &[]);
        let printed =
            to_path_d(&bow, &PrintOptions { tolerance, ..PrintOptions::default() }).expect("finite");
        // All of it is in y, whose digits are fine there: one segment, a line or a cubic, of the same parameter.
        let [was, is] = [&bow, &path(&printed.d)].map(|curve| pairs(&curve.sample(257).expect("few enough")));
        let truth = was.iter().zip(&is).map(|(a, b)| (a.y - b.y).abs()).fold(0.0, f64::max);
        // Coordinates of 1e9 have a last place of 1e-7.
        let last_place = f64::EPSILON * points[0];
        assert!(truth <= printed.deviation + 1e-15, "{}: {truth} {}", printed.d, printed.deviation);
        assert!(printed.deviation <= tolerance + last_place, "{}: {}", printed.d, printed.deviation);
    }
}

#[test]
fn a_curve_smaller_than_any_grid_is_printed_within_its_tolerance() {
    let speck = curve(Space::Polynomial, &[0.0, 0.0, 1e-18, 0.0], &[0.0, 2e-18, 0.0, -2e-18], false, &[]);
    let printed =
        to_path_d(&speck, &PrintOptions { tolerance: 1e-21, ..PrintOptions::default() }).expect("finite");
    assert!(printed.deviation <= 1e-21, "{printed:?}");
    assert_eq!(path(&printed.d).points(), speck.points(), "{}", printed.d);
}

#[test]
fn halves_that_cancel_have_no_centre_of_gravity_wherever_they_lie() {
    for shift in [0.0, 1e3, 1e5, 1e7, 1e9 - 200.0] {
        let points = [shift, shift, shift, shift - 100.0];
        let eight = curve(Space::Polynomial, &points, &[100.0, 100.0, 100.0, -200.0], true, &[]);
        let centre = unboxed(eight.centroid());
        assert!(matches!(centre, Err(Error::Degenerate { argument: "curve", .. })), "{shift}: {centre:?}");
    }
}

#[test]
fn quadratics_come_back_to_the_last_bit() {
    let mut random = Random::new(9);
    let exact = PrintOptions { decimals: Some(17), ..PrintOptions::default() };
    let mut texts = vec!["M71.86 8.01Q4.18 9.28 97.22 97.54".to_owned()];
    for decimals in [2, 3, 6] {
        for _ in 0..3000 {
            let n: Vec<String> =
                (0..6).map(|_| format!("{:.decimals$}", 50.0 + 50.0 * random.symmetric())).collect();
            texts.push(format!("M{} {}Q{}", n[0], n[1], n[2..].join(" ")));
        }
    }
    for text in texts {
        let curve = path(&text);
        let printed = to_path_d(&curve, &exact).expect("finite");
        assert_eq!(format!("{:?}", path(&printed.d)), format!("{curve:?}"), "{text} → {}", printed.d);
    }
}

#[test]
fn what_a_removal_moves_is_no_less_than_it_is_where_long_handles_go_far_from_place_to_place() {
    let mut random = Random::new(17);
    for case in 0..60 {
        let long = [10.0, 30.0, 100.0][case % 3];
        let options = HermiteOptions {
            points: (0..3).map(|_| random.vector(1.0)).collect(),
            tangents: (0..3).map(|_| random.vector(long)).collect(),
            tangents_in: (0..3).map(|_| random.vector(long)).collect(),
            space: Some(Space::Polynomial),
            ..HermiteOptions::default()
        };
        let wild = HermiteCurve::new(options).expect("in range");
        let (healed, deviation) = wild.remove(1).expect("enough points");
        let truth = directed(&wild, &healed).max(directed(&healed, &wild));
        assert!(deviation >= 0.999 * truth, "{case}: {deviation} {truth}");
    }
}

#[test]
fn what_is_written_is_read_back_however_large_it_is_or_is_refused() {
    let mut random = Random::new(23);
    let (mut written, mut refused) = (0, 0);
    for case in 0..160 {
        let size = [3e8, 9.9e8][case % 2];
        let space = [Space::Polynomial, Space::Trigonometric][case / 2 % 2];
        let length = [1.0, 4.0][case / 4 % 2];
        let straight = case % 5 == 0;
        let points: Vec<Point> = (0..3).map(|_| random.vector(size)).collect();
        let along = |i: usize| (points[(i + 1) % 3] - points[i]) / length;
        let tangents: Vec<Point> =
            (0..3).map(|i| if straight { along(i) } else { random.vector(size) }).collect();
        let options = HermiteOptions {
            tangents_in: (0..3).map(|i| if straight { along((i + 2) % 3) } else { tangents[i] }).collect(),
            points,
            tangents,
            closed: true,
            space: Some(space),
            omega: vec![if space == Space::Polynomial { 0.0 } else { 1.5 / length }],
            lengths: vec![length; 3],
        };
        let Ok(large) = HermiteCurve::new(options) else { continue };
        match unboxed(to_path_d(&large, &PrintOptions { tolerance: 1.0, ..PrintOptions::default() })) {
            Ok(printed) => {
                let back = path(&printed.d);
                let gap = directed(&large, &back).max(directed(&back, &large));
                // The tolerance, and what coordinates of 1e9 are rounded to.
                assert!(gap <= printed.deviation + 1e-5, "{case}: {gap} {}", printed.deviation);
                written += 1;
            }
            Err(error) => {
                assert!(matches!(error, Error::OutOfRange { argument: "handles", .. }), "{case}: {error}");
                refused += 1;
            }
        }
    }
    assert!(written > 20 && refused > 20, "{written} written, {refused} refused");
    let round = HermiteCurve::ellipse(Point::zeros(), Point::new(9e8, 9e8), 0.0, 12).expect("in range");
    let printed = to_path_d(&round, &PrintOptions::default()).expect("in range");
    assert!(directed(&round, &path(&printed.d)) < 1e-5, "{}", printed.d);
}

#[test]
fn an_arc_is_written_where_its_bezier_points_are_too_far_away_but_it_is_not() {
    let mut random = Random::new(29);
    for case in 0..60 {
        let radius = 6.4e8 + 3.4e8 * random.unit();
        let center = random.vector(0.99e9 - radius);
        let radii = [Point::new(radius, radius), Point::new(radius, 0.4 * radius)][case % 2];
        let sweep = [1.0, -1.0][case / 2 % 2] * (2.5 + 3.7 * random.unit());
        let arc =
            HermiteCurve::arc(center, radii, random.unit(), 6.0 * random.unit(), sweep).expect("in range");
        for (arcs, decimals) in
            [(true, None), (true, Some(2)), (true, Some(17)), (false, None), (false, Some(3))]
        {
            let options = PrintOptions { decimals, arcs, relative: case % 3 == 0, ..PrintOptions::default() };
            let printed = to_path_d(&arc, &options).expect("it is within the limits");
            let back = path(&printed.d);
            let (one, other) = (NearestFinder::new(&arc), NearestFinder::new(&back));
            let from = |points: &HermiteCurve, to: &NearestFinder| {
                let points = points.sample(301).expect("few enough");
                pairs(&points).into_iter().map(|p| to.nearest(p).distance).fold(0.0, f64::max)
            };
            let gap = from(&arc, &other).max(from(&back, &one));
            // Tolerances of 1e-9 of the extent of all Bézier points at the least; and 1e-12 of 1e9, which is what
            // distances are found to.
            assert!(
                printed.deviation <= 10.0 && gap <= printed.deviation + 1e-3,
                "{case}: {gap} {printed:?}"
            );
        }
    }
}

#[test]
fn one_frequency_has_no_index_and_a_tolerance_is_looked_at_where_it_is_not_needed() {
    let points = pairs(&[0.0, 0.0, 1.0, 1.0, 2.0, 0.0]);
    let error = unboxed(HermiteCurve::through(points.clone(), false, Some(7.0), Space::Trigonometric));
    assert!(matches!(error, Err(Error::OutOfRange { argument: "omega", index: None, .. })), "{error:?}");
    let hill = HermiteCurve::through(points, false, None, Space::Polynomial).expect("in range");
    for tolerance in [f64::NAN, f64::INFINITY, 0.0, -1.0] {
        let error = unboxed(hill.to_hermite(tolerance));
        assert_eq!(error.expect_err("no tolerance").argument(), Some("tolerance"), "{tolerance}");
    }
}

#[test]
fn a_table_of_lengths_is_not_asked_about_another_curve() {
    let round =
        |count| HermiteCurve::ellipse(Point::zeros(), Point::new(2.0, 1.0), 0.0, count).expect("in range");
    let mut table = LengthTable::new(&round(9), 1e-6).expect("in range");
    let error = unboxed(table.points(&round(3), 5));
    assert!(matches!(error, Err(Error::WrongLength { argument: "curve", got: 3, needed: 9 })), "{error:?}");
}
