//! Curves through their points: what they keep, how far a point acts, and that every grid shows the same curve.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use core::f64::consts::TAU;

use crate::support::curves::Random;
use crate::support::{scale, unboxed};
use expline::generator::{Root, Roots};
use expline::{BSplineCurve, Curve, Error, InterpolatingCurve};

/// Root lists of every kind, orders 3 to 8.
fn lists() -> Vec<Roots> {
    let pair = |re: f64, im: f64| [Root { re, im }, Root { re, im: -im }];
    let list = |roots: &[Root]| Roots::new(roots, "roots").expect("within the limits");
    let zero = Root::default();
    vec![
        Roots::polynomials(2).expect("in range"),
        Roots::polynomials(3).expect("in range"),
        Roots::polynomials(5).expect("in range"),
        Roots::ellipse(5).expect("in range"),
        Roots::harmonics(9, 2).expect("in range"),
        Roots::hyperbola(0.7).expect("in range"),
        list(&[pair(0.0, 1.1), pair(0.0, 0.4)].concat()),
        list(&[pair(0.3, 1.0), pair(-0.3, 1.0), [zero, zero]].concat()),
        list(&[[zero, zero], pair(0.0, 1.0), pair(0.0, 2.0), pair(0.0, 0.5)].concat()),
    ]
}

fn random_points(random: &mut Random, count: usize, dimension: usize) -> Vec<f64> {
    (0..count * dimension).map(|_| random.symmetric()).collect()
}

/// The largest distance between coordinates of two curves at 400 parameters, ends among them.
fn difference(domain: (f64, f64), first: &dyn Fn(f64) -> Vec<f64>, second: &dyn Fn(f64) -> Vec<f64>) -> f64 {
    let mut worst: f64 = 0.0;
    for i in 0..=400 {
        let t = domain.0 + (domain.1 - domain.0) * f64::from(i) / 400.0;
        for (a, b) in first(t).iter().zip(second(t)) {
            worst = worst.max((a - b).abs());
        }
    }
    worst
}

#[test]
fn a_curve_passes_through_its_points_to_the_last_bit() {
    let mut random = Random::new(1);
    for roots in lists() {
        for (dimension, closed) in [(2, true), (3, true), (2, false), (3, false)] {
            for count in [3, 4, 7, 16] {
                let points = random_points(&mut random, count, dimension);
                let curve = InterpolatingCurve::new(points.clone(), dimension, closed, Some(roots.clone()))
                    .expect("finite points");
                for (k, point) in points.chunks_exact(dimension).enumerate() {
                    assert_eq!(curve.evaluate(k as f64, 0).expect("in the domain"), point, "{roots:?} {k}");
                    // The limit from the left is no other point.
                    if k > 0 {
                        let before = curve.evaluate(k as f64 * (1.0 - 1e-15), 0).expect("in the domain");
                        for (a, b) in before.iter().zip(point) {
                            assert!((a - b).abs() < 1e-11, "{roots:?} {k}: {a} {b}");
                        }
                    }
                }
            }
        }
    }
}

/// Fills a list with the coefficients of a piece.
type Filler<'a> = &'a dyn Fn(usize, &mut Vec<f64>);

#[test]
fn pieces_meet_with_all_derivatives_that_are_promised() {
    let mut random = Random::new(2);
    for roots in lists() {
        let points = random_points(&mut random, 6, 2);
        let curve = InterpolatingCurve::new(points, 2, true, Some(roots.clone())).expect("finite points");
        let fine = curve.refine(2, 2, 3).expect("in range");
        let cancelled = 1.0 + 2.0 * curve.interpolator().lambda().iter().map(|l| l.abs()).sum::<f64>();
        let checks: [(usize, Filler); 2] = [
            (curve.piece_count(), &|i, out| curve.piece_into(i, out).expect("it is there")),
            (fine.piece_count(), &|i, out| fine.piece_into(i, out).expect("it is there")),
        ];
        for (count, piece_into) in checks {
            let (mut before, mut after) = (Vec::new(), Vec::new());
            for i in 0..count {
                piece_into(i, &mut before);
                piece_into((i + 1) % count, &mut after);
                for order in 0..=roots.order() - 2 {
                    for d in 0..2 {
                        let left = derivative(&before, d, order, 0.5);
                        let right = derivative(&after, d, order, -0.5);
                        // λ cancels, and a derivative of order k amplifies what is left by about 4ᵏ.
                        let lost = 1e-14 * cancelled * f64::from(4_u32.pow(order as u32)) * scale(&after);
                        assert!((left - right).abs() < lost, "{roots:?} {i} {order}: {left} {right}");
                    }
                }
            }
        }
    }
}

