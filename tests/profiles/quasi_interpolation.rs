//! The weighted quasi-interpolant is what its definition says, and its closed forms are what they replace.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::golden;
use expline::numerics::Point;
use expline::trace::{
    Cloud, End, Estimator, Knots, Method, QuasiInterpolant, Rule, Score, choose, diameter,
    directed_hausdorff, generalised_cross_validation, jaccard, leave_one_out, left_out_locally,
    mean_absolute, root_mean_square,
};
use serde::Deserialize;
use std::collections::BTreeMap;

/// Golden numbers are printed with twelve digits after the point.
const PRINTED: f64 = 1e-9;

#[derive(Deserialize)]
struct Golden {
    clouds: BTreeMap<String, GoldenCloud>,
    metrics: Metrics,
}

#[derive(Deserialize)]
struct GoldenCloud {
    a: f64,
    b: f64,
    pts: Vec<[f64; 2]>,
    cases: Vec<Case>,
    loo_grid_p2_free: Grid,
    loo_grid_p2_clamped00: Grid,
    loo_grid_p3_free: Grid,
    loo_grid_p3_clamped00: Grid,
}

#[derive(Deserialize)]
struct Case {
    p: usize,
    j: usize,
    k: usize,
    knots: Vec<f64>,
    greville: Vec<f64>,
    coeffs: Vec<f64>,
    eval_x: Vec<f64>,
    eval_y: Vec<f64>,
    train_rmse: f64,
    train_mae: f64,
    loo_rmse: f64,
    loo_mae: f64,
    bezier: Vec<Vec<[f64; 2]>>,
}

#[derive(Deserialize)]
struct Grid {
    js: Vec<usize>,
    ks: Vec<usize>,
    rmse: Vec<Vec<f64>>,
    best: Best,
}

#[derive(Deserialize)]
struct Best {
    j: usize,
    k: usize,
}

#[derive(Deserialize)]
struct Metrics {
    residuals: Vec<f64>,
    rmse: f64,
    mae: f64,
    hausdorff: Hausdorff,
    jaccard: GoldenJaccard,
}

#[derive(Deserialize)]
#[allow(non_snake_case, reason = "names of the golden file")]
struct Hausdorff {
    A: Vec<[f64; 2]>,
    B: Vec<[f64; 2]>,
    diameter: f64,
    directed_A_to_B: f64,
    directed_B_to_A: f64,
}

#[derive(Deserialize)]
#[allow(non_snake_case, reason = "names of the golden file")]
struct GoldenJaccard {
    P: Vec<(i32, i32)>,
    C: Vec<(i32, i32)>,
    J_tol1: f64,
    J_literal_dilated: f64,
}

#[derive(Deserialize)]
struct GoldenPlus {
    clouds: BTreeMap<String, Vec<PlusCase>>,
}

#[derive(Deserialize)]
#[allow(non_snake_case, reason = "names of the golden file")]
struct PlusCase {
    j: usize,
    k: usize,
    coeffs: Vec<f64>,
    eval_x: Vec<f64>,
    eval_y: Vec<f64>,
    trace_H: f64,
    gcv: f64,
}

fn golden() -> Golden {
    golden::parse(include_str!("../golden/tracing/wqisa.json"))
}

fn points(list: &[[f64; 2]]) -> Vec<Point> {
    list.iter().map(|&[x, y]| Point::new(x, y)).collect()
}

fn close(what: &str, got: f64, expected: f64) {
    assert!((got - expected).abs() <= PRINTED, "{what}: {got} for {expected}");
}

fn all_close(what: &str, got: &[f64], expected: &[f64]) {
    assert_eq!(got.len(), expected.len(), "{what}: how many");
    got.iter().zip(expected).for_each(|(&got, &expected)| close(what, got, expected));
}

const FREE: [End; 2] = [End::Free, End::Free];
const HELD: [End; 2] = [End::Held, End::Held];

