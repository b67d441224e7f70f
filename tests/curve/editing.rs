//! Editing keeps the shape: every operation that promises "same curve" is held to a few roundings.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use expline::curve::{Scheme, Side};
use expline::refine::{HermiteData, subdivide_hermite, subdivide_scalar};
use expline::{Error, HermiteCurve, HermiteOptions, Space};
use nalgebra::Vector2;

type Point = Vector2<f64>;

/// Two roundings of positions of size 1 to 10 add up to 2e-15; refinement and cuts make a handful.
const SAME: f64 = 2e-14;

fn vectors(values: &[f64]) -> Vec<Point> {
    values.chunks_exact(2).map(|v| Point::new(v[0], v[1])).collect()
}

/// A curve with corners, several frequencies and several lengths.
fn mixed(closed: bool, space: Space) -> HermiteCurve {
    HermiteCurve::new(HermiteOptions {
        points: vectors(&[0.0, 0.0, 4.0, 1.0, 5.0, 5.0, 1.0, 6.0]),
        tangents: vectors(&[3.0, -2.0, 2.0, 2.0, -3.0, 1.5, 0.0, -4.0]),
        tangents_in: vectors(&[3.0, -2.0, 1.0, 4.0, -3.0, 1.5, -2.0, -4.0]),
        closed,
        space: Some(space),
        omega: if closed { vec![1.0, 0.5, 0.0, 2.0] } else { vec![1.0, 0.5, 2.0] },
        lengths: if closed { vec![1.0, 2.5, 0.75, 1.5] } else { vec![1.0, 2.5, 0.75] },
    })
    .expect("a valid curve")
}

fn all_mixed() -> Vec<HermiteCurve> {
    let spaces = [Space::Trigonometric, Space::Hyperbolic, Space::Polynomial];
    spaces.into_iter().flat_map(|space| [mixed(true, space), mixed(false, space)]).collect()
}

fn circle(count: usize) -> HermiteCurve {
    HermiteCurve::ellipse(Point::new(2.0, 1.0), Point::new(5.0, 5.0), 0.0, count).expect("a valid circle")
}

/// The largest difference of values at the same parameter.
fn difference(first: &HermiteCurve, second: &HermiteCurve) -> f64 {
    let (_, end) = first.domain();
    assert!((second.domain().1 - end).abs() <= 1e-14 * end, "both have the same domain");
    let end = end.min(second.domain().1);
    (0..=1000)
        .map(|i| f64::from(i) / 1000.0 * end)
        .map(|t| (first.evaluate(t, 0).expect("valid") - second.evaluate(t, 0).expect("valid")).norm())
        .fold(0.0, f64::max)
}

#[test]
fn refining_by_any_arity_leaves_the_curve_where_it_was() {
    for curve in all_mixed() {
        for arity in [1, 2, 3, 7, 100] {
            let refined = curve.refine(arity).expect("within limits");
            assert_eq!(refined.segment_count(), arity * curve.segment_count(), "arity times the segments");
            let moved = difference(&curve, &refined);
            assert!(moved < SAME, "arity {arity}: moved by {moved:e}");
        }
    }
}

#[test]
fn refining_twenty_times_leaves_a_circle_round() {
    let mut curve = circle(2);
    for level in 0..20 {
        curve = curve.refine(2).expect("within limits");
        let step = (curve.points().len() / 500).max(1);
        for t in (0..500).map(|i| (i as f64 + 0.37) * curve.domain().1 / 500.0) {
            let radius = (curve.evaluate(t, 0).expect("closed") - Point::new(2.0, 1.0)).norm();
            assert!((radius / 5.0 - 1.0).abs() < 1e-12, "level {level}, t = {t}: {radius}");
        }
        for point in curve.points().iter().step_by(step) {
            let radius = (point - Point::new(2.0, 1.0)).norm();
            assert!((radius / 5.0 - 1.0).abs() < 1e-12, "level {level}: a point is off");
        }
    }
}

#[test]
fn inserting_anywhere_leaves_the_curve_where_it_was() {
    for curve in all_mixed() {
        let (_, end) = curve.domain();
        for share in [0.001, 0.11, 0.25, 0.5, 0.613, 0.9, 0.999_999] {
            let inserted = curve.insert(share * end).expect("inside the domain");
            assert_eq!(inserted.points().len(), curve.points().len() + 1, "one more point");
            let moved = difference(&curve, &inserted);
            assert!(moved < SAME, "at {share}: moved by {moved:e}");
        }
    }
}

