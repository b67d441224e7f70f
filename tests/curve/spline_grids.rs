//! Grids of B-spline curves: far from parameter 0, with steps that doubles cannot hold, and at the limits of what may
//! be asked.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::unboxed;
use expline::generator::{Root, Roots};
use expline::numerics::Point;
use expline::svg::{PrintOptions, to_path_d};
use expline::{BSplineCurve, Curve, Error, InterpolatingCurve};

const POINTS: [f64; 10] = [0.0, 0.0, 7.0, 1.0, 9.0, 6.0, 3.0, 8.0, -2.0, 5.0];

/// Roundings of a curve of this size: some ten of 1.1e-16 in every weight, five weights, coordinates to 9.
const ROUNDED: f64 = 1e-13;

fn on_grid(roots: Roots, closed: bool, step: f64, offset: f64) -> BSplineCurve {
    BSplineCurve::new(POINTS.to_vec(), 2, closed, roots, step, offset).expect("a curve")
}

/// Quadratics, an ellipse's roots and ones that only cubics can follow, for a step.
fn lists(step: f64) -> Vec<Roots> {
    let pair = |im: f64| [im, -im].map(|im| Root { re: 0.0, im: im / step });
    let mixed = [&[Root::default()], &pair(1.1)[..], &pair(0.4)[..]].concat();
    let ellipse = [&[Root::default()], &pair(1.1)[..]].concat();
    let list = |roots: &[Root]| Roots::new(roots, "roots").expect("within the limits");
    // Roots are at most 10 per unit: short steps have polynomials only.
    let mut lists = vec![Roots::polynomials(2).expect("three"), Roots::polynomials(4).expect("five")];
    if step >= 0.5 {
        lists.extend([list(&ellipse), list(&mixed)]);
    }
    lists
}

/// Coordinates in units of 9, the size of the curve.
fn apart(curve: &[f64], other: &[f64]) -> f64 {
    assert_eq!(curve.len(), other.len(), "as many numbers");
    curve.iter().zip(other).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
}

#[test]
fn where_the_parameter_starts_changes_nothing_of_the_shape() {
    // From steps that are below the rounding of the offset to ones that are not.
    for (step, offset) in [(1e-3, 1e9), (1e-3, 1e6), (1e-12, 1e9), (1e-12, 0.0), (1.0, 1e9), (0.5, -1e9)] {
        for closed in [true, false] {
            for roots in lists(step) {
                let plain = on_grid(roots.scaled(1.0 / step).expect("in range"), closed, 1.0, 0.0);
                let curve = on_grid(roots, closed, step, offset);
                let what = format!("{closed} {step} {offset} {}", curve.roots().order());
                // The oracle is the same curve with whole knots, sampled in pieces, which no parameter is asked for.
                let (cubics, own) =
                    (plain.to_cubics(1e-6).expect("near"), curve.to_cubics(1e-6).expect("near"));
                assert!(apart(&cubics.path, &own.path) <= ROUNDED, "{what}: cubics");
                let (length, area) =
                    (curve.length(1e-9).expect("a length"), plain.length(1e-9).expect("a length"));
                assert!((length - area).abs() <= 2e-9, "{what}: {length}");
                let (hermite, deviation) = curve.to_hermite(1e-6).expect("in the plane");
                assert!(deviation <= 1e-6, "{what}: {deviation}");
                let finder = expline::curve::NearestFinder::new(&hermite);
                for point in plain.sample(301, 0).expect("points").chunks_exact(2) {
                    let off = finder.nearest(Point::new(point[0], point[1])).distance;
                    assert!(off <= deviation + ROUNDED, "{what}: {off:e} of {deviation:e}");
                }
                let printed = to_path_d(&curve, &PrintOptions::default()).expect("a path");
                let expected = to_path_d(&plain, &PrintOptions::default()).expect("a path");
                assert_eq!(printed.d, expected.d, "{what}");
            }
        }
    }
}

#[test]
fn a_curve_far_from_parameter_0_keeps_its_lengths_of_segments() {
    let curve = on_grid(Roots::polynomials(2).expect("three"), false, 1e-3, 1e9);
    let (hermite, _) = curve.to_hermite(1e-6).expect("in the plane");
    assert!(hermite.lengths().iter().all(|&length| length == 1e-3), "{:?}", hermite.lengths());
}

/// The curve that its numbers make again, as JSON carries them.
fn again(curve: &BSplineCurve) -> BSplineCurve {
    let ((start, end), roots) = (curve.domain(), curve.roots().clone());
    let (points, closed) = (curve.points().to_vec(), curve.is_closed());
    BSplineCurve::new(points, 2, closed, roots, curve.step(), curve.offset())
        .and_then(|curve| curve.with_domain(start, end))
        .expect("its own numbers")
}