#[test]
fn coefficients_values_and_bezier_points_agree_with_the_golden_data() {
    for (name, cloud) in &golden().clouds {
        let sorted = Cloud::new(&points(&cloud.pts)).expect("valid");
        for case in &cloud.cases {
            let what = format!("{name} p{} j{} k{}", case.p, case.j, case.k);
            let knots = Knots::even(cloud.a, cloud.b, case.j, case.p).expect("valid");
            all_close(&what, knots.as_slice(), &case.knots);
            let greville: Vec<f64> = (0..knots.count()).map(|q| knots.greville(q)).collect();
            all_close(&what, &greville, &case.greville);
            let fitted =
                QuasiInterpolant::new(&sorted, knots, Estimator::Mean { k: case.k }, FREE).expect("valid");
            all_close(&what, fitted.coefficients(), &case.coeffs);
            let values: Vec<f64> = case.eval_x.iter().map(|&x| fitted.evaluate(x)).collect();
            all_close(&what, &values, &case.eval_y);
            let residuals = fitted.residuals(&sorted).expect("there is memory");
            close(&what, root_mean_square(residuals.iter().copied()), case.train_rmse);
            close(&what, mean_absolute(residuals.iter().copied()), case.train_mae);
            assert_eq!(fitted.knots().piece_count(), case.bezier.len(), "{what}");
            for (piece, expected) in case.bezier.iter().enumerate() {
                for (point, expected) in fitted.bezier(piece).iter().zip(expected) {
                    all_close(&what, &[point.x, point.y], expected);
                }
            }
            let scores = leave_one_out(&sorted, fitted.knots(), case.k, FREE).expect("valid");
            close(&what, scores[case.k - 1].rmse, case.loo_rmse);
            close(&what, scores[case.k - 1].mae, case.loo_mae);
        }
    }
}

#[test]
fn scores_of_whole_grids_agree_with_the_golden_data_free_and_held() {
    for (name, cloud) in &golden().clouds {
        let sorted = Cloud::new(&points(&cloud.pts)).expect("valid");
        for (degree, ends, grid) in [
            (2, FREE, &cloud.loo_grid_p2_free),
            (2, HELD, &cloud.loo_grid_p2_clamped00),
            (3, FREE, &cloud.loo_grid_p3_free),
            (3, HELD, &cloud.loo_grid_p3_clamped00),
        ] {
            let mut best = (f64::MAX, 0, 0);
            for (&j, expected) in grid.js.iter().zip(&grid.rmse) {
                let knots = Knots::even(cloud.a, cloud.b, j, degree).expect("valid");
                let scores = leave_one_out(&sorted, &knots, grid.ks.len(), ends).expect("valid");
                let rmse: Vec<f64> = scores.iter().map(|score| score.rmse).collect();
                all_close(name, &rmse, expected);
                for (score, &k) in scores.iter().zip(&grid.ks) {
                    if score.rmse < best.0 {
                        best = (score.rmse, j, k);
                    }
                }
            }
            assert_eq!((best.1, best.2), (grid.best.j, grid.best.k), "{name} degree {degree}: the best");
        }
    }
}

#[test]
fn leaving_one_out_in_closed_form_is_leaving_one_out() {
    for (name, golden) in &golden().clouds {
        let cloud = Cloud::new(&points(&golden.pts)).expect("valid");
        let knots = Knots::even(golden.a, golden.b, 3, 2).expect("valid");
        let ends = [End::Tangent(0.3), End::Held];
        for (Score { rmse, .. }, k) in leave_one_out(&cloud, &knots, 6, ends).expect("valid").iter().zip(1..)
        {
            let errors = (0..cloud.len()).map(|left_out| {
                let rest: Vec<Point> = (0..cloud.len())
                    .filter(|&i| i != left_out)
                    .map(|i| Point::new(cloud.x()[i], cloud.y()[i]))
                    .collect();
                let rest = Cloud::new(&rest).expect("valid");
                let fitted =
                    QuasiInterpolant::new(&rest, knots.clone(), Estimator::Mean { k }, ends).expect("valid");
                cloud.y()[left_out] - fitted.evaluate(cloud.x()[left_out])
            });
            // The same sums in another order.
            assert!((rmse - root_mean_square(errors)).abs() < 1e-12, "{name} k = {k}");
        }
    }
}

