//! A chain of points becomes one curve, smooth where the chain is and with its cusps.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use expline::numerics::Point;
use expline::trace::{Chain, CuspRule, Method, Profile, ProfileOptions, Rule};

fn closed(points: Vec<Point>) -> Chain {
    Chain::new(points, true).expect("a chain")
}

/// Places along a closed polygon, a step apart.
fn along(corners: &[(f64, f64)], step: f64) -> Vec<Point> {
    let mut points = Vec::new();
    for (i, &(x, y)) in corners.iter().enumerate() {
        let (to_x, to_y) = corners[(i + 1) % corners.len()];
        let length = (to_x - x).hypot(to_y - y);
        let count = (length / step).round().max(1.0);
        points.extend((0..count as usize).map(|k| {
            let share = k as f64 / count;
            Point::new(x + (to_x - x) * share, y + (to_y - y) * share)
        }));
    }
    points
}

fn breaks(profile: &Profile) -> f64 {
    let curve = profile.curve().expect("a curve");
    let (out, into) = (curve.tangents(), curve.tangents_in());
    let turn = |i: usize| {
        let (a, b) = (into[i], out[i]);
        (a.x * b.y - a.y * b.x).atan2(a.dot(&b)).abs()
    };
    let near_cusp = |i: usize| profile.cusps().iter().any(|c| (c.point - curve.points()[i]).norm() < 1e-9);
    let inner = usize::from(!curve.is_closed())..curve.points().len() - usize::from(!curve.is_closed());
    inner.filter(|&i| !near_cusp(i)).map(turn).fold(0.0, f64::max)
}

#[test]
fn a_circle_is_smooth_everywhere_and_on_its_points() {
    let points = (0..200)
        .map(|i| f64::from(i) / 200.0 * core::f64::consts::TAU)
        .map(|a| Point::new(50.0 + 32.0 * a.cos(), 40.0 + 32.0 * a.sin()))
        .collect();
    let profile = closed(points).follow(&ProfileOptions::default()).expect("valid");
    assert!(profile.cusps().is_empty(), "no cusp");
    assert!(breaks(&profile) < 1e-9, "one tangent at every joint: {}", breaks(&profile));
    let metrics = profile.metrics().expect("a curve");
    // Quadratic pieces of 25 degrees of a radius of 32 are within 0.02; so few that the score is within a tenth of the
    // least.
    assert!(metrics.rmse < 0.03 && metrics.mae <= metrics.rmse, "{metrics:?}");
    assert!(metrics.hausdorff < 0.1 && metrics.jaccard > 0.99, "{metrics:?}");
}

#[test]
fn a_polygon_has_its_corners_and_straight_sides() {
    let corners = [(10.2, 10.1), (60.4, 14.3), (52.3, 50.2), (18.1, 44.6)];
    let chain = closed(along(&corners, 0.9));
    let profile = chain.follow(&ProfileOptions::default()).expect("valid");
    assert_eq!(profile.cusps().len(), 4);
    assert_eq!(profile.tubes().len(), 4);
    for &(x, y) in &corners {
        let off =
            profile.cusps().iter().map(|c| (c.point - Point::new(x, y)).norm()).fold(f64::MAX, f64::min);
        assert!(off < 1e-6, "where the sides meet: {off}");
    }
    assert!(profile.metrics().expect("a curve").hausdorff < 1e-6, "sides are lines");
    // The chain begins at the corner at the lower left: y goes down.
    let first = profile.chain().points()[0];
    assert!((first - Point::new(18.1, 44.6)).norm() < 1.0, "{first}");
}

#[test]
fn an_open_wave_keeps_its_ends() {
    let points: Vec<Point> =
        (0..150).map(f64::from).map(|x| Point::new(x, 20.0 * (x / 18.0).sin())).collect();
    let chain = Chain::new(points.clone(), false).expect("a chain");
    for method in [ProfileOptions::default().method, Method::Mean(Rule::Least)] {
        let options = ProfileOptions { method, ..ProfileOptions::default() };
        let profile = chain.follow(&options).expect("valid");
        let curve = profile.curve().expect("a curve");
        assert!(!curve.is_closed(), "open");
        assert!((curve.points()[0] - points[0]).norm() < 1e-9, "begins where the chain begins");
        assert!((curve.points()[curve.points().len() - 1] - points[149]).norm() < 1e-9, "and ends there");
        assert!(breaks(&profile) < 1e-9, "smooth");
        let metrics = profile.metrics().expect("a curve");
        let bound = if matches!(method, Method::Placed { .. }) { 0.06 } else { 0.4 };
        assert!(metrics.rmse < bound, "{method:?}: {metrics:?}");
    }
}