#[test]
fn inserting_forty_points_in_a_row_leaves_a_circle_round() {
    let mut curve = circle(3);
    let mut t = 0.1;
    for _ in 0..40 {
        t = (t + 1.618_033_988_749_895) % 3.0;
        curve = curve.insert(t).expect("closed curves take any t");
    }
    assert_eq!(curve.points().len(), 43, "no two golden steps meet");
    assert!(difference(&curve, &circle(3)) < SAME * 5.0, "five times the size");
}

#[test]
fn inserting_at_a_point_that_is_there_changes_nothing() {
    for curve in all_mixed() {
        for &knot in curve.knots() {
            for t in [knot, (knot - 1e-13).max(0.0)] {
                let same = curve.insert(t).expect("inside the domain");
                assert_eq!(same.points(), curve.points(), "t = {t}");
                assert_eq!(same.lengths(), curve.lengths(), "t = {t}");
            }
        }
    }
}

#[test]
fn removing_an_inserted_point_gives_the_old_curve_back() {
    for curve in all_mixed() {
        let (_, end) = curve.domain();
        for share in [0.05, 0.3, 0.47, 0.8, 0.97] {
            let inserted = curve.insert(share * end).expect("inside the domain");
            let added = inserted.points().iter().zip(curve.points()).take_while(|(a, b)| a == b).count();
            let (restored, deviation) = inserted.remove(added).expect("it has points to spare");
            assert!(deviation < 1e-13, "the deviation is measured: {deviation:e}");
            assert!(difference(&curve, &restored) < 1e-13, "{:?} at {share}", curve.space());
        }
    }
}

#[test]
fn removing_a_point_of_a_circle_leaves_a_circle() {
    for count in [3, 4, 5, 8, 16] {
        for i in [0, 1, count - 1] {
            let (healed, deviation) = circle(count).remove(i).expect("2 points are left");
            assert_eq!(healed.points().len(), count - 1, "one point less");
            // Two thirds of a turn are the worst: the basis grows towards a whole turn.
            assert!(deviation < 1e-13, "{count} points without {i}: {deviation:e}");
            for k in 0..100 {
                let t = healed.domain().1 * f64::from(k) / 100.0;
                let radius = (healed.evaluate(t, 0).expect("closed") - Point::new(2.0, 1.0)).norm();
                assert!((radius - 5.0).abs() < 1e-13, "{count} points without {i}: radius {radius}");
            }
        }
    }
}

#[test]
fn a_circle_can_be_thinned_down_to_two_points() {
    let mut curve = circle(8);
    while curve.points().len() > 2 {
        let (healed, deviation) = curve.remove(1).expect("2 points are left");
        let most = if healed.lengths()[0] * healed.omega()[0] < 6.0 { 1e-12 } else { 0.2 };
        assert!(deviation < most, "{} points: {deviation:e}", healed.points().len());
        curve = healed;
    }
    let error = curve.remove(0).expect_err("a curve needs two points");
    assert_eq!(error.code(), "E_TOO_FEW_POINTS", "{error}");
    assert_eq!(
        error.to_string(),
        "points has 2 points; at least 3 are needed",
        "what there is, not what would be left"
    );
}

#[test]
fn pieces_with_parameters_of_their_own_are_recognised_as_one() {
    // Both pieces of a cut cubic with parameter length 1, as a path of cubics gives them.
    let whole = HermiteCurve::new(HermiteOptions {
        points: vectors(&[0.0, 0.0, 10.0, 2.0]),
        tangents: vectors(&[12.0, 30.0, 5.0, -20.0]),
        space: Some(Space::Polynomial),
        ..HermiteOptions::default()
    })
    .expect("a valid cubic");
    let mut options = whole.insert(0.3).expect("inside").to_options();
    let lengths = core::mem::replace(&mut options.lengths, vec![1.0, 1.0]);
    options.tangents =
        vec![options.tangents[0] * lengths[0], options.tangents[1] * lengths[1], Point::zeros()];
    options.tangents_in =
        vec![Point::zeros(), options.tangents_in[1] * lengths[0], options.tangents_in[2] * lengths[1]];
    let pieces = HermiteCurve::new(options).expect("valid pieces");
    let (healed, deviation) = pieces.remove(1).expect("two points are left");
    assert!(deviation < 1e-13, "{deviation:e}");
    for i in 0..=50 {
        let t = f64::from(i) / 50.0;
        let (a, b) = (healed.evaluate(2.0 * t, 0).expect("inside"), whole.evaluate(t, 0).expect("inside"));
        assert!((a - b).norm() < 1e-13, "at {t}");
    }
}

