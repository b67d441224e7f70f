//! Chains of pixels: tangents and tubes are those of the golden chain, and every tube has its spline.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::golden;
use expline::numerics::{Point, Vector};
use expline::trace::{Chain, CuspRule, Joint, Method, Rule, Tube, fit_tube, fit_tube_with};
use serde::Deserialize;
use std::collections::BTreeMap;

/// Golden numbers have nine digits.
const PRINTED: f64 = 1e-6;

#[derive(Deserialize)]
struct Golden {
    chain: Vec<[f64; 2]>,
    window: f64,
    alpha0_deg: f64,
    corner_threshold_deg: f64,
    tangents: BTreeMap<String, [f64; 2]>,
    curvature: BTreeMap<String, f64>,
    smoothed: BTreeMap<String, [f64; 2]>,
    corners: Vec<usize>,
    tubes: Vec<GoldenTube>,
    fits: Vec<GoldenFit>,
}

#[derive(Deserialize)]
struct GoldenTube {
    first: usize,
    count: usize,
    cusp_start: bool,
    cusp_end: bool,
}

#[derive(Deserialize)]
struct GoldenFit {
    control: Vec<[f64; 2]>,
    j: usize,
    k: usize,
    rmse: f64,
    mae: f64,
    loo: f64,
}

fn golden() -> (Golden, Chain) {
    let golden: Golden = golden::parse(include_str!("../golden/tracing/pipeline.json"));
    let points = golden.chain.iter().map(|&[x, y]| Point::new(x, y)).collect();
    (golden, Chain::new(points, true).expect("a chain"))
}

fn near(what: &str, got: f64, expected: f64) {
    assert!((got - expected).abs() <= PRINTED, "{what}: {got} for {expected}");
}

#[test]
fn tangents_curvatures_and_smoothed_points_agree_with_the_golden_chain() {
    let (golden, chain) = golden();
    for (i, tangent) in &golden.tangents {
        let place = chain.place(i.parse().expect("an index"), golden.window);
        near("tangent", place.tangent.x, tangent[0]);
        near("tangent", place.tangent.y, tangent[1]);
        near("curvature", place.curvature, golden.curvature[i]);
        near("point", place.point.x, golden.smoothed[i][0]);
        near("point", place.point.y, golden.smoothed[i][1]);
    }
}

#[test]
fn tubes_agree_with_the_golden_chain() {
    let (golden, chain) = golden();
    let tubes = chain.tubes(&golden.corners, golden.alpha0_deg.to_radians(), golden.window).expect("valid");
    assert_eq!(tubes.len(), golden.tubes.len());
    for (tube, expected) in tubes.iter().zip(&golden.tubes) {
        let cusps = [expected.cusp_start, expected.cusp_end];
        assert_eq!(*tube, Tube { first: expected.first, count: expected.count, cusps });
    }
    let owned: usize = tubes.iter().map(|tube| tube.count - 1).sum();
    assert_eq!(owned, chain.points().len(), "every point is owned once, joints twice");
}

#[test]
fn splines_between_cusps_agree_with_the_golden_chain() {
    let (golden, chain) = golden();
    let mut compared = 0;
    for (tube, expected) in golden.tubes.iter().zip(&golden.fits) {
        if !tube.cusp_start || !tube.cusp_end {
            continue;
        }
        let cusps = [true, true];
        let points = chain.tube_points(&Tube { first: tube.first, count: tube.count, cusps });
        let joint = |point: Point| Joint { point, tangent: None };
        let joints = [joint(points[0]), joint(points[points.len() - 1])];
        let fitted = fit_tube(&points, joints, 2, Method::Mean(Rule::Least)).expect("valid");
        let choice = fitted.choice.expect("enough points");
        assert_eq!((choice.interior, choice.k), (expected.j, expected.k), "tube at {}", tube.first);
        near("rmse", fitted.rmse, expected.rmse);
        near("mae", fitted.mae, expected.mae);
        near("left out", choice.score, expected.loo);
        for (point, expected) in fitted.control.iter().zip(&expected.control) {
            near("control", point.x, expected[0]);
            near("control", point.y, expected[1]);
        }
        compared += 1;
    }
    assert_eq!(compared, 4);
}