#[test]
fn every_degree_gives_one_curve_and_others_are_refused() {
    let points: Vec<Point> = (0..80)
        .map(|i| f64::from(i) / 80.0 * core::f64::consts::TAU)
        .map(|a| Point::new((24.0 * a.cos()).round(), (17.0 * a.sin()).round()))
        .collect();
    for degree in 1..=3 {
        let options = ProfileOptions { degree, ..ProfileOptions::printed() };
        let profile = closed(points.clone()).follow(&options).expect("valid");
        assert!(profile.metrics().expect("a curve").rmse < 0.7, "degree {degree}");
        let owned: usize = profile.tubes().iter().map(|tube| tube.count - 1).sum();
        assert_eq!(owned, 80, "every point is owned once");
    }
    for degree in [0, 4] {
        let options = ProfileOptions { degree, ..ProfileOptions::default() };
        assert!(closed(points.clone()).follow(&options).is_err(), "degree {degree}");
    }
}

#[test]
fn two_cusps_closer_than_the_window_and_a_cusp_at_the_first_point_do_no_harm() {
    let notch = [(0.0, 0.0), (30.0, 0.0), (31.0, -6.0), (32.0, 0.0), (60.0, 0.0), (60.0, 30.0), (0.0, 30.0)];
    for shift in [0, 1, 7, 33] {
        let mut points = along(&notch, 0.7);
        points.rotate_left(shift);
        let rule = CuspRule { gap: 0.0, window: 4.0, angle: 0.6, reach: 2.0 };
        let options = ProfileOptions { cusps: rule, ..ProfileOptions::default() };
        let profile = closed(points).follow(&options).expect("valid");
        assert!(profile.cusps().len() >= 6, "shift {shift}: {}", profile.cusps().len());
        assert!(profile.metrics().expect("a curve").hausdorff < 1.5, "shift {shift}");
    }
}

#[test]
fn the_smallest_rings_and_lines_have_a_curve() {
    for count in 2..12 {
        for ring in [false, true] {
            let points: Vec<Point> = (0..count)
                .map(|i| f64::from(i) / f64::from(count) * core::f64::consts::TAU)
                .map(|a| Point::new(3.0 * a.cos(), 3.0 * a.sin()))
                .collect();
            let chain = Chain::new(points, ring).expect("a chain");
            for options in [ProfileOptions::default(), ProfileOptions::printed()] {
                let profile = chain.follow(&options).expect("valid");
                let curve = profile.curve().expect("a curve");
                assert!(curve.points().iter().all(|p| p.x.is_finite() && p.y.is_finite()), "{count}");
                // At worst one chord for a whole ring.
                assert!(profile.metrics().expect("a curve").hausdorff < 6.5, "{count} {ring}");
            }
        }
    }
}

#[test]
fn noise_is_what_was_put_in() {
    let mut state = 1_u64;
    let mut normal = move || {
        let mut unit = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as f64 / (1_u64 << 31) as f64
        };
        (0..12).map(|_| unit()).sum::<f64>() - 6.0
    };
    let points = (0..400).map(|i| Point::new(f64::from(i), 0.2 * normal())).collect();
    let noise = Chain::new(points, false).expect("a chain").noise();
    // 400 differences, less the largest twentieth: a tenth less than 0.2, give or take a twentieth.
    assert!((0.15..0.21).contains(&noise), "{noise}");
    let window =
        Chain::new(vec![Point::new(0.0, 0.0), Point::new(9.0, 0.0)], false).expect("a chain").window();
    assert!((window - 3.0).abs() < 1e-12, "no noise, the least window");
}

#[test]
fn a_chain_across_all_coordinates_is_compared_with_its_curve_in_bounded_work() {
    let points = vec![Point::new(0.0, 0.0), Point::new(1e9, 0.0), Point::new(0.0, 1e9)];
    let chain = Chain::new(points, false).expect("a chain");
    for options in [ProfileOptions::printed(), ProfileOptions::default()] {
        let metrics = chain.follow(&options).and_then(|profile| profile.metrics());
        if let Ok(metrics) = metrics {
            let finite = metrics.rmse.is_finite() && metrics.hausdorff.is_finite();
            assert!(finite && (0.0..=1.0).contains(&metrics.jaccard), "{metrics:?}");
        }
    }
}
