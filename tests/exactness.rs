//! One segment is exact: the weights against 50 digits in all three spaces.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

mod support;

use expline::generator::{Basis, Space};
use serde::Deserialize;
use support::{golden, tolerance};

#[derive(Deserialize)]
struct WeightCase {
    space: String,
    w: f64,
    weights: Vec<Vec<f64>>,
}

#[derive(Deserialize)]
struct WeightTable {
    x: Vec<f64>,
    cases: Vec<WeightCase>,
}

#[test]
fn weights_and_three_derivatives_agree_with_fifty_digits() {
    let table: WeightTable = golden::parse(include_str!("golden/splines/weights.json"));
    for case in &table.cases {
        let space = if case.space == "hyperbolic" { Space::Hyperbolic } else { Space::Trigonometric };
        let basis = Basis::new(space, case.w);
        for (row, expected) in case.weights.iter().enumerate() {
            let (derivative, which) = (row / 3, row % 3);
            let largest = expected.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            for (&x, &expected) in table.x.iter().zip(expected) {
                let weights = basis.weights(x, derivative);
                let got = [weights.chord, weights.leaving, weights.arriving][which];
                let deviation = (got - expected).abs() / largest;
                assert!(
                    deviation <= tolerance::WEIGHTS,
                    "{} w = {} x = {x} derivative {derivative} weight {which}: {got} for {expected}, {deviation:e}",
                    case.space,
                    case.w,
                );
            }
        }
    }
}