#[test]
fn a_refined_curve_has_the_domain_of_the_curve_to_the_last_bit() {
    for closed in [false, true] {
        let base = InterpolatingCurve::new(POINTS.to_vec(), 2, closed, None).expect("a curve");
        let end = if closed { 5.0 } else { 4.0 };
        for (levels, m) in [(1, 2), (2, 3), (6, 3), (3, 7), (2, 49), (3, 10), (2, 1000)] {
            let fine = base.refine(levels, 2, m).expect("within the limits");
            assert_eq!(fine.domain(), (0.0, end), "{levels} {m}");
            for curve in [&fine, &again(&fine)] {
                assert_eq!(curve.domain(), (0.0, end), "{levels} {m}");
                assert_eq!(curve.knot(curve.piece_count()), end);
                let (last, wanted) = (curve.evaluate(end, 0), base.evaluate(end, 0).expect("in the domain"));
                assert!(apart(&last.expect("in the domain"), &wanted) <= 1e-11, "{levels} {m}");
            }
        }
    }
    for (step, offset) in [(0.1, 0.3), (0.7, -1e6), (3.3e-5, 17.1), (1e7, 1e9 - 3e7)] {
        for closed in [false, true] {
            let curve = on_grid(Roots::polynomials(3).expect("four"), closed, step, offset);
            let fine = curve.refine(3).and_then(|fine| fine.refine(7)).expect("within the limits");
            assert_eq!(fine.domain(), curve.domain(), "{step} {offset}");
            assert_eq!(again(&fine).domain(), curve.domain(), "{step} {offset}");
            assert_eq!(fine.with_point(0, &[1.0, 1.0]).expect("a point").domain(), curve.domain());
            let (back, off) = fine.reduce(21).expect("it was refined");
            assert_eq!(back.domain(), curve.domain(), "{step} {offset}");
            assert!(off <= 1e-12, "{off}");
        }
    }
}

#[test]
fn a_domain_that_is_another_is_refused() {
    let curve = on_grid(Roots::polynomials(3).expect("four"), true, 0.5, 0.0);
    for (i, (start, end)) in
        [(0.01, 2.5), (0.0, 2.51), (f64::NAN, 2.5), (0.0, f64::INFINITY)].into_iter().enumerate()
    {
        let error = unboxed(curve.clone().with_domain(start, end)).expect_err("not this domain");
        assert_eq!(error.argument(), Some("domain"), "{i}: {error}");
    }
}

#[test]
fn what_refine_and_reduce_give_can_be_made_again_or_is_refused_with_the_largest_factor() {
    let largest = |result: expline::Result<BSplineCurve>| match unboxed(result) {
        Err(Error::OutOfRange { argument: "m", value, most, .. }) => {
            assert!(most < value, "the value breaks the bound");
            most
        }
        // Equal to no factor.
        _ => f64::NAN,
    };
    let quadratic = Roots::polynomials(2).expect("three");
    let short = on_grid(quadratic.clone(), false, 1e-12, 0.0);
    assert_eq!(largest(short.refine(2)), 1.0, "the least step there is");
    assert_eq!(largest(on_grid(quadratic.clone(), true, 5.5e-12, 0.0).refine(9)), 5.0);
    // Control point 0 of an open curve is half a step before the first knot, and nearer to it on a finer grid.
    let far = on_grid(quadratic.clone(), false, 1.0, 1e9);
    assert_eq!(largest(far.refine(2)), 1.0);
    let same = far.refine(1).expect("the curve itself");
    assert_eq!(again(&same), same);
    let at_the_limit = on_grid(quadratic, false, 1.0, 1e9 - 0.25).refine(2).expect("at the limit");
    assert_eq!(again(&at_the_limit), at_the_limit);
    // Five points round: ω = 2π/5 a unit, so that a step of five halves is half a turn.
    let refined =
        InterpolatingCurve::new(POINTS.to_vec(), 2, true, None).and_then(|curve| curve.refine(1, 2, 2));
    assert_eq!(largest(refined.expect("finer").reduce(5).map(|(curve, _)| curve)), 4.0);
}

#[test]
fn a_bound_that_is_not_to_be_reached_is_printed_as_one_that_the_value_breaks() {
    let pi = core::f64::consts::PI;
    let roots = Roots::new(&[0.0, pi, -pi].map(|im| Root { re: 0.0, im }), "roots").expect("a list");
    for error in [
        unboxed(expline::generator::Interpolator::new(&roots).map(|_| ())),
        unboxed(BSplineCurve::new(POINTS.to_vec(), 2, true, roots, 1.0, 0.0).map(|_| ())),
    ] {
        let fits = |error: &Error| match error {
            Error::OutOfRange { argument: "roots", value, most, .. } => *value == pi && *most < pi,
            _ => false,
        };
        assert!(error.as_ref().is_err_and(fits), "{error:?}");
    }
}

#[test]
fn a_closed_curve_is_not_reduced_to_fewer_than_three_cells() {
    let curve =
        BSplineCurve::new(POINTS[..8].to_vec(), 2, true, Roots::polynomials(2).expect("three"), 1.0, 0.0);
    let error = unboxed(curve.expect("four points").reduce(2)).expect_err("two cells");
    assert!(matches!(error, Error::TooFewPoints { got: 2, needed: 3, .. }), "{error}");
}

#[test]
fn a_curve_of_any_fineness_comes_back_as_the_one_through_its_points() {
    for (levels, m0, m) in [(11, 2, 2), (12, 2, 2), (4, 6, 11), (3, 1024, 3)] {
        let base = InterpolatingCurve::new(POINTS.to_vec(), 2, false, None).expect("a curve");
        let (back, off) =
            base.refine(levels, m0, m).and_then(|fine| fine.interpolating()).expect("a whole grid");
        assert!(off <= 1e-11 && apart(back.points(), base.points()) <= 1e-11, "{levels} {m0} {m}: {off}");
    }
    // 1031 is prime: no steps of at most 1024 lead there.
    let step = 1.0 / 2062.0;
    let points: Vec<f64> = (0..2 * (2062 + 3)).map(f64::from).collect();
    let offset = -step;
    let curve = BSplineCurve::new(points, 2, false, Roots::polynomials(3).expect("four"), step, offset);
    let error = unboxed(curve.expect("a curve").interpolating()).expect_err("no steps");
    assert_eq!(error.argument(), Some("step"), "{error}");
}