/// The derivative of coordinate d of a piece, term by term.
fn derivative(piece: &[f64], d: usize, order: usize, y: f64) -> f64 {
    let mut sum = 0.0;
    for (power, c) in piece.chunks_exact(2).map(|c| c[d]).enumerate().skip(order) {
        let falling: f64 = (0..order).map(|k| (power - k) as f64).product();
        sum += c * falling * y.powi((power - order) as i32);
    }
    sum
}

#[test]
fn ellipses_harmonics_polynomials_and_hyperbolas_are_kept() {
    for count in 3..40 {
        let w = TAU / count as f64;
        let ellipse = |t: f64| vec![5.0 + 3.0 * (w * t).cos(), 1.0 - 2.0 * (w * t + 0.3).sin()];
        let points = (0..count).flat_map(|k| ellipse(k as f64)).collect();
        let curve = InterpolatingCurve::new(points, 2, true, None).expect("finite points");
        let off = difference((0.0, count as f64), &|t| curve.evaluate(t, 0).expect("finite"), &ellipse);
        assert!(off < 4e-14, "{count} points: {off:e}");
    }
    let w = TAU / 9.0;
    let knot = |t: f64| vec![(2.0 * w * t).sin(), (w * t).cos(), 0.5 - (2.0 * w * t).cos()];
    let points = (0..9).flat_map(|k| knot(f64::from(k))).collect();
    let roots = Roots::harmonics(9, 2).expect("in range");
    let curve = InterpolatingCurve::new(points, 3, true, Some(roots)).expect("finite points");
    let off = difference((0.0, 9.0), &|t| curve.evaluate(t, 0).expect("finite"), &knot);
    assert!(off < 1e-14, "harmonics: {off:e}");
    // Open curves keep theirs to the ends.
    let cubic = |t: f64| vec![t, 1.0 + t * (0.5 - 0.1 * t * t)];
    let points = (0..6).flat_map(|k| cubic(f64::from(k))).collect();
    let curve = InterpolatingCurve::new(points, 2, false, None).expect("finite points");
    let off = difference((0.0, 5.0), &|t| curve.evaluate(t, 0).expect("inside"), &cubic);
    assert!(off < 1e-13, "cubic: {off:e}");
    let hyperbola = |t: f64| vec![(0.7 * (t - 2.0)).cosh(), (0.7 * (t - 2.0)).sinh()];
    let points = (0..5).flat_map(|k| hyperbola(f64::from(k))).collect();
    let roots = Roots::hyperbola(0.7).expect("in range");
    let curve = InterpolatingCurve::new(points, 2, false, Some(roots)).expect("finite points");
    let off = difference((0.0, 4.0), &|t| curve.evaluate(t, 0).expect("inside"), &hyperbola);
    assert!(off < 1e-14, "hyperbola: {off:e}");
    // Fewer points than roots: the polynomial through them.
    for count in 2..4 {
        let points = (0..count).flat_map(|k| [f64::from(k), f64::from(k * k)]).collect();
        let curve = InterpolatingCurve::new(points, 2, false, None).expect("finite points");
        let parabola = |t: f64| vec![t, if count == 2 { t } else { t * t }];
        let end = f64::from(count - 1);
        let off = difference((0.0, end), &|t| curve.evaluate(t, 0).expect("inside"), &parabola);
        assert!(off < 1e-14, "{count} points: {off:e}");
    }
}