#[test]
fn local_polynomials_agree_with_the_golden_data() {
    let plus: GoldenPlus = golden::parse(include_str!("../golden/tracing/wqisa_plus.json"));
    let clouds = golden().clouds;
    for (name, cases) in &plus.clouds {
        let cloud = &clouds[name];
        let sorted = Cloud::new(&points(&cloud.pts)).expect("valid");
        for case in cases {
            let knots = Knots::even(cloud.a, cloud.b, case.j, 2).expect("valid");
            let (gcv, trace) = generalised_cross_validation(&sorted, &knots, case.k, FREE).expect("valid");
            close(name, trace, case.trace_H);
            close(name, gcv, case.gcv);
            let estimator = Estimator::Local { k: case.k };
            let fitted = QuasiInterpolant::new(&sorted, knots, estimator, FREE).expect("valid");
            all_close(name, fitted.coefficients(), &case.coeffs);
            let values: Vec<f64> = case.eval_x.iter().map(|&x| fitted.evaluate(x)).collect();
            all_close(name, &values, &case.eval_y);
        }
    }
}

#[test]
fn local_polynomials_reproduce_all_polynomials_of_their_degree() {
    for degree in 1..=4_usize {
        let polynomial = |x: f64| (0..=degree).fold(0.0, |sum, m| sum * (x - 0.4) + 1.0 - 0.7 * m as f64);
        let samples: Vec<Point> =
            (0..60).map(|i| f64::from(i) / 59.0).map(|x| Point::new(x, polynomial(x))).collect();
        let cloud = Cloud::new(&samples).expect("valid");
        for interior in [0, 1, 4] {
            let knots = Knots::even(0.0, 1.0, interior, degree).expect("valid");
            // Enough neighbours for the ridge of 1e-9 not to count beside their spread: a third of the cloud.
            let fitted =
                QuasiInterpolant::new(&cloud, knots, Estimator::Local { k: 20 }, FREE).expect("valid");
            for i in 0..=50 {
                let x = f64::from(i) / 50.0;
                let off = (fitted.evaluate(x) - polynomial(x)).abs();
                assert!(off < 1e-3, "degree {degree} interior {interior} at {x}: {off}");
            }
        }
    }
}

#[test]
fn projections_reproduce_all_polynomials_of_their_degree() {
    for degree in 1..=4_usize {
        let polynomial = |x: f64| (0..=degree).fold(0.0, |sum, m| sum * (x - 0.4) + 1.0 - 0.7 * m as f64);
        let samples: Vec<Point> =
            (0..90).map(|i| f64::from(i) / 89.0).map(|x| Point::new(x, polynomial(x))).collect();
        let cloud = Cloud::new(&samples).expect("valid");
        for inner in [&[][..], &[0.5], &[0.1, 0.15, 0.6, 0.9]] {
            let list = [&[0.0].repeat(degree + 1), inner, &[1.0].repeat(degree + 1)].concat();
            for reach in [0, 2, 9] {
                let knots = Knots::new(&list, degree).expect("valid");
                let fitted = QuasiInterpolant::new(&cloud, knots, Estimator::Projected { reach }, FREE)
                    .expect("valid");
                for i in 0..=50 {
                    let x = f64::from(i) / 50.0;
                    let off = (fitted.evaluate(x) - polynomial(x)).abs();
                    // 1e-10 on the diagonal of normal equations whose least eigenvalue is 1e-3 of a point and more.
                    assert!(off < 1e-5, "degree {degree} {inner:?} at {x}: {off}");
                }
            }
        }
    }
}

