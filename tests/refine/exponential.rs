//! Filters between grids, against 50 digits, and curves that stay what they are on every grid.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::{assert_all_close, golden, roots, tolerance};
use expline::generator::{ExponentialBSpline, Interpolator};
use expline::refine::{finer, from_points};
use serde::Deserialize;

#[derive(Deserialize)]
struct File {
    filters: Vec<FilterCase>,
    prefilters: Vec<PreFilterCase>,
    periodic_examples: Vec<Example>,
}

#[derive(Deserialize)]
struct FilterCase {
    name: String,
    alpha: Vec<Vec<f64>>,
    m: usize,
    h: Vec<f64>,
}

#[derive(Deserialize)]
struct PreFilterCase {
    name: String,
    alpha: Vec<Vec<f64>>,
    m0: usize,
    g: Vec<f64>,
}

#[derive(Deserialize)]
struct Example {
    name: String,
    alpha: Vec<Vec<f64>>,
    m0: usize,
    m: usize,
    c: Vec<f64>,
    levels: Vec<Vec<f64>>,
    scale: Vec<f64>,
    beta_hat0_per_level: Vec<f64>,
    t: Vec<f64>,
    f: Vec<f64>,
}

fn file() -> File {
    golden::parse(include_str!("../golden/splines/refinement.json"))
}

#[test]
fn refinement_filters_agree_with_fifty_digits() {
    for case in file().filters {
        let spline = ExponentialBSpline::new(&roots(&case.alpha)).expect("golden roots");
        let h = spline.refinement_filter(case.m).expect("a factor in range");
        assert_all_close(&case.name, &h, &case.h, tolerance::FILTERS);
    }
}

#[test]
fn pre_filters_agree_with_fifty_digits() {
    for case in file().prefilters {
        let phi = Interpolator::new(&roots(&case.alpha)).expect("golden roots");
        let g = phi.pre_filter(case.m0).expect("a factor in range");
        let cancelled = 2.0 * phi.lambda().iter().map(|l| l.abs()).sum::<f64>();
        assert_all_close(&case.name, &g, &case.g, tolerance::FILTERS * (1.0 + cancelled));
    }
}

/// λ₀ and λ₁ for 0, ±iw (D 9.4), with cos(w/2) and sin w by what w lacks to π: there is nothing to cancel.
fn weights_near_pi(w: f64) -> [f64; 2] {
    /// What PI is less than π.
    const LACKING: f64 = 1.224_646_799_147_353_2e-16;
    let lacks = (core::f64::consts::PI - w) + LACKING;
    let sinc = |x: f64| libm::sin(x) / x;
    let quarter = sinc(0.25 * w);
    [2.0 / (quarter * quarter * libm::sin(0.5 * lacks)), -0.5 * w / (sinc(0.5 * w) * libm::sin(lacks))]
}

#[test]
fn three_roots_near_pi_have_their_weights_and_refinement_keeps_what_is_constant() {
    for lacks in [1e-2, 1e-4, 1e-6, 1e-8, 1e-9, 1e-10] {
        let w = core::f64::consts::PI - lacks;
        let roots = roots(&[vec![0.0, 0.0], vec![0.0, w], vec![0.0, -w]]);
        let phi = Interpolator::new(&roots).expect("below π there is one");
        for (got, expected) in phi.lambda().iter().zip(weights_near_pi(w)) {
            let off = (got / expected - 1.0).abs();
            assert!(off < 4e-15, "{lacks:e} from π: {got}, expected {expected}, {off:e}");
        }
        // Four taps act on a control point: as many roundings of weights that cancel.
        let rounding = 4.0 * f64::EPSILON * (1.0 + 2.0 * phi.lambda().iter().map(|l| l.abs()).sum::<f64>());
        let points = from_points(&[3.0; 8], 1, true, &phi, 2).expect("in range");
        for point in points {
            assert!((point - 3.0).abs() < 3.0 * rounding, "{lacks:e} from π: {point} for 3, {rounding:e}");
        }
    }
}

#[test]
fn closed_curves_have_the_golden_control_points_on_every_level() {
    for case in file().periodic_examples {
        let alpha = roots(&case.alpha);
        let order = alpha.order();
        let phi = Interpolator::new(&alpha).expect("golden roots");
        let mut points = from_points(&case.c, 1, true, &phi, case.m0).expect("in range");
        for (level, expected) in case.levels.iter().enumerate() {
            let scale = case.scale[level];
            if level > 0 {
                let coarse = alpha.scaled(case.scale[level - 1]).expect("in range");
                points = finer(&points, 1, true, &coarse, case.m).expect("in range");
            }
            // The paper counts from the start of the support of point 0, and does not divide by the integral.
            let (count, shift) = (expected.len(), scale as usize * (order - 1) - order / 2);
            let mut rotated = vec![0.0; points.len()];
            for (l, v) in expected.iter().enumerate() {
                rotated[(l + shift * (count - 1)) % count] = v * case.beta_hat0_per_level[level];
            }
            assert_all_close(&case.name, &points, &rotated, 1e-14);
        }
    }
}

#[test]
fn points_and_control_points_of_every_level_are_the_golden_curve() {
    for case in file().periodic_examples {
        let alpha = roots(&case.alpha);
        let phi = Interpolator::new(&alpha).expect("golden roots");
        let period = case.c.len() as f64;
        let cancelled = 1.0 + 2.0 * phi.lambda().iter().map(|l| l.abs()).sum::<f64>();
        // All shifts of a point by whole turns that reach t.
        let sum = |points: &[f64], step: f64, first: f64, t: f64, weight: &dyn Fn(f64) -> f64| {
            let mut sum = 0.0;
            for (l, point) in points.iter().enumerate() {
                for turn in -5..=5 {
                    sum += point * weight((t - first - f64::from(turn) * period) / step - l as f64);
                }
            }
            sum
        };
        for (t, expected) in case.t.iter().zip(&case.f) {
            let got = sum(&case.c, 1.0, 0.0, *t, &|x| phi.at(x, 0));
            assert!((got - expected).abs() < 2e-15 * cancelled, "{}: {got} for {expected} at {t}", case.name);
            let mut points = from_points(&case.c, 1, true, &phi, case.m0).expect("in range");
            for (level, scale) in case.scale.iter().enumerate() {
                if level > 0 {
                    let coarse = alpha.scaled(case.scale[level - 1]).expect("in range");
                    points = finer(&points, 1, true, &coarse, case.m).expect("in range");
                }
                let fine = alpha.scaled(*scale).expect("in range");
                let spline = ExponentialBSpline::new(&fine).expect("in range");
                let first = 0.5 * (alpha.order() % 2) as f64 / scale;
                let got = sum(&points, 1.0 / scale, first, *t, &|x| spline.at(x, 0) / fine.integral());
                assert!(
                    (got - expected).abs() < 1e-14 * cancelled,
                    "{} level {level}: {got} for {expected}",
                    case.name
                );
            }
        }
    }
}