#[test]
fn healing_keeps_directions_and_the_far_side_of_the_neighbours() {
    let curve = mixed(true, Space::Trigonometric);
    let (healed, deviation) = curve.remove(2).expect("points to spare");
    assert!(deviation.is_finite() && deviation > 0.0, "a real point was lost");
    assert_eq!(healed.tangents_in()[1], curve.tangents_in()[1], "the arriving side of the corner before");
    assert_eq!(healed.tangents()[2], curve.tangents()[3], "the leaving side of the corner after");
    let turned = healed.tangents()[1].perp(&curve.tangents()[1]);
    assert!(turned.abs() < 1e-12, "the direction that leaves the point before stays");
    let turned = healed.tangents_in()[2].perp(&curve.tangents_in()[3]);
    assert!(turned.abs() < 1e-12, "the direction that arrives at the point after stays");
    assert!((healed.domain().1 - curve.domain().1).abs() < 1e-15, "the parameter range stays");

    // What changed lies between the neighbours; the deviation is the larger of both directed distances there.
    let places = |of: &HermiteCurve| -> Vec<Point> {
        (0..=2000).map(|k| of.evaluate(1.0 + 3.25 * f64::from(k) / 2000.0, 0).expect("closed")).collect()
    };
    let (old, new) = (places(&curve), places(&healed));
    let directed = |from: &[Point], to: &[Point]| {
        let nearest = |p: &Point| to.iter().map(|q| (p - q).norm_squared()).fold(f64::INFINITY, f64::min);
        from.iter().step_by(3).map(nearest).fold(0.0, f64::max).sqrt()
    };
    let measured = directed(&old, &new).max(directed(&new, &old));
    assert!((deviation - measured).abs() <= 0.01 * measured, "said {deviation}, measured {measured}");
}

#[test]
fn healing_moves_a_smooth_curve_little() {
    // A point pushed off a circle of 8 by a hundredth of its radius, then removed.
    let round = circle(8);
    let pushed = round.with_point(3, round.points()[3] * 1.002).expect("valid");
    let (healed, deviation) = pushed.remove(3).expect("points to spare");
    let moved = (pushed.points()[3] - round.points()[3]).norm();
    assert!(deviation <= 1.05 * moved, "no worse than going back to the circle: {deviation} of {moved}");
    for i in 0..200 {
        let t = healed.domain().1 * f64::from(i) / 200.0;
        let radius = (healed.evaluate(t, 0).expect("closed") - Point::new(2.0, 1.0)).norm();
        assert!((radius - 5.0).abs() < moved, "t = {t}: {radius}");
    }
}

#[test]
fn removing_an_end_of_an_open_curve_takes_its_segment_away() {
    let curve = mixed(false, Space::Trigonometric);
    let (shorter, deviation) = curve.remove(0).expect("3 points are left");
    assert_eq!(shorter.points(), &curve.points()[1..], "the first point is gone");
    assert_eq!(shorter.omega(), &curve.omega()[1..], "with its segment");
    assert!(deviation > 1.0, "which was long");
    let (shorter, _) = curve.remove(3).expect("3 points are left");
    assert_eq!(shorter.points(), &curve.points()[..3], "the last point is gone");
}

#[test]
fn the_parts_of_a_cut_are_the_curve() {
    for curve in all_mixed() {
        let (_, end) = curve.domain();
        for share in [0.0, 0.1, 0.25, 0.618, 0.99, 1.0] {
            let t = share * end;
            let parts = curve.split(t).expect("inside the domain");
            let mut start = if curve.is_closed() { t } else { 0.0 };
            for part in &parts {
                assert!(!part.is_closed(), "parts are open");
                let (_, length) = part.domain();
                for i in 1..40 {
                    let s = length * f64::from(i) / 40.0;
                    let (a, b) =
                        (part.evaluate(s, 0).expect("inside"), curve.evaluate(start + s, 0).expect("inside"));
                    assert!((a - b).norm() < SAME, "cut at {share}, place {i}");
                }
                start += length;
            }
            let total: f64 = parts.iter().map(|part| part.domain().1).sum();
            assert!((total - end).abs() < 1e-14 * end, "nothing is lost");
        }
    }
}