#[test]
fn a_point_acts_on_n_minus_one_segments_to_each_side_and_nowhere_else() {
    let mut random = Random::new(3);
    for roots in lists() {
        for closed in [true, false] {
            let points = random_points(&mut random, 16, 2);
            let curve = InterpolatingCurve::new(points.clone(), 2, closed, Some(roots.clone()))
                .expect("finite points");
            for moved in 0..16 {
                let to = [points[2 * moved] + 0.3, points[2 * moved + 1] - 0.2];
                let other = curve.with_point(moved, &to).expect("a finite point");
                assert_eq!(other.evaluate(moved as f64, 0).expect("in the domain"), to, "through the point");
                let reach = roots.order() as f64 - 1.0;
                let (_, end) = curve.domain();
                for i in 0..=320 {
                    let t = end * f64::from(i) / 320.0;
                    let away = (t - moved as f64).abs();
                    let away = if closed { away.min(16.0 - away) } else { away };
                    if away >= reach {
                        let [was, is] = [&curve, &other].map(|c| c.evaluate(t, 0).expect("in the domain"));
                        assert_eq!(was, is, "{roots:?}: point {moved} acts at {t}");
                    }
                }
            }
        }
    }
}

#[test]
fn refining_to_level_six_leaves_the_curve_where_it_is() {
    let mut random = Random::new(4);
    for roots in lists() {
        for (dimension, closed) in [(2, true), (3, false)] {
            for (count, m0, m) in [(3, 2, 2), (11, 4, 2), (5, 2, 3)] {
                let points = random_points(&mut random, count, dimension);
                let curve = InterpolatingCurve::new(points, dimension, closed, Some(roots.clone()))
                    .expect("finite points");
                for levels in [1, 2, 3, 6] {
                    let fine = curve.refine(levels, m0, m).expect("in range");
                    let size = scale(fine.points()).max(scale(curve.points()));
                    let off =
                        difference(curve.domain(), &|t| curve.evaluate(t, 0).expect("in the domain"), &|t| {
                            fine.evaluate(t.min(fine.domain().1), 0).expect("in the domain")
                        });
                    assert!(
                        off < 1e-12 * size,
                        "{roots:?} {count} {closed} level {levels}: {off:e} of {size}"
                    );
                }
            }
        }
    }
}

#[test]
fn control_points_close_in_on_the_curve_with_the_square_of_the_step() {
    let mut random = Random::new(5);
    for roots in lists() {
        for (closed, m) in [(true, 2), (false, 2), (true, 3)] {
            let points = random_points(&mut random, 9, 2);
            let curve =
                InterpolatingCurve::new(points, 2, closed, Some(roots.clone())).expect("finite points");
            let distance = |levels: usize| {
                let fine = curve.refine(levels, 2, m).expect("in range");
                let mut worst: f64 = 0.0;
                for (l, point) in fine.points().chunks_exact(2).enumerate() {
                    let t = fine.offset() + l as f64 * fine.step();
                    let (least, most) = fine.domain();
                    if closed || (least..=most).contains(&t) {
                        let on = curve.evaluate(t, 0).expect("in the domain");
                        worst = worst.max((on[0] - point[0]).hypot(on[1] - point[1]));
                    }
                }
                worst
            };
            let ratio = distance(5) / distance(6);
            let square = (m * m) as f64;
            assert!((0.93 * square..1.07 * square).contains(&ratio), "{roots:?} {closed} {m}: {ratio}");
        }
    }
}

#[test]
fn a_translation_of_the_points_is_one_of_every_control_polygon() {
    let mut random = Random::new(6);
    for roots in lists().into_iter().filter(Roots::keeps_constants) {
        for closed in [true, false] {
            let points = random_points(&mut random, 7, 2);
            let moved: Vec<f64> = points.chunks_exact(2).flat_map(|p| [p[0] + 20.0, p[1] - 7.0]).collect();
            let [here, there] = [points, moved].map(|p| {
                let curve =
                    InterpolatingCurve::new(p, 2, closed, Some(roots.clone())).expect("finite points");
                curve.refine(3, 2, 2).expect("in range")
            });
            for (a, b) in here.points().chunks_exact(2).zip(there.points().chunks_exact(2)) {
                assert!(
                    (a[0] + 20.0 - b[0]).abs() < 1e-12 && (a[1] - 7.0 - b[1]).abs() < 1e-12,
                    "{a:?} {b:?}"
                );
            }
        }
    }
}