#[test]
fn a_projection_is_local() {
    let wave = |i: i32| Point::new(f64::from(i), (0.2 * f64::from(i)).sin());
    let mut points: Vec<Point> = (0..200).map(wave).collect();
    let knots = Knots::even(0.0, 199.0, 19, 2).expect("valid");
    let fit = |points: &[Point]| {
        let cloud = Cloud::new(points).expect("valid");
        QuasiInterpolant::new(&cloud, knots.clone(), Estimator::Projected { reach: 2 }, FREE).expect("valid")
    };
    let before = fit(&points);
    points[100].y += 5.0;
    let after = fit(&points);
    let changed: Vec<usize> =
        (0..22).filter(|&q| before.coefficients()[q] != after.coefficients()[q]).collect();
    // The point is in piece 10; a coefficient looks two pieces beyond the three pieces of its B-spline.
    assert_eq!(changed, (8..=14).collect::<Vec<_>>());
}

#[test]
fn placed_knots_are_where_they_are_needed_and_their_score_is_leaving_one_out() {
    let mut state = 1_u32;
    let mut noise = move || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        0.2 * (f64::from(state >> 8) / f64::from(1 << 24) - 0.5)
    };
    // A roof whose ridge is at 30, and 90 units of nothing.
    let points: Vec<Point> =
        (0..120).map(f64::from).map(|x| Point::new(x, (6.0 - (x - 30.0).abs()).max(0.0) + noise())).collect();
    let cloud = Cloud::new(&points).expect("valid");
    let method = Method::Placed { price: 1.2, floor: 0.0 };
    let chosen = |method| choose(&cloud, 0.0, 119.0, 2, FREE, method).expect("valid").expect("enough points");
    let (choice, knots) = chosen(method);
    let inner = &knots.as_slice()[3..knots.as_slice().len() - 3];
    assert_eq!(choice.interior, inner.len());
    let near = inner.iter().filter(|&&x| (20.0..40.0).contains(&x)).count();
    assert!(near >= 3 && inner.len() <= near + 3, "{inner:?}");
    let even = chosen(Method::Mean(Rule::Least)).0;
    assert!(choice.score < 0.5 * even.score, "{} against {}", choice.score, even.score);
    let errors = (0..cloud.len()).map(|left_out| {
        let rest: Vec<Point> = (0..120).filter(|&i| i != left_out).map(|i| points[i]).collect();
        let rest = Cloud::new(&rest).expect("valid");
        let fitted = QuasiInterpolant::new(&rest, knots.clone(), Estimator::Projected { reach: 2 }, FREE)
            .expect("valid");
        points[left_out].y - fitted.evaluate(points[left_out].x)
    });
    // Rounding of normal equations.
    assert!((choice.score - root_mean_square(errors)).abs() < 1e-9, "without fitting anything twice");
    assert!(choose(&cloud, 0.0, 119.0, 2, FREE, Method::Placed { price: -1.0, floor: 0.0 }).is_err());
    let flat: Vec<Point> =
        points.iter().map(|p| Point::new(p.x, if p.x % 5.0 < 3.0 { 0.2 } else { -0.3 })).collect();
    let flat = Cloud::new(&flat).expect("valid");
    let floor = Method::Placed { price: 1.2, floor: 0.5 };
    let line = choose(&flat, 0.0, 119.0, 2, HELD, floor).expect("valid").expect("enough points");
    assert_eq!(line.0.interior, 0, "errors below the floor need no knot");
}

#[test]
fn a_projection_keeps_what_its_ends_hold() {
    let points: Vec<Point> = (0..40).map(f64::from).map(|x| Point::new(x, 0.01 * x * (39.0 - x))).collect();
    let cloud = Cloud::new(&points).expect("valid");
    for ends in [HELD, [End::Tangent(0.39), End::Tangent(-0.39)], [End::Tangent(1.0), End::Free]] {
        let method = Method::Placed { price: 1.2, floor: 0.001 };
        let (_, knots) = choose(&cloud, 0.0, 39.0, 2, ends, method).expect("valid").expect("enough points");
        let estimator = Estimator::Projected { reach: 2 };
        let fitted = QuasiInterpolant::new(&cloud, knots, estimator, ends).expect("valid");
        assert!(fitted.evaluate(0.0).abs() < 1e-12, "on the axis");
        if let End::Tangent(slope) = ends[0] {
            // A difference quotient over 1e-6 of pieces of a curvature below 10.
            assert!((fitted.evaluate(1e-6) / 1e-6 - slope).abs() < 1e-4, "along its slope");
        }
        if ends[0] != End::Tangent(1.0) {
            let most = fitted.residuals(&cloud).expect("memory").iter().fold(0.0_f64, |m, r| m.max(r.abs()));
            assert!(most < 2e-3, "{most}");
        }
    }
}