#[test]
fn trimming_takes_the_part_that_was_asked_for() {
    let curve = circle(5);
    for (from, to, length) in
        [(0.5, 1.5, 1.0), (4.0, 1.0, 2.0), (1.25, 1.0, 4.75), (2.0, 2.0, 5.0), (1.2, 1.7, 0.5)]
    {
        let part = curve.trim(from, to).expect("closed curves take any t");
        assert!((part.domain().1 - length).abs() < 1e-14, "{from} to {to}");
        let (first, last) = (part.points()[0], part.points()[part.points().len() - 1]);
        assert!((first - curve.evaluate(from, 0).expect("closed")).norm() < SAME, "{from} to {to}: start");
        assert!((last - curve.evaluate(to, 0).expect("closed")).norm() < SAME, "{from} to {to}: end");
    }
    let open = mixed(false, Space::Trigonometric);
    assert_eq!(open.trim(2.0, 1.0).expect_err("backwards").code(), "E_DEGENERATE", "an end before the start");
    assert_eq!(open.trim(-1.0, 1.0).expect_err("outside").code(), "E_RANGE", "a start before the curve");
}

#[test]
fn a_part_of_a_closed_curve_that_is_too_short_is_refused_by_its_end() {
    let curve = circle(3);
    for way in [2e-16, 1e-13, 9e-13] {
        let refused = curve.trim(0.5, 0.5 + way).map_err(|error| *error).err();
        assert!(matches!(refused, Some(Error::Degenerate { argument: "t1", .. })), "{way}: {refused:?}");
    }
    for (t0, t1, length) in [
        (0.5, 0.5 + 2e-12, 2e-12),
        (0.5, 0.5, 3.0),
        (0.5, 0.5 - 2e-16, 3.0),
        (1.0 - 1e-13, 1.0 + 2e-12, 2e-12),
    ] {
        let part = curve.trim(t0, t1).expect("long enough").domain().1;
        assert!((part - length).abs() < 1e-13, "{t0} to {t1}: {part}");
    }
}

#[test]
fn reversing_runs_the_same_curve_backwards() {
    for curve in all_mixed() {
        let reversed = curve.reversed();
        let (_, end) = curve.domain();
        for i in 0..=100 {
            let t = end * f64::from(i) / 100.0;
            let (a, b) =
                (reversed.evaluate(t, 0).expect("inside"), curve.evaluate(end - t, 0).expect("inside"));
            assert!((a - b).norm() < SAME, "t = {t}");
        }
        let twice = reversed.reversed();
        assert_eq!(twice.points(), curve.points(), "twice reversed is the curve");
        assert_eq!(twice.tangents(), curve.tangents(), "leaving");
        assert_eq!(twice.tangents_in(), curve.tangents_in(), "arriving");
        assert_eq!((twice.omega(), twice.lengths()), (curve.omega(), curve.lengths()), "segments");
    }
}

#[test]
fn an_affine_image_is_the_image_of_every_point() {
    let [a, b, c, d, e, f] = [0.5, 1.5, -2.0, 0.25, 10.0, -3.0];
    for curve in all_mixed() {
        let image = curve.transformed([a, b, c, d, e, f]).expect("finite");
        let (_, end) = curve.domain();
        for i in 0..=100 {
            let t = end * f64::from(i) / 100.0;
            let p = curve.evaluate(t, 0).expect("inside");
            let expected = Point::new(a * p.x + c * p.y + e, b * p.x + d * p.y + f);
            assert!((image.evaluate(t, 0).expect("inside") - expected).norm() < SAME, "t = {t}");
        }
    }
    let curve = circle(4);
    assert_eq!(
        curve.transformed([f64::NAN; 6]).expect_err("not finite").argument(),
        Some("matrix"),
        "the argument at fault"
    );
    assert_eq!(
        curve.transformed([1e10, 0.0, 0.0, 1.0, 0.0, 0.0]).expect_err("too far").code(),
        "E_RANGE",
        "points beyond the bound"
    );
}

#[test]
fn setting_a_point_or_one_side_of_a_tangent_changes_nothing_else() {
    let curve = mixed(true, Space::Trigonometric);
    let moved = curve.with_point(2, Point::new(9.0, 9.0)).expect("valid");
    assert_eq!(moved.points()[2], Point::new(9.0, 9.0), "the point moved");
    assert_eq!(moved.tangents(), curve.tangents(), "its tangents stay");
    let side = |side| curve.with_tangent(1, Point::new(7.0, 8.0), side).expect("valid");
    assert_eq!(side(Side::Out).tangents_in(), curve.tangents_in(), "leaving alone");
    assert_eq!(side(Side::In).tangents(), curve.tangents(), "arriving alone");
    assert_eq!(side(Side::Both).tangents()[1], side(Side::Both).tangents_in()[1], "both");
    assert_eq!(
        curve.with_point(4, Point::zeros()).expect_err("no such point").code(),
        "E_RANGE",
        "four points, counted from 0"
    );
    let nan = curve.with_tangent(0, Point::new(0.0, f64::NAN), Side::In).expect_err("not finite");
    assert_eq!(nan.argument(), Some("tangentsIn"), "the argument at fault");
}