#[test]
fn a_b_spline_curve_can_be_made_again_from_its_numbers() {
    let mut random = Random::new(7);
    for roots in lists() {
        for closed in [true, false] {
            let points = random_points(&mut random, 5, 3);
            let curve =
                InterpolatingCurve::new(points, 3, closed, Some(roots.clone())).expect("finite points");
            let fine = curve.refine(2, 2, 3).expect("in range");
            let again = BSplineCurve::new(
                fine.points().to_vec(),
                3,
                closed,
                fine.roots().clone(),
                fine.step(),
                fine.offset(),
            )
            .expect("its own numbers");
            assert!((again.domain().1 - fine.domain().1).abs() < 1e-15, "the domain");
            let middle = 0.37 * fine.domain().1;
            let [a, b] = [&fine, &again].map(|c| c.evaluate(middle, 0).expect("in the domain"));
            for (a, b) in a.iter().zip(b) {
                assert!((a - b).abs() < 1e-13, "{roots:?}: {a} {b}");
            }
            let moved = fine.with_point(2, &[9.0, 9.0, 9.0]).expect("a finite point");
            assert_eq!(moved.points()[6..9], [9.0; 3], "control points are edited in place");
        }
    }
}

#[test]
fn what_is_wrong_is_named() {
    let curve =
        |points: &[f64], closed, roots| unboxed(InterpolatingCurve::new(points.to_vec(), 2, closed, roots));
    assert!(matches!(
        curve(&[0.0; 4], true, None),
        Err(Error::TooFewPoints { argument: "points", got: 2, needed: 3 })
    ));
    assert!(matches!(curve(&[0.0; 2], false, None), Err(Error::TooFewPoints { needed: 2, .. })));
    assert!(matches!(curve(&[0.0; 7], true, None), Err(Error::WrongLength { got: 7, needed: 8, .. })));
    assert!(matches!(
        curve(&[0.0, 1.0, f64::NAN, 0.0, 2.0, 1.0], true, None),
        Err(Error::NotFinite { argument: "points", index: Some(2) })
    ));
    assert!(matches!(
        curve(&[0.0, 1.0, 1e10, 0.0, 2.0, 1.0], true, None),
        Err(Error::OutOfRange { index: Some(2), .. })
    ));
    let fine = curve(&[0.0, 1.0, 2.0, 0.0, 2.0, 1.0], false, None).expect("three points");
    // One number has no index.
    assert!(matches!(
        unboxed(fine.evaluate(2.5, 0)),
        Err(Error::OutOfRange { argument: "t", index: None, .. })
    ));
    assert_eq!(unboxed(fine.evaluate(f64::NAN, 0)), Err(Error::NotFinite { argument: "t", index: None }));
    assert!(matches!(unboxed(fine.evaluate(1.0, 4)), Err(Error::OutOfRange { argument: "derivative", .. })));
    assert!(matches!(unboxed(fine.refine(1, 3, 2)), Err(Error::Degenerate { argument: "m0", .. })));
    assert!(matches!(unboxed(fine.refine(0, 2, 2)), Err(Error::OutOfRange { argument: "levels", .. })));
    assert!(matches!(
        // What all levels together would need: it is known before the first of them is computed.
        unboxed(fine.refine(24, 2, 2)),
        Err(Error::LimitExceeded { limit: "maxOutputPoints", needed, .. }) if needed >= 33_554_432.0
    ));
    assert!(matches!(unboxed(fine.refine(3, 2, 0)), Err(Error::OutOfRange { argument: "m", .. })));
    let spline = |step: f64, offset: f64| {
        unboxed(BSplineCurve::new(vec![0.0; 10], 2, true, Roots::ellipse(3).expect("in range"), step, offset))
    };
    assert!(matches!(spline(2.0, 0.0), Err(Error::OutOfRange { argument: "roots", index: Some(1), .. })));
    assert!(matches!(spline(0.0, 0.0), Err(Error::OutOfRange { argument: "step", .. })));
    assert!(matches!(spline(f64::NAN, 0.0), Err(Error::NotFinite { argument: "step", .. })));
    assert!(matches!(spline(1.0, f64::INFINITY), Err(Error::NotFinite { argument: "offset", .. })));
}

