//! Exponential B-splines of any roots, against 50 digits and against what defines them.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

mod support;

use expline::generator::ExponentialBSpline;
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
    beta_hat0: f64,
    t: Vec<f64>,
    d: Vec<Vec<f64>>,
}

fn file() -> File {
    golden::parse(include_str!("golden/splines/exponential_bsplines.json"))
}

#[test]
fn values_and_all_continuous_derivatives_agree_with_fifty_digits() {
    for case in file().cases {
        let roots = roots(&case.alpha);
        let spline = ExponentialBSpline::new(&roots).expect("the golden roots are in range");
        let shift = 0.5 * roots.order() as f64;
        for (order, expected) in case.d.iter().enumerate() {
            let largest = expected.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            let mut worst: f64 = 0.0;
            for (t, expected) in case.t.iter().zip(expected) {
                let got = spline.at(t - shift, order);
                worst = worst.max((got - expected).abs() / largest);
            }
            assert!(worst <= tolerance::B_SPLINES, "{} derivative {order}: off by {worst:e}", case.name);
        }
        let off = (roots.integral() / case.beta_hat0 - 1.0).abs();
        assert!(off < 2e-15, "{}: the integral is off by {off:e}", case.name);
    }
}