#[test]
fn neighbours_share_joint_and_tangent() {
    let points: Vec<Point> = (0..120)
        .map(|i| f64::from(i) / 120.0 * core::f64::consts::TAU)
        .map(|a| Point::new((40.0 * a.cos()).round(), (40.0 * a.sin()).round()))
        .collect();
    let chain = Chain::new(points, true).expect("a chain");
    let tubes = chain.tubes(&[], 50_f64.to_radians(), 8.0).expect("valid");
    assert!((6..=9).contains(&tubes.len()), "a full turn by 50 degrees: {}", tubes.len());
    let joint = |i: usize| {
        let place = chain.place(i % 120, 8.0);
        Joint { point: place.point, tangent: Some(place.tangent) }
    };
    for tube in &tubes {
        let joints = [joint(tube.first), joint(tube.first + tube.count - 1)];
        let rule = Method::Mean(Rule::Parsimonious { share: 0.1, slack: 0.02 });
        let fitted = fit_tube(&chain.tube_points(tube), joints, 2, rule).expect("valid");
        assert!(fitted.mae <= fitted.rmse && fitted.rmse < 0.5, "within the pixels: {}", fitted.rmse);
        let (first, last) = (fitted.control[1] - fitted.control[0], joints[0].tangent.expect("smooth"));
        let sine = |a: Vector, b: Vector| (a.x * b.y - a.y * b.x) / (a.norm() * b.norm());
        assert!(sine(first, last).abs() < 1e-9, "leaves along the tangent");
        assert!((fitted.control[0] - joints[0].point).norm() < 1e-12, "at the joint");
    }
}

#[test]
fn short_chains_do_no_harm() {
    for count in 2..9 {
        for closed in [false, true] {
            let points = (0..count).map(|i| Point::new(f64::from(i % 3), f64::from(i / 3))).collect();
            let chain = Chain::new(points, closed).expect("a chain");
            let tubes = chain.tubes(&[], 0.8, 3.0).expect("valid");
            let owned: usize = tubes.iter().map(|tube| tube.count - 1).sum();
            assert_eq!(owned, chain.points().len() - usize::from(!closed), "{count} points");
            for tube in &tubes {
                let points = chain.tube_points(tube);
                let joint = |point: Point| Joint { point, tangent: None };
                let joints = [joint(points[0]), joint(points[points.len() - 1])];
                let fitted = fit_tube(&points, joints, 2, Method::Mean(Rule::Least)).expect("valid");
                assert!(fitted.control.iter().all(|p| p.x.is_finite() && p.y.is_finite()));
            }
        }
    }
    assert!(Chain::new(vec![Point::new(0.0, 0.0)], false).is_err(), "one point is no chain");
    let chain = Chain::new(vec![Point::new(0.0, 0.0), Point::new(1.0, 0.0)], false).expect("a chain");
    assert!(chain.tubes(&[1, 1], 0.8, 3.0).is_err(), "cusps ascend");
    assert!(chain.tubes(&[2], 0.8, 3.0).is_err(), "cusps are points");
    assert!(chain.tubes(&[], 2.0, 3.0).is_err(), "an angle beyond a quarter turn");
}

#[test]
fn cusps_agree_with_the_golden_chain() {
    let (golden, chain) = golden();
    let angle = golden.corner_threshold_deg.to_radians();
    let rule = CuspRule { gap: 0.0, window: 8.0, angle, reach: 3.0 };
    let cusps: Vec<usize> = chain.cusps(&rule).expect("valid").iter().map(|cusp| cusp.index).collect();
    assert_eq!(cusps, golden.corners);
}

#[test]
fn splines_at_smooth_joints_agree_with_the_golden_chain() {
    let (golden, chain) = golden();
    for (tube, expected) in golden.tubes.iter().zip(&golden.fits) {
        let cusps = [tube.cusp_start, tube.cusp_end];
        let mut points = chain.tube_points(&Tube { first: tube.first, count: tube.count, cusps });
        let last = (tube.first + tube.count - 1) % chain.points().len();
        let joint = |index: usize, cusp: bool| {
            let place = chain.joint(index, golden.window);
            let on_pixel = (place.point - chain.points()[index]).norm() < 1e-9;
            let point = if cusp || on_pixel { chain.points()[index] } else { place.point };
            Joint { point, tangent: (!cusp).then_some(place.tangent) }
        };
        let joints = [joint(tube.first, cusps[0]), joint(last, cusps[1])];
        // The golden frame loses the last point of this tube to rounding.
        if tube.first == 102 {
            points.pop();
        }
        // The golden splines are chosen before their ends are moved onto the tangents.
        let method = Method::Mean(Rule::Least);
        let held = joints.map(|joint| Joint { tangent: None, ..joint });
        let chosen = fit_tube(&points, held, 2, method).expect("valid").choice.expect("enough points");
        assert_eq!((chosen.interior, chosen.k), (expected.j, expected.k), "tube at {}", tube.first);
        near("left out", chosen.score, expected.loo);
        let fitted = fit_tube_with(&points, joints, 2, method, chosen).expect("valid");
        near("rmse", fitted.rmse, expected.rmse);
        near("mae", fitted.mae, expected.mae);
        for (point, expected) in fitted.control.iter().zip(&expected.control) {
            near("control", point.x, expected[0]);
            near("control", point.y, expected[1]);
        }
    }
}
