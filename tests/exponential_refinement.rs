//! Filters between grids, against 50 digits, and curves that stay what they are on every grid.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

mod support;

use expline::generator::{ExponentialBSpline, Interpolator};
use expline::refine::{finer, from_points};
use serde::Deserialize;
use support::{assert_all_close, golden, roots, tolerance};

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
    golden::parse(include_str!("golden/splines/refinement.json"))
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