#[test]
fn what_was_refined_comes_back_and_what_was_changed_says_by_how_much() {
    let mut random = Random::new(8);
    for roots in lists() {
        for (dimension, closed, m) in [(2, true, 2), (3, false, 2), (2, false, 3), (3, true, 3)] {
            let points = random_points(&mut random, 7, dimension);
            let curve =
                InterpolatingCurve::new(points, dimension, closed, Some(roots.clone())).expect("finite");
            let coarse = curve.refine(1, 2, 2).expect("in range");
            let fine = coarse.refine(m).expect("in range");
            let (back, deviation) = fine.reduce(m).expect("it divides");
            let size = scale(coarse.points());
            assert!(deviation < 1e-12 * size, "{roots:?} {closed} {m}: {deviation:e}");
            assert!((back.step() - coarse.step()).abs() < 1e-15, "the grid");
            assert!((back.offset() - coarse.offset()).abs() < 1e-14, "the place");
            for (a, b) in back.points().iter().zip(coarse.points()) {
                assert!((a - b).abs() < 1e-11 * size, "{roots:?} {closed} {m}: {a} {b}");
            }
            let (through, deviation) = coarse.interpolating().expect("an even grid");
            assert!(deviation < 1e-12 * size, "{deviation:e}");
            for (a, b) in through.points().iter().zip(curve.points()) {
                assert!((a - b).abs() < 1e-12 * size, "{a} {b}");
            }
            // A point that is moved leaves a deviation, which is that of the two curves.
            let mut point = fine.points()[..dimension].to_vec();
            point[0] += 0.5;
            let moved = fine.with_point(0, &point).expect("finite");
            let (back, deviation) = moved.reduce(m).expect("it divides");
            let end = moved.domain().1.min(back.domain().1);
            let mut worst: f64 = 0.0;
            for i in 0..=2000 {
                let t = (end * f64::from(i) / 2000.0).min(end);
                let [a, b] = [&moved, &back].map(|c| c.evaluate(t, 0).expect("in the domain"));
                worst = worst.max(a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt());
            }
            assert!((worst / deviation - 1.0).abs() < 4e-3, "{roots:?}: {worst} measured as {deviation}");
        }
    }
    let points = random_points(&mut random, 7, 2);
    let fine =
        InterpolatingCurve::new(points, 2, true, None).expect("finite").refine(1, 2, 2).expect("in range");
    assert!(matches!(unboxed(fine.reduce(3)), Err(Error::Degenerate { argument: "m", .. })));
    assert!(matches!(unboxed(fine.reduce(0)), Err(Error::OutOfRange { argument: "m", .. })));
}

#[test]
fn a_curve_of_one_point_becomes_few_cubics_whatever_its_coordinates() {
    // Their extent is a rounding: a share of that as the tolerance once made this go on without end.
    for value in [0.1, 1.0 / 3.0, 1e-10, 1e9 / 7.0] {
        for (degree, closed) in [(4, false), (5, false), (5, true), (15, false)] {
            let roots = Roots::polynomials(degree).expect("a list");
            let curve = InterpolatingCurve::new(vec![value; 10], 2, closed, Some(roots)).expect("a curve");
            let tolerance = (1e-9 * curve.bounds().extent()).max(f64::MIN_POSITIVE);
            let cubics = curve.to_cubics(tolerance).expect("cubics");
            assert!(
                cubics.path.len() <= 8 * 2 * curve.piece_count(),
                "{value}, {degree}: {}",
                cubics.path.len() / 8
            );
            // Rounding of an interpolator grows with its order, by its Lebesgue constant.
            let worst = cubics.path.iter().fold(0.0, |worst: f64, x| worst.max((x / value - 1.0).abs()));
            assert!(worst <= 1e-11, "{value}, {degree}: off by {worst:e}");
            let (points, _) = curve.flatten(tolerance).expect("a polyline");
            assert!(
                points.len() <= 2 * 2 * curve.piece_count(),
                "{value}, {degree}: {} points",
                points.len() / 2
            );
        }
    }
}