#[test]
fn means_reproduce_constants_stay_between_the_ordinates_and_do_not_care_for_the_order() {
    let wave: Vec<Point> =
        (0..50).map(|i| Point::new(f64::from(i * 7 % 50), f64::from(i * i % 11))).collect();
    let mut turned = wave.clone();
    turned.reverse();
    let (cloud, turned) = (Cloud::new(&wave).expect("valid"), Cloud::new(&turned).expect("valid"));
    let flat: Vec<Point> = wave.iter().map(|p| Point::new(p.x, 2.5)).collect();
    let flat = Cloud::new(&flat).expect("valid");
    for degree in [1, 2, 3, 5] {
        for k in [1, 4, 50] {
            let knots = Knots::even(0.0, 49.0, 5, degree).expect("valid");
            let fit = |cloud| {
                QuasiInterpolant::new(cloud, knots.clone(), Estimator::Mean { k }, FREE).expect("valid")
            };
            let (fitted, other, constant) = (fit(&cloud), fit(&turned), fit(&flat));
            assert_eq!(fitted, other, "distinct abscissae: the order does not count");
            for i in 0..=98 {
                let x = 0.5 * f64::from(i);
                assert!((constant.evaluate(x) - 2.5).abs() < 1e-14, "a constant stays");
                assert!((-1e-14..=10.0 + 1e-14).contains(&fitted.evaluate(x)), "between least and largest");
            }
        }
    }
}

#[test]
fn an_end_that_is_held_is_on_the_axis_with_its_slope() {
    let golden = golden();
    let cloud = Cloud::new(&points(&golden.clouds["B_pixel_chain_local"].pts)).expect("valid");
    let end = golden.clouds["B_pixel_chain_local"].b;
    let ends = [End::Tangent(0.25), End::Tangent(-0.5)];
    let knots = Knots::even(0.0, end, 2, 2).expect("valid");
    let fitted = QuasiInterpolant::new(&cloud, knots, Estimator::Mean { k: 3 }, ends).expect("valid");
    let step = 1e-6;
    assert!(fitted.evaluate(0.0).abs() < 1e-12 && fitted.evaluate(end).abs() < 1e-12, "on the axis");
    // A difference quotient over 1e-6 of a parabola of curvature below 1.
    assert!((fitted.evaluate(step) / step - 0.25).abs() < 1e-5, "slope at the start");
    assert!((fitted.evaluate(end - step) / -step + 0.5).abs() < 1e-5, "slope at the end");
}

#[test]
fn a_straight_edge_takes_no_knot_more_than_it_needs() {
    let stairs: Vec<Point> =
        (0..60).map(|i| Point::new(f64::from(i), if i % 5 < 3 { 0.2 } else { -0.3 })).collect();
    let cloud = Cloud::new(&stairs).expect("valid");
    let chosen = |rule| {
        choose(&cloud, 0.0, 59.0, 2, HELD, Method::Mean(rule)).expect("valid").expect("enough points").0
    };
    assert_eq!(chosen(Rule::Parsimonious { share: 0.1, slack: 0.02 }).interior, 0, "one piece");
    assert!(
        chosen(Rule::Least).score <= chosen(Rule::Parsimonious { share: 0.1, slack: 0.02 }).score,
        "least is least"
    );
    let two = Cloud::new(&stairs[..2]).expect("valid");
    assert!(
        choose(&two, 0.0, 1.0, 2, FREE, Method::Mean(Rule::Least)).expect("valid").is_none(),
        "two points are a line"
    );
    let three = Cloud::new(&stairs[..3]).expect("valid");
    assert!(
        choose(&three, 0.0, 2.0, 2, FREE, Method::Mean(Rule::Least)).expect("valid").is_some(),
        "three are enough"
    );
}