#[test]
fn the_hermite_polygon_lies_on_the_curve_at_every_level() {
    for curve in all_mixed() {
        for (levels, arity) in [(0, 2), (1, 2), (5, 2), (3, 3), (2, 10)] {
            let polygon = vectors(&curve.subdivide(levels, arity, Scheme::Hermite).expect("within limits"));
            let pieces = arity.pow(levels as u32);
            assert_eq!(
                polygon.len(),
                pieces * curve.segment_count() + usize::from(!curve.is_closed()),
                "a point for each piece, one more where it is open"
            );
            for (k, point) in polygon.iter().enumerate() {
                let (i, part) = (k / pieces, (k % pieces) as f64 / pieces as f64);
                let t = curve.knots()[i] + if part > 0.0 { curve.lengths()[i] * part } else { 0.0 };
                assert!((point - curve.evaluate(t, 0).expect("inside")).norm() < SAME, "point {k}");
            }
        }
    }
}

#[test]
fn polygons_are_those_of_the_schemes_step_by_step() {
    for curve in all_mixed().into_iter().chain([circle(5)]) {
        let data = HermiteData {
            space: curve.space(),
            closed: curve.is_closed(),
            points: curve.points().to_vec(),
            leaving: curve.tangents().to_vec(),
            arriving: curve.tangents_in().to_vec(),
            omega: curve.omega().to_vec(),
            lengths: curve.lengths().to_vec(),
        };
        let check = |scheme, levels, arity, expected: Vec<Point>| {
            let polygon = vectors(&curve.subdivide(levels, arity, scheme).expect("within limits"));
            assert_eq!(polygon.len(), expected.len(), "{scheme:?}, {levels} levels of arity {arity}");
            let apart = polygon.iter().zip(&expected).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
            assert!(apart < SAME, "{scheme:?}, {levels} levels of arity {arity}: {apart:e}");
        };
        for levels in 0..6 {
            let arity = 2 + levels % 2;
            let fine = subdivide_hermite(&data, arity, levels).expect("within limits");
            check(Scheme::Hermite, levels, arity, fine.points);
            check(Scheme::Scalar, levels, 2, subdivide_scalar(&data, levels).expect("within limits"));
        }
    }
}

#[test]
fn the_scalar_polygon_converges_to_the_curve_with_the_square_of_the_step() {
    let curve = mixed(true, Space::Trigonometric);
    let distance = |levels: usize| {
        let polygon = vectors(&curve.subdivide(levels, 2, Scheme::Scalar).expect("within limits"));
        let pieces = 1 << levels;
        // After node k and before node k + 1.
        polygon[1..]
            .chunks_exact(2)
            .enumerate()
            .map(|(k, pair)| {
                let segment = curve.segment(k / pieces).expect("it is there");
                let x = ((k % pieces) as f64 + 0.5) / pieces as f64;
                ((pair[0] + pair[1]) * 0.5 - segment.position(x)).norm()
            })
            .fold(0.0, f64::max)
    };
    let (coarse, fine) = (distance(5), distance(6));
    assert!((coarse / fine - 4.0).abs() < 0.2, "{coarse:e} to {fine:e}");
    assert!(distance(18) < 1e-10, "and goes to zero");
}

#[test]
fn subdivision_is_bounded_before_it_starts() {
    let square = HermiteCurve::through(
        vectors(&[0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0]),
        true,
        None,
        Space::Trigonometric,
    )
    .expect("a valid curve");
    let code = |levels, arity| square.subdivide(levels, arity, Scheme::Hermite).expect_err("too much").code();
    assert_eq!(code(24, 2), "E_LIMIT", "64 million points");
    assert_eq!(code(53, 2), "E_RANGE", "beyond 24 levels");
    assert_eq!(code(24, 4_000_000), "E_LIMIT", "overflows every integer");
    assert_eq!(code(1, 0), "E_RANGE", "arity 0");
    assert_eq!(square.refine(0).expect_err("arity 0").code(), "E_RANGE", "no segments");
    assert_eq!(
        square.refine(1_000_001).expect_err("too much").code(),
        "E_LIMIT",
        "four million points and four"
    );
    assert_eq!(square.refine(usize::MAX).expect_err("no such arity").code(), "E_RANGE", "no overflow");
    let points = square.subdivide(0, 2, Scheme::Hermite).expect("a copy");
    assert_eq!(vectors(&points), square.points(), "level 0 is the points");
}