#[test]
fn finer_control_points_are_at_most_four_million_in_the_plane_as_in_space() {
    for dimension in [2, 3] {
        let points = (0..10_000 * dimension).map(|i| (i % 7) as f64).collect();
        let roots = Roots::polynomials(2).expect("in range");
        let curve = InterpolatingCurve::new(points, dimension, true, Some(roots)).expect("finite");
        let fine = curve.refine(1, 2, 2).expect("within the limits");
        assert_eq!(fine.refine(200).expect("exactly at the limit").points().len(), 4_000_000 * dimension);
        let refused = unboxed(fine.refine(202)).map(|_| ());
        let limited = matches!(refused, Err(Error::LimitExceeded { argument: "m", most: 4e6, .. }));
        assert!(limited, "{dimension}: {refused:?}");
    }
}

#[test]
fn finer_control_points_beyond_the_limits_are_refused_where_they_are_made() {
    let points: Vec<f64> = (0..14).map(|i| if i / 2 % 2 == 0 { -9e8 } else { 9e8 }).collect();
    let roots = Roots::hyperbola(1.85).expect("in range");
    let curve = InterpolatingCurve::new(points, 2, true, Some(roots)).expect("in range");
    // The control points lie outside the points: at 1.03e9 here, of which no curve can be made.
    let refused = unboxed(curve.refine(1, 2, 2)).map(|_| ());
    assert!(matches!(refused, Err(Error::OutOfRange { argument: "points", .. })), "{refused:?}");
}

/// The functions of 0, `zeros` times, and ±`rate`, each at most 1 on [0, end], at t.
fn functions(zeros: usize, rate: f64, end: f64, t: f64) -> Vec<f64> {
    let powers = (0..zeros).map(|k| (t / end).powi(k as i32));
    powers.chain([(rate * (t - end)).exp(), (-rate * t).exp()]).collect()
}

#[test]
fn an_open_curve_keeps_what_large_roots_stand_for_to_the_digits_that_its_ends_leave() {
    for (zeros, rate) in
        [(2, 1.0), (2, 3.0), (2, 8.0), (2, 12.0), (2, 19.0), (3, 5.0), (3, 12.0), (4, 6.0), (1, 19.0)]
    {
        let zero = vec![Root::default(); zeros];
        let real = [rate, -rate].map(|re| Root { re, im: 0.0 });
        let roots = Roots::new(&[zero, real.to_vec()].concat(), "roots").expect("within the limits");
        let count = zeros + 2;
        let end = count as f64 - 1.0;
        let (mut off, mut refined_off) = (0.0_f64, 0.0_f64);
        for f in 0..count {
            let points: Vec<f64> =
                (0..count).flat_map(|k| [functions(zeros, rate, end, k as f64)[f], 1.0]).collect();
            let curve =
                InterpolatingCurve::new(points, 2, false, Some(roots.clone())).expect("an interpolator");
            let fine = curve.refine(1, 2, 2).expect("finer");
            for i in 0..=400 {
                let t = end * f64::from(i) / 400.0;
                let expected = functions(zeros, rate, end, t)[f];
                off = off.max((curve.evaluate(t, 0).expect("in the domain")[0] - expected).abs());
                refined_off =
                    refined_off.max((fine.evaluate(t, 0).expect("in the domain")[0] - expected).abs());
            }
        }
        let growth = (rate * (zeros as f64 - 1.0)).exp();
        // What the documentation says; the worst seen are 1e-17 and 1.3e-15 of the growth, for 0, 0, ±19.
        assert!(off < 1e-14 + 1e-16 * growth, "{zeros} {rate}: {off:e}");
        assert!(refined_off < 1e-12 + 1e-14 * growth, "{zeros} {rate}: {refined_off:e}");
    }
}