#[test]
fn metrics_agree_with_the_golden_data() {
    let metrics = golden().metrics;
    close("rmse", root_mean_square(metrics.residuals.iter().copied()), metrics.rmse);
    close("mae", mean_absolute(metrics.residuals.iter().copied()), metrics.mae);
    let (a, b) = (points(&metrics.hausdorff.A), points(&metrics.hausdorff.B));
    close("there", directed_hausdorff(&a, &b), metrics.hausdorff.directed_A_to_B);
    close("back", directed_hausdorff(&b, &a), metrics.hausdorff.directed_B_to_A);
    close("diameter", diameter(&b), metrics.hausdorff.diameter);
    let found = jaccard(&metrics.jaccard.P, &metrics.jaccard.C);
    close("tolerant", found.tolerant, metrics.jaccard.J_tol1);
    close("literal", found.literal, metrics.jaccard.J_literal_dilated);
}

#[test]
fn what_cannot_be_fitted_is_refused_by_name() {
    let argument = |result: expline::Result<()>| result.expect_err("refused").argument();
    assert_eq!(argument(Cloud::new(&[]).map(drop)), Some("points"));
    assert_eq!(argument(Cloud::new(&[Point::new(0.0, f64::NAN)]).map(drop)), Some("points"));
    assert_eq!(argument(Knots::even(0.0, 0.0, 1, 2).map(drop)), Some("end"));
    assert_eq!(argument(Knots::even(0.0, 1.0, 1, 0).map(drop)), Some("degree"));
    assert_eq!(argument(Knots::even(0.0, 1.0, 1, 10).map(drop)), Some("degree"));
    assert_eq!(argument(Knots::even(0.0, 1.0, usize::MAX, 2).map(drop)), Some("interior"));
    let cloud = Cloud::new(&[Point::new(0.0, 1.0), Point::new(1.0, 1.0)]).expect("valid");
    let knots = Knots::even(0.0, 1.0, 7, 2).expect("valid");
    let fit = |k| QuasiInterpolant::new(&cloud, knots.clone(), Estimator::Mean { k }, FREE);
    assert_eq!(argument(fit(0).map(drop)), Some("neighbours"));
    assert_eq!(argument(fit(3).map(drop)), Some("neighbours"));
    assert!(fit(2).is_ok(), "pieces without a point of their own have neighbours all the same");
    assert_eq!(argument(leave_one_out(&cloud, &knots, 2, FREE).map(drop)), Some("neighbours"));
}

#[test]
fn local_polynomials_of_any_cloud_are_numbers_or_refused() {
    let (mut answers, mut refusals) = (0, 0);
    for power in 0..12 {
        let places = (0..24_i32).map(|i| {
            let far = 10f64.powi((i * 7 + power) % 30 - 21).min(1e9);
            Point::new(if i % 2 == 0 { far } else { -far }, f64::from(i * i % 11) * 1e7)
        });
        let cloud = Cloud::new(&places.collect::<Vec<_>>()).expect("in range");
        for (degree, k) in (1..=9).flat_map(|degree| (1..=12).map(move |k| (degree, k))) {
            let knots = Knots::even(cloud.x()[0], cloud.x()[23], degree, degree).expect("in range");
            let made = QuasiInterpolant::new(&cloud, knots.clone(), Estimator::Local { k }, FREE);
            let left_out = left_out_locally(&cloud, &knots, k, FREE).map(|score| vec![score]);
            let validated = generalised_cross_validation(&cloud, &knots, k, FREE)
                .map(|(score, trace)| vec![score, trace]);
            for answer in [made.map(|made| made.coefficients().to_vec()), left_out, validated] {
                match answer {
                    Ok(numbers) => {
                        answers += 1;
                        assert!(numbers.iter().all(|x| x.is_finite()), "{power}, {degree}, {k}: {numbers:?}");
                    }
                    Err(error) => {
                        refusals += 1;
                        assert_eq!(error.argument(), Some("points"), "{error}");
                    }
                }
            }
        }
    }
    assert!(answers > 0 && refusals > 0, "{answers} answers, {refusals} refusals");
}
