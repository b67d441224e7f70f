//! Interpolators of compact support, against 50 digits and against what defines them.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

mod support;

use expline::generator::Interpolator;
use serde::Deserialize;
use support::{golden, roots, tolerance};

#[derive(Deserialize)]
struct File {
    cases: Vec<Case>,
}

#[derive(Deserialize)]
struct Case {
    name: String,
    alpha: Vec<Vec<f64>>,
    lam: Vec<f64>,
    t: Vec<f64>,
    d: Vec<Vec<f64>>,
    riesz: [f64; 2],
    bounds: [f64; 2],
    beta_riesz: [f64; 2],
    lebesgue: f64,
}

fn file() -> File {
    golden::parse(include_str!("golden/splines/interpolators.json"))
}

#[test]
fn weights_and_values_agree_with_fifty_digits() {
    for case in file().cases {
        let phi = Interpolator::new(&roots(&case.alpha)).expect("the golden roots are in range");
        let largest = case.lam.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        for (got, expected) in phi.lambda().iter().zip(&case.lam) {
            let off = (got - expected).abs() / largest;
            assert!(off <= tolerance::LAMBDA, "{}: λ off by {off:e}", case.name);
        }
        let cancelled = 1.0 + 2.0 * case.lam.iter().map(|l| l.abs()).sum::<f64>();
        for (order, expected) in case.d.iter().enumerate() {
            let largest = expected.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            for (t, expected) in case.t.iter().zip(expected) {
                let off = (phi.at(*t, order) - expected).abs() / largest / cancelled;
                assert!(off <= tolerance::INTERPOLATORS, "{} order {order}: off by {off:e}", case.name);
            }
        }
        assert!(
            phi.identity() < 1e-14 * cancelled,
            "{}: the identity is off by {:e}",
            case.name,
            phi.identity()
        );
    }
}

#[test]
fn riesz_bounds_are_exact_and_within_the_estimates_of_the_paper() {
    for case in file().cases {
        let phi = Interpolator::new(&roots(&case.alpha)).expect("the golden roots are in range");
        let own = phi.riesz_bounds().expect("finite");
        let spline = phi.b_spline().riesz_bounds().expect("finite");
        for (got, expected) in [(own, case.riesz), (spline, case.beta_riesz)] {
            let off = (got.lower / expected[0] - 1.0).abs().max((got.upper / expected[1] - 1.0).abs());
            assert!(off < tolerance::RIESZ, "{}: off by {off:e}", case.name);
        }
        // (A.6) and (A.7) are bounds, and not equalities as printed.
        let [least, most] = case.bounds;
        assert!(least <= own.lower && own.upper <= most, "{}: {least} {own:?} {most}", case.name);
    }
}

#[test]
fn the_lebesgue_constant_is_no_less_than_at_any_place_looked_at() {
    for case in file().cases {
        let phi = Interpolator::new(&roots(&case.alpha)).expect("the golden roots are in range");
        // The golden value is the largest of 41 places.
        let ratio = phi.lebesgue() / case.lebesgue;
        assert!((1.0 - 1e-13..1.0 + 2e-3).contains(&ratio), "{}: {ratio}", case.name);
    }
}
